"""The use cases of records that are handed in: receive, show, send, delete.

A record is verified before it is answered, so that nothing of a broken one stays; then
it waits for its replay. All methods raise Refused, and StoreFailed.
"""

from __future__ import annotations

import asyncio
import secrets
import time
from collections import Counter
from collections.abc import AsyncIterator, Callable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Protocol

import msgspec

from reference_record.broken import BrokenRecord
from reference_record.contents.replay_verdict import ReplaySummary
from reference_record.formats.bundle import open_bundle
from reference_record.formats.names import VERDICTS_MAX, is_verdict, verdict_name
from reference_record.formats.opened_seeds import OpenedBenchmark
from reference_record.unsigned_record import Record, with_verdict
from reference_server.files.object_storage import ObjectStorage
from reference_server.records.examination_turns import NoTurn
from reference_server.records.import_files import Draft, ImportFiles
from reference_server.records.import_replays import ImportReplays
from reference_server.records.record_verifier import ExaminationFailed, RecordVerifier
from reference_server.rules.imported_record import (
    ImportUsage,
    RecordImport,
    Trust,
    refuse_import,
    trust_of,
)
from reference_server.rules.refusal import Refused
from reference_server.storage.connection.database import StoreFailed
from reference_server.storage.import_store import ImportStore
from reference_sim.process.pool import SimulatorPool

# How often a node looks for what was handed in at another one.
LOOK_S = 2.0


class HostKeys(Protocol):
    """The keys of this server; `RunRecords` has them."""

    async def key_names(self, own: str) -> Mapping[str, str]:
        """keyid → whose key it is, of all that are known here; own: of this server."""

    async def sign_verdict(
        self, replay: ReplaySummary, statement_sha256: str
    ) -> bytes: ...


@dataclass(frozen=True, slots=True)
class ImportSettings:
    """most: of one account.

    opened: seeds of sealed splits that their hosts have opened. is_shared: other nodes
    use the folder, too; or storage has the archives of all. may_replay: whether this
    node does the replays of all.
    """

    folder: Path
    most: ImportUsage
    record_bytes_max: int
    replay_s_max: float
    opened: Sequence[OpenedBenchmark] = ()
    is_shared: bool = False
    storage: ObjectStorage | None = None
    may_replay: Callable[[], bool] = lambda: True


class RecordImports:
    """The records that accounts of this server have handed in.

    check_room: refuses a new one where the disk has no room for it.
    """

    def __init__(
        self,
        store: ImportStore,
        pool: SimulatorPool,
        keys: HostKeys,
        settings: ImportSettings,
        check_room: Callable[[], None] = lambda: None,
    ) -> None:
        self._check_room = check_room
        self._store, self._keys, self._settings = store, keys, settings
        self._files = ImportFiles(
            settings.folder, is_shared=settings.is_shared, storage=settings.storage
        )
        self._verifier = RecordVerifier()
        self._replays = ImportReplays(
            store,
            pool,
            self._verifier,
            find=self._files.make_here,
            sign=keys.sign_verdict,
            replay_s_max=settings.replay_s_max,
            opened=settings.opened,
            may_work=settings.may_replay,
            look_every_s=LOOK_S if settings.is_shared else None,
        )
        self._receiving = Counter[str]()  # of each account
        # Held from the check of an account's quota until the new import is stored, so
        # that two at once can neither exceed the quota nor store the same archive
        # twice.
        self._adding = asyncio.Lock()

    async def open(self) -> None:
        """Go on after a restart. Raises OSError and StoreFailed."""
        self._files.open(await self._store.ids())
        self._replays.open()

    async def close(self) -> None:
        await self._replays.close()

    async def receive(
        self, account: str, declared_bytes: int, parts: AsyncIterator[bytes]
    ) -> RecordImport:
        """REC-112: the import of a body; of one that the account has, the same.

        declared_bytes: what is known of the size before the body is read.
        """
        if declared_bytes > self._settings.record_bytes_max:  # REC-121
            raise too_long(self._settings.record_bytes_max)
        if self._receiving[account] >= self._settings.most.waiting:
            text = f"The account sends {self._receiving[account]} records already."
            act = "Wait until one of them has arrived."
            raise Refused("quota_exceeded", text, act=act, requirement="REC-122")
        import_id = f"imp_{secrets.token_hex(12)}"
        self._receiving[account] += 1
        is_kept = False
        try:
            bounded = _bounded(parts, self._settings.record_bytes_max)
            draft = await self._files.receive(import_id, bounded)
            same = await self._store.find_archive(account, draft.sha256)
            if same is not None:  # REC-119
                return same
            self._check_room()
            await self._check_quota(account, draft.size_bytes)
            record_import = await self._examine(account, import_id, draft)
            stored = await self._add(record_import, draft)
            is_kept = stored.import_id == import_id
        except OSError as error:
            raise Refused("unavailable", "The record could not be stored.") from error
        finally:
            self._receiving[account] -= 1
            if not is_kept:
                await self._remove_unless_stored(import_id)
        self._replays.wake()
        return stored

    async def _remove_unless_stored(self, import_id: str) -> None:
        """A write that failed or was cancelled may have stored the row all the same.

        Where that cannot be looked up, `open` does it.
        """
        with suppress(OSError, StoreFailed):
            if (
                self._files.is_changing(import_id)
                and await self._store.find(None, import_id) is not None
            ):
                self._files.settle(import_id)
                self._replays.wake()
            else:
                self._files.remove(import_id)

    async def _check_quota(self, account: str, size_bytes: int) -> None:
        self._check_usage(size_bytes, await self._store.usage(account))

    def _check_usage(self, size_bytes: int, has: ImportUsage) -> None:
        """REC-122."""
        refused = refuse_import(has, self._settings.most, size_bytes)
        if refused is not None:
            raise Refused.from_verdict(refused)

    async def _examine(
        self, account: str, import_id: str, draft: Draft
    ) -> RecordImport:
        try:
            facts = await self._verifier.examine(account, draft.path)
        except NoTurn as error:
            text = f"{self._verifier.waiting} records wait to be read before this one."
            raise Refused("unavailable", text) from error
        except ExaminationFailed as failed:
            raise Refused("unavailable", f"The record: {failed}.") from failed
        except BrokenRecord as broken:  # REC-113
            raise Refused(
                "record_broken",
                f"{broken.file}: {broken.detail}.",
                errors=[(f"record:{broken.file}", broken.detail)],
                requirement=broken.rule,
            ) from broken
        return RecordImport(
            number=0,
            import_id=import_id,
            account=account,
            archive_sha256=draft.sha256,
            size_bytes=draft.size_bytes,
            imported_at_wall=time.time(),
            **msgspec.structs.asdict(facts),
        )

    async def _add(self, record_import: RecordImport, draft: Draft) -> RecordImport:
        async with self._adding:
            same = await self._store.find_archive(
                record_import.account, record_import.archive_sha256
            )
            if same is not None:  # handed in twice at the same time
                return same
            await self._check_quota(record_import.account, record_import.size_bytes)
            await self._files.keep(record_import.import_id, draft)
            check = partial(self._check_usage, record_import.size_bytes)
            same = await self._store.add(record_import, check)
            if same is not None:  # handed in at another node at the same time
                return same
            with suppress(OSError):  # the next start does it
                self._files.settle(record_import.import_id)
        return record_import

    async def find(self, account: str | None, import_id: str) -> RecordImport:
        """REC-114: of another account it does not exist."""
        record_import = await self._store.find(account, import_id)
        if record_import is None:
            raise Refused("not_found", f"There is no import {import_id}.")
        return record_import

    async def page(
        self, account: str | None, before: int | None, limit: int
    ) -> list[RecordImport]:
        """REC-120: those below a number, newest first."""
        return await self._store.page(account, before, limit)

    async def delete(self, account: str, import_id: str) -> None:
        """REC-120: the row before the file here: the start removes what a crash left.

        The copy for all nodes goes first: nothing would remove that later.
        """
        record_import = await self.find(account, import_id)
        await self._files.remove_stored(record_import.import_id)
        with suppress(OSError):  # a full disk, of which this makes room
            self._files.begin_change(import_id)
        await self._store.delete(record_import.import_id)
        await self._replays.stop(record_import.import_id)
        await asyncio.to_thread(self._files.remove, record_import.import_id)

    async def trust(self, record_import: RecordImport, url: str) -> Trust:
        """url: of this server for the reader, which is its name, as in its clients."""
        return trust_of(record_import, await self._keys.key_names(url), url)

    def episodes_replayed(self, record_import: RecordImport) -> int:
        return self._replays.episodes_replayed(record_import)

    async def archive(self, account: str | None, import_id: str) -> Record:
        """REC-118: the files that were handed in, with this server's verdict."""
        record_import = await self.find(account, import_id)
        try:
            path = await self._files.make_here(import_id)
            return await asyncio.to_thread(_record_of, path, record_import)
        except OSError as error:
            raise Refused("not_found", "Its archive is not there any more.") from error


def too_long(most: int, requirement: str = "REC-121") -> Refused:
    """Refuse a record by what is said of its length (REC-121), or by its length."""
    text = f"The record has more than {most} bytes, see limits.max_record_bytes."
    return Refused("body_too_large", text, requirement=requirement)


async def _bounded(parts: AsyncIterator[bytes], most: int) -> AsyncIterator[bytes]:
    size = 0
    async for part in parts:
        size += len(part)
        if size > most:
            raise too_long(most, "REC-126")
        yield part


def _record_of(path: Path, record_import: RecordImport) -> Record:
    bundle, verdict = open_bundle(path), record_import.verdict
    name = f"replayed-{record_import.import_id.removeprefix('imp_')}"
    verdicts = sum(map(is_verdict, bundle.sizes))
    has_room = verdicts < VERDICTS_MAX or verdict_name(name) in bundle.sizes
    with_ours = name, verdict if has_room else None
    return Record(with_verdict(bundle, *with_ours), record_import.statement_sha256)
