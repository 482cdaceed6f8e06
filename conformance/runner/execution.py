"""Runs the checks with pytest in this process and collects their verdicts."""

import gc
import importlib
import os
import tempfile
import warnings
from collections.abc import Callable
from pathlib import Path
from types import ModuleType
from typing import Any

import hypothesis
import pytest
from hypothesis.errors import HypothesisWarning
from hypothesis.strategies import integers

from conformance import checks
from conformance.run_settings import Settings
from conformance.runner.forked_checks import CAN_FORK, Properties, WorkerProcesses
from conformance.runner.further_rounds import FurtherRounds
from conformance.runner.pytest_plugin import (
    COVERAGE,
    LEFT,
    SERVER_UNREACHABLE,
    SUBMITTED,
    TALLY,
    VERDICT,
    docstring_of,
    requirements_of,
)
from conformance.specification.document import load_spec
from conformance.specification.ledger import OF_OTHER_PROGRAMS, PROFILES
from conformance.verdicts.coverage import Coverage
from conformance.verdicts.universal_rules import Tally
from conformance.verdicts.verdict import Outcome, Verdict

# Python 3.14 does not show the library that its own generator is referred to.
warnings.filterwarnings("ignore", "It looks like `register_random`", HypothesisWarning)

CHECKS = Path(checks.__file__).resolve().parent
_REGULAR_EXIT_CODES = (
    pytest.ExitCode.OK,
    pytest.ExitCode.TESTS_FAILED,
    pytest.ExitCode.NO_TESTS_COLLECTED,
    pytest.ExitCode.INTERRUPTED,
)


class ResultCollector:
    """A pytest plugin that collects verdicts, tallies and problems."""

    def __init__(self, progress: Callable[[Verdict, int], None]) -> None:
        self.verdicts: dict[str, Verdict] = {}
        self.tally = Tally(load_spec())
        self.coverage = Coverage()
        self.submitted: list[tuple[str | None, str]] = []
        self.left: list[tuple[str, str]] = []
        self.problem: str | None = None
        self.collect: Callable[[Properties], None] = self.add
        self._progress = progress
        self._total = 0

    def pytest_collection_finish(self, session: pytest.Session) -> None:
        """Store the number of checks."""
        self._total = sum(len(requirements_of(item)) for item in session.items)

    def pytest_collectreport(self, report: pytest.CollectReport) -> None:
        """A file of checks that cannot be imported is an error of the kit."""
        if report.failed:
            self.problem = f"internal error of the kit: {report.longreprtext[-600:]}"

    def pytest_internalerror(self, excrepr: Any) -> None:
        """An internal error of pytest is an error of the kit, too."""
        self.problem = f"internal error of the kit: {str(excrepr)[-600:]}"

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        """Take the verdict and the tally that the plugin attached."""
        if report.when == "teardown":
            self.collect(report.user_properties)

    def redirect(self, collect: Callable[[Properties], None]) -> None:
        """Send everything on instead of storing it; for a process of its own."""
        self.collect = collect

    def add(self, properties: Properties) -> None:
        """Add what the plugin attached to the report of one check."""
        for name, value in properties:
            if name == VERDICT:
                self._add_verdict(Verdict.from_plain(value))
            elif name == TALLY:
                self.tally.add_plain(value)
            elif name == COVERAGE:
                self.coverage.add_plain(value)
            elif name == SUBMITTED:
                self.submitted += value
            elif name == LEFT:
                self.left += value
            elif name == SERVER_UNREACHABLE:
                self.problem = self.problem or str(value)

    def _add_verdict(self, verdict: Verdict) -> None:
        earlier = self.verdicts.get(verdict.requirement_id)
        if earlier is not None and verdict.outcome == Outcome.PASSED:
            return
        self.verdicts[verdict.requirement_id] = verdict
        self._progress(verdict, self._total)


class _CheckCollector:
    """A pytest plugin that lists the collected checks."""

    def __init__(self) -> None:
        self.checks: list[list[str]] = []

    def pytest_collection_finish(self, session: pytest.Session) -> None:
        """Note id, name and docstring of each check."""
        self.checks = [
            [rule, item.name, docstring_of(item)]
            for item in session.items
            for rule in requirements_of(item)
        ]


def execute(
    settings: Settings, processes: int, progress: Callable[[Verdict, int], None]
) -> ResultCollector:
    """Run the selected checks."""
    collector = ResultCollector(progress)
    further = FurtherRounds(settings)
    plugins: list[object] = [collector]
    if processes > 1 and CAN_FORK:
        workers = WorkerProcesses(
            processes,
            collect=collector.add,
            redirect=collector.redirect,
            must_stop=lambda: collector.problem is not None,
            play_on=further.play,
        )
        plugins.append(workers)
    else:
        plugins.append(further)
    code = _run_pytest(settings, plugins)
    if collector.problem is None and code not in _REGULAR_EXIT_CODES:
        collector.problem = f"internal error of the kit: pytest ended with code {code}"
    if collector.problem is None and code == pytest.ExitCode.INTERRUPTED:
        collector.problem = "interrupted"
    return collector


def import_checks() -> None:
    """Import what the checks need, so that collecting them takes little time.

    Hypothesis reads the source of all modules when it first draws some values. Each
    forked process would do that again. It also searches for garbage, of which there is
    none yet.
    """
    _check_modules()
    _place_files_of_hypothesis()
    gc.freeze()
    draw = hypothesis.settings(database=None, derandomize=True, max_examples=50)
    draw(hypothesis.given(integers())(lambda _: None))()


def _check_modules() -> list[ModuleType]:
    return [
        importlib.import_module(f"{checks.__name__}.{path.parent.name}.{path.stem}")
        for path in sorted(CHECKS.glob("*/test_*.py"))
    ]


def rules_marked(name: str) -> list[str]:
    """Give the rules of the checks that have a marker."""
    rules: list[str] = []
    for module in _check_modules():
        for check in vars(module).values():
            marks = {mark.name: mark for mark in getattr(check, "pytestmark", ())}
            if name in marks:
                rules += marks["requirement"].args
    return rules


def list_checks(chosen: Settings | None = None) -> list[list[str]]:
    """Give id, name and docstring of the checks (of all), without a server."""
    profiles = [*PROFILES, *OF_OTHER_PROGRAMS]
    everything = Settings(profiles=profiles)
    everything.assume_all_offered()
    collector = _CheckCollector()
    code = _run_pytest(chosen or everything, [collector], "--collect-only")
    if code not in (pytest.ExitCode.OK, pytest.ExitCode.NO_TESTS_COLLECTED):
        raise RuntimeError(f"the checks cannot be collected: pytest's code {code}")
    return collector.checks


def _run_pytest(
    settings: Settings, plugins: list[object], *more: str
) -> int | pytest.ExitCode:
    settings.store_in_environment()
    # Plugins and configuration of the operator must not change a verdict.
    os.environ["PYTEST_DISABLE_PLUGIN_AUTOLOAD"] = "1"
    os.environ.pop("PYTEST_ADDOPTS", None)
    _place_files_of_hypothesis()
    arguments = [
        str(CHECKS),
        f"--rootdir={CHECKS.parent.parent}",
        f"--config-file={os.devnull}",
        "--strict-markers",
        "--assert=plain",
        "--capture=no",
        "--import-mode=importlib",
        "-pconformance.runner.pytest_plugin",
        "-pno:cacheprovider",
        "-pno:faulthandler",
        "-pno:terminal",
        # Collects garbage again and again at the end of each process.
        "-pno:unraisableexception",
        "-pno:warnings",
        *more,
    ]
    return pytest.main(arguments, plugins=plugins)


def _place_files_of_hypothesis() -> None:
    """Keep Hypothesis from writing into the working directory."""
    user = getattr(os, "getuid", int)()
    directory = Path(tempfile.gettempdir(), f"proctor-conformance-{user}")
    os.environ.setdefault("HYPOTHESIS_STORAGE_DIRECTORY", str(directory))
