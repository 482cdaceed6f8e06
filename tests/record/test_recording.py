"""Recordings: parts cut anywhere, joined to a file that MCAP's library reads."""

import hashlib
import json
import os
import signal
import subprocess
import sys
import threading
import time
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import msgspec
import pytest
from mcap.reader import make_reader

from reference_record.recordings.recording import (
    MESSAGE,
    TOPIC_IDS,
    WHOLE_HEAD,
    AttemptEvent,
    EpisodeResult,
    Fault,
    Message,
    Picture,
    Turn,
    checked_record,
    digest_state,
)
from reference_record.recordings.recording_file import _COMPRESSORS, LEVEL, join_parts
from reference_record.recordings.recording_parts import (
    EXECUTED_TURN,
    ExecutedTurn,
    PartWriter,
    append_part,
    parts_of,
    read_part,
)
from reference_record.texts.timestamps import timestamp
from tests.support.paths import ROOT
from tests.support.sim.recorded_turn import make_executed, make_turn

STARTED = AttemptEvent(1, "started", "t", state_digest="00")
RESULT = EpisodeResult("success", success=True, score=1.0, steps=3, attempts=1, at="t")


def write_part(folder: Path, *messages: tuple[str, Message]) -> None:
    part = PartWriter(folder)
    for number, (topic, message) in enumerate(messages, 1):
        part.write(topic, message, at_ns=1_000 * number)
    part.close()


def write_executed(folder: Path, *turns: ExecutedTurn[msgspec.Raw]) -> None:
    part = PartWriter(folder)
    part.write("/attempt", STARTED)
    for turn in turns:
        part.write_turn(turn)
    part.close()


def read_file(path: Path) -> list[tuple[str, dict[str, Any]]]:
    """By MCAP's own library, which checks the checksums of the chunks."""
    with path.open("rb") as file:
        reader = make_reader(file, validate_crcs=True)
        return [
            (channel.topic, json.loads(message.data))
            for _, channel, message in reader.iter_messages(log_time_order=False)
        ]


def test_a_recording_says_what_was_written(tmp_path: Path) -> None:
    folder, target = tmp_path / "parts", tmp_path / "e.mcap"
    write_part(folder, ("/attempt", STARTED), ("/turn", make_turn(1)))
    append_part(folder, "/fault", Fault(1, 2, "simulator_fault", "it broke", "t"))
    write_part(folder, ("/attempt", STARTED), ("/turn", make_turn(7)))
    joined = join_parts(folder, target, [("/result", 9_000, RESULT)])
    found = read_file(target)
    topics = ["/attempt", "/turn", "/fault", "/attempt", "/turn", "/result"]
    assert [topic for topic, _ in found] == topics
    expected = {"attempt": 1, "event": "started", "at": "t", "state_digest": "00"}
    assert found[0][1] == expected
    assert found[4][1]["actions"] == [{"arm": [0.1 * 7, -1.0]}]
    assert joined.sha256 == hashlib.sha256(target.read_bytes()).hexdigest()
    assert joined.bytes == target.stat().st_size
    assert (joined.turns, joined.first_digest, joined.last_digest) == (2, "00", "07")
    assert joined.latency.think_ms_p50 == 2.0
    assert joined.latency.think_ms_p99 == 14.0
    assert target.stat().st_mode & 0o777 == 0o600


def test_the_summary_counts_and_names_every_channel(tmp_path: Path) -> None:
    write_part(tmp_path, ("/attempt", STARTED), *[("/turn", make_turn(1))] * 5)
    join_parts(tmp_path, tmp_path / "e.mcap", [("/result", 1, RESULT)])
    with (tmp_path / "e.mcap").open("rb") as file:
        summary = make_reader(file).get_summary()
    assert summary is not None
    assert summary.statistics is not None
    counts = summary.statistics.channel_message_counts
    named = {summary.channels[i].topic: n for i, n in counts.items()}
    assert named == {"/attempt": 1, "/turn": 5, "/result": 1}
    required = json.loads(summary.schemas[2].data)["required"]
    assert required == list(Turn.__struct_fields__)


def test_a_part_that_is_cut_anywhere_is_read_up_to_there(tmp_path: Path) -> None:
    write_part(tmp_path, *(("/turn", make_turn(n)) for n in range(2)))
    (part,) = parts_of(tmp_path)
    whole = part.read_bytes()
    ends = [0, len(whole) // 2, len(whole)]
    assert len(list(read_part(part))) == 2
    for size in range(len(whole) + 1):
        part.write_bytes(whole[:size])
        assert len(list(read_part(part))) == sum(end <= size for end in ends) - 1
        part.write_bytes(whole[:size] + bytes(64))  # as a power cut may leave it
        assert len(list(read_part(part))) == sum(end <= size for end in ends) - 1


def test_an_executed_turn_is_read_as_the_message_that_it_is(tmp_path: Path) -> None:
    """Times are rounded; actions that were not executed are left out."""
    long = msgspec.structs.replace(make_executed(2), state=b"", digest="d" * 32)
    before = timestamp(time.time())
    write_executed(tmp_path, make_executed(1, b"state"), long)
    join_parts(tmp_path, tmp_path / "e.mcap", [], steps=2)
    _, (topic, first), (_, second) = read_file(tmp_path / "e.mcap")
    assert before <= first.pop("at") <= timestamp(time.time())
    assert (topic, first) == (
        "/turn",
        {
            "attempt": 1,
            "seq": 1,
            "actions": [{"arm": [1.0, 0.5]}],
            "rewards": [0.5],
            "steps": 1,
            "score": 0.25,
            "success": False,
            "ended": True,
            "state_digest": digest_state(b"state"),
            "simulate_ms": 1.2346,
            "think_ms": 1.2346,
        },
    )
    assert (second["seq"], second["state_digest"]) == (2, "d" * 32)


def test_executed_turns_cut_anywhere_are_read_up_to_there(tmp_path: Path) -> None:
    write_executed(tmp_path)
    (part,) = parts_of(tmp_path)
    start = part.stat().st_size
    part.unlink()
    write_executed(tmp_path, make_executed(1), make_executed(2))
    whole = part.read_bytes()
    ends = [start, (start + len(whole)) // 2, len(whole)]
    for size in range(start, len(whole) + 1):
        count = sum(end <= size for end in ends)
        for tail in (b"", bytes(64)):  # as a power cut may leave it
            part.write_bytes(whole[:size] + tail)
            assert len(list(read_part(part))) == count
    part.write_bytes(whole[:-1] + bytes([whole[-1] ^ 1]))
    assert len(list(read_part(part))) == 2


def test_a_length_that_no_file_has_ends_a_part(tmp_path: Path) -> None:
    """As a broken disk may leave it; so much memory is not asked for."""
    write_executed(tmp_path, make_executed(1))
    (part,) = parts_of(tmp_path)
    head = WHOLE_HEAD.pack(MESSAGE, 2**62, 1, 0, 0, 0)
    part.write_bytes(part.read_bytes() + head)
    assert len(list(read_part(part))) == 2


@pytest.mark.parametrize("kind", [MESSAGE, EXECUTED_TURN])
def test_a_whole_message_that_says_nothing_is_damage(tmp_path: Path, kind: int) -> None:
    """Of a writer with an error: no turn is left out of a recording in silence."""
    write_executed(tmp_path, make_executed(1))
    (part,) = parts_of(tmp_path)
    channel = TOPIC_IDS["/turn"]
    part.write_bytes(part.read_bytes() + checked_record(kind, channel, 1, b"{"))
    with pytest.raises(OSError, match=f"{part.name} has been damaged"):
        join_parts(tmp_path, tmp_path / "e.mcap", [])
    assert not (tmp_path / "e.mcap").exists()


def test_no_two_threads_compress_with_the_same_memory() -> None:
    """zstandard lets other threads run meanwhile, and does not guard its own."""
    found = [_COMPRESSORS.of(LEVEL), _COMPRESSORS.of(LEVEL)]
    thread = threading.Thread(target=lambda: found.append(_COMPRESSORS.of(LEVEL)))
    thread.start()
    thread.join()
    assert found[0] is found[1]
    assert found[0] is not found[2]


def test_what_follows_a_cut_part_is_read(tmp_path: Path) -> None:
    write_part(tmp_path, ("/attempt", STARTED), ("/turn", make_turn(1)))
    (part,) = parts_of(tmp_path)
    part.write_bytes(part.read_bytes()[:-1])
    write_part(tmp_path, ("/attempt", STARTED), ("/turn", make_turn(2)))
    join_parts(tmp_path, tmp_path / "e.mcap", [])
    seqs = [m.get("seq") for _, m in read_file(tmp_path / "e.mcap")]
    assert seqs == [None, None, 2]


def test_long_recordings_have_several_chunks(tmp_path: Path) -> None:
    turn = make_turn(1)
    turn.actions = [{"arm": [1 / 3] * 5000}]
    write_part(tmp_path, *[("/turn", turn)] * 40)
    join_parts(tmp_path, tmp_path / "e.mcap", [("/result", 1, RESULT)])
    assert len(read_file(tmp_path / "e.mcap")) == 41
    with (tmp_path / "e.mcap").open("rb") as file:
        summary = make_reader(file).get_summary()
    assert summary is not None
    assert len(summary.chunk_indexes) == 4


def test_pictures_have_a_channel_for_each_camera(tmp_path: Path) -> None:
    stamp = {"sec": 1, "nsec": 2}
    for _ in range(2):
        write_part(
            tmp_path,
            ("/camera/left", Picture(stamp, "left", b"\xff\xd8", "jpeg")),
            ("/turn", make_turn(1)),
            ("/camera/right", Picture(stamp, "right", b"\xff", "jpeg")),
        )
    join_parts(tmp_path, tmp_path / "e.mcap", [])
    found = read_file(tmp_path / "e.mcap")
    order = ["/camera/left", "/turn", "/camera/right"] * 2
    assert sorted(topic for topic, _ in found) == sorted(order)
    assert ("/camera/left", "/9g=") in [(t, m.get("data")) for t, m in found]


def test_a_disk_that_is_full_leaves_no_file_and_every_part(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    write_part(tmp_path, ("/turn", make_turn(1)))

    def refuse(_: int) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, "fsync", refuse)
    with pytest.raises(OSError, match="No space"):
        join_parts(tmp_path, tmp_path / "e.mcap", [])
    assert [path.name for path in tmp_path.iterdir()] == ["000001.part"]


def test_a_write_that_stops_half_way_is_an_error(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    part, write = PartWriter(tmp_path), os.write
    part.write("/turn", make_turn(1))
    monkeypatch.setattr(os, "write", lambda file, data: write(file, data[:-1]))
    with pytest.raises(OSError, match="part of a message"):
        part.write("/turn", make_turn(2))
    with pytest.raises(OSError, match="part of a message"):
        part.write_turn(make_executed(2))
    part.close()
    assert len(list(read_part(parts_of(tmp_path)[0]))) == 1
    with pytest.raises(OSError, match="part of a message"):
        append_part(tmp_path, "/turn", make_turn(2))
    assert len(parts_of(tmp_path)) == 1


def test_failures_to_append_leave_no_parts(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """An episode may have so many parts: a full disk uses none of them."""
    fault = "/fault", Fault(1, 2, "simulator_fault", "it broke", "t")
    append_part(tmp_path, *fault)

    def refuse(*_: Any) -> int:
        raise OSError(28, "No space left on device")

    with monkeypatch.context() as patched:
        patched.setattr(os, "write", refuse)
        for _ in range(3):
            with pytest.raises(OSError, match="No space"):
                append_part(tmp_path, *fault)
            with pytest.raises(OSError, match="No space"):
                write_part(tmp_path, ("/turn", make_turn(1)))
    assert [path.name for path in parts_of(tmp_path)] == ["000001.part"]


WRITE_AND_SAY = """
import sys
from pathlib import Path
from reference_record.recordings.recording_parts import PartWriter
from reference_record.recordings.recording import AttemptEvent
from tests.support.sim.recorded_turn import make_executed
part = PartWriter(Path(sys.argv[1]))
part.write("/attempt", AttemptEvent(1, "started", "t"))
for seq in range(1_000_000):
    part.write_turn(make_executed(seq))
    print(seq, flush=True)
"""


def test_a_writer_that_is_killed_loses_nothing_that_it_reported(tmp_path: Path) -> None:
    writer = subprocess.Popen(
        [sys.executable, "-c", WRITE_AND_SAY, str(tmp_path)],
        cwd=ROOT,
        stdout=subprocess.PIPE,
        text=True,
    )
    assert writer.stdout is not None
    for _ in range(50):
        writer.stdout.readline()
    writer.send_signal(signal.SIGKILL)
    reported = 49 + len(writer.stdout.read().splitlines())
    writer.wait()
    writer.stdout.close()
    (part,) = parts_of(tmp_path)
    assert sum(topic == "/turn" for topic, *_ in read_part(part)) > reported


@pytest.mark.parametrize("at_wall", [0.0, 951_827_696.789, 1.7e9, 1_798_761_599.999])
def test_times_are_rfc_3339_to_the_millisecond(at_wall: float) -> None:
    """A leap day, and the last second of a year, among others."""
    expected = datetime.fromtimestamp(int(at_wall * 1000) / 1000, UTC)
    text = timestamp(at_wall)
    assert datetime.fromisoformat(text) == expected
    assert len(text) == len("2026-11-23T09:00:00.000Z")
