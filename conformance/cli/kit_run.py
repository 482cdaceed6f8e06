"""The frame of a kit run: errors become a problem of the result, reports are written.

Shared by `python -m conformance` and the kits of policy servers and simulators. Does
not know how a server is inspected.
"""

import contextlib
import sys
import tempfile
import time
from collections.abc import Callable, Collection, Iterator, Sequence
from datetime import UTC, datetime
from pathlib import Path

from conformance.cli.console import Terminal
from conformance.cli.kit_command import (
    BadArguments,
    KitCommand,
    KitOptions,
    parse_options,
)
from conformance.client.connections.transport.closed_output import (
    UNWRITABLE,
    unwritable,
)
from conformance.reports.attestation import CannotAttest, write_attestation
from conformance.reports.files import write_reports
from conformance.reports.summary import append_summary
from conformance.run_settings import Settings
from conformance.runner.ending_signals import EndingSignals
from conformance.runner.preflight import CannotJudge
from conformance.runner.server_process import StartFailed
from conformance.specification.document import load_spec, spec_name
from conformance.specification.ledger import load_ledger
from conformance.verdicts.result import Result, conclude
from conformance.verdicts.universal_rules import Tally


def run_kit(result: Result, terminal: Terminal, judge: Callable[[], None]) -> int:
    """Judge, write and print the reports, and give the exit code.

    `judge` fills in the result; it raises when nothing can be decided.
    """
    result.started_at = datetime.now(UTC).isoformat(timespec="seconds")
    began_at = time.monotonic()
    EndingSignals(once=False).install()
    try:
        _require_place(Path(result.settings.report))
        judge()
    except BadArguments as error:
        result.problem = f"{error} (see --help)"
    except (CannotJudge, StartFailed) as error:
        result.problem = str(error)
    except KeyboardInterrupt:
        result.problem = "interrupted"
    result.elapsed_s = time.monotonic() - began_at
    if result.problem is not None and not result.rows:
        conclude(result, {}, Tally(load_spec()), set())
    with _report_write_errors(terminal, result):
        write_reports(result)
        append_summary(result)
        try:
            write_attestation(result)
        except CannotAttest as error:
            result.notes.append(f"no statement was written: {error}")
    terminal.report(result)
    if terminal.lost is None:
        return result.exit_code
    reports = f"the reports in {result.settings.report}/ have the verdict"
    sys.stderr.write(f"{unwritable(terminal.lost)}; {reports}.\n")
    return result.exit_code or UNWRITABLE


def run_profile_kit(
    command: KitCommand,
    arguments: Sequence[str] | None,
    profile: str,
    read_settings: Callable[[KitOptions], Settings],
    judge: Callable[[Result, Terminal], None],
) -> int:
    """Run the kit of one profile with a command line of its own; give the exit code."""
    terminal = Terminal()
    try:
        given = sys.argv[1:] if arguments is None else arguments
        options = parse_options(command, given)
    except BadArguments as error:
        sys.stderr.write(f"{command.name}: {error} (see --help)\n")
        return 2
    result = Result(Settings(report=options.report, profiles=[profile]))

    def read_and_judge() -> None:
        result.settings = read_settings(options)
        terminal.say(f"{profile}, specification {spec_name()}")
        judge(result, terminal)

    return run_kit(result, terminal, read_and_judge)


def run_checks(
    result: Result,
    terminal: Terminal,
    *,
    processes: int = 1,
    known_failures: Collection[str] = (),
) -> None:
    """Run the checks of the selected rules, and fill in the rows of the result."""
    # Imported late: it loads pytest, which no earlier exit needs.
    from conformance.runner.execution import execute
    from conformance.runner.left_behind import delete_runs, describe_left

    collector = execute(result.settings, processes, terminal.progress)
    result.problem = collector.problem
    result.coverage = collector.coverage
    conclude(result, collector.verdicts, collector.tally, set(known_failures))
    runs = delete_runs(result.settings, collector.submitted)
    others = describe_left(result.settings, collector.left)
    result.notes += [note for note in (runs, others) if note is not None]


def read_only(text: str | None, profile: str) -> list[str]:
    """The ids and prefixes of --only, of a kit that judges one profile.

    Raises BadArguments.
    """
    only = [part.strip() for part in (text or "").split(",") if part.strip()]
    rules = [row.id for row in load_ledger().values() if row.profile == profile]
    for wanted in only:
        if not any(rule.startswith(wanted) for rule in rules):
            raise BadArguments(f"--only {wanted}: no rule id starts with {wanted}")
    return only


def _require_place(folder: Path) -> None:
    """Refuse a folder that cannot be written, before minutes of checks."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
        tempfile.TemporaryFile(dir=folder).close()
    except OSError as error:
        raise BadArguments(f"--report {folder}: {error.strerror}") from error


@contextlib.contextmanager
def _report_write_errors(terminal: Terminal, result: Result) -> Iterator[None]:
    try:
        yield
    except OSError as error:
        terminal.say(f"the reports could not be written: {error}", "bold red")
        result.problem = result.problem or f"no reports: {error}"
