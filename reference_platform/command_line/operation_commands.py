"""`proctor admin platform|key`: what waits, is stuck and used; retention and backup."""

from __future__ import annotations

import contextlib
import getpass
import time
from pathlib import Path

import click

from reference_platform.images.presets import Presets
from reference_platform.images.python_preset import (
    DEFAULT,
    CannotMake,
    make_python_preset,
)
from reference_platform.parts import Parts
from reference_platform.storage.backup import BackupFailed, back_up, restore
from reference_platform.storage.host_status import bytes_by_folder, host_status, uses
from reference_platform.storage.platform_database import audit
from reference_platform.storage.retention import clean
from reference_record.command_line.click_commands import (
    Command,
    Group,
    Options,
    WrongUsage,
    argument,
    number_of_days,
    option,
)
from reference_record.texts.timestamps import timestamp


def operation_groups(
    database: click.Parameter, submissions: click.Parameter
) -> list[Group]:
    folder = argument("folder", "of the backup", type=Path)
    days = option("--days", "so many days (30)", type=number_of_days, default=30.0)
    name = argument("name", "of the preset, which participants give")
    packages = option(
        "--packages", f"installed here, besides its own ({'+'.join(DEFAULT)})",
        default="+".join(DEFAULT), may_be_empty=True,
    )  # fmt: skip
    account, key = argument("account", "its account"), argument("key", "id of the key")
    return [
        Group(
            "platform",
            "what waits, is stuck and is used; retention, backup",
            [
                Command(
                    "status", "what waits, what is stuck and why, the disk",
                    [submissions, database], do=_status,
                ),
                Command(
                    "usage", "what each account used in the last days",
                    [days, database], do=_usage,
                ),
                Command(
                    "clean", "remove logs, uploads, keys and mail that are older",
                    [days, submissions, database], do=_clean,
                ),
                Command(
                    "backup", "copy the platform to a folder, also while it runs",
                    [folder, submissions, database], do=_back_up,
                ),
                Command(
                    "restore", "put a backup where --database and --submissions say",
                    [folder, submissions, database],
                    do=_restore, does_without_parts=True,
                ),
            ],
        ),
        Group(
            "preset",
            "environments for code",
            [
                Command(
                    "add", "make a preset of this Python and packages of it",
                    [name, packages, submissions, database], do=_add_preset,
                ),
                Command(
                    "list", "list the presets", [submissions, database], do=_presets
                ),
            ],
        ),
        Group(
            "key",
            "keys of accounts",
            [
                Command("list", "list the valid keys", [database], do=_keys),
                Command("revoke", "revoke a key", [account, key, database], do=_revoke),
            ],
        ),
    ]  # fmt: skip


def _status(parts: Parts, args: Options) -> None:
    sizes = bytes_by_folder(args.submissions)
    status = host_status(parts, args.submissions, sizes)
    for what, count in status.waiting.items():
        print(f"{count:>6} {what}")
    states = ", ".join(f"{count} {state}" for state, count in status.states.items())
    print(f"submissions that have not ended: {states}")
    for one in status.stuck:
        print(f"STUCK {one.submission.submission_id} {one.submission.state}: {one.why}")
    print("disk:", ", ".join(f"{name} {_mib(sizes[name])}" for name in sizes))
    print(f"free: {_mib(status.free_bytes)}")
    for problem in status.problems:
        print(f"PROBLEM {problem}")


def _mib(size: int) -> str:
    return f"{size / 2**20:.1f} MiB"


def _usage(parts: Parts, args: Options) -> None:
    print("account               submissions counted  runs  keys  sandbox h    CPU h")
    for use in uses(parts, args.days):
        counts = f"{use.submissions:>11} {use.counted:>7} {use.runs:>5} {use.keys:>5}"
        hours = f"{use.sandbox_s / 3600:>10.2f} {use.cpu_s / 3600:>8.2f}"
        print(f"{use.account:<21} {counts} {hours}")


def _clean(parts: Parts, args: Options) -> None:
    removed = clean(parts, args.submissions, args.days, _actor())
    for what, count in removed.items():
        print(f"{count:>6} {what}")


def _back_up(parts: Parts, args: Options) -> None:
    """The audit log has it, as a copy of all that accounts have leaves the host."""
    _note(parts, "back_up", str(args.folder))
    try:
        for line in back_up(parts.database.path, args.submissions, args.folder):
            print(line)
    except BackupFailed as error:
        raise WrongUsage(str(error)) from error


def _restore(args: Options) -> None:
    try:
        for line in restore(args.folder, Path(args.database), args.submissions):
            print(line)
    except BackupFailed as error:
        raise WrongUsage(str(error)) from error
    parts = Parts.of(Path(args.database))
    with contextlib.closing(parts.database):
        _note(parts, "restore", str(args.folder))


def _add_preset(parts: Parts, args: Options) -> None:
    packages = [name for name in args.packages.split("+") if name]
    try:
        path = make_python_preset(args.submissions / "presets", args.name, packages)
    except CannotMake as error:
        raise WrongUsage(str(error)) from error
    _note(parts, "add_preset", args.name, " ".join(packages))
    print(path)


def _presets(_parts: Parts, args: Options) -> None:
    for name in Presets(args.submissions / "presets").names():
        print(name)


def _keys(parts: Parts, _args: Options) -> None:
    for account in parts.accounts.in_state("approved"):
        for key in parts.keys.of_account(account.account, time.time()):
            used = "never used" if key.used_at is None else timestamp(key.used_at)
            text = f"{key.key_id} {key.account:<20} {key.scopes:<16} {used}"
            print(f"{text} until {timestamp(key.expires_at)} {key.label}")


def _revoke(parts: Parts, args: Options) -> None:
    now = time.time()
    with parts.database.transaction():
        parts.keys.revoke(args.account, args.key, now)
        _note(parts, "revoke_key", f"{args.account} {args.key}")
    print(f"{args.key} revoked")


def _note(parts: Parts, act: str, subject: str, detail: str = "") -> None:
    audit(
        parts.database, time.time(), actor=_actor(), act=act, subject=subject,
        detail=detail,
    )  # fmt: skip


def _actor() -> str:
    return f"{getpass.getuser()} on this machine"
