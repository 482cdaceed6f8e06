"""Control sequences in the texts of a server never reach the terminal."""

import json
import sys
from collections.abc import Iterator
from typing import Any

import pytest

from reference_client.errors import ProctorError
from reference_client.evaluation.status_board import Progress, ProgressLine
from reference_client.printable_text import printable
from tests.support.client.command import Proctor
from tests.support.kit.null_servers import (
    SERVICE,
    Behaviour,
    Reply,
    Request,
    canned_answers,
    run_server,
)

# Clears the screen, sets the title and the clipboard, reorders, and is half a pair.
ATTACK = "\x1b[2J\x1b]0;x\x07\x9b1A\x1b]52;c;eA==\x07\r\u202e\ud800"
# Members whose values the specification leaves to people.
FREE = ("reason", "name", "title", "description", "unavailable_reason", "version")


def spoil(value: Any, *names: str) -> Any:
    """The value with the attack in each text, or in those with these names."""
    if isinstance(value, dict):
        return {
            name: spoil(one, *names)
            if not isinstance(one, str | None)
            else f"{one}{ATTACK}"
            if not names or name in names
            else one
            for name, one in value.items()
        }
    return [spoil(one, *names) for one in value] if isinstance(value, list) else value


def spoiling(*names: str) -> Behaviour:
    def behaviour(request: Request) -> Reply:
        found = canned_answers(request)
        assert found is not None
        status, headers, body = found
        if request.path == "/v1":
            return found
        return status, headers, json.dumps(spoil(json.loads(body), *names)).encode()

    return behaviour


def refusing(request: Request) -> Reply:
    if request.path == "/v1":
        return 200, {"Content-Type": "application/json"}, json.dumps(SERVICE).encode()
    problem = {
        "type": "about:blank",
        "title": ATTACK,
        "status": 404,
        "code": "not_found",
        "detail": f"There is no {ATTACK}",
        "retryable": False,
        "side_effects": "none",
        "errors": [{"pointer": f"/{ATTACK}", "detail": ATTACK}],
    }
    headers = {"Content-Type": "application/problem+json", "Proctor-Version": "1.0"}
    return 404, headers, json.dumps(problem).encode()


def not_http(_request: Request) -> Reply:
    return 500, {"Content-Type": "text/html"}, ATTACK.encode("utf-8", "surrogatepass")


def acts(text: str) -> bool:
    """Whether anything but letters, tabs and line feeds would reach the terminal."""
    text.encode()  # a lone surrogate raises
    return any(not c.isprintable() and c not in "\n\t" for c in text)


@pytest.fixture(
    scope="module",
    params=[spoiling(*FREE), spoiling(), refusing, not_http],
    ids=["free texts", "all texts", "problems", "no problem"],
)
def url(request: pytest.FixtureRequest) -> Iterator[str]:
    with run_server(request.param) as found:
        yield found


@pytest.mark.parametrize(
    "line",
    [
        "status",
        "status run-1",
        "status run-1 --debug",
        "benchmarks",
        "benchmarks calibration",
        "results run-1 --episodes",
        "submit --benchmark calibration --print-endpoint",
        "compare run-1 run-2",
    ],
)
@pytest.mark.parametrize("as_json", [False, True])
def test_no_text_of_a_server_acts_on_the_terminal(
    url: str, line: str, as_json: bool, capsys: pytest.CaptureFixture[str]
) -> None:
    proctor = Proctor(url, capsys)
    options = ["--retry-timeout-s", "0", *(["--json"] if as_json else [])]
    assert proctor(*line.split(), *options) in (0, 1, 2)
    assert proctor.out + proctor.err != ""
    assert not acts(proctor.out + proctor.err)


def test_exceptions_and_progress_hold_no_control_characters(
    capsys: pytest.CaptureFixture[str],
) -> None:
    error = ProctorError("not_found", ATTACK, errors=[(ATTACK, ATTACK)])
    assert not acts(f"{error} {error.detail} {error.errors}")
    ProgressLine(sys.stderr)(Progress(f"run{ATTACK}", 1, 0, None, ATTACK))
    written = capsys.readouterr().err
    assert not acts(written.removeprefix("\r\x1b[2K"))


def test_what_is_printable_stays() -> None:
    text = 'Grüße, 你好 🤖, ½ – naïve\n\tquoted "text" \\x1b'
    assert printable(text) == text
    assert printable("a\x1b[2Jb\x00") == "a\\x1b[2Jb\\x00"
