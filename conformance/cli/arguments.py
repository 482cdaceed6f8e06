"""The command line of the kit."""

import argparse
import difflib
import os
import random
import time
from collections.abc import Iterable
from typing import NoReturn

from conformance.run_settings import Settings
from conformance.specification.ledger import PROFILES, load_ledger


class BadArguments(Exception):
    """The command line makes no sense, and why."""


class _Parser(argparse.ArgumentParser):
    def error(self, message: str) -> NoReturn:
        raise BadArguments(message)


def build_parser() -> argparse.ArgumentParser:
    """Describe every option."""
    parser = _Parser(
        prog="proctor-conformance",
        description="Judge a Proctor server by its answers alone.",
        epilog="Exit codes: 0 conformant, 1 a MUST is violated, 2 could not judge. "
        "Every run leaves report.html, report.json, junit.xml and badge.svg in "
        "--report.",
    )
    server = parser.add_argument_group("the server")
    server.add_argument("--url", help="base URL of the server to judge")
    server.add_argument(
        "--start-cmd",
        metavar="CMD",
        help="start the server with this command instead; it gets PROCTOR_HOST, "
        "PROCTOR_PORT, PROCTOR_TOKENS and PROCTOR_DATABASE in its environment",
    )
    server.add_argument(
        "--restart-cmd",
        metavar="CMD",
        help="command that kills the server at --url and starts it again",
    )
    accounts = parser.add_argument_group("accounts (better given by environment)")
    accounts.add_argument("--token", help="token with read and run [PROCTOR_TOKEN]")
    accounts.add_argument("--token-2", help="another account's [PROCTOR_TOKEN_2]")
    accounts.add_argument(
        "--token-read", help="the first account's, read only [PROCTOR_TOKEN_READ]"
    )
    choice = parser.add_argument_group("what is judged")
    choice.add_argument("--only", metavar="ID,...", help="ids or beginnings of ids")
    choice.add_argument("--profile", metavar="NAME,...", help=", ".join(PROFILES))
    choice.add_argument("--quick", action="store_true", help="leave out what waits")
    choice.add_argument("--list", action="store_true", help="list the rules and stop")
    choice.add_argument(
        "--dry-run",
        action="store_true",
        help="list the checks that would run and their rules; send nothing",
    )
    manner = parser.add_argument_group("how")
    manner.add_argument("--seed", type=int, help="repeat a run's generated requests")
    manner.add_argument("-n", metavar="N", type=int, default=0, help="processes")
    manner.add_argument(
        "--max-time",
        type=float,
        metavar="SECONDS",
        help="start no further check after this time; what is left is not verified",
    )
    manner.add_argument("--report", default="report", metavar="DIR")
    manner.add_argument(
        "--known-failures",
        metavar="FILE",
        help="one id per line and a # comment; such a failure is reported but does "
        "not fail the run, and an entry that does not fail any more does",
    )
    return parser


def read_choice(options: argparse.Namespace) -> Settings:
    """Read what is to be judged, which needs no server; or raise BadArguments."""
    only = _split(options.only)
    for wanted in only:
        if not any(known.startswith(wanted) for known in load_ledger()):
            problem = f"--only {wanted}: no requirement has such an id"
            raise BadArguments(problem + _suggestion(wanted))
    profiles = _split(options.profile)
    for profile in profiles:
        if profile not in PROFILES:
            raise BadArguments(f"--profile {profile}: there are {', '.join(PROFILES)}")
    return Settings(
        quick=options.quick,
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
    return f"; the areas are {', '.join(areas)}"


def _close_matches(wanted: str, known: Iterable[str]) -> list[str]:
    return difflib.get_close_matches(wanted.upper(), list(known), n=3, cutoff=0.6)


def read_settings(options: argparse.Namespace) -> Settings:
    """Turn options and environment into settings, or raise BadArguments."""
    settings = read_choice(options)
    if options.start_cmd is None and options.url is None:
        raise BadArguments("give --url URL or --start-cmd CMD")
    if options.start_cmd is not None and options.url is not None:
        raise BadArguments("--url and --start-cmd exclude each other")
    if options.start_cmd is not None and options.restart_cmd is not None:
        raise BadArguments("--start-cmd restarts by itself; leave --restart-cmd away")
    if options.url is not None and not options.url.startswith(("http://", "https://")):
        raise BadArguments(f"--url {options.url} is no http or https URL")
    if options.max_time is not None and not options.max_time > 0:
        raise BadArguments(f"--max-time {options.max_time:g}: give some seconds")
    environment = os.environ
    settings.url = (options.url or "").rstrip("/")
    settings.token = options.token or environment.get("PROCTOR_TOKEN") or None
    settings.token_2 = options.token_2 or environment.get("PROCTOR_TOKEN_2") or None
    settings.token_read = (
        options.token_read or environment.get("PROCTOR_TOKEN_READ") or None
    )
    settings.start_cmd = options.start_cmd
    settings.restart_cmd = options.restart_cmd
    seed: int | None = options.seed
    settings.seed = seed if seed is not None else random.randrange(10**6)
    if options.max_time is not None:
        settings.max_time_s = options.max_time
        settings.deadline = time.monotonic() + options.max_time
    return settings


def _split(text: str | None) -> list[str]:
    return [part.strip() for part in (text or "").split(",") if part.strip()]


def read_known_failures(path: str | None) -> set[str]:
    """Read the ids of a file of known failures."""
    if path is None:
        return set()
    try:
        with open(path, encoding="utf-8") as file:  # noqa: PTH123 - as the user gave it
            lines = file.read().splitlines()
    except OSError as error:
        raise BadArguments(f"--known-failures {path}: {error.strerror}") from error
    known: set[str] = set()
    for number, line in enumerate(lines, 1):
        requirement_id, _, comment = line.partition("#")
        requirement_id = requirement_id.strip()
        if not requirement_id:
            continue
        where = f"--known-failures {path} line {number}"
        if requirement_id not in load_ledger():
            problem = f"{where}: there is no requirement {requirement_id}"
            raise BadArguments(problem + _suggestion(requirement_id))
        if not comment.strip():
            raise BadArguments(f"{where}: say after a # why {requirement_id} fails")
        known.add(requirement_id)
    return known
