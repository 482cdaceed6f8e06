"""Checks in several processes: all run, groups stay together, a death is noticed."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from conformance.runner.forked_checks import CAN_FORK
from tests.support.paths import ROOT

pytestmark = pytest.mark.skipif(not CAN_FORK, reason="this system cannot fork safely")
PROGRAM = """
import os, sys, pytest
from conformance.runner.forked_checks import WorkerProcesses

class Collector:
    def __init__(self):
        self.collect = self.add
    def add(self, properties):
        values = map(str, dict(properties).values())  # one write: pytest writes dots
        print(f"\\ntook {' '.join(values)}\\n", end="", flush=True)
    def redirect(self, collect):
        self.collect = collect
    def pytest_runtest_logreport(self, report):
        if report.when == "teardown":
            self.collect(report.user_properties)

one = Collector()
def play_on(session, number, count):
    one.collect([("number", number), ("count", count), ("items", len(session.items))])
workers = WorkerProcesses(
    2, one.add, one.redirect, must_stop=lambda: False, play_on=play_on
)
sys.exit(pytest.main([sys.argv[1], "-q", "-pno:cacheprovider"], [one, workers]))
"""
CHECKS = """
import os, pytest
@pytest.fixture
def note(record_property):
    record_property("check", os.environ.get("PYTEST_CURRENT_TEST").split("::")[1])
    record_property("process", os.getpid())
@pytest.mark.parametrize("n", range(8))
def test_alone(note, n): ...
@pytest.mark.one_process("pair")
@pytest.mark.parametrize("n", range(3))
def test_together(note, n): ...
"""


def run_checks(folder: Path, checks: str) -> subprocess.CompletedProcess[str]:
    (folder / "test_some.py").write_text(checks)
    (folder / "pytest.ini").write_text("[pytest]\nmarkers = one_process(name): x\n")
    return subprocess.run(
        [sys.executable, "-c", PROGRAM, str(folder)],
        cwd=ROOT,
        env=os.environ | {"PYTEST_DISABLE_PLUGIN_AUTOLOAD": "1"},
        capture_output=True,
        text=True,
        timeout=60,
        check=False,
    )


def test_all_run_and_groups_stay_in_one_process(tmp_path: Path) -> None:
    done = run_checks(tmp_path, CHECKS)
    lines = [line.split() for line in done.stdout.splitlines() if "took" in line]
    played_on = [line for line in lines if line[1].isdigit()]
    taken = [line for line in lines if line not in played_on]
    assert done.returncode == 0, done.stderr
    assert sorted(played_on) == [["took", str(n), "2", "11"] for n in (1, 2)]
    assert len({line[1] for line in taken}) == len(taken) == 11
    together = {line[-1] for line in taken if line[1].startswith("test_together")}
    assert len(together) == 1
    assert 1 <= len({line[-1] for line in taken}) <= 2


def test_a_process_that_dies_ends_the_run(tmp_path: Path) -> None:
    checks = "import os\ndef test_dies(): os._exit(3)\ndef test_lives(): ...\n"
    done = run_checks(tmp_path, checks)
    assert done.returncode == pytest.ExitCode.INTERNAL_ERROR
    assert "a process of the kit has ended" in done.stdout + done.stderr
