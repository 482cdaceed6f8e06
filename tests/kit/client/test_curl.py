"""The script on a failure card does what it says: on a fresh server it finds the same
wrong answer. Each is taken from the kit's output and run by bash, with nothing more
than curl and python3 at hand.
"""

import re
import shlex
import shutil
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from conformance.runner.server_process import AccountTokens, ServerProcess, claim_port
from tests.mutants.fork_servers import mutant_command
from tests.support.kit.run_kit import run_kit

TOOLS = ("bash", "base64", "curl", "python3", "sleep", "tee")


@pytest.fixture
def few_tools(tmp_path: Path) -> Path:
    """A PATH with no more than a fresh machine has; in particular no jq."""
    directory = tmp_path / "bin"
    directory.mkdir()
    for tool in TOOLS:
        found = shutil.which(tool)
        assert found is not None, f"these tests need {tool}"
        (directory / tool).symlink_to(sys.executable if tool == "python3" else found)
    return directory


@contextmanager
def start_mutant(mutant: str, directory: Path) -> Iterator[dict[str, str]]:
    """A fresh mutant, as the variables of the script."""
    tokens = AccountTokens.generate()
    command = shlex.join([*mutant_command(), mutant])
    log = directory / "server.log"
    with claim_port() as port:
        server = ServerProcess(command, tokens, directory=directory, port=port, log=log)
        try:
            server.start()
            yield {
                "URL": server.url,
                "TOKEN": tokens.alice,
                "TOKEN_2": tokens.bob,
                "TOKEN_READ": tokens.reader,
            }
        finally:
            server.stop()


def printed_script(mutant: str, requirement_id: str, report: Path) -> str:
    """What the kit prints of a mutant to be repeated."""
    server = shlex.join([*mutant_command(), mutant])
    options = ("--start-cmd", server, "--seed", "1", "--only", requirement_id)
    kit = run_kit(report, *options)
    assert kit.code == 1, kit.output
    card = kit.output.partition("\n  reproduce ")[2].splitlines()
    lines = [line[4:] for line in card if line.startswith("    ") and line[4] != " "]
    assert lines == kit.rows[requirement_id]["script"].splitlines()
    return "\n".join(lines)


# What a mutant answers wrongly: status, and a part of the body.
@pytest.mark.slow("starts servers and kits")
@pytest.mark.parametrize(
    ("mutant", "requirement_id", "answered"),
    [
        ("names_the_wrong_expected_seq", "PRED-004", ("409", '"expected_seq":2')),
        ("answers_another_body_under_the_same_seq", "PRED-003", ("200", '"seq":1')),
        (
            "goes_on_serving_a_superseded_session",
            "ATT-005",
            ("409", "seq_out_of_order"),
        ),
        ("calls_a_partial_score_complete", "SCORE-005", ("200", '"complete":true')),
        ("lets_readers_write", "AUTH-005", ("201", '"run_id"')),
        # It waits for the end of a lease.
        ("never_ends_a_lease", "LEASE-001", ("200", '"seq":2')),
        # It asks again before the first request was answered.
        ("refuses_a_repeat_in_flight", "PRED-005", ("409", "seq_conflict")),
        # It resumes after events that were sent before.
        ("restarts_the_stream_on_reconnect", "EVT-005", ("200", "event: episode")),
        # Its body is MessagePack.
        ("reads_messagepack_extensions", "ENC-008", ("422", "invalid_request")),
    ],
)
@pytest.mark.slow("starts a server and the kit")
def test_script_finds_the_same_wrong_answer(
    tmp_path: Path,
    few_tools: Path,
    mutant: str,
    requirement_id: str,
    answered: tuple[str, str],
) -> None:
    text = printed_script(mutant, requirement_id, tmp_path / "report")
    with start_mutant(mutant, tmp_path) as variables:
        done = subprocess.run(
            ["bash", "-c", text],
            cwd=tmp_path,
            env=variables | {"PATH": str(few_tools)},
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            timeout=60,
            check=False,
        )
    output = done.stdout.decode(errors="replace")
    assert done.returncode == 0, output
    answers = re.findall(r"(.*?)\n→ (\d+)", output, re.DOTALL)
    # What is waited for is not shown.
    assert len(answers) == text.count("\n# → ") - text.count("\nwait_for state ")
    is_beside = "\nwait" in text
    status, part = answered
    wrong = [said for said in answers if said[1] == status and part in said[0]]
    assert wrong[-1:] == answers[-1:] or (is_beside and wrong), output


@pytest.mark.slow("starts a server or a kit")
def test_script_asks_for_what_it_needs(tmp_path: Path, few_tools: Path) -> None:
    text = printed_script(
        "names_the_wrong_expected_seq", "PRED-004", tmp_path / "report"
    )
    done = subprocess.run(
        ["bash", "-c", text],
        env={"PATH": str(few_tools), "URL": "http://127.0.0.1:1"},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode != 0
    assert "TOKEN: a token with the scopes read and run" in done.stderr
