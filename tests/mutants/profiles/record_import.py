"""Mutants of records that are uploaded: stored unread, shown to others, misjudged."""

from __future__ import annotations

import time
from collections.abc import Mapping
from dataclasses import replace
from itertools import islice
from pathlib import Path
from typing import Any

from reference_record.broken import BrokenRecord
from reference_record.contents.replay_verdict import ReplaySummary
from reference_server.records import import_replays, record_imports
from reference_server.records.import_files import Draft, ImportFiles
from reference_server.records.import_replays import ImportReplays
from reference_server.records.record_imports import RecordImports
from reference_server.records.record_verifier import RecordVerifier
from reference_server.rules.imported_record import (
    RecordImport,
)
from reference_server.storage.import_store import ImportStore
from tests.mutants import instead_of, mutant, put

MANY = 1000


@mutant("REC-112", through=instead_of(RecordImports, "_examine"))
async def shows_another_run_of_an_import(
    right: Any, self: RecordImports, account: str, import_id: str, draft: Draft
) -> Any:
    """A record is listed under a run that it is not of."""
    return replace(await right(self, account, import_id, draft), run_id="run_other")


@mutant("REC-113", through=instead_of(RecordVerifier, "examine"))
async def names_no_rule_of_a_broken_record(
    right: Any, self: RecordVerifier, account: str, path: Path
) -> Any:
    """An author cannot see what is wrong with a file."""
    try:
        return await right(self, account, path)
    except BrokenRecord as broken:
        detail = "it is wrong"
        raise BrokenRecord("archive", "REC-002", detail) from broken


@mutant("REC-114", through=instead_of(RecordImports, "find"))
async def shows_imports_to_every_account(
    right: Any, self: RecordImports, _account: str | None, import_id: str
) -> Any:
    """A competitor fetches a record that is not published."""
    return await right(self, None, import_id)


@mutant("REC-115", "REC-116", through=instead_of(ImportReplays, "_prepare"))
async def replays_the_first_episode_alone(
    right: Any, self: ImportReplays, path: Path
) -> Any:
    """A record whose other episodes are made up has the level of one that is true."""
    benchmark, recorded = await right(self, path)
    return benchmark, islice(recorded, 1)


@mutant("REC-116", through=instead_of(import_replays, "_replay_shown"))
def calls_every_replay_exact(right: Any, summary: ReplaySummary) -> Any:
    """A score that no simulator gives carries the word replayed."""
    shown = right(summary)
    return replace(shown, result="exact", diverged=0, first_divergence=None)


@mutant("REC-116", through=instead_of(import_replays, "_replay_one"))
async def names_another_step_of_a_divergence(right: Any, *arguments: Any) -> Any:
    """An author looks for the difference where there is none."""
    result, where = await right(*arguments)
    if where is not None:
        where.step -= 1
    return result, where


@mutant("REC-117", through=instead_of(record_imports, "trust_of"))
def believes_the_name_in_a_record(
    right: Any, imported: RecordImport, names: Mapping[str, str], host: str
) -> Any:
    """A file with the name of a lab in it passes for one of that lab."""
    return right(imported, {imported.keyid: host, **names}, host)


@mutant("REC-118", through=instead_of(record_imports, "_record_of"))
def keeps_its_verdict_to_itself(right: Any, path: Path, imported: RecordImport) -> Any:
    """A reader has to believe a server that its replay was done."""
    return right(path, replace(imported, verdict=None))


@mutant("REC-119", "REC-123")
def makes_an_import_of_every_repeat() -> None:
    """A client that lost an answer has the record twice."""

    async def wrong(_self: ImportStore, _account: str, _sha256: str) -> None:
        return None

    put(ImportStore, "find_archive", wrong)
    right = ImportStore.add

    async def add(
        self: ImportStore, imported: RecordImport, *check: Any
    ) -> RecordImport | None:
        # The database would refuse the same digest again.
        another_digest = imported.import_id.removeprefix("imp_").ljust(64, "0")
        other = replace(imported, archive_sha256=another_digest)
        return await right(self, other, *check)

    put(ImportStore, "add", add)


@mutant("REC-120", through=instead_of(RecordImports, "page"))
async def lists_imports_oldest_first(
    right: Any, self: RecordImports, account: str | None, before: int | None, limit: int
) -> Any:
    """A record that was just uploaded stands behind all others."""
    return (await right(self, account, before, limit))[::-1]


@mutant("REC-120")
def forgets_to_delete() -> None:
    """A record that was uploaded by mistake stays for good."""

    async def wrong(_self: ImportStore, _import_id: str) -> None:
        return None

    put(ImportStore, "delete", wrong)
    put(ImportFiles, "remove", lambda _self, _import_id: None)


@mutant("REC-121", through=instead_of(RecordImports, "receive"))
async def awaits_bodies_of_every_length(
    right: Any, self: RecordImports, account: str, _declared_bytes: int, parts: Any
) -> Any:
    """A line that costs money carries 4 GiB that are refused in the end."""
    return await right(self, account, 0, parts)


@mutant("REC-123", through=instead_of(ImportFiles, "open"))
def loses_archives_at_a_restart(
    right: Any, self: ImportFiles, import_ids: set[str]
) -> None:
    """A record that was accepted has to be sent again, if its author still has it."""
    right(self, import_ids)
    for import_id in import_ids:
        self.remove(import_id)


@mutant("REC-123")
def gives_up_what_waits_for_its_replay() -> None:
    """A record that came before a restart never gets its level."""
    right, began_at = ImportReplays._replay, time.time()

    async def wrong(self: ImportReplays, imported: RecordImport) -> ReplaySummary:
        if imported.imported_at_wall < began_at:
            raise import_replays.NotReplayed("It came before a restart.")
        return await right(self, imported)

    put(ImportReplays, "_replay", wrong)


@mutant("REC-123", through=instead_of(ImportStore, "oldest_unfinished"))
async def forgets_a_replay_that_a_restart_cut_off(
    _right: Any, self: ImportStore
) -> Any:
    """A record that was almost checked stays unchecked for good."""
    imports = await self.page(None, None, MANY)
    waiting = [imported for imported in imports if imported.state == "waiting"]
    oldest = {
        imported.account: imported for imported in waiting
    }  # they are newest first
    return sorted(oldest.values(), key=lambda imported: imported.number)
