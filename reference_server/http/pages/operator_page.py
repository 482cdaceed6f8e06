"""`proctor admin page`: all accounts and runs of a server of this machine, as a file.

It is made from the files of the server, so it is for who may read them: no token shows
the runs of all accounts with their tokens and their share of the disk. The server may
run meanwhile, or be down.
"""

from __future__ import annotations

import shutil
import sys
import time
from collections import Counter, defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from reference_record.command_line.click_commands import Command, Options, option
from reference_record.command_line.replaced_file import replace_file
from reference_record.command_line.written_output import writing
from reference_record.pages.page_templates import render_page
from reference_record.texts.timestamps import timestamp
from reference_server.files.file_sizes import size_of
from reference_server.files.object_storage import storage_at
from reference_server.http.auth import Caller
from reference_server.http.pages.page_links import ServerLinks
from reference_server.http.tokens import made_token
from reference_server.http.tokens.token_file import parse, read_bytes, token_id
from reference_server.records.recordings import Recordings
from reference_server.rules.runs.run import RunHead
from reference_server.settings import Settings
from reference_server.storage.runs import run_overview


@dataclass(slots=True)
class AccountRow:
    """tokens: id and scopes of those in the file; no page has a secret."""

    account: str = ""
    tokens: list[tuple[str, str]] = field(default_factory=list)
    states: Counter[str] = field(default_factory=Counter)
    recording_bytes: int = 0
    stored_bytes: int = 0
    changed_at_wall: float = 0.0

    @property
    def runs(self) -> int:
        return self.states.total()

    @property
    def by_state(self) -> str:
        return ", ".join(f"{n} {state}" for state, n in self.states.most_common())

    @property
    def changed_at(self) -> str:
        return timestamp(self.changed_at_wall) if self.changed_at_wall else ""


def page_command() -> Command:
    """The command of `proctor admin`; `do_with_settings` is its function."""
    output = option(
        "--output", "(DATABASE.operator.html)", also="-o", type=Path, metavar="FILE"
    )
    runs = option(
        "--runs", "the newest N runs (500)", type=int, default=500, metavar="N"
    )
    return Command(
        "page",
        "write a page of all accounts and runs, for a browser here",
        [output, runs],
        do_with_settings=write_page,
    )


def write_page(settings: Settings, args: Options) -> None:
    """Write it for its owner alone. Raises StoreFailed and WrongUsage."""
    beside = settings.database_folder / f"{settings.database_name}.operator.html"
    path = args.output or beside
    text = _page_of(settings, args.runs)
    with writing(path, "-o"):
        if args.output is None:
            path.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
        replace_file(path, text, is_private=True)
    print(path.absolute().as_uri())
    base_url = _base_url(settings)
    if base_url and not settings.public_url:
        print(
            f"proctor: its links lead to {base_url}; PROCTOR_PUBLIC_URL, or "
            "PROCTOR_PORT, of the server names another address",
            file=sys.stderr,
        )


def _page_of(settings: Settings, shown: int) -> str:
    accounts: defaultdict[str, AccountRow] = defaultdict(AccountRow)
    for hashed, caller in _callers(settings).items():
        scopes = "+".join(sorted(caller.scopes))
        accounts[caller.account].tokens.append((token_id(hashed), scopes))
    runs: list[Mapping[str, Any]] = []
    total = 0

    def note(head: RunHead) -> None:
        nonlocal total
        size = sizes.get(head.run_id, 0)
        _count(accounts[head.account], head, size)
        if total < shown:
            runs.append(_run_row(settings, head, size))
        total += 1

    sizes = _sizes(settings)
    stored_bytes = run_overview.read_overview(settings.database_url, note)
    for name, row in accounts.items():
        row.account, row.stored_bytes = name, stored_bytes.get(name, 0)
    return render_page(
        "operator",
        ServerLinks(),
        database=settings.database.rpartition("@")[2],  # a URL may have a password
        made_at=timestamp(time.time()),
        disk=_disk(settings, sizes),
        accounts=sorted(accounts.values(), key=lambda row: -row.changed_at_wall),
        runs=runs,
        total=total,
    )


def _callers(settings: Settings) -> Mapping[str, Caller]:
    path = settings.tokens_file_path
    made = {} if settings.tokens else made_token.callers_of(settings.token_path)
    if not path.exists():
        return made
    return {**made, **parse(read_bytes(path), path)}


def _count(row: AccountRow, head: RunHead, recording_bytes: int) -> None:
    row.states[head.state] += 1
    row.recording_bytes += recording_bytes
    row.changed_at_wall = max(row.changed_at_wall, head.updated_at_wall)


def _sizes(settings: Settings) -> Mapping[str, int]:
    """The bytes that are recorded of each run, as `proctor admin records usage`."""
    folder, storage = settings.records_path, storage_at(settings.records_storage)
    return Recordings(folder, storage=storage).sizes() if folder.is_dir() else {}


def _run_row(
    settings: Settings, head: RunHead, recording_bytes: int
) -> Mapping[str, Any]:
    policy = head.submission.get("policy", {})
    base_url = _base_url(settings)
    return {
        "run_id": head.run_id,
        "link": f"{base_url}/pages/runs/{head.run_id}" if base_url else "",
        "account": head.account,
        "policy": f"{policy.get('name', '')} {policy.get('version') or ''}".strip(),
        "benchmark_id": head.manifest["benchmark_id"],
        "state": head.state,
        "reason": head.reason,
        "scored": head.scored,
        "total": head.total,
        "submitted_at": timestamp(head.created_at_wall),
        "changed_at": timestamp(head.updated_at_wall),
        "recording_bytes": recording_bytes,
    }


def _base_url(settings: Settings) -> str:
    """The address of the pages by the settings; empty if these name none."""
    if settings.pages == "off" or not (settings.port or settings.public_url):
        return ""
    return settings.public_url.rstrip("/") or f"http://127.0.0.1:{settings.port}"


def _disk(settings: Settings, sizes: Mapping[str, int]) -> Sequence[tuple[str, int]]:
    """sizes: of what is recorded, by run."""
    records, imports = settings.records_path, settings.imports_path
    files = [path for path in settings.kept_paths if path not in (records, imports)]
    rows = [("database", size_of(files))] if files else []
    rows.append(("recordings", size_of([records])))
    rows.append(("records that were handed in", size_of([imports])))
    rows.append(("in all", sum(size for _, size in rows)))
    if settings.max_disk_bytes:
        rows.append(("max_disk_bytes", settings.max_disk_bytes))
    folder = next((p for p in (records, settings.database_folder) if p.is_dir()), None)
    if settings.records_storage:
        rows.append((f"in {settings.records_storage}", sum(sizes.values())))
    if folder is not None:
        rows.append(("free on the disk", shutil.disk_usage(folder).free))
    return rows
