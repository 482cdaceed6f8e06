"""Mutants of records that are handed in: taken unread, shown to others, misjudged."""

from __future__ import annotations

import time
from collections.abc import Mapping
from dataclasses import replace
from itertools import islice
from pathlib import Path
from typing import Any

from reference_record.broken import BrokenRecord
from reference_record.export import Record
from reference_record.formats.bundle import open_bundle
from reference_record.formats.names import is_verdict
from reference_record.replay_verdict import ReplaySummary
from reference_server.records import import_replays, record_imports
from reference_server.records.import_files import Draft, ImportFiles
from reference_server.records.import_replays import ImportReplays
from reference_server.records.record_imports import RecordImports
from reference_server.records.record_verifier import RecordVerifier
from reference_server.records.verify_process import RecordFacts
from reference_server.rules.imported_record import (
    ImportReplay,
    RecordImport,
    Trust,
    trust_of,
)
from reference_server.storage.import_store import ImportStore
from tests.mutants import mutant, put

MANY = 1000


def change_replay(**members: Any) -> None:
    """Let every replay be shown otherwise than it came out."""
    right = import_replays._replay_shown

    def wrong(summary: ReplaySummary) -> ImportReplay:
        return replace(right(summary), **members)

    put(import_replays, "_replay_shown", wrong)


@mutant("REC-112")
def shows_another_run_of_an_import() -> None:
    """A record is listed under a run that it is not of."""
    right = RecordImports._examine

    async def wrong(
        self: RecordImports, account: str, import_id: str, draft: Draft
    ) -> RecordImport:
        return replace(await right(self, account, import_id, draft), run_id="run_other")

    put(RecordImports, "_examine", wrong)


@mutant("REC-113")
def names_no_rule_of_a_broken_record() -> None:
    """An author cannot see what is wrong with a file."""
    right = RecordVerifier.examine

    async def wrong(self: RecordVerifier, account: str, path: Path) -> RecordFacts:
        try:
            return await right(self, account, path)
        except BrokenRecord as broken:
            detail = "it is wrong"
            raise BrokenRecord("archive", "REC-002", detail) from broken

    put(RecordVerifier, "examine", wrong)


@mutant("REC-114")
def shows_imports_to_every_account() -> None:
    """A competitor fetches a record that is not published."""
    right = RecordImports.find

    async def wrong(
        self: RecordImports, _account: str | None, import_id: str
    ) -> RecordImport:
        return await right(self, None, import_id)

    put(RecordImports, "find", wrong)


@mutant("REC-114")
def lists_imports_of_every_account() -> None:
    """A competitor sees which policies are evaluated elsewhere."""
    right = RecordImports.page

    async def wrong(
        self: RecordImports, _account: str | None, before: int | None, limit: int
    ) -> list[RecordImport]:
        return await right(self, None, before, limit)

    put(RecordImports, "page", wrong)


@mutant("REC-114")
def gives_the_import_of_another_account() -> None:
    """A client that hands in what a competitor has cannot read what it was given."""

    async def wrong(
        self: ImportStore, _account: str, sha256: str
    ) -> RecordImport | None:
        found = await self.page(None, None, MANY)
        return next((one for one in found if one.archive_sha256 == sha256), None)

    put(ImportStore, "find_archive", wrong)


@mutant("REC-115", "REC-116")
def replays_the_first_episode_alone() -> None:
    """A record whose other episodes are made up has the level of one that is true."""
    right = ImportReplays._prepare

    async def wrong(self: ImportReplays, path: Path) -> Any:
        benchmark, recorded = await right(self, path)
        return benchmark, islice(recorded, 1)

    put(ImportReplays, "_prepare", wrong)


@mutant("REC-116")
def calls_every_replay_exact() -> None:
    """A score that no simulator gives carries the word replayed."""
    change_replay(result="exact", diverged=0, first_divergence=None)


@mutant("REC-116")
def names_another_step_of_a_divergence() -> None:
    """An author looks for the difference where there is none."""
    right = import_replays._replay_one

    async def wrong(*arguments: Any) -> Any:
        result, where = await right(*arguments)
        if where is not None:
            where.step -= 1
        return result, where

    put(import_replays, "_replay_one", wrong)


@mutant("REC-117")
def believes_the_name_in_a_record() -> None:
    """A file with the name of a lab in it passes for one of that lab."""
    right = trust_of

    def wrong(one: RecordImport, names: Mapping[str, str], host: str) -> Trust:
        return right(one, {one.keyid: host, **names}, host)

    put(record_imports, "trust_of", wrong)


@mutant("REC-118")
def keeps_its_verdict_to_itself() -> None:
    """A reader has to believe a server that its replay was done."""
    right = record_imports._record_of

    def wrong(path: Path, one: RecordImport) -> Record:
        return right(path, replace(one, verdict=None))

    put(record_imports, "_record_of", wrong)


@mutant("REC-118")
def adds_no_verdict_to_that_of_another() -> None:
    """A reader who trusts this server alone cannot use the record."""
    right = record_imports._record_of

    def wrong(path: Path, one: RecordImport) -> Record:
        has_one = any(map(is_verdict, open_bundle(path).sizes))
        return right(path, replace(one, verdict=None) if has_one else one)

    put(record_imports, "_record_of", wrong)


@mutant("REC-119", "REC-123")
def makes_an_import_of_every_repeat() -> None:
    """A client that lost an answer has the record twice."""

    async def wrong(_self: ImportStore, _account: str, _sha256: str) -> None:
        return None

    put(ImportStore, "find_archive", wrong)
    right = ImportStore.add

    async def add(self: ImportStore, one: RecordImport) -> None:
        # The database would refuse the same digest again.
        other = one.import_id.removeprefix("imp_").ljust(64, "0")
        await right(self, replace(one, archive_sha256=other))

    put(ImportStore, "add", add)


@mutant("REC-120")
def lists_imports_oldest_first() -> None:
    """What was just handed in stands behind everything else."""
    right = RecordImports.page

    async def wrong(
        self: RecordImports, account: str | None, before: int | None, limit: int
    ) -> list[RecordImport]:
        return (await right(self, account, before, limit))[::-1]

    put(RecordImports, "page", wrong)


@mutant("REC-120")
def begins_a_page_with_the_last_import_of_the_one_before() -> None:
    """A client that adds up a list by pages counts records twice."""
    right = RecordImports.page

    async def wrong(
        self: RecordImports, account: str | None, before: int | None, limit: int
    ) -> list[RecordImport]:
        return await right(self, account, before and before + 1, limit)

    put(RecordImports, "page", wrong)


@mutant("REC-120")
def forgets_to_delete() -> None:
    """What was handed in by mistake stays for good."""

    async def wrong(_self: ImportStore, _import_id: str) -> None:
        return None

    put(ImportStore, "delete", wrong)
    put(ImportFiles, "remove", lambda _self, _import_id: None)


@mutant("REC-121")
def awaits_bodies_of_every_length() -> None:
    """A line that costs money carries 4 GiB that are refused in the end."""
    right = RecordImports.receive

    async def wrong(
        self: RecordImports, account: str, _declared_bytes: int, parts: Any
    ) -> RecordImport:
        return await right(self, account, 0, parts)

    put(RecordImports, "receive", wrong)


@mutant("REC-123")
def loses_archives_at_a_restart() -> None:
    """A record that was taken in has to be sent again, if its author still has it."""
    right = ImportFiles.open

    def wrong(self: ImportFiles, import_ids: set[str]) -> None:
        right(self, import_ids)
        for import_id in import_ids:
            self.remove(import_id)

    put(ImportFiles, "open", wrong)


@mutant("REC-123")
def gives_up_what_waits_for_its_replay() -> None:
    """A record that came before a restart never gets its level."""
    right, began_at = ImportReplays._replay, time.time()

    async def wrong(self: ImportReplays, one: RecordImport) -> ReplaySummary:
        if one.imported_at_wall < began_at:
            raise import_replays.NotReplayed("It came before a restart.")
        return await right(self, one)

    put(ImportReplays, "_replay", wrong)


@mutant("REC-123")
def forgets_a_replay_that_a_restart_cut_off() -> None:
    """A record that was almost checked stays unchecked for good."""

    async def wrong(self: ImportStore) -> list[RecordImport]:
        found = await self.page(None, None, MANY)
        waiting = [one for one in found if one.state == "waiting"]
        oldest = {one.account: one for one in waiting}  # they are newest first
        return sorted(oldest.values(), key=lambda one: one.number)

    put(ImportStore, "oldest_unfinished", wrong)
