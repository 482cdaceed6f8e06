"""Hooks of pytest that show what a run of the tests cost and what it left out.

A test has one of three tiers, by its marker: none (`make check`), `slow` (`make test`)
and `release` (`make test-all`). A run of over half a minute ends with the seconds of
each folder, and what the tests that were left out would judge.
"""

from collections import Counter, defaultdict
from collections.abc import Sequence
from typing import Any

import pytest

# A run of one file, while it is edited, prints none of this.
REPORTED_RUN_MIN_S = 30.0
# A folder below this is not worth a line.
FOLDER_MIN_S = 1.0
_LEFT_OUT = "left_out"  # what a worker process sends to the one that reports


class TierReport:
    """Adds up times and deselected tests, of this process and of its workers."""

    def __init__(self) -> None:
        self._seconds_by_folder: defaultdict[str, float] = defaultdict(float)
        self._left_out = Counter[str]()

    def pytest_deselected(self, items: Sequence[pytest.Item]) -> None:
        """Count the tests that the tier leaves out by the reason of their marker."""
        for item in items:
            marker = item.get_closest_marker("release")
            if marker is not None:
                self._left_out[str(marker.args[0])] += 1

    def pytest_sessionfinish(self, session: pytest.Session) -> None:
        """In a worker process, pass on what it left out: all leave out the same."""
        output = getattr(session.config, "workeroutput", None)
        if output is not None:
            output[_LEFT_OUT] = dict(self._left_out)

    @pytest.hookimpl(optionalhook=True)
    def pytest_testnodedown(self, node: Any) -> None:
        """Take what a worker process passed on."""
        self._left_out |= Counter(getattr(node, "workeroutput", {}).get(_LEFT_OUT, {}))

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        """Add the time of a set-up, a call or a tear-down."""
        folder = report.nodeid.partition("::")[0].rpartition("/")[0]
        self._seconds_by_folder[folder] += report.duration

    def pytest_terminal_summary(
        self, terminalreporter: pytest.TerminalReporter
    ) -> None:
        """Print both lists."""
        if sum(self._seconds_by_folder.values()) < REPORTED_RUN_MIN_S:
            return
        write = terminalreporter.write_line
        terminalreporter.section("seconds of each folder, added up over all processes")
        by_folder = self._seconds_by_folder.items()
        for folder, seconds in sorted(by_folder, key=lambda item: -item[1]):
            if seconds >= FOLDER_MIN_S:
                write(f"{seconds:8.1f}  {folder}")
        if self._left_out:
            terminalreporter.section("not judged in this run: make test-all judges it")
            for reason, tests in sorted(self._left_out.items()):
                write(f"{tests:5} tests left out: {reason}")


def pytest_configure(config: pytest.Config) -> None:
    """Register the report of this run."""
    config.pluginmanager.register(TierReport(), "tier-report")
