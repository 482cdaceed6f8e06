"""The options of `proctor-conformance`, and their translation into settings."""

import importlib.metadata
import random
import time
from collections.abc import Sequence
from pathlib import Path

import click

from conformance.cli.kit_command import (
    BadArguments,
    KitCommand,
    KitOptions,
    close_names,
    flag,
    option,
    parse_options,
)
from conformance.cli.reached_server import (
    accept_authorities,
    read_base_url,
    read_secret,
)
from conformance.client.connections.transport.replaced_file import check_writable
from conformance.client.connections.transport.text_file import NotText, read_text_file
from conformance.reports.attestation import CannotAttest, load_key, read_subject
from conformance.run_settings import Settings
from conformance.specification.document import spec_name
from conformance.specification.ledger import LEVELS, PROFILES, load_ledger
from conformance.specification.stages import STAGES

PROGRAM = "proctor-conformance"
_NODES_MAX = 9
# Processes of a run. A check waits for its server or for a moment half of its time:
# three keep two cores busy. A whole run has one more group of checks that mostly wait.
_PROCESSES, _QUICK_PROCESSES = 3, 4
# A whole run plays generated histories until then: it is promised to take 60 s.
_HISTORY_TIME_S = 50.0
_MINUTES_MAX = 7 * 24 * 60


def build_command() -> KitCommand:
    """Describe every option."""
    version = flag(
        "--version",
        "show the versions of the kit and of the specification",
        is_eager=True,
        expose_value=False,
        callback=_print_version,
    )
    headings = {
        "Server": _server_options(),
        "Accounts (prefer the environment)": _account_options(),
        "Selection": _selection_options(),
        "Execution": _execution_options(),
        "Statement": _attestation_options(),
        "Version": [version],
    }
    return KitCommand(
        PROGRAM,
        headings,
        help="Check a Proctor server against the specification over HTTP (black box).",
        epilog="Exit codes: 0 conformant, 1 a MUST is violated, 2 not decided (no "
        "server, no token, kit error). Every run writes report.html, report.json, "
        "junit.xml, badge.svg and a badge of each level to the directory --report.",
    )


def parse_arguments(arguments: Sequence[str]) -> KitOptions:
    """Parse a command line of the kit, or raise BadArguments."""
    return parse_options(build_command(), arguments)


def _print_version(context: click.Context, _: click.Parameter, is_given: bool) -> None:
    if is_given and not context.resilient_parsing:
        click.echo(_version())
        context.exit()


def _version() -> str:
    """Name the kit and the specification that it judges."""
    try:
        installed = importlib.metadata.version("proctor-conformance")
    except importlib.metadata.PackageNotFoundError:
        installed = "of a checkout"
    return f"{PROGRAM} {installed}, specification {spec_name()}"


def _server_options() -> list[click.Option]:
    return [
        option(
            "--url",
            "base URL of the server under test; all of them, with commas, of a "
            "service that has several: requests are spread over them",
            "URL[,URL…]",
        ),
        option(
            "--ca",
            "certificates to accept, instead of the system's [PROCTOR_CA]",
            "FILE",
        ),
        option(
            "--start-cmd",
            "start the server under test with this command; the kit sets "
            "PROCTOR_HOST, PROCTOR_PORT, PROCTOR_TOKENS (account:scopes:token, with "
            "commas between several; a scope is read, run or read+run) and "
            "PROCTOR_DATABASE (the path of a file) in its environment",
            "CMD",
        ),
        option(
            "--nodes",
            "start --start-cmd so many times with one PROCTOR_DATABASE, each on a "
            "port of its own; PROCTOR_PUBLIC_URL is the URL of the first",
            "N",
            type=int,
            default=1,
        ),
        option(
            "--restart-cmd",
            "command that kills the server at --url and restarts it",
            "CMD",
        ),
        flag(
            "--not-durable",
            "the runs of this server do not outlive its process: kill nothing, and "
            "report the rules about crashes as not verified",
        ),
    ]


def _account_options() -> list[click.Option]:
    return [
        option("--token", "token with the scopes read and run [PROCTOR_TOKEN]"),
        option("--token-2", "token of a second account [PROCTOR_TOKEN_2]"),
        option(
            "--token-read",
            "token of the first account with the scope read only [PROCTOR_TOKEN_READ]",
        ),
    ]


def _selection_options() -> list[click.Option]:
    return [
        option("--only", "rule ids or id prefixes", "ID,..."),
        option("--profile", ", ".join(PROFILES), "NAME,..."),
        option(
            "--level",
            "the rules of a level alone, which the server has to reach: "
            + ", ".join(LEVELS),
            "NAME",
            type=click.Choice([*LEVELS]),
        ),
        flag("--quick", "skip checks that wait, kill the server or play a long run"),
        option(
            "--stage",
            "the rules that a server of so many stages can obey: "
            + ", ".join(f"{stage.number} {stage.name}" for stage in STAGES),
            "N",
            type=click.Choice([stage.number for stage in STAGES]),
        ),
        flag("--list", "print the rules and exit"),
        flag(
            "--dry-run",
            "print the checks that would run and their rules; send no request",
        ),
    ]


def _execution_options() -> list[click.Option]:
    return [
        option("--seed", "seed of the requests (reproduces a kit run)", type=int),
        option(
            "-n",
            f"number of parallel processes; {_PROCESSES}, {_QUICK_PROCESSES} with "
            "--quick, 1 with --only or --fail-fast",
            "N",
            type=int,
        ),
        flag(
            "--fail-fast",
            "start no check after the first violated MUST; the remaining rules are "
            "reported as not verified; rules are judged in the order of --only",
        ),
        option(
            "--minutes",
            "generate histories and requests for so many minutes more: more of them "
            "find more, and the report says how many there were",
            "MINUTES",
            type=float,
        ),
        option(
            "--history-time",
            "play further generated histories, always others, until the run has taken "
            f"so long; {_HISTORY_TIME_S:g} for a whole run, otherwise 0",
            "SECONDS",
            type=float,
        ),
        option(
            "--max-time",
            "start no check after this time; the remaining rules are reported as not "
            "verified",
            "SECONDS",
            type=float,
        ),
        flag(
            "--stress",
            "also send requests that are too large or too slow to the server at "
            "--url; without this option only a server started by --start-cmd gets them",
        ),
        flag(
            "--exchanges",
            "also report the requests and answers of rules that passed, as scripts "
            "and as data: what a right server answers",
        ),
        option("--report", "directory of the reports", "DIR", default="report"),
        option(
            "--summary",
            "append a short report in Markdown, for the page of a CI job",
            "FILE",
        ),
        option(
            "--known-failures",
            "file with one rule id and a # comment per line: these failures do not "
            "fail the run; an entry that passes does",
            "FILE",
        ),
    ]


def _attestation_options() -> list[click.Option]:
    return [
        option(
            "--attest",
            "write the verdict on all rules as an in-toto statement (test-result)",
            "FILE",
        ),
        option("--attest-key", "sign it with this Ed25519 private key, in PEM", "FILE"),
        option(
            "--attest-subject",
            "what the server was built as, such as an image and its digest",
            "NAME@sha256:HEX",
        ),
    ]


def read_processes(options: KitOptions) -> int:
    """The number of processes that judge; one process keeps the order of --only."""
    if options.n is not None:
        return int(options.n)
    if options.only or options.fail_fast:
        return 1
    return _QUICK_PROCESSES if options.quick else _PROCESSES


def read_selection(options: KitOptions) -> Settings:
    """Read the selection, which needs no server, or raise BadArguments."""
    only = _split(options.only)
    for wanted in only:
        if not any(rule_id.startswith(wanted) for rule_id in load_ledger()):
            problem = f"--only {wanted}: no rule id starts with {wanted}"
            raise BadArguments(problem + _suggestion(wanted))
    profiles = _split(options.profile)
    if profiles and options.level:
        raise BadArguments("--profile and --level exclude each other")
    for profile in profiles:
        if profile not in PROFILES:
            close = close_names(profile, PROFILES)
            raise BadArguments(
                f"--profile {profile}: unknown profile{close or ';'} "
                f"known: {', '.join(PROFILES)}"
            )
    of_level = LEVELS[options.level] if options.level else PROFILES
    settings = Settings(
        quick=options.quick,
        stage=options.stage,
        level=options.level,
        only=only,
        profiles=profiles or list(of_level),
        report=options.report,
    )
    if not settings.selected_rules:
        raise BadArguments(_why_nothing_is_selected(settings))
    return settings


def _why_nothing_is_selected(settings: Settings) -> str:
    """Say which option leaves the rules of --only out."""
    wanted = [
        row for row in load_ledger().values() if row.id.startswith(tuple(settings.only))
    ]
    left_out = [row.profile for row in wanted if row.profile not in settings.profiles]
    only = ",".join(settings.only)
    if len(left_out) < len(wanted):
        return f"--only {only} and --stage {settings.stage} select no rule"
    option = f"--level {settings.level}" if settings.level else "--profile"
    profiles = ", ".join(dict.fromkeys(left_out))
    return f"--only {only} is of {profiles}, which {option} leaves out: no rule is left"


def _suggestion(wanted: str) -> str:
    areas = dict.fromkeys(row.area for row in load_ledger().values())
    area = wanted.upper().partition("-")[0]
    close = close_names(wanted.upper(), load_ledger()) or close_names(area, areas)
    return close or f"; areas: {', '.join(areas)}"


def read_settings(options: KitOptions) -> Settings:
    """Turn options and environment into settings, or raise BadArguments."""
    settings = read_selection(options)
    if options.start_cmd is None and options.url is None:
        raise BadArguments("give --url URL or --start-cmd CMD")
    if options.start_cmd is not None and options.url is not None:
        raise BadArguments("--url and --start-cmd exclude each other")
    if options.start_cmd is not None and options.restart_cmd is not None:
        raise BadArguments("--start-cmd and --restart-cmd exclude each other")
    if options.not_durable and options.restart_cmd is not None:
        raise BadArguments("--not-durable and --restart-cmd exclude each other")
    if options.fail_fast and options.known_failures is not None:
        raise BadArguments("--fail-fast and --known-failures exclude each other")
    if options.minutes is not None and not 0 < options.minutes <= _MINUTES_MAX:
        raise BadArguments(
            f"--minutes {options.minutes:g}: must be above 0, up to {_MINUTES_MAX}"
        )
    if options.max_time is not None and not options.max_time > 0:
        raise BadArguments(f"--max-time {options.max_time:g}: must be greater than 0")
    try:
        _read_accounts(options, settings)
        _read_nodes(options, settings)
    except ValueError as error:
        raise BadArguments(str(error)) from error
    _read_attestation(options, settings)
    settings.start_cmd = options.start_cmd
    settings.restart_cmd = options.restart_cmd
    settings.durable = not options.not_durable
    settings.fail_fast = options.fail_fast
    settings.summary = options.summary
    settings.exchanges = options.exchanges
    settings.stress = options.stress or options.start_cmd is not None
    seed: int | None = options.seed
    settings.seed = seed if seed is not None else random.randrange(10**6)
    settings.minutes = options.minutes or 0.0
    if options.max_time is not None:
        settings.max_time_s = options.max_time
        settings.deadline = time.monotonic() + options.max_time
    settings.rounds_until = time.monotonic() + _read_history_time(options, settings)
    return settings


def _read_history_time(options: KitOptions, settings: Settings) -> float:
    """Read until when, in seconds from now, further histories are played."""
    if options.history_time is not None:
        if options.minutes is not None:
            raise BadArguments("--history-time and --minutes exclude each other")
        return float(options.history_time)
    is_other = settings.is_partial or options.fail_fast
    is_other = is_other or options.minutes is not None or options.max_time is not None
    return 0.0 if is_other else _HISTORY_TIME_S


def _read_accounts(options: KitOptions, settings: Settings) -> None:
    accept_authorities(options.ca)
    settings.token = read_secret(options.token, "--token", "PROCTOR_TOKEN")
    settings.token_2 = read_secret(options.token_2, "--token-2", "PROCTOR_TOKEN_2")
    settings.token_read = read_secret(
        options.token_read, "--token-read", "PROCTOR_TOKEN_READ"
    )


def _read_nodes(options: KitOptions, settings: Settings) -> None:
    """Read where the service is reached, or how many servers of it are started."""
    urls = [read_base_url("--url", url) for url in _split(options.url)]
    if len(set(urls)) < len(urls):
        raise BadArguments(f"--url {options.url}: a base URL stands twice")
    if options.nodes > 1 and options.start_cmd is None:
        raise BadArguments("--nodes needs --start-cmd")
    if not 1 <= options.nodes <= _NODES_MAX:
        raise BadArguments(f"--nodes {options.nodes}: must be 1 to {_NODES_MAX}")
    settings.url, settings.other_urls = (urls or [""])[0], urls[1:]
    settings.nodes = options.nodes


def check_summary(path: str | None) -> None:
    """Refuse early a file that could not be written after the whole run."""
    if path is None:
        return
    try:
        with open(path, "a", encoding="utf-8"):  # noqa: PTH123 - as the user gave it
            pass
    except OSError as error:
        raise BadArguments(f"--summary {path}: {error.strerror}") from error


def _read_attestation(options: KitOptions, settings: Settings) -> None:
    """Refuse arguments early that would otherwise fail only after the whole run."""
    settings.attest = options.attest
    settings.attest_key = options.attest_key
    settings.attest_subject = options.attest_subject
    if options.attest is None and (options.attest_key or options.attest_subject):
        raise BadArguments("--attest-key and --attest-subject need --attest FILE")
    if options.attest is not None and settings.is_partial:
        raise BadArguments("--attest states a verdict on all rules; select none")
    try:
        if options.attest_subject is not None:
            read_subject(options.attest_subject)
        if options.attest_key is not None:
            load_key(Path(options.attest_key))
        if options.attest is not None:
            check_writable(Path(options.attest))
    except (ValueError, CannotAttest) as error:
        raise BadArguments(str(error)) from error
    except OSError as error:
        raise BadArguments(f"--attest {options.attest}: {error.strerror}") from error


def _split(text: str | None) -> list[str]:
    return [part.strip() for part in (text or "").split(",") if part.strip()]


def read_known_failures(path: str | None) -> set[str]:
    """Read the ids of a file of known failures."""
    if path is None:
        return set()
    try:
        lines = read_text_file(path).splitlines()
    except OSError as error:
        raise BadArguments(f"--known-failures {path}: {error.strerror}") from error
    except NotText as error:
        raise BadArguments(f"--known-failures {path}: {error}") from error
    rule_ids: set[str] = set()
    for number, line in enumerate(lines, 1):
        requirement_id, _, comment = line.partition("#")
        requirement_id = requirement_id.strip()
        if not requirement_id:
            continue
        where = f"--known-failures {path} line {number}"
        if requirement_id not in load_ledger():
            problem = f"{where}: unknown rule id {requirement_id}"
            raise BadArguments(problem + _suggestion(requirement_id))
        if not comment.strip():
            raise BadArguments(
                f"{where}: add a # comment with the reason for {requirement_id}"
            )
        rule_ids.add(requirement_id)
    return rule_ids
