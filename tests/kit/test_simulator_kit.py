"""The kit for simulators: it passes a right one, and fails exactly what each broken one
breaks.
"""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path

import pytest

from conformance.simulator.__main__ import main as simulator_main
from conformance.specification.ledger import SIMULATOR, load_ledger
from tests.support.cells import breakable_robot
from tests.support.example_simulators import build_example
from tests.support.kit.run_kit import KitRun, run_simulator_kit
from tests.support.sim import breakable_simulator

pytestmark = pytest.mark.slow("starts kits, and each of them many simulators")

PROGRAM = [sys.executable, "-S", breakable_simulator.__file__]
LATE = ("SIM-003", "SIM-023", "SIM-027")  # these are waited for, three times
OF_PROCESSES = {"SIM-022", "SIM-023", "SIM-024"}
OF_SOCKETS = {"SIM-026", "SIM-027", "SIM-028"}
OF_ROBOTS = {"SIM-031", "SIM-033", "SIM-034", "SIM-035", "SIM-036"}
UNSEEN_OF_ROBOTS = {"SIM-029", "SIM-030", "SIM-032"}
ROBOT = [sys.executable, "-S", breakable_robot.__file__]
RULES = [
    row.id
    for row in load_ledger().values()
    if row.profile == SIMULATOR and row.is_observable
]


def judge(folder: Path, *options: str, command: list[str] = PROGRAM) -> KitRun:
    return run_simulator_kit(folder, "--seed", "1", *options, command=command)


@contextmanager
def listening(folder: Path, *command: str) -> Iterator[list[str]]:
    """Start a program that listens at a socket; gives its address as a command."""
    address = f"unix:{folder}/sim.sock"
    started = subprocess.Popen([*command, address], start_new_session=True)
    try:
        yield [address]
    finally:
        os.killpg(started.pid, signal.SIGKILL)  # its connections are its children
        started.wait()


def require_conformant(kit: KitRun, not_applicable: set[str]) -> None:
    assert (kit.code, kit.report["problem"]) == (0, None), kit.output
    assert kit.rules_with("not_applicable") == not_applicable
    assert kit.rules_with("passed") == {*RULES} - not_applicable
    assert kit.report["conclusion"] == "conformant"


def test_a_right_simulator_is_conformant(tmp_path: Path) -> None:
    kit = judge(tmp_path)
    require_conformant(kit, OF_SOCKETS | OF_ROBOTS | UNSEEN_OF_ROBOTS)
    assert kit.rules_with("not_verified") == set()


def test_episodes_that_cannot_be_compared_fail_repeatability_alone(
    tmp_path: Path,
) -> None:
    """A draw without the seed is no fault against the rules that compare episodes."""
    kit = judge(tmp_path, command=[*PROGRAM, "draws_without_the_seed"])
    assert kit.rules_with("failed") <= {"SIM-011", "SIM-012"}, kit.output
    assert "SIM-011" in kit.rules_with("failed")
    compared = {"SIM-006", "SIM-010", "SIM-019", "SIM-020"}
    assert kit.rules_with("not_verified") == compared
    rows = kit.report["rows"]
    reasons = {row["reason"] for row in rows if row["requirement_id"] in compared}
    text = "equal seeds and actions give other episodes on this simulator; see SIM-011"
    assert reasons == {text}


def test_a_task_that_cannot_be_reset_breaks_one_rule_alone(tmp_path: Path) -> None:
    """The rest is judged by the other task. Expect the task and its seed."""
    kit = judge(tmp_path, command=[*PROGRAM, "refuses_a_task"])
    assert (kit.code, kit.rules_with("failed")) == (1, {"SIM-010"}), kit.output
    assert kit.rules_with("not_verified") == set()
    assert "an episode of task hold with seed 1" in " ".join(kit.output.split())


def test_a_right_simulator_at_a_socket_is_conformant(tmp_path: Path) -> None:
    with listening(tmp_path, *PROGRAM, "") as address:
        kit = judge(tmp_path, command=address)
        require_conformant(kit, OF_PROCESSES | OF_ROBOTS | UNSEEN_OF_ROBOTS)


@pytest.mark.parametrize("language", ["python", "cpp"])
def test_a_right_robot_is_conformant(language: str, tmp_path: Path) -> None:
    """It declares no digest, no pictures and no equal episodes."""
    command = ROBOT
    if language == "cpp":
        command = build_example("counting_robot.cpp", tmp_path)
    other = {"SIM-011", "SIM-012", "SIM-017", "SIM-018", "SIM-020", "SIM-021"}
    other |= {"SIM-037"}
    require_conformant(judge(tmp_path, command=command), OF_SOCKETS | other)


@pytest.mark.parametrize("example", ["numpy_world.py", "go_world", "drawn_world.cpp"])
def test_an_example_is_conformant_at_a_socket(example: str, tmp_path: Path) -> None:
    """One world and many, of both libraries and of none."""
    rules = ",".join(OF_SOCKETS | {"SIM-001", "SIM-021", "SIM-025"})
    with listening(tmp_path, *build_example(example, tmp_path)) as address:
        kit = judge(tmp_path, "--only", rules, command=address)
    assert (kit.code, kit.rules_with("failed")) == (0, set()), kit.output


def judge_broken(rule: str, folder: Path, *options: str) -> None:
    with ExitStack() as stack:
        command = [*(ROBOT if rule in OF_ROBOTS else PROGRAM), rule]
        if rule in OF_SOCKETS:
            command = stack.enter_context(listening(folder, *command))
            options = ("--start-timeout", "2", *options)
        kit = judge(folder, *options, command=command)
    assert kit.rules_with("failed") == {rule}, kit.output
    assert kit.code == (1 if load_ledger()[rule].level == "MUST" else 0)


@pytest.mark.parametrize("rule", [rule for rule in RULES if rule not in LATE])
def test_a_broken_simulator_fails_its_rule(rule: str, tmp_path: Path) -> None:
    judge_broken(rule, tmp_path, "--only", rule)


@pytest.mark.parametrize(
    "fault", [*breakable_simulator.NO_BOOLEANS, "stages_with_the_goal"]
)
def test_a_member_of_a_wrong_type_fails_the_rule_of_members(
    fault: str, tmp_path: Path
) -> None:
    kit = judge(tmp_path, "--only", "SIM-004", command=[*PROGRAM, fault])
    assert (kit.code, kit.rules_with("failed")) == (1, {"SIM-004"}), kit.output


def test_a_simulator_that_is_not_graded_may_name_stages(tmp_path: Path) -> None:
    """It sends no score, which none of its stages is counted by."""
    kit = judge(tmp_path, "--only", "SIM-016,SIM-037", command=[*PROGRAM, "ungraded"])
    assert (kit.code, kit.rules_with("passed")) == (0, {"SIM-016"}), kit.output
    assert kit.rules_with("not_applicable") == {"SIM-037"}


def test_a_truth_that_the_library_refuses_is_seen_as_its_fault(tmp_path: Path) -> None:
    command = [*PROGRAM, "world_reports_text"]
    kit = judge(tmp_path, "--only", "SIM-004", command=command)
    assert kit.rules_with("passed") == set(), kit.output
    assert kit.code != 0
    reasons = [row["reason"] for row in kit.report["rows"]]
    assert any("success is 'no' (str), and must" in str(text) for text in reasons)


@pytest.mark.parametrize(
    ("fault", "notes"),
    [
        ("", []),
        (
            "ignores_the_seed",
            ["seeds 1 and 2 give the same episode of count, hold"],
        ),
        (
            "has_mistyped_members",
            ["its description has `control_rate`, which is ignored; did you mean "],
        ),
    ],
)
def test_a_likely_mistake_that_breaks_no_rule_is_a_note(
    fault: str, notes: list[str], tmp_path: Path
) -> None:
    kit = judge(tmp_path, "--only", "SIM-011", command=[*PROGRAM, fault])
    assert (kit.code, kit.rules_with("passed")) == (0, {"SIM-011"}), kit.output
    assert len(kit.report["notes"]) == len(notes)
    for said, note in zip(kit.report["notes"], notes, strict=True):
        assert said.startswith(note)


@pytest.mark.release("broken simulators, judged by all rules")
@pytest.mark.parametrize("rule", RULES)
def test_a_broken_simulator_fails_no_other_rule(rule: str, tmp_path: Path) -> None:
    """A simulator that hangs is judged by two rules: each check would wait for it."""
    options = ("--timeout", "1", "--only", "SIM-003,SIM-004") if rule == LATE[0] else ()
    judge_broken(rule, tmp_path, *options)


@pytest.mark.parametrize(
    ("word", "text"),
    [
        (
            "lab/my_env.py:Kitchen",
            "reference_sim.gymnasium check lab/my_env.py:Kitchen",
        ),
        ("my_lab.envs:Kitchen", "reference_sim.gymnasium check my_lab.envs:Kitchen"),
        ("my_sim.toml", "is a benchmark file; give the command of its `simulator`"),
    ],
)
def test_what_is_no_program_is_named_with_the_way_to_check_it(
    word: str,
    text: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("my_sim.toml").write_text("simulator = ['./my_sim']")
    assert simulator_main([word]) == 2
    assert text in " ".join(capsys.readouterr().out.split())


@pytest.mark.parametrize(
    ("command", "reason"),
    [
        (["./there_is_none"], "cannot be started: No such file"),
        (["true"], "the output ended after 0 bytes; exit code 0"),
        (["echo", "Loading the world"], "b'Loading the world"),
        ([sys.executable, "-c", "import of_nothing"], "ModuleNotFoundError"),
        (["sleep", "60"], "0 of 4 bytes in time; --start-timeout allows more"),
    ],
    ids=("none", "ends", "prints", "fails", "waits"),
)
def test_a_program_that_does_not_start_is_not_judged(
    command: list[str], reason: str, tmp_path: Path
) -> None:
    kit = judge(tmp_path, "--start-timeout", "2", command=command)
    assert kit.code == 2
    assert reason in kit.report["problem"]
