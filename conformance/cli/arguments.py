"""The options of `proctor-conformance`, and their translation into settings."""

import argparse
import difflib
import importlib.metadata
import random
import time
from collections.abc import Iterable
from pathlib import Path
from typing import NoReturn

from conformance.cli.reached_server import (
    accept_authorities,
    read_base_url,
    read_secret,
)
from conformance.client.connections.transport.text_file import NotText, read_text_file
from conformance.reports.attestation import CannotAttest, load_key, read_subject
from conformance.run_settings import Settings
from conformance.specification.document import spec_name
from conformance.specification.ledger import PROFILES, load_ledger
from conformance.specification.stages import STAGES

_NODES_MAX = 9
# Processes of a quick run. A check waits for its server or for a moment half of its
# time: three keep two cores busy, and each more costs more to start than it saves.
_QUICK_PROCESSES = 4


class BadArguments(Exception):
    """The command line is invalid; the text gives the reason."""


class _Parser(argparse.ArgumentParser):
    def error(self, message: str) -> NoReturn:
        raise BadArguments(message)


def build_parser() -> argparse.ArgumentParser:
    """Describe every option."""
    parser = _Parser(
        prog="proctor-conformance",
        description="Check a Proctor server against the specification over HTTP "
        "(black box).",
        epilog="Exit codes: 0 conformant, 1 a MUST is violated, 2 not decided (no "
        "server, no token, kit error). Every run writes report.html, report.json, "
        "junit.xml and badge.svg to the directory --report.",
    )
    parser.add_argument("--version", action="version", version=_version())
    server = parser.add_argument_group("server")
    server.add_argument(
        "--url",
        metavar="URL[,URL…]",
        help="base URL of the server under test; all of them, with commas, of a "
        "service that has several: requests are spread over them",
    )
    server.add_argument(
        "--ca",
        metavar="FILE",
        help="certificates to accept, instead of the system's [PROCTOR_CA]",
    )
    server.add_argument(
        "--start-cmd",
        metavar="CMD",
        help="start the server under test with this command; the kit sets "
        "PROCTOR_HOST, PROCTOR_PORT, PROCTOR_TOKENS (account:scopes:token, with "
        "commas between several; a scope is read, run or read+run) and "
        "PROCTOR_DATABASE (the path of a file) in its environment",
    )
    server.add_argument(
        "--nodes",
        metavar="N",
        type=int,
        default=1,
        help="start --start-cmd so many times with one PROCTOR_DATABASE, each on a "
        "port of its own; PROCTOR_PUBLIC_URL is the URL of the first",
    )
    server.add_argument(
        "--restart-cmd",
        metavar="CMD",
        help="command that kills the server at --url and restarts it",
    )
    server.add_argument(
        "--not-durable",
        action="store_true",
        help="the runs of this server do not outlive its process: kill nothing, and "
        "report the rules about crashes as not verified",
    )
    accounts = parser.add_argument_group(
        "accounts (environment variables are preferred)"
    )
    accounts.add_argument(
        "--token", help="token with the scopes read and run [PROCTOR_TOKEN]"
    )
    accounts.add_argument(
        "--token-2", help="token of a second account [PROCTOR_TOKEN_2]"
    )
    accounts.add_argument(
        "--token-read",
        help="token of the first account with the scope read only [PROCTOR_TOKEN_READ]",
    )
    _add_selection(parser)
    _add_execution(parser)
    _add_attestation(parser)
    return parser


def _version() -> str:
    """Name the kit and the specification that it judges."""
    try:
        installed = importlib.metadata.version("proctor-conformance")
    except importlib.metadata.PackageNotFoundError:
        installed = "of a checkout"
    return f"proctor-conformance {installed}, specification {spec_name()}"


def _add_selection(parser: argparse.ArgumentParser) -> None:
    selection = parser.add_argument_group("selection")
    selection.add_argument("--only", metavar="ID,...", help="rule ids or id prefixes")
    selection.add_argument("--profile", metavar="NAME,...", help=", ".join(PROFILES))
    selection.add_argument(
        "--quick",
        action="store_true",
        help="skip checks that wait, kill the server or play a long run",
    )
    selection.add_argument(
        "--stage",
        type=int,
        choices=[stage.number for stage in STAGES],
        help="the rules that a server of so many stages can obey: "
        + ", ".join(f"{stage.number} {stage.name}" for stage in STAGES),
    )
    selection.add_argument(
        "--list", action="store_true", help="print the rules and exit"
    )
    selection.add_argument(
        "--dry-run",
        action="store_true",
        help="print the checks that would run and their rules; send no request",
    )


def _add_execution(parser: argparse.ArgumentParser) -> None:
    execution = parser.add_argument_group("execution")
    execution.add_argument(
        "--seed", type=int, help="seed of the generated requests (reproduces a kit run)"
    )
    execution.add_argument(
        "-n",
        metavar="N",
        type=int,
        help=f"number of parallel processes; {_QUICK_PROCESSES} with --quick alone, "
        "otherwise 1",
    )
    execution.add_argument(
        "--fail-fast",
        action="store_true",
        help="start no check after the first violated MUST; the remaining rules are "
        "reported as not verified; rules are judged in the order of --only",
    )
    execution.add_argument(
        "--max-time",
        type=float,
        metavar="SECONDS",
        help="start no check after this time; the remaining rules are reported as "
        "not verified",
    )
    execution.add_argument(
        "--stress",
        action="store_true",
        help="also send requests that are too large or too slow to the server at "
        "--url; without this option only a server started by --start-cmd gets them",
    )
    execution.add_argument(
        "--exchanges",
        action="store_true",
        help="also report the requests and answers of rules that passed, as scripts "
        "and as data: what a right server answers",
    )
    execution.add_argument(
        "--report", default="report", metavar="DIR", help="directory of the reports"
    )
    execution.add_argument(
        "--summary",
        metavar="FILE",
        help="append a short report in Markdown, for the page of a CI job",
    )
    execution.add_argument(
        "--known-failures",
        metavar="FILE",
        help="file with one rule id and a # comment per line: these failures do not "
        "fail the run; an entry that passes does",
    )


def _add_attestation(parser: argparse.ArgumentParser) -> None:
    statement = parser.add_argument_group("statement")
    statement.add_argument(
        "--attest",
        metavar="FILE",
        help="write the verdict on all rules as an in-toto statement (test-result)",
    )
    statement.add_argument(
        "--attest-key",
        metavar="FILE",
        help="sign it with this Ed25519 private key, in PEM",
    )
    statement.add_argument(
        "--attest-subject",
        metavar="NAME@sha256:HEX",
        help="what the server was built as, such as an image and its digest",
    )


def read_processes(options: argparse.Namespace) -> int:
    """The number of processes that judge; one process keeps the order of --only."""
    if options.n is not None:
        return int(options.n)
    is_ordered = bool(options.only or options.fail_fast)
    return _QUICK_PROCESSES if options.quick and not is_ordered else 1


def read_selection(options: argparse.Namespace) -> Settings:
    """Read the selection, which needs no server, or raise BadArguments."""
    only = _split(options.only)
    for wanted in only:
        if not any(rule_id.startswith(wanted) for rule_id in load_ledger()):
            problem = f"--only {wanted}: no rule id starts with {wanted}"
            raise BadArguments(problem + _suggestion(wanted))
    profiles = _split(options.profile)
    for profile in profiles:
        if profile not in PROFILES:
            raise BadArguments(
                f"--profile {profile}: unknown profile; known: {', '.join(PROFILES)}"
            )
    return Settings(
        quick=options.quick,
        stage=options.stage,
        only=only,
        profiles=profiles or list(PROFILES),
        report=options.report,
    )


def _suggestion(wanted: str) -> str:
    areas = dict.fromkeys(row.area for row in load_ledger().values())
    close = _close_matches(wanted, load_ledger()) or _close_matches(
        wanted.partition("-")[0], areas
    )
    if close:
        return f"; did you mean {' or '.join(close)}?"
    return f"; areas: {', '.join(areas)}"


def _close_matches(wanted: str, names: Iterable[str]) -> list[str]:
    return difflib.get_close_matches(wanted.upper(), list(names), n=3, cutoff=0.6)


def read_settings(options: argparse.Namespace) -> Settings:
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
    if options.max_time is not None:
        settings.max_time_s = options.max_time
        settings.deadline = time.monotonic() + options.max_time
    return settings


def _read_accounts(options: argparse.Namespace, settings: Settings) -> None:
    accept_authorities(options.ca)
    settings.token = read_secret(options.token, "--token", "PROCTOR_TOKEN")
    settings.token_2 = read_secret(options.token_2, "--token-2", "PROCTOR_TOKEN_2")
    settings.token_read = read_secret(
        options.token_read, "--token-read", "PROCTOR_TOKEN_READ"
    )


def _read_nodes(options: argparse.Namespace, settings: Settings) -> None:
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


def _read_attestation(options: argparse.Namespace, settings: Settings) -> None:
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
    except (ValueError, CannotAttest) as error:
        raise BadArguments(str(error)) from error


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
