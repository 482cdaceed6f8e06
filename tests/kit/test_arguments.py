"""The command line: what would run, what is left when time is up, what was meant, and
failures that the implementer knows of.
"""

import itertools
import json
import re
import shlex
import subprocess
import sys
import time
from collections.abc import Callable, Sequence
from pathlib import Path

import pytest

from conformance.cli.arguments import (
    parse_arguments,
    read_processes,
    read_selection,
    read_settings,
)
from conformance.cli.kit_command import BadArguments
from conformance.cli.main import main
from conformance.policy.__main__ import main as main_policy
from conformance.run_settings import Settings
from conformance.simulator.__main__ import main as main_simulator
from conformance.specification.ledger import load_ledger
from conformance.verdicts.expect import VIOLATION_FOUND
from conformance.verdicts.verdict import Outcome, Verdict
from tests.mutants.fork_servers import mutant_command
from tests.support.forking import forked_servers
from tests.support.kit.concluded_results import concluded
from tests.support.kit.run_kit import run_kit
from tests.support.paths import ROOT

pytestmark = pytest.mark.slow("starts servers or kits")


def server_command(*options: str) -> str:
    return shlex.join([*forked_servers.server_command(), *options])


def mutant() -> str:
    """The command of a server with one wrong row, PRED-004."""
    return shlex.join([*mutant_command(), "names_the_wrong_expected_seq"])


def test_dry_run_lists_checks_and_sends_nothing(tmp_path: Path) -> None:
    kit = run_kit(tmp_path, "--dry-run", "--only", "PRED-00,AUTH")
    assert kit.code == 0
    assert not kit.report
    assert load_ledger()["PRED-004"].text in kit.output
    assert "test_pred_004_cannot_skip_or_go_back" in kit.output
    assert "LEASE-" not in kit.output
    said = "no request was sent; 3 of the 17 selected rules are not observable"
    assert said in kit.last_line


def test_an_empty_dry_run_is_no_success(tmp_path: Path) -> None:
    kit = run_kit(tmp_path, "--dry-run", "--only", "SVC", "--profile", "crash")
    assert kit.code == 2
    assert "no rule is left" in kit.output


@pytest.mark.parametrize("columns", ["40", "80", "0", "-1", "wide"])
@pytest.mark.parametrize("program", [main, main_policy, main_simulator])
def test_the_help_fits_the_terminal(
    program: Callable[[Sequence[str]], int],
    columns: str,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.setenv("COLUMNS", columns)
    with pytest.raises(SystemExit, match="0"):
        program(["--help"])
    longest = max(map(len, capsys.readouterr().out.splitlines()))
    known = columns if columns in ("40", "80") else "80"
    assert int(known) // 2 < longest <= int(known)


def test_list_takes_a_choice(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["--list", "--only", "ATT-003"]) == 0
    assert capsys.readouterr().out.startswith("ATT-003  MUST  core  ")


@pytest.mark.parametrize(
    ("arguments", "processes"),
    [
        ([], 3),
        (["--only", "ATT"], 1),
        (["--quick"], 4),
        (["--quick", "-n", "1"], 1),
        (["--quick", "--only", "ATT"], 1),
        (["--quick", "--fail-fast"], 1),
        (["-n", "2"], 2),
    ],
)
def test_a_selection_takes_one_process(arguments: list[str], processes: int) -> None:
    """One keeps the order of --only, and the place where --fail-fast ends."""
    assert read_processes(parse_arguments(arguments)) == processes


@pytest.mark.parametrize(
    ("arguments", "longest_s"),
    [
        ([], 50),
        (["--level", "core"], 50),
        (["--history-time", "7", "--only", "ATT"], 7),
        (["--history-time", "0"], 0),
        (["--only", "ATT"], 0),
        (["--quick"], 0),
        (["--profile", "core"], 0),
        (["--max-time", "9"], 0),
        (["--minutes", "9"], 0),
        (["--fail-fast"], 0),
    ],
)
def test_a_whole_run_has_time_for_histories(
    arguments: list[str], longest_s: int
) -> None:
    began_at = time.monotonic()
    given = ["--url", "http://127.0.0.1:1", "--token", "t", *arguments]
    settings = read_settings(parse_arguments(given))
    assert settings.rounds_until - longest_s >= began_at
    assert settings.rounds_until - longest_s <= time.monotonic()


@pytest.mark.parametrize(
    ("limits", "has_room"),
    [({}, True), ({"max_idempotency_keys": 300}, False), ({"max_stored_bytes": 9}, 0)],
)
def test_small_quotas_leave_no_room_for_more_histories(
    limits: dict[str, int], has_room: bool
) -> None:
    assert Settings(service={"limits": limits}).has_room_for_rounds == has_room


@pytest.mark.parametrize(("quick", "are_apart"), [(True, True), (False, False)])
def test_quick_mixes_the_checks_of_the_files(quick: bool, are_apart: bool) -> None:
    """Those of one file wait alike, so all processes would wait at one time."""
    code = (
        "import json; from conformance.run_settings import Settings;"
        "from conformance.runner.execution import list_checks;"
        "names = ['core', 'push']; service = {'profiles': names};"
        f"chosen = Settings(quick={quick}, profiles=names, service=service);"
        "print(json.dumps([row[0] for row in list_checks(chosen)]))"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], cwd=ROOT, capture_output=True, check=True
    )
    ids = json.loads(done.stdout.splitlines()[-1])
    places = [n for n, name in enumerate(ids) if name.startswith("PUSH-")]
    distances = [after - before for before, after in itertools.pairwise(places)]
    assert len(places) > 5
    assert (min(distances) > 1) == are_apart


@pytest.mark.parametrize("processes", ["0", "2"])
def test_rules_after_the_time_limit_are_not_verified(
    tmp_path: Path, processes: str
) -> None:
    arguments = ("--start-cmd", server_command(), "--max-time", "0.1", "-n", processes)
    kit = run_kit(tmp_path, *arguments)
    assert kit.code == 2
    assert "time limit reached (--max-time 0.1)" in kit.last_line
    ledger = load_ledger()
    off = [
        *("ebench", "flageval", "public_board", "record_import", "cluster", "hosting"),
        "physical",
    ]
    not_offered = {rule for rule in kit.rows if ledger[rule].profile in off}
    assert kit.rules_with("not_applicable") == not_offered
    assert kit.rules_with("not_verified") == kit.rows.keys() - not_offered


@pytest.mark.parametrize(
    ("outcome", "is_known", "code"),
    [
        (Outcome.PASSED, False, 2),
        (Outcome.FAILED, False, 1),
        # What follows from a known failure is excused; a check not started is not.
        (Outcome.FAILED, True, 2),
    ],
)
def test_the_time_limit_hides_no_violation(
    outcome: Outcome, is_known: bool, code: int
) -> None:
    settings = Settings(only=["ATT-001", "ATT-003"], profiles=["core"])
    first = Verdict("ATT-003", outcome)
    left = Verdict("ATT-001", Outcome.NOT_VERIFIED, "time limit reached (--max-time 5)")
    known = ["ATT-003"] if is_known else []
    assert concluded(settings, first, left, known=known).exit_code == code


@pytest.mark.parametrize(
    ("wanted", "says"),
    [
        ("PRDE-004", "did you mean PRED-004"),
        ("pred-004", "did you mean PRED-004"),
        ("ATT-999", "did you mean ATT-0"),
        ("LEESE", "did you mean LEASE?"),
        ("zzz", "areas: SVC, "),
    ],
)
def test_unknown_id_gets_a_suggestion(wanted: str, says: str) -> None:
    options = parse_arguments(["--only", wanted])
    with pytest.raises(BadArguments) as caught:
        read_selection(options)
    assert str(caught.value).startswith(
        f"--only {wanted}: no rule id starts with {wanted}"
    )
    assert says in str(caught.value)


@pytest.mark.parametrize("name", ["--only", "--profile", "--url"])
def test_a_list_is_given_once(name: str) -> None:
    with pytest.raises(BadArguments, match=f"{name} is given twice.*with commas"):
        parse_arguments([name, "1", f"{name}=2"])
    assert parse_arguments(["--quick", "--quick", "--seed=1", "--seed=2"]).seed == 2


@pytest.mark.parametrize("seconds", ["0", "-1", "nan"])
def test_the_time_limit_must_be_positive(tmp_path: Path, seconds: str) -> None:
    time = f"--max-time={seconds}"
    kit = run_kit(tmp_path, "--url", "http://127.0.0.1:1", time)
    assert kit.code == 2
    assert "must be greater than 0" in kit.output


# --- services of several base URLs ---


@pytest.mark.parametrize(
    ("options", "says"),
    [
        (["--url", "http://a,b"], "--url: url must be like http://"),
        (["--url", "http://a,http://a/"], "a base URL stands twice"),
        (["--url", "http://a", "--nodes", "2"], "--nodes needs --start-cmd"),
        (["--start-cmd", "x", "--nodes", "0"], "--nodes 0: must be 1 to 9"),
    ],
)
def test_base_urls_are_read(options: list[str], says: str) -> None:
    with pytest.raises(BadArguments, match=re.escape(says)):
        read_settings(parse_arguments(options))
    good = parse_arguments(["--url", "http://a/, http://b"])
    assert read_settings(good).urls == ["http://a", "http://b"]


def test_nodes_are_started_and_judged_across(tmp_path: Path) -> None:
    """Expect the rules of the profile `cluster` judged, and requests at both nodes."""
    command = server_command("--cluster", "on", "--recordings", "off")
    options = ("--nodes", "2", "--only", "CLU-001,CLU-002,SVC-001", "--exchanges")
    kit = run_kit(tmp_path, "--start-cmd", command, *options)
    assert kit.code == 0, kit.output
    assert set(kit.outcomes.values()) == {"passed"}
    logs = [tmp_path / "server.log", tmp_path / "server-2.log"]
    assert all(log.stat().st_size for log in logs)


# --- known failures ---


def test_known_failure_is_excused_and_a_stale_one_is_not(tmp_path: Path) -> None:
    known = tmp_path / "known"
    known.write_text("PRED-004  # fixed in our next release\n")
    options = ("--only", "PRED-003,PRED-004", "--known-failures", str(known))
    kit = run_kit(tmp_path, "--start-cmd", mutant(), *options)
    assert kit.code == 0, kit.output
    assert kit.outcomes == {"PRED-003": "passed", "PRED-004": "failed"}
    assert "known fail." in kit.output
    said = "every MUST that is violated is a known failure (PRED-004)"
    assert kit.last_line == f"NOT conformant (selected rules): {said}"
    assert "#c62828" in (tmp_path / "badge.svg").read_text()

    kit = run_kit(tmp_path, "--start-cmd", server_command(), *options)
    assert kit.code == 1
    assert kit.report["stale_known_failures"] == ["PRED-004"]
    assert kit.last_line.startswith("PRED-004 passes now: take the line out")


def test_known_failure_excuses_no_other(tmp_path: Path) -> None:
    known = tmp_path / "known"
    known.write_text("PRED-003  # not the one that fails\n")
    only = ("--only", "PRED-004")
    arguments = ("--start-cmd", mutant(), *only, "--known-failures", str(known))
    kit = run_kit(tmp_path, *arguments)
    assert kit.code == 1
    assert kit.report["stale_known_failures"] == []


def test_known_failure_with_an_unknown_id_is_refused(tmp_path: Path) -> None:
    known = tmp_path / "known"
    known.write_text("PRDE-004  # a slip\n")
    where = ("--url", "http://127.0.0.1:1", "--known-failures", str(known))
    kit = run_kit(tmp_path, *where)
    assert kit.code == 2
    said = "line 1: unknown rule id PRDE-004; did you mean PRED-004"
    assert said in kit.output


@pytest.mark.parametrize("only", ["PRED-004,LIFE-201", "LIFE-201,PRED-004"])
def test_fail_fast_ends_at_the_first_violation(tmp_path: Path, only: str) -> None:
    """A mutant with one wrong row. Expect what --only names after it not verified."""
    options = ("--fail-fast", "--only", only)
    kit = run_kit(tmp_path, "--start-cmd", mutant(), *options)
    assert kit.code == 1
    assert kit.outcomes["PRED-004"] == "failed"
    if only.startswith("LIFE"):
        assert kit.outcomes["LIFE-201"] == "passed"
    else:
        assert kit.outcomes["LIFE-201"] == "not_verified"
        assert kit.rows["LIFE-201"]["reason"] == VIOLATION_FOUND


def test_fail_fast_and_known_failures_exclude_each_other(tmp_path: Path) -> None:
    file = tmp_path / "known"
    file.write_text("ATT-001 # a reason\n")
    options = ("--url", "http://127.0.0.1:1", "--known-failures", str(file))
    kit = run_kit(tmp_path, *options, "--fail-fast")
    assert kit.code == 2
    assert "exclude each other" in kit.output
