"""The rules are tested to the last branch, each module by the tests that are its own.

One process runs the unit tests of all these modules and notes under which test file
each branch was taken; what a module is needed for elsewhere does not count for it.
"""

import io
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import coverage
import pytest

# Run as a program this file imports nothing of tests: pytest has to do that itself.
ROOT = Path(__file__).resolve().parents[3]

pytestmark = pytest.mark.slow("measures the unit tests of the rules")

OWN_TESTS = {
    "reference_server/rules/capacity.py": ("test_capacity.py",),
    "reference_server/rules/board/entry_changes.py": ("test_entry_changes.py",),
    "reference_server/rules/board/ranking.py": ("test_ranking.py",),
    "reference_server/rules/comparison.py": ("test_comparison.py",),
    "reference_server/rules/runs/events.py": ("test_events.py",),
    "reference_server/http/problems.py": ("test_problems.py",),
    "reference_server/rules/runs/effects.py": (
        *("test_effects.py", "test_push_run_rules.py"),
    ),
    "reference_server/rules/runs/lifecycle.py": (
        *("test_lifecycle.py", "test_record_rules.py", "test_push_run_rules.py"),
    ),
    "reference_server/profiles/ebench/lost_answers.py": ("test_lost_answers.py",),
    "reference_server/profiles/ebench/pickle_reader.py": ("test_pickle_reader.py",),
    "reference_server/rules/scoring.py": ("test_scoring.py",),
    "reference_server/rules/manifest.py": ("test_manifest.py",),
    "reference_server/rules/submission.py": ("test_submission.py",),
    "reference_server/rules/runs/action_space.py": ("test_action_space.py",),
    "conformance/oracle/expected_ranking.py": ("test_expected_ranking.py",),
    "conformance/oracle/expected_comparison.py": ("test_expected_comparison.py",),
    "conformance/oracle/expected_score.py": ("test_expected_score.py",),
    "conformance/verdicts/verdict.py": ("test_verdict.py",),
}
IMPORTED = "imported"


class _ByFile:
    """Sets the measurement's context to the file of the test that runs."""

    def __init__(self, measured: coverage.Coverage) -> None:
        self._measured = measured

    def pytest_runtest_logstart(self, location: tuple[str, int | None, str]) -> None:
        self._measured.switch_context(Path(location[0]).name)


def measure() -> int:
    """Write a line for each module that is not covered wholly; returns how many."""
    names = {name for names in OWN_TESTS.values() for name in names}
    files = sorted(
        str(path.relative_to(ROOT))
        for path in (ROOT / "tests").rglob("test_*.py")
        if path.name in names
    )
    assert len(files) == len(names)
    measured = coverage.Coverage(
        data_file=None,
        config_file=False,
        branch=True,
        include=[str(ROOT / name) for name in OWN_TESTS],
        context=IMPORTED,
    )
    measured.start()
    plain = ["-p", "no:cacheprovider", "-p", "no:xdist", "-q"]
    code = pytest.main([*plain, *files], plugins=[_ByFile(measured)])
    measured.stop()
    missing = []
    for name, own in OWN_TESTS.items():
        report = io.StringIO()
        contexts = [rf"^{IMPORTED}(\|{file})?$" for file in own]
        shown: dict[str, Any] = {"file": report, "show_missing": True}
        if (
            measured.report(include=[str(ROOT / name)], contexts=contexts, **shown)
            < 100
        ):
            missing.append(report.getvalue())
    sys.stdout.write("\n".join(missing))
    return len(missing) + int(code)


def test_every_branch_of_the_rules_is_tested() -> None:
    ours = ("COVERAGE", "PYTEST")
    env = {key: value for key, value in os.environ.items() if not key.startswith(ours)}
    command = [sys.executable, "-m", "tests.repository.code.test_coverage"]
    done = subprocess.run(
        command, cwd=ROOT, env=env, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stdout + done.stderr


if __name__ == "__main__":
    sys.exit(measure())
