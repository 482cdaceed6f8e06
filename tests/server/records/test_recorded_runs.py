"""What is recorded of a run, and what happens when it cannot be."""

from __future__ import annotations

import asyncio
import errno
import os
import resource
import time
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import msgspec
import pytest
from mcap.records import Channel, Message
from mcap.stream_reader import StreamReader

from reference_record.generated.answers import Turn
from reference_record.recordings import recording_file, recording_parts
from reference_server.files.object_storage import ObjectStorage, StorageFailed
from reference_server.records import recordings as recordings_module
from reference_server.records.recordings import Recordings
from reference_server.records.run_records import HostSettings, RunRecords
from reference_server.rules.refusal import Refused
from reference_server.rules.runs.lifecycle import Attach
from reference_server.rules.runs.run import Run
from tests.support.server.server_parts import (
    ServerParts,
    calibration_run,
    open_server_parts,
    predict_command,
    stop_run,
)
from tests.support.waiting import wait_in_loop


@asynccontextmanager
async def played(path: Path) -> AsyncIterator[tuple[ServerParts, Recordings]]:
    """A server of its own, over the same database and recordings each time."""
    recordings = Recordings(path / "records")
    async with open_server_parts(
        path / "proctor.sqlite", recordings=recordings
    ) as parts:
        recordings.open()
        yield parts, recordings


async def attach(parts: ServerParts, run: Run, key: str = "key") -> Turn:
    return await parts.executor.attach(run, Attach("w", key))


async def submit(parts: ServerParts) -> Run:
    return await parts.registry.add(calibration_run("score"), None, "")


def topics(path: Path) -> list[str]:
    """Of all messages of a recording, in order."""
    names: dict[int, str] = {}
    found = []
    with path.open("rb") as file:
        for record in StreamReader(file).records:
            if isinstance(record, Channel):
                names[record.id] = record.topic
            elif isinstance(record, Message):
                found.append(names[record.channel_id])
    return found


async def test_what_cannot_be_recorded_fails_the_run_and_costs_no_attempt(
    tmp_path: Path,
) -> None:
    async with played(tmp_path) as (parts, _):
        (tmp_path / "records" / "run_1").write_text("in the way")
        run = await submit(parts)
        with pytest.raises(Refused):
            await attach(parts, run)
        assert (run.state, run.retryable) == ("failed", True)
        assert "recording could not be written" in str(run.reason)
        assert run.episodes[0].attempt == 1


async def test_a_result_whose_recording_fails_does_not_count(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The disk is full once, at the end. Expect `unavailable`, and nothing charged."""
    right, failures = recording_file.join_parts, iter([True])

    def join(*arguments: Any, **options: Any) -> Any:
        if next(failures, False):
            raise OSError(errno.ENOSPC, "No space left on device")
        return right(*arguments, **options)

    monkeypatch.setattr(recordings_module, "join_parts", join)
    async with played(tmp_path) as (parts, recordings):
        run = await submit(parts)
        turn = await attach(parts, run)
        with pytest.raises(Refused) as refused:
            await parts.executor.predict(run, predict_command(turn, end=1))
        assert refused.value.code == "unavailable"
        assert (run.scored, run.episodes[0].faults) == (0, 0)
        turn = await attach(parts, run, "again")
        turn = await parts.executor.predict(run, predict_command(turn, end=1))
        assert turn["episode_result"]["attempt"] == 1
        assert topics(recordings.path("run_1", 0))[-2:] == ["/attempt", "/result"]


async def test_a_result_that_the_storage_does_not_take_does_not_count(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    """It is away for a while: neither an attempt nor a fault is charged.

    The log says why, once, and the client and the log of the run say of what.
    """
    caplog.set_level("INFO", "proctor")
    storage = ObjectStorage((tmp_path / "bucket").as_uri())
    recordings = Recordings(tmp_path / "records", storage=storage)

    def fail(*_: object) -> None:
        raise StorageFailed("it is away")

    async with open_server_parts(
        tmp_path / "proctor.sqlite", recordings=recordings
    ) as parts:
        recordings.open()
        run = await submit(parts)
        for is_away in (True, True, False):
            turn = await attach(parts, run, str(is_away))
            with monkeypatch.context() as patch:
                if is_away:
                    patch.setattr(ObjectStorage, "put", fail)
                playing = parts.executor.predict(run, predict_command(turn, end=1))
                if is_away:
                    with pytest.raises(Refused) as refused:
                        await playing
                    assert refused.value.code == "unavailable"
                    assert "storage of recordings" in refused.value.detail
                else:
                    assert (await playing)["done"]
            run = await parts.registry.get(run.run_id)
            assert (run.episodes[0].attempt, run.episodes[0].faults) == (1, 0)
        assert storage.names_in(run.run_id) == ["00000.mcap"]
    errors = [line for line in caplog.messages if "it is away" in line]
    assert errors == [f"cannot use {storage.url}: it is away"]
    left = [line for line in caplog.records if line.message == "worker left"]
    assert ["storage of recordings" in line.members["cause"] for line in left[:2]] == [  # type: ignore[attr-defined]
        True,
        True,
    ]


@pytest.mark.parametrize("room", [0, 10])
async def test_a_turn_for_which_the_disk_has_no_room_costs_nothing(
    tmp_path: Path, room: int
) -> None:
    """The disk is full at the second turn, or within what is recorded of it.

    room: bytes that it takes before. Expect `unavailable`, no fault and no attempt; and
    all that was answered in the recording when there is room again.
    """
    async with played(tmp_path) as (parts, recordings):
        run = await submit(parts)
        turn = await parts.executor.predict(
            run, predict_command(await attach(parts, run))
        )
        (part,) = recording_parts.parts_of(tmp_path / "records/run_1/00000.parts")
        lent = parts.executor._resources.find(run.workers["w"])
        assert lent is not None
        assert lent.handle is not None
        assert lent.handle.pid is not None
        size = part.stat().st_size + room, resource.RLIM_INFINITY
        resource.prlimit(lent.handle.pid, resource.RLIMIT_FSIZE, size)
        with pytest.raises(Refused) as refused:
            await parts.executor.predict(run, predict_command(turn, end=1))
        assert refused.value.code == "unavailable"
        assert "could not be written" in refused.value.detail
        episode = run.episodes[0]
        assert (run.state, run.scored) == ("ready", 0)
        assert (episode.attempt, episode.faults) == (1, 0)
        turn = await attach(parts, run, "again")
        turn = await parts.executor.predict(run, predict_command(turn, end=1))
        assert turn["episode_result"]["attempt"] == 1
        of_turns = ["/attempt", "/turn", "/attempt"]
        assert topics(recordings.path("run_1", 0)) == [*of_turns * 2, "/result"]


async def test_what_could_not_be_appended_is_appended_later(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The end of an attempt meets a full disk, and is in the recording all the same."""
    right, failures = recording_parts.append_part, iter([True])

    def append(*arguments: Any) -> None:
        if next(failures, False):
            raise OSError(errno.ENOSPC, "No space left on device")
        right(*arguments)

    monkeypatch.setattr(recordings_module, "append_part", append)
    async with played(tmp_path) as (parts, recordings):
        run = await submit(parts)
        turn = await attach(parts, run)
        await parts.executor.predict(run, predict_command(turn))
        stop_run(parts, run)
        await parts.registry.writer.commit(run)
        await parts.service.resume_run(run.account, run.run_id)
        turn = await attach(parts, run, "another")
        await parts.executor.predict(run, predict_command(turn, end=1))
        of_turns = ["/attempt", "/turn", "/attempt"]
        assert topics(recordings.path("run_1", 0)) == [*of_turns * 2, "/result"]


async def test_each_event_is_written_once_by_several_writers(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The second of three meets a full disk while `begin` writes them, too."""
    right, failures = recording_parts.PartWriter.write, iter([False, True])

    def write_message(*arguments: Any) -> None:
        time.sleep(0.01)
        if next(failures, False):
            raise OSError(errno.ENOSPC, "No space left on device")
        right(*arguments)

    monkeypatch.setattr(recording_parts.PartWriter, "write", write_message)
    run: Any = SimpleNamespace(run_id="run_1", fence=0)
    episode: Any = SimpleNamespace(index=0, attempt=1)
    recordings = Recordings(tmp_path)
    for seq in range(3):
        recordings.add_fault(run, episode, seq, "simulator_fault", "it broke")
    await asyncio.gather(
        *(recordings.begin(run, episode) for _ in range(3)), return_exceptions=True
    )
    await recordings.begin(run, episode)
    await recordings.close()
    parts = recording_parts.parts_of(tmp_path / "run_1" / "00000.parts")
    found = [
        msgspec.json.decode(recording_parts.json_of(message))["seq"]
        for part in parts
        for _, _, message in recording_parts.read_part(part)
    ]
    assert found == [0, 1, 2]


async def test_a_result_whose_turns_are_gone_does_not_count(tmp_path: Path) -> None:
    """Their parts were removed; the episode is played again in the same attempt."""
    async with played(tmp_path) as (parts, recordings):
        run = await submit(parts)
        turn = await attach(parts, run)
        turn = await parts.executor.predict(run, predict_command(turn))
        for part in recording_parts.parts_of(tmp_path / "records/run_1/00000.parts"):
            part.unlink()
        turn = await parts.executor.predict(run, predict_command(turn, end=1))
        assert "turns of the result" in turn["fault"]["detail"]
        assert run.scored == 0
        assert not recordings.path("run_1", 0).exists()
        turn = await parts.executor.predict(run, predict_command(turn, end=1))
        assert turn["episode_result"]["attempt"] == 1


async def test_what_a_crash_left_is_removed_and_nothing_else(tmp_path: Path) -> None:
    """Killed between the stored result and the removal of its parts."""
    kept = ["notes.draft", "00001.parts", "00002.draft.txt", "other.parts"]
    async with played(tmp_path) as (parts, recordings):
        run = await submit(parts)
        folder = tmp_path / "records" / "run_1"
        for name in ("00000.parts", *kept):
            (folder / name).mkdir(parents=True)
        (folder / "other.mcap").touch()
        (folder / "00003.draft").touch()
        os.utime(folder / "00003.draft", (1.0, 1.0))
        (folder / "00004.draft").touch()
        turn = await attach(parts, run)
        (folder / "00000.mcap").touch()
        settings = HostSettings("host", Path("key"))
        records = RunRecords(parts.store, recordings, settings)
        await records.remove_leftovers()
        assert (folder / "00000.parts").exists()  # it may have to be joined again
        assert not (folder / "00003.draft").exists()
        await parts.executor.predict(run, predict_command(turn, end=1))
        await wait_in_loop(lambda: not (folder / "00000.parts").exists())
        (folder / "00000.parts").mkdir()
        await records.remove_leftovers()
        found = sorted(path.name for path in folder.iterdir())
        assert found == sorted([*kept, "00000.mcap", "other.mcap", "00004.draft"])


def test_parts_beyond_a_million_keep_their_order(tmp_path: Path) -> None:
    names = ["000002.part", "999999.part", "1000000.part"]
    for name in names:
        (tmp_path / name).touch()
    assert [path.name for path in recording_parts.parts_of(tmp_path)] == names
