"""The use cases of a leaderboard over its tables: at once, after a restart, in an old
database, and how often a ranking is computed."""

from __future__ import annotations

import asyncio
import contextlib
import threading
from collections.abc import AsyncIterator, Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any, cast

import pytest
import sqlalchemy as sa

from reference_record.history.checkpoint import read
from reference_record.history.merkle_tree import is_consistent, leaf_hash
from reference_record.keys import SigningKey
from reference_server.records.board_history import BoardHistory
from reference_server.records.run_records import RunRecords
from reference_server.rules.board import ranking
from reference_server.rules.board.entry_changes import BoardEntry, Change
from reference_server.rules.capacity import Quota
from reference_server.runs import board_service
from reference_server.runs.board_service import BoardService
from reference_server.storage.board_store import BoardStore, RunDeleted
from reference_server.storage.runs.rows import RUN_BYTES, stored_bytes
from reference_server.storage.runs.run_store import StoreFailed
from tests.support.server.server_parts import (
    RESULT,
    ServerParts,
    calibration_run,
    expect_refusal,
    open_server_parts,
)

KEY = SigningKey(bytes(32))
PUBLIC = {"model_name": "A", "is_public": True}
PRIVATE = {"model_name": "A", "is_public": False}


@contextlib.asynccontextmanager
async def opened_board(path: Path) -> AsyncIterator[tuple[ServerParts, BoardService]]:
    """A server of its own, over the same database each time."""
    async with open_server_parts(path / "proctor.sqlite") as parts:
        store = BoardStore(parts.store, leaf_hash)
        records = SimpleNamespace(key=KEY, host_name="https://eval.example.org/a b")
        history = BoardHistory(store, cast("RunRecords", records))
        service = parts.service
        board = BoardService(service.registry, service.benchmarks, store, history)
        yield parts, board


async def completed(parts: ServerParts, run_id: str, account: str = "alice") -> str:
    """The manifest of a run that is completed."""
    run = calibration_run("score", run_id=run_id, account=account, state="completed")
    # A policy of its own: an account has one entry of one result of a policy.
    run.submission = {**run.submission, "policy": {"name": run_id}}
    assert await parts.store.insert(run, None, "")
    run.episodes[0].result = RESULT
    run.changed = {0}
    await parts.store.save(run)
    return run.manifest_sha256


async def test_an_entry_outlives_a_restart(tmp_path: Path) -> None:
    """With its leaf; the history goes on where it was."""
    seen: dict[str, Any] = {}
    async with opened_board(tmp_path) as (parts, board):
        seen["manifest"] = await completed(parts, "run_1")
        seen["entry"], is_new = await board.publish("alice", "run_1", PUBLIC)
        assert is_new
        seen["checkpoint"] = await board.checkpoint()
    async with opened_board(tmp_path) as (_, board):
        entry_id = seen["entry"]["entry_id"]
        assert await board.get("bob", entry_id) == seen["entry"]
        found, total = await board.rank("calibration", seen["manifest"], 0, 10)
        assert (total, found["rows"][0]["entry"]) == (1, seen["entry"])
        assert await board.checkpoint() == seen["checkpoint"]
        await board.withdraw("alice", "run_1")
        later = await board.checkpoint()
        proof = await board.consistency(1, 2)
        old, new = (
            read(one["note"], KEY.public_key) for one in (seen["checkpoint"], later)
        )
        hashes = [bytes.fromhex(one) for one in proof["hashes"]]
        assert is_consistent(1, old.root, 2, new.root, hashes)
        assert new.origin == "eval.example.org/a_b/board"


async def test_a_run_is_deleted_or_published_and_never_both(tmp_path: Path) -> None:
    """Decided in the transaction: what was looked at before may have changed since."""
    async with board_of_two(tmp_path) as (parts, board):
        object.__setattr__(parts.service, "deletes_played", True)
        await board.publish("alice", "run_1", PUBLIC)
        with expect_refusal("not_deletable"):
            await parts.service.delete_run("alice", "run_1")
        assert "run_1" in await parts.store.heads(["run_1"])
        await asyncio.gather(
            *(board.publish("alice", "run_2", PUBLIC) for _ in range(2)),
            parts.service.delete_run("alice", "run_2"),
            return_exceptions=True,
        )
        is_there = "run_2" in await parts.store.heads(["run_2"])
        assert is_there == bool(
            await parts.store.transactions.read(entries_of("run_2"))
        )
        deleted = await parts.registry.get("run_1")
        await board.withdraw("alice", "run_1")
        await parts.service.delete_run("alice", "run_1")
        with pytest.raises(RunDeleted):
            await board._store.change("run_1", never, needs_run=True)
        assert deleted.lost


@contextlib.asynccontextmanager
async def board_of_two(path: Path) -> AsyncIterator[tuple[ServerParts, BoardService]]:
    """A server that has started after two runs were completed."""
    async with opened_board(path) as (parts, _):
        for run_id in ("run_1", "run_2"):
            await completed(parts, run_id)
    async with opened_board(path) as opened:
        yield opened


def never(_: BoardEntry | None) -> Change:
    raise AssertionError


def entries_of(run_id: str) -> Callable[[sa.Connection], int]:
    query = sa.text("SELECT count(*) FROM entries WHERE run_id = :run_id")
    return lambda connection: int(connection.scalar(query, {"run_id": run_id}) or 0)


async def test_the_host_deletes_old_runs_with_private_entries(tmp_path: Path) -> None:
    """The owner withdraws them first. A public entry keeps its run."""
    async with board_of_two(tmp_path) as (parts, board):
        described = {"run_1": PUBLIC, "run_2": PRIVATE}
        for run_id, description in described.items():
            await board.publish("alice", run_id, description)
        object.__setattr__(parts.service, "deletes_played", True)
        object.__setattr__(parts.service, "is_kept", board._store.keeps_run)
        with expect_refusal("not_deletable"):
            await parts.service.delete_run("alice", "run_2")
        await parts.service.delete_old(keep_days=-1)
        assert set(await parts.store.heads(list(described))) == {"run_1"}
        entries = await board.page("alice", None, None, 10)
        assert [view["run_id"] for _, view in entries] == ["run_1"]
        assert len(await board.leaves(0, 10)) == 1


async def test_requests_at_once_make_one_entry(tmp_path: Path) -> None:
    """And each change one leaf, in one order."""
    async with opened_board(tmp_path) as (parts, board):
        await completed(parts, "run_1")
        described = [PUBLIC | {"notes": str(number)} for number in range(20)]
        made = await asyncio.gather(
            *(board.publish("alice", "run_1", one) for one in described)
        )
        assert sum(is_new for _, is_new in made) == 1
        assert len({entry["entry_id"] for entry, _ in made}) == 1
        assert parts.database.count("entries") == 1
        assert len(await board.leaves(0, 100)) == 20


async def test_what_the_history_keeps_counts_for_the_account(tmp_path: Path) -> None:
    """Also after the run was deleted. Flags of the host count for no account.

    An account without room publishes and changes nothing, and withdraws.
    """
    async with board_of_two(tmp_path) as (parts, board):
        object.__setattr__(parts.service, "deletes_played", True)
        usage = parts.registry.usage

        async def stored() -> int:
            return (await parts.store.usage_of("alice")).stored_bytes

        before = await stored()
        entry, _ = await board.publish("alice", "run_1", PUBLIC)
        published = await stored()
        await board.flag(entry["entry_id"], flagged=True, reason="odd")
        assert await stored() == published
        usage.quota = Quota(stored_bytes=published)
        for run_id, description in (("run_1", PRIVATE), ("run_2", PUBLIC)):
            with expect_refusal("quota_exceeded", limit="stored_bytes"):
                await board.publish("alice", run_id, description)
        with expect_refusal("quota_exceeded", limit="stored_bytes"):
            await parts.registry.add(calibration_run(run_id="run_3"), None, "")
        _, is_new = await board.publish("alice", "run_1", PUBLIC)  # changes nothing
        assert not is_new
        await board.withdraw("alice", "run_1")
        leaves = [one["leaf"] for one in await board.leaves(0, 10)]
        kept = len(leaves[0]) + len(leaves[2])
        assert (len(leaves), await stored()) == (3, before + kept)
        run = await parts.registry.get("run_1")
        await parts.service.delete_run("alice", "run_1")
        left = before + kept - stored_bytes(run) + RUN_BYTES
        assert await stored() == left
        usage.quota = Quota(stored_bytes=left)
        with expect_refusal("quota_exceeded", limit="stored_bytes"):
            await parts.registry.add(calibration_run(run_id="run_3"), None, "")
        usage.quota = Quota(stored_bytes=left + 1)
        await parts.registry.add(calibration_run(run_id="run_3"), None, "")


async def test_entries_are_stored_in_the_thread_of_all_writes(tmp_path: Path) -> None:
    """One whose caller is gone ends before the next one: none finds a locked file."""
    threads: list[str] = []

    def note(_: BoardEntry | None) -> Change:
        threads.append(threading.current_thread().name)
        raise LookupError

    async with opened_board(tmp_path) as (_, board):
        with pytest.raises(LookupError):
            await board._store.change("run_1", note)
        assert threads[0].startswith("store-writer")


async def test_a_ranking_is_computed_once_for_its_entries(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Also when a description changes; again when an entry comes, is flagged, goes."""
    counted: list[int] = []

    def count(contenders: Any, episodes_total: int) -> ranking.Ranking:
        counted.append(len(contenders))
        return ranking.rank(contenders, episodes_total)

    monkeypatch.setattr(board_service, "rank", count)
    async with opened_board(tmp_path) as (parts, board):
        manifest = await completed(parts, "run_1")
        await completed(parts, "run_2", "bob")

        async def read_twice() -> list[Any]:
            for _ in range(2):
                found, _ = await board.rank("calibration", manifest, 0, 10)
            return [
                (row.get("rank"), row["entry"]["model_name"]) for row in found["rows"]
            ]

        entry, _ = await board.publish("alice", "run_1", PUBLIC)
        await read_twice()
        await board.publish("alice", "run_1", PUBLIC | {"model_name": "B"})
        assert await read_twice() == [({"low": 1, "high": 1}, "B")]
        assert counted == [1]
        await board.publish("bob", "run_2", PUBLIC)
        both = {"low": 1, "high": 2}
        assert await read_twice() == [(both, "B"), (both, "A")]
        await board.flag(entry["entry_id"], flagged=True, reason="odd")
        assert await read_twice() == [({"low": 1, "high": 1}, "A"), (None, "B")]
        await board.withdraw("alice", "run_1")
        assert await read_twice() == [({"low": 1, "high": 1}, "A")]
        assert counted == [1, 2, 2, 1]


async def test_cached_rankings_are_bounded(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Readers may name any manifest."""
    monkeypatch.setattr(board_service, "CACHED_RANKINGS_MAX", 3)
    async with opened_board(tmp_path) as (_, board):
        for number in range(10):
            await board.rank("calibration", f"{number:064x}", 0, 10)
        assert len(board._rankings) == 3


async def test_a_leaf_that_is_not_stored_stores_no_entry(tmp_path: Path) -> None:
    """The disk is full between both. Expect neither, and both at the next try."""
    async with opened_board(tmp_path) as (parts, board):
        await completed(parts, "run_1")
        parts.database.execute(
            "CREATE TRIGGER full BEFORE INSERT ON history "
            "BEGIN SELECT RAISE(ABORT, 'the disk is full'); END"
        )
        with pytest.raises(StoreFailed, match="full"):
            await board.publish("alice", "run_1", PUBLIC)
        assert parts.database.count("entries") == 0
        parts.database.execute("DROP TRIGGER full")
        _, is_new = await board.publish("alice", "run_1", PUBLIC)
        assert is_new
