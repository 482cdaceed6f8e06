"""`proctor submit, status, stop, resume, results, benchmarks` with a real server.

What people read, what scripts read, the exit codes, and every mistake in one line.
"""

import importlib.util
import json
import re
import shlex
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from conformance.specification.document import load_spec
from reference_client.command.command_line import aliases
from reference_client.command.main import main
from reference_client.command.runs import control
from reference_client.command.usage_error import UsageError
from reference_client.evaluation.parameters import WORKER_ID
from reference_sim import benchmark_registry
from tests.support.client.command import Proctor, options
from tests.support.paths import ROOT
from tests.support.servers import TOKENS, ReferenceServer

pytestmark = pytest.mark.usefixtures("policy_folder")


def one_line(text: str) -> bool:
    return text.startswith("proctor: ") and text.count("\n") == 1


def test_a_run_is_submitted_stopped_resumed_and_scored(proctor: Proctor) -> None:
    """A run by its commands. Expect 1 from `results` until it is complete."""
    run = proctor.json("submit", *options("count"), "--name", "mine", "--wait")
    assert (proctor.code, run["state"], run["policy"]) == (0, "ready", {"name": "mine"})
    run_id = run["run_id"]
    assert proctor.json("stop", run_id)["state"] == "stopped"
    assert proctor.json("status", run_id)["state"] == "stopped"
    assert proctor.json("resume", "--run-id", run_id)["state"] in ("queued", "ready")
    assert "It waits for a policy, which plays it with:" in proctor.err
    assert proctor.err.endswith(f"/pages/runs/{run_id}\n")
    assert f"run --run-id {run_id} --policy POLICY" in proctor.err
    assert proctor("results", run_id) == 1
    assert "not complete: between 0.0000 and 1.0000" in proctor.out
    assert proctor("run", "--policy", "policies:Graded", "--run-id", run_id) == 0
    score = proctor.json("results", run_id, "--episodes")
    assert (proctor.code, score["score"]) == (0, 1.0)
    assert [episode["status"] for episode in score["episodes"]] == ["scored"]
    assert proctor.json("status", run_id, "--watch")["state"] == "completed"
    assert (proctor.code, proctor.err) == (0, f"{run_id}: completed\n")


@pytest.mark.parametrize(
    ("state", "mode", "live_workers", "says"),
    [
        ("ready", None, 0, "run_1: ready; no worker plays it now"),
        ("running", "pull", 0, "run_1: running; no worker plays it now"),
        ("running", "pull", 2, "run_1: running"),
        ("running", "push", 0, "run_1: running"),
        ("failed", "pull", 0, "run_1: failed"),
    ],
)
def test_a_watched_run_says_whether_it_is_played(
    state: str, mode: str | None, live_workers: int, says: str
) -> None:
    run: Any = SimpleNamespace(
        run_id="run_1", state=SimpleNamespace(value=state), mode=mode,
        live_workers=live_workers,
    )  # fmt: skip
    assert control._played_now(run) == says


COUNTS = "0 of 1 episode is scored"
AGAIN = "then repeat this command: proctor run --run-id RUN --policy POLICY --url URL"
THE_REST = f"Play the rest, {AGAIN}"


@pytest.mark.parametrize(
    ("before", "command", "says"),
    [
        (
            "",
            "video RUN --failures",
            f"A run that is ready has no record; … {THE_REST}",
        ),
        ("", "export RUN", f"… completed. {COUNTS}. {THE_REST}"),
        ("", "publish RUN", f"The run is ready; … {COUNTS}. {THE_REST}"),
        ("stop", "publish RUN", f"The run is stopped; … {COUNTS}. {THE_REST}"),
        ("stop", "export RUN --to parquet", f"A run that is stopped … {THE_REST}"),
        (
            "play",
            "stop RUN",
            "A run that is completed cannot be stopped; nothing was …",
        ),
        ("play", "resume RUN", "A run that is completed cannot be resumed; nothing …"),
    ],
)
def test_what_a_run_is_not_ready_for_is_refused_with_what_to_do_first(
    proctor: Proctor, before: str, command: str, says: str
) -> None:
    run_id = proctor.json("submit", *options("count"), "--name", "mine")["run_id"]
    if before == "stop":
        proctor("stop", run_id)
    if before == "play":
        proctor("run", "--policy", "policies:Graded", "--run-id", run_id)
    assert proctor(*command.replace("RUN", run_id).split()) == 2
    (line,) = proctor.err.splitlines()
    expected = f"proctor: {says} [illegal_transition]"
    expected = expected.replace("URL", proctor.url).replace("RUN", run_id)
    start, _, end = expected.partition(" … ")
    assert line.startswith(start.removesuffix("…"))
    assert line.endswith(end.removeprefix("…"))
    assert "lifecycle" not in line


@pytest.fixture
def browser(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The file to which what stands in for a browser writes the address it is given."""
    program, opened = tmp_path / "browser.sh", tmp_path / "opened"
    program.write_text(f'#!/bin/sh\necho "$1" > {opened}\n')
    program.chmod(0o700)
    monkeypatch.setattr("webbrowser._tryorder", None)  # BROWSER is read once
    monkeypatch.setenv("BROWSER", f"{program} %s")
    return opened


ASKS = "The pages ask for a token once:"


def test_the_page_of_a_run_is_opened(
    proctor: Proctor, server: ReferenceServer, browser: Path
) -> None:
    """Expect the address in the browser and printed; with --print nothing opened."""
    run_id = proctor.json("submit", *options("score"))["run_id"]
    page = f"{server.url}/pages/runs/{run_id}"
    assert proctor("open", run_id, "--print") == 0
    assert (proctor.out, proctor.err) == (f"{page}\n", "")
    assert not browser.exists()
    assert proctor.json("open", run_id) == {"url": page, "opened": True}
    assert browser.read_text() == f"{page}\n"
    assert proctor.err == f"{ASKS} paste the value of PROCTOR_TOKEN.\n"
    assert proctor("open") == 0
    assert browser.read_text() == proctor.out == f"{server.url}/pages\n"
    assert proctor("open", "run_none") == 2
    assert "There is no run run_none" in proctor.err
    assert one_line(proctor.err)


def test_the_address_is_said_where_no_browser_starts(
    proctor: Proctor, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("webbrowser.open", lambda _address: False)
    assert proctor("open") == 0
    assert proctor.out.endswith("/pages\n")
    assert "no browser can be started here; open the address in one" in proctor.err


def test_no_browser_of_a_terminal_is_started_unasked(
    proctor: Proctor, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Without a display a text browser would take the terminal."""
    for name in ("DISPLAY", "WAYLAND_DISPLAY", "BROWSER"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setattr("sys.platform", "linux")
    monkeypatch.setattr("webbrowser.open", lambda _address: pytest.fail("started"))
    assert proctor.json("open")["opened"] is False


def test_the_place_of_a_token_that_was_given_is_the_flag(
    proctor: Proctor, browser: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("PROCTOR_TOKEN", "another")
    assert proctor("open", "--token", TOKENS["alice"]) == 0
    assert browser.is_file()
    assert proctor.err == f"{ASKS} paste the value of --token.\n"


@pytest.mark.slow("starts a server without pages")
def test_a_server_without_pages_is_named(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    with ReferenceServer(tmp_path, PROCTOR_PAGES="off") as server:
        proctor = Proctor(server.url, capsys)
        assert proctor("open") == 2
        assert f"{server.url} has no pages" in proctor.err
        assert one_line(proctor.err)


def test_a_url_with_the_version_is_recognised(
    server: ReferenceServer, capsys: pytest.CaptureFixture[str]
) -> None:
    """It stands in every example with curl, so it is pasted here, too."""
    pasted = (
        ("status", "--url", f"{server.url}/v1/"),
        ("verify", "x.proctor", "--server", f"{server.url}/v1"),
    )
    for words in pasted:
        assert main([*words]) == 2
        said = capsys.readouterr().err
        assert "This server has no such path. Leave /v1 out of the base URL" in said
        assert "Try the URL" not in said
        assert "accounts" not in said
    assert main(["status", "run_none", "--url", server.url]) == 2
    assert "/v1" not in capsys.readouterr().err


def required(requirements: str) -> set[str]:
    """The modules that an extra installs, as far as they have a package's name."""
    lines = (ROOT / "requirements" / requirements).read_text().splitlines()
    return {re.split("[^a-z_]", line.replace("-", "_"))[0] for line in lines}


@pytest.mark.parametrize("command", ["serve", "admin", "replay", "conformance"])
def test_a_program_of_another_extra_is_refused_in_one_line(
    proctor: Proctor, monkeypatch: pytest.MonkeyPatch, command: str
) -> None:
    """Only the client is installed. Expect what to install, and no traceback."""
    absent = required("server.in") | required("kit.in")
    absent -= required("client.in")
    find_spec = importlib.util.find_spec
    monkeypatch.setattr(
        importlib.util,
        "find_spec",
        lambda name: None if name in absent else find_spec(name),
    )
    monkeypatch.setattr("os.execv", lambda *_: pytest.fail("it was started"))
    assert proctor(command) == 2
    assert one_line(proctor.err)
    assert "which is not installed: pip install" in proctor.err


def test_a_run_that_was_never_played_is_deleted(proctor: Proctor) -> None:
    """Expect no run afterwards; a played one is kept without --yes, and by the host."""
    unplayed = proctor.json("submit", *options("score"), "--wait")["run_id"]
    assert proctor.json("delete", unplayed) == {"deleted": unplayed}
    assert proctor("status", unplayed) == 2
    assert "not_found" in proctor.err
    played = proctor.json("run", "--policy", "policies:Graded", *options("count"))
    assert proctor("delete", played["run_id"]) == 2
    assert "--yes" in proctor.err
    assert proctor("delete", played["run_id"], "--yes") == 2
    assert "not_deletable" in proctor.err
    assert proctor("status", played["run_id"]) == 0


def test_the_submitter_is_recorded(proctor: Proctor) -> None:
    """Every flag about the policy arrives in the run."""
    flags = "--name n --type VLA --policy-version 2 --submitter s --homepage http://h"
    lease = ["--idle-timeout-s", "5", "--max-workers", "2", "--images", "png:64x48"]
    run = proctor.json("submit", *options("echo"), *flags.split(), *lease)
    assert run["policy"] == {
        "name": "n (VLA)",
        "version": "2",
        "submitter": "s",
        "homepage": "http://h",
    }
    assert (run["idle_timeout_s"], run["max_workers"]) == (5, 2)
    assert run["images"] == {"codec": "png", "width": 64, "height": 48}


def test_gmp_commands_are_accepted(
    server: ReferenceServer, capsys: pytest.CaptureFixture[str]
) -> None:
    """The command of EBench's manual, with our benchmark. Expect a ready run."""
    line = "--benchmark_set calibration --model_name internVLA --model_type VLA"
    submitter = "--submitter_name test --submitter_homepage http://h --is_public 0"
    place = ["--base_url", server.url, "--interval", "5", "--json"]
    assert main(["online", "submit", *place, *f"{line} {submitter}".split()]) == 0
    out, err = capsys.readouterr()
    run = json.loads(out)
    assert run["policy"]["name"] == "internVLA (VLA)"
    assert run["policy"]["submitter"] == "test"
    assert err.count("is ignored") == 2
    host, _, port = server.url.removeprefix("http://").partition(":")
    again = ["--host", host, "--port", port, "--task_id", run["run_id"]]
    assert main(["online", "submit", *again, "--print_endpoint"]) == 0
    assert capsys.readouterr().out == f"{run['endpoint']}\n"
    play = ["--policy", "policies:best", "--worker_ids", "0,1", "--json"]
    assert main(["eval", *again, *play]) == 0
    assert json.loads(capsys.readouterr().out)["score"] == 1.0


def test_an_entry_is_not_published_against_is_public() -> None:
    for words in (["--is_public", "0"], ["--is-public=False"]):
        given = ["publish", *words, "run_1"]
        assert aliases.translate(given) == (["publish", "--private", "run_1"], [])
    given = ["publish", "run_1", "--is_public", "1"]
    assert aliases.translate(given) == (["publish", "run_1"], [])
    with pytest.raises(UsageError, match="expected 1 or 0"):
        aliases.translate(["publish", "--is_public", "run_1"])


def test_aliases_do_not_apply_to_passed_through_arguments() -> None:
    arguments = ["conformance", "--url", "u", "--is_public"]
    assert aliases.translate(arguments) == (arguments, [])
    kept = ["run", "--", "--task_id"]
    assert aliases.translate(kept)[0] == kept
    renamed, *_ = aliases.translate(["status", "--task_id=a_b"])
    assert renamed == ["status", "--run-id=a_b"]


def test_benchmarks_are_listed_and_described(
    proctor: Proctor, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("COLUMNS", "80")
    assert proctor("benchmarks") == 0
    count = benchmark_registry.resolve("tabletop_state").manifest["episodes_total"]
    row = rf"^tabletop_state +\S+ +{count} +Tabletop"
    assert re.search(row, proctor.out, re.MULTILINE)
    assert proctor("benchmarks", "tabletop_state") == 0
    assert re.search(r"action\.joint_position +7 +rad", proctor.out)
    assert max(map(len, proctor.out.splitlines())) <= 80
    assert proctor.json("benchmarks", "calibration")["tasks"][0] == "score"


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("submit", "--benchmark NAME"),
        ("submit --benchmark none", "not_found"),
        ("submit --benchmark NO", "benchmark_id"),
        ("submit CALIBRATION --options {", "invalid JSON"),
        ("submit CALIBRATION --images raw", "jpeg:224x224"),
        ("submit CALIBRATION --max-workers 0", "expected an integer"),
        ("board calibration --manifest abc", "abc: expected a SHA-256"),
        ("board calibration --manifest=", "it is empty: expected a SHA-256"),
        ("submit CALIBRATION --max-workers 999", "allows 16 per run"),
        ("status run_none", "not_found"),
        ("status run_a --run-id run_b", "conflicting run ids"),
        ("stop", "a run id is required"),
        ("results --what", "--help"),
        ("run", "my_module:MyPolicy"),
        ("run --policy policies:Graded", "--benchmark NAME"),
        ("run CALIBRATION --policy policies:None_", "has no None_"),
        ("run CALIBRATION --policy nowhere:X", "no module nowhere"),
        ("run CALIBRATION --policy none.py:X", "no file none.py"),
        ("run CALIBRATION --policy policies", "my_module:MyPolicy"),
        ("run CALIBRATION --policy policies:answer", "is not callable"),
        ("run CALIBRATION --policy policies:NoReset", "reset"),
        ("run CALIBRATION --policy policies:Unmakeable", "no such weights"),
        ("run CALIBRATION --policy policies:NoReset --processes", "reset"),
        ("run CALIBRATION --policy openpi:ws://x", "--mapping FILE"),
        ("run CALIBRATION --policy openpi:8000", "ws://127.0.0.1"),
        (
            "run CALIBRATION --policy policies:best --mapping none",
            "there is no file none",
        ),
        ("run CALIBRATION --policy policies:best --worker-ids a,a", "must differ"),
        ("run CALIBRATION --policy policies:best --worker-ids a.b", "A-Z a-z 0-9"),
        (
            "run CALIBRATION --policy policies:best --view --view-port 99999",
            "view-port",
        ),
        ("rnu", "unknown command rnu; did you mean run?"),
        ("status --stat x", "unknown option --stat; did you mean --state?"),
        ("submit --assumes {}", "--assumes is an option of proctor run only"),
        ("status --state runing", "unknown value runing; did you mean running?"),
        ("status --watch", "--watch needs a run id"),
        (
            "submit CALIBRATION --homepage example.org",
            "--homepage must begin with http:// or https:// and have no spaces, not",
        ),
        ("publish run_a --homepage example.org", "--homepage must begin with http"),
        ("publish run_a --code-url x.org", "--code-url must begin with http"),
        ("benchmarks calibratoin", "did you mean calibration?"),
        ("submit --benchmark calibratoin", "did you mean calibration?"),
        ("results run/1", "'run/1' is no id of a run; `proctor status` lists them"),
        ("compare run_a b!", "'b!' is no id of a run"),
        ("submit --benchmark Calibration!", "lower-case letters, digits and _"),
        ("run CALIBRATION --policy policies:Gradd", "mean Graded?"),
        (
            "submit CALIBRATION --options '{\"taks\":[]}'",
            "options has no member 'taks'; did you mean tasks?",
        ),
        (
            "submit CALIBRATION --idle-timeout-s 0.1",
            "idle_timeout_s must be at least 1.0, not 0.1",
        ),
    ],
)
def test_a_usage_error_is_one_line_with_exit_code_2(
    proctor: Proctor, line: str, message: str
) -> None:
    """Expect what is wrong or was meant, without a pattern or a sentence of a library,
    nothing on the standard output, and no run left behind."""
    before = proctor.json("status")
    line = line.replace("CALIBRATION", "--benchmark calibration")
    assert proctor(*shlex.split(line)) == 2
    assert one_line(proctor.err), proctor.err
    assert message in proctor.err
    assert not re.search(r"regular expression|\^\[|validation|constrained", proctor.err)
    assert proctor.out == ""
    assert proctor.json("status") == before


def test_a_script_reads_errors_too(proctor: Proctor) -> None:
    printed = proctor.json("status", "run_none")
    assert (proctor.code, printed["error"]["code"]) == (2, "not_found")
    printed = proctor.json("stop")
    assert (proctor.code, printed["error"]["code"]) == (2, "usage")


def test_an_unreachable_server_gives_code_2(capsys: pytest.CaptureFixture[str]) -> None:
    place = ["--url", "http://127.0.0.1:9", "--retry-timeout-s", "0"]
    run = ["run", "--policy", "policies:best", *options("count")]
    for command in (["status"], run):
        assert main([*command, *place]) == 2
        message = capsys.readouterr().err.splitlines()[-1]
        assert re.match(r"proctor: .*is unreachable.*\[unreachable\]", message)
    assert main(["status", "--url", "nowhere"]) == 2
    assert "url must be like" in capsys.readouterr().err


def test_debug_prints_a_traceback(proctor: Proctor) -> None:
    assert proctor("status", "run_none", "--debug") == 2
    assert "Traceback" in proctor.err


def test_ids_of_workers_are_those_of_the_specification() -> None:
    parameters = load_spec().document["components"]["parameters"]
    assert parameters["WorkerId"]["schema"]["pattern"] == f"^{WORKER_ID.pattern}$"
