"""The kit for simulators: it passes a right one, and fails exactly what each broken one
breaks.
"""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

from conformance.specification.ledger import SIMULATOR, load_ledger
from tests.support.kit.run_kit import KitRun, run_simulator_kit
from tests.support.sim import breakable_simulator

pytestmark = pytest.mark.slow("starts kits, and each of them many simulators")

PROGRAM = [sys.executable, "-S", breakable_simulator.__file__]
LATE = ("SIM-003", "SIM-023")  # these are waited for, three times
RULES = [row.id for row in load_ledger().values() if row.profile == SIMULATOR]


def judge(folder: Path, *options: str, command: list[str] = PROGRAM) -> KitRun:
    return run_simulator_kit(folder, "--seed", "1", *options, command=command)


def test_a_right_simulator_is_conformant(tmp_path: Path) -> None:
    kit = judge(tmp_path)
    assert (kit.code, kit.report["problem"]) == (0, None)
    assert kit.outcomes == dict.fromkeys(RULES, "passed")
    assert kit.report["conclusion"] == "conformant"


def judge_broken(rule: str, folder: Path, *options: str) -> None:
    kit = judge(folder, *options, command=[*PROGRAM, rule])
    assert kit.rules_with("failed") == {rule}, kit.output
    assert kit.code == (1 if load_ledger()[rule].level == "MUST" else 0)


@pytest.mark.parametrize("rule", [rule for rule in RULES if rule not in LATE])
def test_a_broken_simulator_fails_its_rule(rule: str, tmp_path: Path) -> None:
    judge_broken(rule, tmp_path, "--only", rule)


@pytest.mark.release("broken simulators, judged by all rules")
@pytest.mark.parametrize("rule", RULES)
def test_a_broken_simulator_fails_no_other_rule(rule: str, tmp_path: Path) -> None:
    """A simulator that hangs is judged by two rules: each check would wait for it."""
    options = ("--timeout", "1", "--only", "SIM-003,SIM-004") if rule == LATE[0] else ()
    judge_broken(rule, tmp_path, *options)


@pytest.mark.parametrize(
    ("command", "reason"),
    [
        (["./there_is_none"], "cannot be started: No such file"),
        (["true"], "the output ended after 0 bytes; exit code 0"),
        (["echo", "Loading the world"], "b'Loading the world"),
        ([sys.executable, "-c", "import of_nothing"], "ModuleNotFoundError"),
    ],
    ids=("none", "ends", "prints", "fails"),
)
def test_a_program_that_does_not_start_is_not_judged(
    command: list[str], reason: str, tmp_path: Path
) -> None:
    kit = judge(tmp_path, command=command)
    assert kit.code == 2
    assert reason in kit.report["problem"]
