"""`proctor admin account|track|image|submission|platform|…`, on the host's machine.

It changes the database of the platform, which may run meanwhile: a revoked key ends
within seconds. Each change stands in the audit log under the user of this machine.
"""

from __future__ import annotations

import asyncio
import contextlib
import getpass
import secrets
import sys
import time
from collections.abc import Callable, Mapping, Sequence
from datetime import datetime
from pathlib import Path
from typing import Any

import click
import msgspec

from reference_platform.accounts.account_keys import SCOPES
from reference_platform.accounts.account_rules import (
    DECISIONS,
    Account,
    AccountState,
    Role,
    SignUp,
    check_key_scopes,
    parse_decision,
)
from reference_platform.command_line.host_command import DATABASE
from reference_platform.command_line.operation_commands import operation_groups
from reference_platform.command_line.submission_commands import submission_groups
from reference_platform.parts import Parts
from reference_platform.storage.platform_database import BadDatabase, audit, audit_lines
from reference_platform.storage.submissions_folder import folder_of
from reference_platform.tracks.track_rules import Track
from reference_record.command_line.click_commands import (
    Command,
    Group,
    Options,
    WrongUsage,
    argument,
    count,
    flag,
    number_of_days,
    option,
    parse_options,
)
from reference_record.command_line.closed_output import run_program
from reference_record.command_line.document_faults import describe_fault
from reference_record.command_line.toml_file import read_toml_file
from reference_record.texts.timestamps import timestamp
from reference_server.http.tokens import admin_command as server_admin
from reference_server.rules.refusal import Refused

_MOMENT = "2026-01-01T00:00:00Z"
_STATES: Sequence[AccountState] = ("pending", "approved", "suspended", "rejected")


def main(arguments: Sequence[str] | None = None) -> int:
    """Returns the exit code: 0, or 2 with one line on stderr."""
    words = sys.argv[1:] if arguments is None else [*arguments]
    if words and words[0] in server_admin.build_command().commands:
        return server_admin.main(words)
    try:
        args = parse_options(build_command(), words)
        if getattr(args, "submissions", ...) is None:
            args.submissions = folder_of(Path(args.database))
        if getattr(args, "does_without_parts", False):
            args.do(args)
        else:
            parts = _open(Path(args.database))
            with contextlib.closing(parts.database):
                args.do(parts, args)
    except (Refused, WrongUsage, BadDatabase, OSError, ValueError) as error:
        print(f"proctor: {error}", file=sys.stderr)
        return 2
    return 0


def _open(path: Path) -> Parts:
    if not path.exists():
        text = f"there is no {path}; proctor-host makes it, or name it"
        raise BadDatabase(f"{text} with --database")
    return Parts.of(path)


def build_command() -> Group:
    """All areas of `proctor admin`: those of the server are another program's."""
    return Group(
        "proctor admin",
        "manage a server, and a challenge beside it, of this machine",
        {
            "Of a challenge": challenge_areas(),
            "Of a server": [*server_admin.build_command().commands.values()],
        },
    )


def challenge_areas() -> list[click.Command]:
    """The areas of `proctor admin` that are the platform's."""
    database = option(
        "--database", f"file of the platform ({DATABASE})", default=DATABASE
    )
    submissions = option(
        "--submissions", "folder of submissions (that of the host of the database)",
        type=Path,
    )  # fmt: skip
    account = argument("account", "name of the account")
    reason = option("--reason", "the account gets it", default="")
    decisions = [
        Command(
            name, f"{name} an account", [account, reason, database],
            do=_decide, decision=name,
        )
        for name in dict.fromkeys(name for row in DECISIONS.values() for name in row)
    ]  # fmt: skip
    profile = [
        option("--full-name", "its person", required=True),
        option("--organisation", "its organisation", required=True),
        option("--email", "its address", required=True),
        flag("--administrator", "it reviews others"),
    ]
    names = ", ".join(SCOPES)
    scopes = option("--scopes", f"of {names} (read+run)", default="read+run")
    days = option(
        "--days", "days until it expires (90)", type=number_of_days, default=90.0
    )
    accounts = [
        Command("list", "list accounts", [database], do=_list),
        Command(
            "add", "make an approved account, print its password",
            [account, *profile, database], do=_add,
        ),
        *decisions,
        Command(
            "delete", "delete accounts that were never approved",
            [argument("accounts", "names of accounts", nargs=-1, required=True),
             database], do=_delete,
        ),
        Command("password", "print a new password", [account, database], do=_password),
        Command(
            "key", "make a key, print it", [account, scopes, days, database], do=_key
        ),
    ]  # fmt: skip
    file = argument("file", "TOML file of a track", metavar="FILE")
    tracks = [
        Command("list", "list tracks", [database], do=_tracks),
        Command("put", "make or change a track", [file, database], do=_put_track),
        Command(
            "delete",
            "delete a track that nothing has entered",
            [argument("track", "id of the track"), database],
            do=_delete_track,
        ),
    ]
    newest = option("--newest", "so many lines (50)", type=count, default=50)
    return [
        Group("account", "who may take part", accounts),
        Group("track", "what is evaluated", tracks),
        *submission_groups(database, submissions),
        *operation_groups(database, submissions),
        Command("audit", "what administrators did", [newest, database], do=_audit),
    ]


Do = Callable[[Parts, Options], None]


def _actor() -> str:
    return f"{getpass.getuser()} on this machine"


def _list(parts: Parts, _args: Options) -> None:
    for state in _STATES:
        for account in parts.accounts.in_state(state):
            print(_line_of(account))


def _line_of(account: Account) -> str:
    who = f"{account.full_name}, {account.organisation}, {account.email}"
    return f"{account.account:<20} {account.state:<10} {who} {account.reason}".rstrip()


def _add(parts: Parts, args: Options) -> None:
    password = secrets.token_urlsafe(12)
    filled = SignUp(
        account=args.account, full_name=args.full_name, email=args.email,
        organisation=args.organisation, password=password, agrees=True,
    )  # fmt: skip
    role: Role = "administrator" if args.administrator else "participant"
    asyncio.run(parts.accounts.register(filled, role))
    parts.accounts.decide(args.account, "approve", "", _actor())
    print(password)


def _decide(parts: Parts, args: Options) -> None:
    decision = parse_decision(args.decision)
    account = parts.accounts.decide(args.account, decision, args.reason, _actor())
    print(_line_of(account))


def _delete(parts: Parts, args: Options) -> None:
    with parts.database.transaction():  # all of them, or none
        for account in args.accounts:
            parts.accounts.delete(account, _actor())


def _password(parts: Parts, args: Options) -> None:
    account, password = parts.accounts.get(args.account), secrets.token_urlsafe(12)
    with parts.database.transaction():
        asyncio.run(parts.accounts.set_password(account, password))
        _note(parts, "set_password", args.account)
    print(password)


def _key(parts: Parts, args: Options) -> None:
    account, scopes = parts.accounts.get(args.account), args.scopes.split("+")
    check_key_scopes(account, scopes)
    with parts.database.transaction():
        key, secret = parts.keys.make(
            account.account, "made by the host", scopes, args.days * 86_400, time.time()
        )
        _note(parts, "make_key", f"{args.account} {key.key_id}")
    print(secret)


def _tracks(parts: Parts, _args: Options) -> None:
    for track in parts.tracks.all():
        print(f"{track.track_id:<24} {track.title}")
        for phase in track.phases:
            dates = f"{timestamp(phase.opens_at)} to {timestamp(phase.closes_at)}"
            print(f"    {phase.phase_id:<20} {phase.benchmark_id:<20} {dates}")


def _put_track(parts: Parts, args: Options) -> None:
    values = read_toml_file(args.file)
    try:
        track = msgspec.convert(_with_seconds(values), type=Track)
        doubts = parts.tracks.doubts(track)
        parts.tracks.put(track, _actor())
    except msgspec.ValidationError as error:
        raise WrongUsage(f"{args.file}: {describe_fault(error, Track)}") from error
    except Refused as refused:
        raise WrongUsage(f"{args.file}: {refused}") from refused
    for doubt in doubts:
        print(f"proctor: warning: {doubt}", file=sys.stderr)
    print(f"track {track.track_id}")


def _with_seconds(values: Mapping[str, Any]) -> Mapping[str, Any]:
    """Moments of TOML become seconds, as `Phase` has them. Raises ValidationError.

    A value of another type stays as it is, and the check of types refuses it.
    """
    phases = values.get("phases")
    if not isinstance(phases, list):
        return values
    return {
        **values,
        "phases": [
            {name: _seconds(name, at, place) for name, at in phase.items()}
            if isinstance(phase, dict)
            else phase
            for place, phase in enumerate(phases)
        ],
    }


def _seconds(name: str, value: object, place: int) -> object:
    """A day without a time, or without its zone, is another moment elsewhere."""
    if name not in ("opens_at", "closes_at"):
        return value
    if isinstance(value, datetime) and value.tzinfo is not None:
        return value.timestamp()
    text = f"write a date with its time in UTC, such as {_MOMENT}, without quotes"
    raise msgspec.ValidationError(f"{text} - at `$.phases[{place}].{name}`")


def _delete_track(parts: Parts, args: Options) -> None:
    parts.tracks.delete(args.track, _actor())
    print(f"track {args.track}: deleted")


def _audit(parts: Parts, args: Options) -> None:
    for line in reversed(audit_lines(parts.database, args.newest)):
        text = f"{timestamp(line.at)}  {line.actor}  {line.act}  {line.subject}"
        print(f"{text}  {line.detail}".rstrip())


def _note(parts: Parts, act: str, subject: str) -> None:
    audit(parts.database, time.time(), actor=_actor(), act=act, subject=subject)


if __name__ == "__main__":
    sys.exit(run_program(main))
