"""The main program of the kit: arguments, server, preflight, checks, reports."""

import contextlib
import signal
import sys
import tempfile
import time
from collections.abc import Iterator, Sequence
from datetime import UTC, datetime
from pathlib import Path
from types import FrameType

from conformance.cli.arguments import (
    BadArguments,
    build_parser,
    read_choice,
    read_known_failures,
    read_settings,
)
from conformance.cli.console import Terminal
from conformance.reports.files import write_reports
from conformance.run_settings import Settings
from conformance.runner.preflight import CannotJudge, inspect
from conformance.runner.server_process import AccountTokens, ServerProcess, StartFailed
from conformance.specification.document import load_spec, spec_name
from conformance.verdicts.result import Result, conclude, select
from conformance.verdicts.universal_rules import Tally


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the kit; the exit code is 0 conformant, 1 violated, 2 not decided."""
    given = list(sys.argv[1:] if arguments is None else arguments)
    terminal = Terminal()
    parser = build_parser()
    result = Result(Settings(report=_report_directory(given)))
    result.started_at = datetime.now(UTC).isoformat(timespec="seconds")
    began_at = time.monotonic()
    signal.signal(signal.SIGTERM, _raise_interrupt)
    known: set[str] = set()
    try:
        options = parser.parse_args(given)
        if options.list or options.dry_run:
            settings = read_choice(options)
            return _dry_run(settings) if options.dry_run else _list(settings)
        result.settings = read_settings(options)
        known = read_known_failures(options.known_failures)
        with _server(result.settings):
            _judge(result, known, options.n, terminal)
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
    terminal.report(result)
    return result.exit_code


def _judge(result: Result, known: set[str], processes: int, terminal: Terminal) -> None:
    settings = result.settings
    terminal.say(f"specification {spec_name()}")
    findings = inspect(settings)
    result.round_trip_p50_s = findings.round_trip_p50_s
    result.notes = findings.notes()
    service = settings.service
    terminal.say(
        f"{service.get('name')} {service.get('version')} at {settings.url}, "
        f"Proctor {service['protocol']['min']} to {service['protocol']['max']}"
    )
    terminal.say(
        f"round trip p50 {1000 * findings.round_trip_p50_s:.1f} ms, "
        f"p95 {1000 * findings.round_trip_p95_s:.1f} ms; "
        f"tolerance {settings.tolerance_s:.2f} s; "
        f"clock {findings.clock_skew_s:+.2f} s; seed {settings.seed}"
    )
    if not select(settings):
        raise CannotJudge("--only and --profile select no rule")
    # Imported late: it loads pytest, which no earlier exit needs.
    from conformance.runner.execution import execute

    # Crash checks by a hook restart the server under all other checks.
    is_exclusive = settings.restart_cmd is not None
    collector = execute(settings, 1 if is_exclusive else processes, terminal.progress)
    result.problem = collector.problem
    conclude(result, collector.verdicts, collector.tally, known)


@contextlib.contextmanager
def _server(settings: Settings) -> Iterator[None]:
    """Run the server of --start-cmd, if given, for the duration of the block."""
    if settings.start_cmd is None:
        yield
        return
    tokens = AccountTokens.generate()
    settings.token, settings.token_2 = tokens.alice, tokens.bob
    settings.token_read = tokens.reader
    log = Path(settings.report) / "server.log"
    log.unlink(missing_ok=True)
    with tempfile.TemporaryDirectory(prefix="proctor-conformance-") as directory:
        process = ServerProcess(settings.start_cmd, tokens, Path(directory), log)
        try:
            process.start()
            settings.url = process.url
            yield
        finally:
            process.stop()


def _list(settings: Settings) -> int:
    for row in select(settings):
        note = "" if row.is_observable else f" [not observable: {row.why}]"
        print(f"{row.id}  {row.level}  {row.profile}  {row.text}{note}")
    return 0


def _dry_run(settings: Settings) -> int:
    """Print the checks for a server that announces every profile."""
    from conformance.runner.execution import list_checks

    rows = select(settings)
    settings.service = {"profiles": settings.profiles}
    checks = list_checks(settings) if rows else []
    names = {requirement_id: name for requirement_id, name, _ in checks}
    for row in rows:
        if row.id not in names:
            continue
        print(f"{row.id}  {row.level}  {row.profile}  {row.text}\n    {names[row.id]}")
    unobservable = sum(not row.is_observable for row in rows)
    print(
        f"{len(checks)} checks of {spec_name()} selected; no request was sent; "
        f"{unobservable} of the {len(rows)} selected rules are not observable"
    )
    return 0 if checks else 2


def _report_directory(given: Sequence[str]) -> str:
    """Find --report even in an invalid command line."""
    for index, word in enumerate(given):
        if word == "--report" and index + 1 < len(given):
            return given[index + 1]
        if word.startswith("--report="):
            return word.partition("=")[2]
    return "report"


@contextlib.contextmanager
def _report_write_errors(terminal: Terminal, result: Result) -> Iterator[None]:
    try:
        yield
    except OSError as error:
        terminal.say(f"the reports could not be written: {error}", "bold red")
        result.problem = result.problem or f"no reports: {error}"


def _raise_interrupt(_number: int, _frame: FrameType | None) -> None:
    """Treat SIGTERM as Ctrl-C, so that a server started by the kit ends, too."""
    raise KeyboardInterrupt
