"""Deleted runs: what goes with them, what stays counted, requests at the same time."""

from __future__ import annotations

import asyncio
from pathlib import Path
from typing import Any

import pytest

from reference_server.process import hourly_work
from reference_server.process.hourly_work import HourlyWork
from reference_server.records.recordings import Recordings
from reference_server.records.run_records import HostSettings, RunRecords
from reference_server.rules.runs.lifecycle import Attach
from reference_server.rules.runs.run import Run
from reference_server.storage.record_store import RecordStore
from reference_server.storage.runs.run_store import StoreFailed
from reference_sim.process.pool import SimulatorHandle
from tests.support.server.server_parts import (
    BlockedCall,
    ServerParts,
    calibration_run,
    expect_refusal,
    open_server_parts,
    predict_command,
    record_score,
)
from tests.support.servers import TIMEOUT_S


async def submit(parts: ServerParts, run_id: str = "run_1", **changes: Any) -> Run:
    run = calibration_run(run_id=run_id, played_number=None, **changes)
    return await parts.registry.add(run, None, "")


async def play_one_action(parts: ServerParts, run: Run) -> None:
    turn = await parts.executor.attach(run, Attach("w", "key"))
    await parts.executor.predict(run, predict_command(turn))


async def is_there(parts: ServerParts, run_id: str) -> bool:
    return run_id in await parts.store.heads([run_id])


async def test_the_first_action_is_on_disk_before_it_is_answered(
    tmp_path: Path,
) -> None:
    async with open_server_parts(tmp_path / "proctor.sqlite") as parts:
        for run_id in ("run_1", "run_2", "run_3"):
            run = await submit(parts, run_id)
            if run_id != "run_2":
                await play_one_action(parts, run)
                rows = parts.database.execute("SELECT run_id, played_number FROM runs")
                assert dict(rows)[run_id] == run.played_number
    async with open_server_parts(tmp_path / "proctor.sqlite") as parts:
        ids = ["run_1", "run_2", "run_3"]
        heads = await parts.store.heads(ids)
        assert [heads[one].played_number for one in ids] == [1, None, 2]
        with expect_refusal("not_deletable"):
            await parts.service.delete_run("alice", "run_1")
        await parts.service.delete_run("alice", "run_2")


@pytest.mark.parametrize("fails_first", [True, False])
async def test_a_first_action_that_is_not_stored_is_not_answered(
    monkeypatch: pytest.MonkeyPatch, fails_first: bool, parts: ServerParts
) -> None:
    """Whichever is known first: that the write has failed, or how the turn went."""
    run = await submit(parts)
    turn = await parts.executor.attach(run, Attach("w", "key"))
    play = BlockedCall(monkeypatch, SimulatorHandle, "play", after=not fails_first)
    save = BlockedCall(monkeypatch, parts.store, "save")
    change = parts.registry.change_event(run.run_id)
    with parts.database.reject_writes(), expect_refusal("unavailable"):
        predicting = asyncio.create_task(
            parts.executor.predict(run, predict_command(turn))
        )
        await play.wait_until_reached()
        await save.wait_until_reached()
        if fails_first:
            save.open()
            assert await parts.registry.wait_for_change(change, TIMEOUT_S)
            play.open()
        else:
            play.open()
            save.open()
        await predicting


async def test_older_databases_count_what_has_left_a_trace(tmp_path: Path) -> None:
    async with open_server_parts(tmp_path / "proctor.sqlite") as parts:
        for run_id in ("run_1", "run_2", "run_3"):
            run = await submit(parts, run_id)
            if run_id != "run_2":
                record_score(run, 0)
                await parts.registry.writer.commit(run)
        parts.database.make_unversioned()
        parts.database.execute(
            "DROP INDEX runs_played",
            "ALTER TABLE runs DROP COLUMN played_number",
            "ALTER TABLE runs DROP COLUMN deleted_at_wall",
        )
    async with open_server_parts(tmp_path / "proctor.sqlite") as parts:
        ids = ["run_1", "run_2", "run_3"]
        heads = await parts.store.heads(ids)
        assert [heads[one].played_number for one in ids] == [1, None, 2]


async def test_all_that_is_stored_goes_and_the_run_stays_counted(
    tmp_path: Path,
) -> None:
    async def scenario(parts: ServerParts, recordings: Recordings) -> None:
        recordings.open()
        host = HostSettings("host", Path("key"))
        records = RunRecords(parts.store, recordings, host)
        object.__setattr__(parts.service, "records", records)
        object.__setattr__(parts.service, "deletes_played", True)
        first = await submit(parts)
        turn = await parts.executor.attach(first, Attach("w", "key"))
        await parts.executor.predict(first, predict_command(turn, end=1))
        await parts.service.stop_run("alice", "run_1")
        signed = RecordStore(parts.store.transactions)
        await signed.add_statement("run_1", b"statement", "0" * 64, None)
        assert parts.database.count("episodes") == 1
        await parts.service.delete_run("alice", "run_1")
        assert not await is_there(parts, "run_1")
        assert parts.database.count("episodes") == 0
        assert recordings.run_ids() == []
        assert await signed.find_statement("run_1") == b""
        assert await signed.last_statement_sha256() == "0" * 64
        assert await parts.store.deleted_ids(["run_1", "run_2"]) == {"run_1"}
        second = await submit(parts, "run_2")
        await play_one_action(parts, second)
        assert (second.played_number, second.attempts_by_submitter) == (2, 2)

    async with asyncio.timeout(TIMEOUT_S):
        recordings = Recordings(tmp_path / "records")
        async with open_server_parts(
            tmp_path / "proctor.sqlite", recordings=recordings
        ) as parts:
            await scenario(parts, recordings)


async def test_no_request_meanwhile_sees_half_a_deletion(parts: ServerParts) -> None:
    """A worker, a reader who waits, and a page of the list, while it is deleted."""
    run = await submit(parts)
    other = await submit(parts, "run_2")
    change = parts.registry.change_event("run_1")
    waiting = asyncio.create_task(parts.registry.wait_for_change(change, TIMEOUT_S))
    deleting = asyncio.create_task(parts.service.delete_run("alice", "run_1"))
    await asyncio.sleep(0)
    with expect_refusal("not_found"):
        await parts.service.attach_worker("alice", "run_1", Attach("w", "key"))
    await deleting
    assert await waiting
    with expect_refusal("not_found"):
        await parts.executor.attach(run, Attach("w", "key"))
    with expect_refusal("not_found"):
        await parts.service.delete_run("alice", "run_1")
    page = await parts.service.list_runs("alice", None, 10, "http://host")
    assert [view["run_id"] for _, view in page] == [other.run_id]


async def test_a_page_is_not_short_of_a_run_that_is_deleted_meanwhile(
    monkeypatch: pytest.MonkeyPatch, parts: ServerParts
) -> None:
    for number in (1, 2, 3):
        await submit(parts, f"run_{number}")
    right = parts.store.heads

    async def delete_first(run_ids: Any) -> Any:
        monkeypatch.setattr(parts.store, "heads", right)
        await parts.service.delete_run("alice", "run_2")
        return await right(run_ids)

    monkeypatch.setattr(parts.store, "heads", delete_first)
    page = await parts.registry.reader.page("alice", None, 2, lambda run: run.run_id)
    assert page == ["run_3", "run_1"]


async def test_a_run_that_cannot_be_deleted_is_as_before(parts: ServerParts) -> None:
    await submit(parts)
    with parts.database.reject_writes(), pytest.raises(StoreFailed):
        await parts.service.delete_run("alice", "run_1")
    run = await parts.registry.get("run_1")
    assert run.state == "ready"
    await parts.executor.attach(run, Attach("w", "key"))


async def test_what_ended_long_ago_is_deleted_and_nothing_else(tmp_path: Path) -> None:
    names = ["old", "published", "resumed", "open", "new"]

    async def is_kept(run_id: str, _by_host: bool) -> bool:
        return run_id == "published"

    async with open_server_parts(tmp_path / "proctor.sqlite") as parts:
        for run_id in names:
            await submit(parts, run_id)
        for run_id in ("old", "published", "resumed"):
            await parts.service.stop_run("alice", run_id)
        await parts.registry.close()
        parts.database.execute(
            "UPDATE runs SET updated_at_wall = 0 WHERE run_id != 'new'"
        )
    async with open_server_parts(tmp_path / "proctor.sqlite") as parts:
        object.__setattr__(parts.service, "is_kept", is_kept)
        await parts.service.stop_run("alice", "new")
        await parts.service.resume_run("alice", "resumed")
        await parts.service.delete_old(keep_days=30.0)
        assert [one for one in names if await is_there(parts, one)] == names[1:]
        object.__setattr__(parts.service, "deletes_played", True)
        with expect_refusal("not_deletable"):
            await parts.service.delete_run("alice", "published")


async def test_hourly_work_is_repeated_after_it_failed(
    monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    monkeypatch.setattr(hourly_work, "HOUR_S", 0.0)
    calls: list[int] = []
    is_repeated = asyncio.Event()

    async def fail_first() -> None:
        calls.append(1)
        if len(calls) == 1:
            raise StoreFailed("the disk is full")
        is_repeated.set()

    work = HourlyWork(fail_first, "old runs could not be deleted")
    await work.close()
    work.open()
    async with asyncio.timeout(TIMEOUT_S):
        await is_repeated.wait()
        await work.close()
    assert "old runs could not be deleted" in caplog.text
    assert "the disk is full" in caplog.text
