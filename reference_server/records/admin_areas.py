"""`proctor admin keys` and `proctor admin records`: keys that sign, and disk space.

They work on the files and the database of a server, which may run meanwhile.
"""

from __future__ import annotations

import asyncio
import time
from collections import defaultdict
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from dataclasses import dataclass
from pathlib import Path

from reference_record.command_line.click_commands import (
    Command,
    Group,
    Options,
    flag,
    number_of_days,
    option,
)
from reference_record.command_line.replaced_file import replace_file
from reference_record.keys import load_or_make, make_key
from reference_record.texts.counted_text import counted
from reference_record.texts.timestamps import timestamp
from reference_server.files.object_storage import ObjectStorage
from reference_server.records.recordings import Recordings
from reference_server.records.run_records import HostSettings, RunRecords
from reference_server.rules.runs.run import PublicKey, RunHead
from reference_server.storage.record_store import RecordStore
from reference_server.storage.runs.run_store import Store

DAY_S = 86_400.0
RUNS_PER_READ = 200


class CannotDo(Exception):
    """The command cannot be carried out; the text says why, in one line."""


@dataclass(frozen=True, slots=True)
class AdminFiles:
    """The files of a server that signs and records.

    keep_days: how long the server promises to keep recordings; 0 is for good.
    benchmarks: the host's own, as in the setting. storage: has the finished recordings.
    """

    database_url: str
    key_path: Path
    folder: Path
    keep_days: float
    seed_secret_path: Path
    benchmarks: str = ""
    storage: ObjectStorage | None = None


def record_areas() -> list[Group]:
    """Both areas of `proctor admin`; `do_with_files` is the function of a command."""
    keys = [
        Command(
            "list",
            "every key that signed, newest first",
            [],
            do_with_files=list_keys,
        ),
        Command(
            "rotate",
            "make a new key, which signs from the next start of the server on",
            [],
            do_with_files=rotate_key,
        ),
    ]
    by_run = flag("--runs", "by run, largest first")
    older_than = option(
        "--older-than",
        "days since the run ended; no fewer than records_keep_days, which is a "
        "promise (0: to keep all)",
        type=number_of_days,
        required=True,
        metavar="DAYS",
    )
    dry_run = flag("--dry-run", "only list the runs")
    records = [
        Command(
            "usage",
            "bytes by benchmark, with the oldest run",
            [by_run],
            do_with_files=show_usage,
        ),
        Command(
            "prune",
            "remove the recordings of old runs",
            [older_than, dry_run],
            do_with_files=prune_old,
        ),
    ]
    return [
        Group("keys", "the keys that sign records", keys),
        Group("records", "disk space of recordings", records),
    ]


# --- keys ---


def list_keys(files: AdminFiles, _args: Options) -> None:
    """REC-101: what `list_keys` of the server shows."""
    for key in asyncio.run(_keys_of(files.database_url)):
        end = key.retired_at_wall
        until = "in use" if end is None else f"until {timestamp(end)}"
        since = timestamp(key.created_at_wall)
        print(f"{key.keyid}  since {since}  {until}")


async def _keys_of(url: str) -> list[PublicKey]:
    async with opened_store(url) as store:
        return await RecordStore(store.transactions).keys()


def rotate_key(files: AdminFiles, _args: Options) -> None:
    """Old statements stay valid: the server goes on to publish the old key."""
    path = files.key_path
    if not path.exists():
        raise CannotDo(f"there is no key in {path} yet; the server makes one")
    old, new = load_or_make(path), make_key()
    # The old secret signs nothing any more; what it signed needs its public key alone.
    replace_file(path, new.content_of_file(), is_private=True)
    print(f"old {old.keyid}\nnew {new.keyid}")
    print("the new key signs from the next start of the server on: restart it")


# --- disk space ---


@dataclass(frozen=True, slots=True)
class RunUsage:
    """head: None for a folder of a run that the database does not have."""

    run_id: str
    size_bytes: int
    head: RunHead | None

    @property
    def benchmark(self) -> str:
        return "(no run)" if self.head is None else self.head.manifest["benchmark_id"]

    def age_days(self, now_wall: float) -> float:
        if self.head is None:
            return 0.0
        return max(0.0, now_wall - self.head.updated_at_wall) / DAY_S


def show_usage(files: AdminFiles, args: Options) -> None:
    usages, now = asyncio.run(_usage_of(files)), time.time()
    if args.runs:
        for usage in sorted(usages, key=lambda usage: -usage.size_bytes):
            state = "-" if usage.head is None else usage.head.state
            print(
                f"{_shown(usage.size_bytes):>10}  {usage.age_days(now):7.1f} days  "
                f"{state:<9}  {usage.benchmark:<24}  {usage.run_id}"
            )
    else:
        by_benchmark: dict[str, list[RunUsage]] = defaultdict(list)
        for usage in usages:
            by_benchmark[usage.benchmark].append(usage)
        for name, runs in sorted(by_benchmark.items()):
            oldest = max(run.age_days(now) for run in runs)
            size = _shown(sum(run.size_bytes for run in runs))
            print(f"{size:>10}  {len(runs):6} runs  oldest {oldest:.1f} days  {name}")
    total = f"{_shown(sum(usage.size_bytes for usage in usages)):>10}  in all"
    print(total if files.storage is None else f"{total}, in {files.storage.url}")


async def _usage_of(files: AdminFiles) -> list[RunUsage]:
    sizes = _recordings_of(files).sizes()
    names = sorted(sizes)
    usages: list[RunUsage] = []
    async with opened_store(files.database_url) as store:
        for start in range(0, len(names), RUNS_PER_READ):
            page = names[start : start + RUNS_PER_READ]
            heads = await store.heads(page)
            usages += [RunUsage(name, sizes[name], heads.get(name)) for name in page]
    return usages


def prune_old(files: AdminFiles, args: Options) -> None:
    """Remove recordings of ended runs, as the server does after `records_keep_days`."""
    days, kept = args.older_than, files.keep_days
    if not kept:
        raise CannotDo(
            "records_keep_days is 0, a promise to keep all recordings; to end it, set "
            f"PROCTOR_RECORDS_KEEP_DAYS={days:g} for the server, and here"
        )
    if days < kept:
        raise CannotDo(
            f"records_keep_days is {kept:g}: runs that ended less than {kept:g} days "
            "ago keep their recordings"
        )
    before = {usage.run_id: usage.size_bytes for usage in asyncio.run(_usage_of(files))}
    removed = asyncio.run(_prune(files, days, is_dry=args.dry_run))
    for run_id in removed:
        print(f"{'would remove' if args.dry_run else 'removed'} {run_id}")
    freed = sum(before.get(run_id, 0) for run_id in removed)
    print(f"{counted(len(removed), 'run')}, {_shown(freed)}")


async def _prune(files: AdminFiles, days: float, *, is_dry: bool) -> list[str]:
    recordings = _recordings_of(files)
    async with opened_store(files.database_url) as store:
        records = RunRecords(
            store, recordings, HostSettings("", files.key_path, keep_days=days)
        )
        try:
            return await records.remove_old(time.time(), is_dry=is_dry)
        finally:
            await recordings.close()


def _recordings_of(files: AdminFiles) -> Recordings:
    if not files.folder.is_dir():
        raise CannotDo("there is no folder of recordings; see the setting records_dir")
    return Recordings(files.folder, storage=files.storage)


@asynccontextmanager
async def opened_store(url: str) -> AsyncIterator[Store]:
    store = Store(url)
    try:
        await store.open(upgrade=False)
        yield store
    finally:
        await store.close()


def _shown(size: float) -> str:
    for unit in ("B", "KiB", "MiB", "GiB"):
        if size < 1024 or unit == "GiB":
            break
        size /= 1024
    return f"{size:.0f} B" if unit == "B" else f"{size:.1f} {unit}"
