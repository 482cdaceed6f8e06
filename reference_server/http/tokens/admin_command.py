"""`proctor admin`: tokens, keys, recordings, seeds, database, backup of a server here.

`token add|list|revoke` edits the file of tokens, which the server reads again within
seconds: no restart.
A new token is printed once; the file has its hash alone.
"""

from __future__ import annotations

import argparse
import re
import sys
from collections.abc import Sequence
from pathlib import Path

from pydantic import ValidationError
from pydantic_settings import SettingsError

from reference_record.broken import UnusableRecord
from reference_server.http.auth import (
    HOST,
    READ_ALL,
    BadTokens,
    hash_of,
    new_secret,
)
from reference_server.http.pages import operator_page
from reference_server.http.tokens.token_file import (
    edited_lines,
    parse,
    parse_line,
    read_bytes,
    token_id,
)
from reference_server.records import admin_seeds
from reference_server.records.admin_areas import AdminFiles, CannotDo, add_areas
from reference_server.settings import Settings, describe_faults
from reference_server.storage import backup_command, database_commands
from reference_server.storage.backup_command import KeptFiles
from reference_server.storage.store import StoreFailed

_SCOPES = ("read", "run", READ_ALL, HOST)
SCOPES_TEXT = (
    "read, run or read+run; with +read_all it reads the runs of all accounts, "
    "with +host it flags entries of the leaderboard"
)
_ACCOUNT = r"[A-Za-z0-9_.@-]{1,64}"


class AdminError(Exception):
    """The command cannot be carried out; the text says why, in one line."""


def main(arguments: Sequence[str] | None = None) -> int:
    """Returns the exit code: 0, or 2 with one line on stderr."""
    args = _parser().parse_args(arguments)
    try:
        if hasattr(args, "do_with_settings"):
            args.do_with_settings(_settings(), args)
        elif hasattr(args, "do_with_kept"):
            args.do_with_kept(_kept_files(), args)
        elif hasattr(args, "do_with_files"):
            args.do_with_files(_record_files(), args)
        elif hasattr(args, "do_with_database"):
            args.do_with_database(_settings().database_url, args)
        else:
            args.do(_path(args), args)
    except (AdminError, CannotDo, BadTokens, OSError) as error:
        print(f"proctor: {error}", file=sys.stderr)
        return 2
    except (StoreFailed, UnusableRecord) as error:
        print(f"proctor: {error}", file=sys.stderr)
        return 2
    return 0


def _path(args: argparse.Namespace) -> Path:
    path = Path(args.file) if args.file else _settings().tokens_file_path
    if path is None:
        raise AdminError("the database is no file; name a file with --file")
    return path


def _record_files() -> AdminFiles:
    settings = _settings()
    return AdminFiles(
        settings.database_url,
        settings.signing_key_path,
        settings.records_path,
        settings.records_keep_days,
        settings.seed_secret_path,
        settings.benchmarks,
    )


def _kept_files() -> KeptFiles:
    settings = _settings()
    name = settings.database
    return KeptFiles(
        settings.database_url,
        "postgresql" if "://" in name else Path(name).name,
        {
            "key": settings.sealing_key_path,
            "seeds": settings.seed_secret_path,
            "tokens": settings.tokens_file_path,
            "token": settings.token_path,
            "signing-key": settings.signing_key_path,
        },
        {"records": settings.records_path, "records.imported": settings.imports_path},
    )


def _settings() -> Settings:
    try:
        return Settings()
    except ValidationError as error:
        raise AdminError(f"bad settings: {describe_faults(error)}") from error
    except SettingsError as error:
        raise AdminError(f"bad settings: {error}") from error


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="proctor admin", description="Manage a server of this machine."
    )
    areas = parser.add_subparsers(metavar="AREA", required=True)
    token = areas.add_parser("token", help="who may use the server")
    commands = token.add_subparsers(metavar="COMMAND", required=True)
    add = commands.add_parser("add", help="make a token and print it, once")
    add.add_argument("account", metavar="ACCOUNT", help="whose runs it makes and sees")
    add.add_argument(
        "--scopes",
        default="read+run",
        help=f"{SCOPES_TEXT} (read+run)",
    )
    add.set_defaults(do=_add)
    listed = commands.add_parser("list", help="list tokens by id, without secrets")
    listed.set_defaults(do=_list)
    revoke = commands.add_parser("revoke", help="make tokens invalid")
    revoke.add_argument(
        "which", metavar="ID|ACCOUNT", help="id of one, or the account for all of its"
    )
    revoke.set_defaults(do=_revoke)
    add_areas(areas)
    admin_seeds.add_area(areas)
    database_commands.add_area(areas)
    backup_command.add_command(areas)
    operator_page.add_command(areas)
    for command in (add, listed, revoke):
        command.add_argument(
            "--file",
            metavar="FILE",
            help="file of tokens (that of the server with the settings of this "
            "environment: var/proctor.sqlite.tokens)",
        )
    return parser


def _add(path: Path, args: argparse.Namespace) -> None:
    if not re.fullmatch(_ACCOUNT, args.account):
        raise AdminError(
            f"{args.account!r} cannot be an account: letters, digits and _.@- only"
        )
    secret = new_secret()
    line = f"{args.account}:{args.scopes}:sha256={hash_of(secret)}"
    try:
        parse_line(line, "what was given")
    except BadTokens as error:  # the account is right, and so is the hash
        raise AdminError(f"--scopes {args.scopes}: expected {SCOPES_TEXT}") from error
    with edited_lines(path) as lines:
        lines.append(line)
    print(secret)
    print(
        f"proctor: token {token_id(hash_of(secret))} of {args.account} with the scopes "
        f"{args.scopes}, shown this once; its hash is in {path}",
        file=sys.stderr,
    )


def _list(path: Path, _args: argparse.Namespace) -> None:
    try:
        callers = parse(read_bytes(path), path)
    except FileNotFoundError:
        callers = {}
    for hashed, caller in callers.items():
        scopes = "+".join(scope for scope in _SCOPES if scope in caller.scopes)
        print(f"{token_id(hashed)}  {scopes:<18}  {caller.account}")


def _revoke(path: Path, args: argparse.Namespace) -> None:
    which, revoked = args.which, []
    with edited_lines(path) as lines:
        for line in list(lines):
            for hashed, caller in parse(line.encode(), path).items():
                if which in (token_id(hashed), caller.account):
                    lines.remove(line)
                    revoked.append(f"{token_id(hashed)} of {caller.account}")
    if not revoked:
        raise AdminError(f"no token has the id or the account {which}; see token list")
    for description in revoked:
        print(f"revoked {description}")


if __name__ == "__main__":
    sys.exit(main())
