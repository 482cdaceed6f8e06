"""The main program of the kit: arguments, server, preflight, checks, reports."""

import contextlib
import sys
import threading
from collections.abc import Iterator, Sequence
from pathlib import Path

from conformance.cli.arguments import (
    check_summary,
    parse_arguments,
    read_known_failures,
    read_processes,
    read_selection,
    read_settings,
)
from conformance.cli.console import Terminal
from conformance.cli.kit_command import BadArguments, close_names
from conformance.cli.kit_run import run_checks, run_kit
from conformance.run_settings import Settings
from conformance.runner.preflight import CannotJudge, inspect
from conformance.runner.server_process import (
    AccountTokens,
    ServerProcess,
    claim_port,
    name_end,
    open_directory,
)
from conformance.specification.document import spec_name
from conformance.specification.ledger import PROFILES
from conformance.verdicts.result import Result

_UNDERSCORES_OF_OTHERS = 2  # at least, in a name that begins with a domain


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the kit; the exit code is 0 conformant, 1 violated, 2 not decided."""
    given = list(sys.argv[1:] if arguments is None else arguments)
    terminal = Terminal()
    report, summary = _value(given, "--report"), _value(given, "--summary")
    result = Result(Settings(report=report or "report", summary=summary))
    with contextlib.suppress(BadArguments):  # raised again and reported by `judge`
        options = parse_arguments(given)
        if options.dry_run:
            return _dry_run(read_selection(options))
        if options.list:
            return _list(read_selection(options))

    def judge() -> None:
        options = parse_arguments(given)
        try:
            check_summary(options.summary)
        except BadArguments:
            result.settings.summary = None
            raise
        result.settings = read_settings(options)
        known_failures = read_known_failures(options.known_failures)
        with _server(result.settings) as servers:
            try:
                _judge(result, known_failures, read_processes(options), terminal)
            except CannotJudge as error:
                raise CannotJudge(name_end(servers, str(error))) from error
            if result.problem is not None:
                result.problem = name_end(servers, result.problem)

    return run_kit(result, terminal, judge)


def _judge(
    result: Result, known_failures: set[str], processes: int, terminal: Terminal
) -> None:
    settings = result.settings
    terminal.say(f"specification {spec_name()}")
    findings = inspect(settings)
    result.round_trip_p50_s = findings.round_trip_p50_s
    result.notes = [*findings.notes(), *_notes_on(settings)]
    service, urls = settings.service, ", ".join(settings.urls)
    terminal.say(
        f"{service.get('name')} {service.get('version')} at {urls}, "
        f"Proctor {service['protocol']['min']} to {service['protocol']['max']}"
    )
    terminal.say(
        f"round trip p50 {1000 * findings.round_trip_p50_s:.1f} ms, "
        f"p95 {1000 * findings.round_trip_p95_s:.1f} ms; "
        f"tolerance {settings.tolerance_s:.2f} s; "
        f"clock {findings.clock_skew_s:+.2f} s; seed {settings.seed}"
    )
    # Crash checks by a hook restart the server under all other checks.
    is_exclusive = settings.restart_cmd is not None
    run_checks(
        result,
        terminal,
        processes=1 if is_exclusive else processes,
        known_failures=known_failures,
    )


def _notes_on(settings: Settings) -> Iterator[str]:
    """Name the profiles that extensions.md gives to no one, and idle --minutes."""
    for profile in settings.service.get("profiles", []):
        if profile not in PROFILES and profile.count("_") < _UNDERSCORES_OF_OTHERS:
            close = close_names(profile, PROFILES)
            yield (
                f"profile {profile} is not one of this version{close or ';'} a name of "
                "others begins with their domain, as in org_example_forces"
            )
    if settings.minutes:
        from conformance.runner.execution import rules_marked

        rules = rules_marked("minutes")
        if not {row.id for row in settings.selected_rules}.intersection(rules):
            yield (
                f"--minutes changes nothing: it is for {', '.join(rules)}, which are "
                "not selected"
            )


def _load_checks(settings: Settings) -> None:
    """Import the checks; what fails here fails again when they are collected.

    Also what few of them need, and a selection may leave out.
    """
    with contextlib.suppress(Exception):
        from conformance.runner.execution import import_checks

        import_checks()
        if not settings.only:
            from conformance.checks.support.generated.wrong_values import load_schema

            load_schema()


@contextlib.contextmanager
def _server(settings: Settings) -> Iterator[list[ServerProcess]]:
    """Run the server of --start-cmd, if given, for the duration of the block.

    Gives its processes, one for each node. The checks are imported while it starts,
    which takes about as long.
    """
    if settings.start_cmd is None:
        yield []
        return
    tokens = AccountTokens.generate()
    settings.token, settings.token_2 = tokens.alice, tokens.bob
    settings.token_read = tokens.reader
    loading = threading.Thread(target=_load_checks, args=[settings], daemon=True)
    loading.start()
    log = Path(settings.report) / "server.log"
    log.unlink(missing_ok=True)
    with open_directory() as directory, contextlib.ExitStack() as ends:
        urls: list[str] = []
        processes: list[ServerProcess] = []
        for number in range(settings.nodes):
            own = log if number == 0 else log.with_name(f"server-{number + 1}.log")
            port = ends.enter_context(claim_port())
            process = ServerProcess(
                settings.start_cmd, tokens, directory=directory, port=port, log=own
            )
            ends.callback(process.stop)
            public_url = urls[0] if urls else ""
            process.start(public_url if settings.nodes > 1 else None)
            urls.append(process.url)
            processes.append(process)
        settings.url, settings.other_urls = urls[0], urls[1:]
        loading.join()
        yield processes


def _list(settings: Settings) -> int:
    for row in settings.selected_rules:
        note = "" if row.is_observable else f" [not observable: {row.why}]"
        print(f"{row.id}  {row.level}  {row.profile}  {row.text}{note}")
    return 0


def _dry_run(settings: Settings) -> int:
    """Print the checks for a server that announces every profile."""
    from conformance.runner.execution import list_checks

    rows = settings.selected_rules
    settings.assume_all_offered()
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


def _value(given: Sequence[str], option: str) -> str | None:
    """Find the value of an option even in an invalid command line."""
    for index, word in enumerate(given):
        if word == option and index + 1 < len(given):
            return given[index + 1]
        if word.startswith(f"{option}="):
            return word.partition("=")[2]
    return None
