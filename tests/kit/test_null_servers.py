"""The kit against servers that implement nothing: it says so, and passes nothing."""

from pathlib import Path
from xml.etree import ElementTree as ET

import pytest

from tests.support.kit import null_servers
from tests.support.kit.null_servers import Behaviour, run_server
from tests.support.kit.run_kit import KitRun, run_kit

pytestmark = pytest.mark.slow("starts servers or kits")

# What answers that are valid and never change may satisfy: rules on single answers,
# and rules that something does not happen. Nothing about playing, scoring, stopping,
# refusing, or resuming is among them. Shrinks when a check learns to look closer.
CANNED_ANSWERS_PASS = frozenset(
    {
        *("SVC-001", "SVC-002", "VER-001", "BEN-001", "BEN-003", "BEN-004"),
        *("RUN-001", "RUN-002", "RUN-016", "ATT-001", "ATT-011"),
        *("PRED-023", "ERR-012", "ENC-001", "LIFE-204"),
        *("RUN-033", "CONV-001", "CONV-002", "CONV-003", "SVC-006"),
    }
)


def judge(folder: Path, *options: str) -> KitRun:
    """Run the kit; expect a report in every form, also where it cannot judge."""
    kit = run_kit(folder, *options, PROCTOR_TOKEN="secret-token")
    assert kit.report
    assert (folder / "report.html").exists()
    return kit


def read_junit(folder: Path) -> ET.Element:
    return ET.fromstring((folder / "junit.xml").read_text())  # noqa: S314 - ours


@pytest.mark.parametrize(
    ("behaviour", "says"),
    [
        (null_servers.always(200), "'limits' is a required property; $: 'profiles' is"),
        (null_servers.always(404), "not a Proctor server"),
        (null_servers.always(500), "not a Proctor server"),
        (null_servers.always(200, b"[]"), "its body is JSON, but not an object"),
        (null_servers.always(401), "wants a token for GET /v1, against SVC-001"),
        (null_servers.echo, "invalid response to GET /v1"),
        (null_servers.close, "no response from"),
        (null_servers.refuse_everyone, "was rejected"),
        (null_servers.other_protocol_version, "supports protocol 7.0 to 7.2"),
        (null_servers.nginx_that_keeps_streams, "nginx, in front of the server, keeps"),
    ],
    ids=[
        "200",
        "404",
        "500",
        "list",
        "401",
        "echo",
        "close",
        "refuse_everyone",
        "version",
        "nginx",
    ],
)
def test_cannot_judge_a_null_server(
    tmp_path: Path, behaviour: Behaviour, says: str
) -> None:
    with run_server(behaviour) as url:
        kit = judge(tmp_path, "--url", url)
    assert kit.code == 2
    assert says in kit.last_line
    assert kit.last_line.startswith("not decided")
    assert kit.rules_with("passed") == set()
    assert read_junit(tmp_path).find(".//testcase[@name='preflight']/error") is not None


def test_cannot_judge_where_nothing_listens(tmp_path: Path) -> None:
    with run_server(null_servers.echo) as url:
        pass
    kit = judge(tmp_path, "--url", url)
    assert kit.code == 2
    assert "no response from" in kit.last_line


def test_canned_answers_pass_no_rule_about_playing(tmp_path: Path) -> None:
    with run_server(null_servers.canned_answers) as url:
        kit = judge(tmp_path, "--url", url)
    assert kit.code == 1
    assert kit.rules_with("passed") <= CANNED_ANSWERS_PASS
    assert kit.last_line == "NOT conformant"
    failures = read_junit(tmp_path).findall(".//failure")
    assert len(failures) == len(kit.rules_with("failed")) > 50
    assert not kit.rules_with("kit_error")
    for path in tmp_path.iterdir():
        assert "secret-token" not in path.read_text()
    assert "secret-token" not in kit.output


@pytest.mark.parametrize("processes", ["1", "2"])
def test_cannot_judge_a_server_that_dies(tmp_path: Path, processes: str) -> None:
    with run_server(
        null_servers.stop_answering_after(150, null_servers.canned_answers)
    ) as url:
        kit = judge(tmp_path, "--url", url, "-n", processes)
    assert kit.code == 2
    assert "server stopped responding during" in kit.last_line
    assert len(kit.rows) > 100


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        ([], "give --url"),
        (["--url", "localhost:8460"], "url must be like http://"),
        (["--no-such-option"], "No such option"),
        (["--profil", "core"], "Did you mean one of: '--profile'"),
        (
            ["--url", "http://x", "--profile", "limit"],
            "; did you mean limits or lists? known: core",
        ),
        (["--url", "http://x", "--only", "NOPE-001"], "no rule id"),
        (["--url", "http://x", "--profile", "fast"], "known: core"),
        (["--url", "http://x", "--known-failures", "/no/file"], "No such file"),
        (["--start-cmd", "false"], "before it served requests"),
        (["--start-cmd", "/no/such/command"], "No such file"),
    ],
)
def test_cannot_judge_with_bad_arguments(
    tmp_path: Path, arguments: list[str], says: str
) -> None:
    kit = judge(tmp_path, *arguments)
    assert kit.code == 2
    assert says in kit.last_line


@pytest.mark.parametrize(
    ("options", "says"),
    [
        (["SVC", "--profile", "crash"], "SVC is of core, strict_http, which --profile"),
        (["ATT-004", "--level", "core"], "of sessions, which --level core leaves out"),
        (["PRED-002", "--stage", "1"], "--only PRED-002 and --stage 1 select no rule"),
    ],
)
def test_cannot_judge_an_empty_selection(
    tmp_path: Path, options: list[str], says: str
) -> None:
    kit = judge(tmp_path, "--url", "http://127.0.0.1:1", "--only", *options)
    assert kit.code == 2
    assert says in kit.last_line
