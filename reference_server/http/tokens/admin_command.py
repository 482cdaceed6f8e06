"""`proctor admin`: tokens, keys, recordings, seeds, the database of a server here.

`token add|list|revoke` edits the file of tokens, which the server reads again within
seconds: no restart.
A new token is printed once; the file has its hash alone.
"""

from __future__ import annotations

import os
import re
import sys
from collections.abc import Sequence
from pathlib import Path

from reference_record.broken import UnusableRecord
from reference_record.command_line.click_commands import (
    Command,
    Group,
    Options,
    WrongUsage,
    argument,
    option,
    parse_options,
)
from reference_record.command_line.closed_output import run_program
from reference_server.files.file_faults import describe_file_fault
from reference_server.files.object_storage import storage_at
from reference_server.http.auth import (
    HOST,
    OPERATOR,
    READ_ALL,
    BadTokens,
    hash_of,
    new_secret,
)
from reference_server.http.pages.operator_page import page_command
from reference_server.http.tokens import made_token
from reference_server.http.tokens.token_file import (
    edited_lines,
    parse,
    parse_line,
    read_bytes,
    token_id,
)
from reference_server.records.admin_areas import AdminFiles, CannotDo, record_areas
from reference_server.records.admin_seeds import seeds_area
from reference_server.settings import Settings
from reference_server.settings.setting_options import (
    misspelled_variables,
    read_settings,
)
from reference_server.storage.backup_command import KeptFiles, backup_command
from reference_server.storage.database_commands import database_area
from reference_server.storage.folder_id import require_files
from reference_server.storage.runs.run_store import StoreFailed

_SCOPES = ("read", "run", READ_ALL, HOST, OPERATOR)
SCOPES_TEXT = (
    "read, run or read+run; with +read_all it reads the runs of all accounts, "
    "with +host it flags entries of the leaderboard, with run and both it stops runs "
    "of all accounts; or operator, for robot cells"
)
_NOT_ALONE = (
    "the server has another user, so its pages draw no film of a sealed episode from "
    "now on; proctor video on this machine draws them"
)
_ACCOUNT = r"[A-Za-z0-9_.@-]{1,64}"


def main(arguments: Sequence[str] | None = None) -> int:
    """Returns the exit code: 0, or 2 with one line on stderr."""
    try:
        args = parse_options(build_command(), arguments)
        for line in misspelled_variables(os.environ):
            print(f"proctor: {line}", file=sys.stderr)
        if hasattr(args, "do_with_settings"):
            args.do_with_settings(_settings_here(), args)
        elif hasattr(args, "do_with_kept"):
            args.do_with_kept(_kept_files(_settings_here()), args)
        elif hasattr(args, "do_with_files"):
            args.do_with_files(_record_files(_settings_here()), args)
        elif hasattr(args, "do_with_database"):
            args.do_with_database(read_settings([]).database_url, args)
        else:
            args.do(_path(args), args)
    except BrokenPipeError:  # of the standard output
        raise
    except OSError as error:
        print(f"proctor: {describe_file_fault(error)}", file=sys.stderr)
        return 2
    except (CannotDo, BadTokens, WrongUsage, StoreFailed, UnusableRecord) as error:
        print(f"proctor: {error}", file=sys.stderr)
        return 2
    return 0


def _path(args: Options) -> Path:
    if args.file:
        return Path(args.file)
    settings = read_settings([])
    if not settings.tokens_file:
        _require_files(settings, more=", or the file of its tokens with --file")
    return settings.tokens_file_path


def _settings_here() -> Settings:
    """The settings of a server that has its files here. Raises StoreFailed."""
    settings = read_settings([])
    _require_files(settings)
    return settings


def _require_files(settings: Settings, *, more: str = "") -> None:
    require_files(settings.database_url, settings.folder_id_path, more=more)


def _record_files(settings: Settings) -> AdminFiles:
    return AdminFiles(
        settings.database_url,
        settings.signing_key_path,
        settings.records_path,
        settings.records_keep_days,
        settings.seed_secret_path,
        settings.benchmark_references,
        storage_at(settings.records_storage),
    )


def _kept_files(settings: Settings) -> KeptFiles:
    name, records = settings.database_name, settings.records_name
    made = {
        f"{name}.key": settings.sealing_key_path,
        f"{name}.seeds": settings.seed_secret_path,
    }
    made_if_recorded = {f"{name}.signing-key": settings.signing_key_path}
    others = {
        f"{name}.tokens": settings.tokens_file_path,
        f"{name}.token": settings.token_path,
        f"{name}.cells.jsonl": settings.cell_acts_path,
    }
    if settings.folder_id_path is not None:
        others[f"{name}.id"] = settings.folder_id_path
    if not settings.records_storage:  # else the folders are a cache
        made_if_recorded[records] = settings.records_path
        others[f"{records}.imported"] = settings.imports_path
    (others if settings.recordings == "off" else made).update(made_if_recorded)
    return KeptFiles(
        settings.database_url,
        name,
        settings.database_folder,
        made,
        others,
        settings.records_storage,
    )


def build_command() -> Group:
    """The command `proctor admin`: areas, each with commands."""
    file = option(
        "--file",
        "file of tokens (that of the server with the settings of this environment: "
        "var/proctor.sqlite.tokens)",
        metavar="FILE",
    )
    account = argument("account", "whose runs it makes and sees")
    scopes = option("--scopes", f"{SCOPES_TEXT} (read+run)", default="read+run")
    which = argument(
        "which", "id of one, or the account for all of its", metavar="ID|ACCOUNT"
    )
    commands = [
        Command(
            "add", "make a token and print it, once", [account, scopes, file], do=_add
        ),
        Command("list", "list tokens by id, without secrets", [file], do=_list),
        Command("revoke", "make tokens invalid", [which, file], do=_revoke),
    ]
    areas = [
        Group("token", "who may use the server", commands),
        *record_areas(),
        seeds_area(),
        database_area(),
        backup_command(),
        page_command(),
    ]
    return Group("proctor admin", "manage a server of this machine", areas)


def _add(path: Path, args: Options) -> None:
    if not re.fullmatch(_ACCOUNT, args.account):
        raise CannotDo(
            f"{args.account!r} cannot be an account: letters, digits and _.@- only"
        )
    secret = new_secret()
    line = f"{args.account}:{args.scopes}:sha256={hash_of(secret)}"
    try:
        parse_line(line, "what was given")
    except BadTokens as error:  # the account is right, and so is the hash
        raise CannotDo(f"--scopes {args.scopes}: expected {SCOPES_TEXT}") from error
    with edited_lines(path) as lines:
        is_first = all(line.startswith("#") for line in lines)
        lines.append(line)
    print(secret)
    print(
        f"proctor: token {token_id(hash_of(secret))} of {args.account} with the scopes "
        f"{args.scopes}, shown this once; its hash is in {path.absolute()}",
        file=sys.stderr,
    )
    if is_first:
        print(f"proctor: {_NOT_ALONE}", file=sys.stderr)


def _list(path: Path, args: Options) -> None:
    try:
        callers = parse(read_bytes(path), path)
    except FileNotFoundError:
        callers = {}
    made_path = _made_token_path(args)
    made = made_token.callers_of(made_path)
    for hashed, caller in [*made.items(), *callers.items()]:
        scopes = "+".join(scope for scope in _SCOPES if scope in caller.scopes)
        place = f"  the server's own, in {made_path}" if hashed in made else ""
        print(f"{token_id(hashed)}  {scopes:<18}  {caller.account}{place}")


def _made_token_path(args: Options) -> Path | None:
    """The file of the token that the server has made; None if it has others."""
    if args.file:
        return None
    settings = read_settings([])
    return None if settings.tokens else settings.token_path


def _revoke(path: Path, args: Options) -> None:
    which, revoked = args.which, []
    with edited_lines(path) as lines:
        for line in list(lines):
            for hashed, caller in parse(line.encode(), path).items():
                if which in (token_id(hashed), caller.account):
                    lines.remove(line)
                    revoked.append(f"{token_id(hashed)} of {caller.account}")
        if not revoked:
            raise CannotDo(_why_none_was_revoked(args))
    for description in revoked:
        print(f"revoked {description}")


def _why_none_was_revoked(args: Options) -> str:
    path = _made_token_path(args)
    for hashed, caller in made_token.callers_of(path).items():
        if args.which in (token_id(hashed), caller.account):
            return (
                f"the token {token_id(hashed)} of {caller.account} is the server's "
                f"own: stop the server and remove {path}; its next start makes another"
            )
    return f"no token has the id or the account {args.which}; see token list"


if __name__ == "__main__":
    sys.exit(run_program(main))
