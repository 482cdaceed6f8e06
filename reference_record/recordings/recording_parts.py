"""The parts of a recording in progress: messages appended one by one.

A part is a sequence of MCAP's message records, in a folder of its episode. It has one
writer, and each message is one write: when the writer is killed at any moment, every
message before that can be read. Who goes on writes another part, with the next number.

A turn is written as the simulator's process has it in memory (`ExecutedTurn`): between
two turns other work has emptied the processor's caches, and formatting a message there
costs five times what it costs when many are read one after the other.
"""

from __future__ import annotations

import errno
import os
import time
from collections.abc import Iterator, Sequence
from contextlib import suppress
from pathlib import Path
from typing import Generic, NamedTuple, TypeVar
from zlib import crc32

import msgspec

from reference_record.recordings.recording import (
    MESSAGE,
    MESSAGE_HEAD,
    TOPIC_IDS,
    WHOLE_HEAD,
    Actions,
    Message,
    Turn,
    checked_record,
    digest_state,
    encode_message,
    text,
)
from reference_record.texts.timestamps import timestamp

SUFFIX = ".part"
# The disk or a quota is full: neither the episode nor the recorder is at fault.
NO_ROOM = frozenset({errno.ENOSPC, errno.EDQUOT, errno.EFBIG})
# The topic of a camera, before the first message with this channel id.
CAMERA_TOPIC = 0xF0
# A turn that is not yet a message.
EXECUTED_TURN = 0xF1
_NAME_AT = 4
_READ_BYTES = 1 << 16
_TURN_CHANNEL = TOPIC_IDS["/turn"]


class TurnCommand(msgspec.Struct):
    """The command of a turn; the episode may end before all actions are executed.

    observe_all, requested: for who goes on with the attempt after a restart; what the
    policy sent, where that was clipped.
    """

    actions: Actions
    seq: int
    think_ms: float
    observe_all: bool = False
    requested: Actions | None = None


CommandT = TypeVar("CommandT")


class ExecutedTurn(msgspec.Struct, Generic[CommandT], array_like=True):
    """A turn as it was executed, with a reward for each executed action.

    state: after it, in bytes; empty if its digest is there. command: TurnCommand,
    written as the MessagePack in which it was received.
    """

    attempt: int
    rewards: Sequence[float]
    score: float
    success: bool
    ended: bool
    state: bytes
    digest: str | None
    simulate_s: float
    command: CommandT


# Topic, nanoseconds since 1970, and what is said, in JSON if it was written so.
PartMessage = tuple[str, int, Turn | bytes]

_encode_turn = msgspec.msgpack.Encoder().encode
decode_turn = msgspec.msgpack.Decoder(ExecutedTurn[TurnCommand]).decode


class _PartEncoder:
    """The bytes of one part; cameras get their channels when they first show."""

    def __init__(self) -> None:
        self._topics = dict(TOPIC_IDS)

    def encode(self, topic: str, message: Message, at_ns: int | None) -> bytes:
        at_ns = time.time_ns() if at_ns is None else at_ns
        channel, written = self._topics.get(topic), b""
        if channel is None:
            channel = self._topics[topic] = len(self._topics) + 1
            written = checked_record(CAMERA_TOPIC, channel, at_ns, text(topic))
        return written + checked_record(
            MESSAGE, channel, at_ns, encode_message(message)
        )


def _turn_record(turn: ExecutedTurn[msgspec.Raw]) -> bytes:
    """As `checked_record` makes it; a call less is a microsecond in these caches."""
    data, at_ns = _encode_turn(turn), time.time_ns()
    length, checksum = MESSAGE_HEAD.size + len(data), crc32(data)
    head = (EXECUTED_TURN, length, _TURN_CHANNEL, checksum, at_ns, at_ns)
    return WHOLE_HEAD.pack(*head) + data


class PartWriter:
    """A new part in `folder`, behind all that are there.

    most: so many parts may be there with it; None for any number. Raises OSError.
    """

    def __init__(self, folder: Path, most: int | None = None) -> None:
        number = 1
        try:
            folder.mkdir(mode=0o700, parents=True)
        except FileExistsError:
            number += max(map(_number_of, parts_of(folder)), default=0)
        if most is not None and number > most:
            raise OSError(f"the episode was begun or broke {most} times")
        flags = os.O_WRONLY | os.O_CREAT | os.O_EXCL | os.O_APPEND | os.O_CLOEXEC
        self._path = folder / f"{number:06d}{SUFFIX}"
        self._file = os.open(self._path, flags, 0o600)
        self._has_message = False
        self._encoder = _PartEncoder()

    def write(self, topic: str, message: Message, at_ns: int | None = None) -> None:
        """Append a message, which survives the end of this process once this returns.

        Raises OSError, and removes a part whose first message cannot be written.
        """
        self.append(self._encoder.encode(topic, message, at_ns))

    def write_turn(self, turn: ExecutedTurn[msgspec.Raw]) -> None:
        """Append a turn, as `write` does; the part has a message already."""
        written = _turn_record(turn)
        taken = os.write(self._file, written)
        if taken < len(written):
            self._write_all(written[taken:])

    def append(self, written: bytes) -> None:
        """Append what a CollectedPart has collected, as `write` does."""
        try:
            self._write_all(written)
        except OSError:
            if not self._has_message:
                self._path.unlink(missing_ok=True)
            raise
        self._has_message = True

    def _write_all(self, written: bytes) -> None:
        taken = os.write(self._file, written)
        while taken < len(written):  # the disk is nearly full: the next one says so
            written = written[taken:]
            taken = os.write(self._file, written)
            if not taken:
                raise OSError("the disk took a part of a message only")

    def close(self) -> None:
        os.close(self._file)


class CollectedPart:
    """A part that another machine writes: `take` gives what it has to append."""

    def __init__(self) -> None:
        self._encoder = _PartEncoder()
        self._collected: list[bytes] = []

    def write(self, topic: str, message: Message, at_ns: int | None = None) -> None:
        self._collected.append(self._encoder.encode(topic, message, at_ns))

    def write_turn(self, turn: ExecutedTurn[msgspec.Raw]) -> None:
        self._collected.append(_turn_record(turn))

    def take(self) -> bytes:
        """All that was written since the last time."""
        taken = b"".join(self._collected)
        self._collected.clear()
        return taken

    def close(self) -> None:
        """Nothing is held."""


def append_part(folder: Path, topic: str, message: Message) -> None:
    """Write one message as a part of its own."""
    part = PartWriter(folder)
    try:
        part.write(topic, message)
    finally:
        part.close()


def parts_of(folder: Path) -> list[Path]:
    """The parts in a folder, in the order in which they were begun."""
    try:
        with os.scandir(folder) as entries:
            names = [one.name for one in entries if one.name.endswith(SUFFIX)]
    except (FileNotFoundError, NotADirectoryError):
        return []
    return sorted((folder / name for name in names), key=_number_of)


def remove_parts(folder: Path) -> None:
    """Remove the parts and their folder; a part that stays only costs space."""
    with suppress(OSError):
        for part in parts_of(folder):
            part.unlink()
        folder.rmdir()


def json_of(message: Turn | bytes) -> bytes:
    """The JSON of a message; the parts hold turns in a binary form of their own."""
    return encode_message(message) if isinstance(message, Turn) else message


class PartRecord(NamedTuple):
    """A whole message of a part, as it was written. topic: empty for a declaration."""

    topic: str
    kind: int
    at_ns: int
    data: bytes
    written: bytes


def read_part(path: Path) -> Iterator[PartMessage]:
    """The messages up to where the part was cut. Raises OSError, MsgspecError."""
    for topic, kind, at_ns, data, _ in _read_records(path):
        if kind == EXECUTED_TURN:
            yield topic, at_ns, _turn_of(decode_turn(data), at_ns)
        elif kind == MESSAGE:
            yield topic, at_ns, data


def records_of(path: Path) -> Iterator[PartRecord]:
    """All that was written up to where the part was cut. Raises OSError."""
    for topic, kind, at_ns, data, head in _read_records(path):
        yield PartRecord(topic, kind, at_ns, data, head + data)


def _read_records(path: Path) -> Iterator[tuple[str, int, int, bytes, bytes]]:
    """Topic, kind, time, data and head of each; plain, as a recording has many."""
    topics = {channel: topic for topic, channel in TOPIC_IDS.items()}
    with path.open("rb", _READ_BYTES) as file:
        read, left = file.read, os.fstat(file.fileno()).st_size
        while len(head := read(WHOLE_HEAD.size)) == WHOLE_HEAD.size:
            kind, length, channel, checksum, at_ns, _ = WHOLE_HEAD.unpack(head)
            size = length - MESSAGE_HEAD.size
            left -= WHOLE_HEAD.size + size
            if size < 0 or left < 0:
                return
            data = read(size)
            if kind == CAMERA_TOPIC:
                topics[channel] = data[_NAME_AT:].decode(errors="replace")
                yield "", kind, at_ns, data, head
            elif kind not in (EXECUTED_TURN, MESSAGE):
                return
            elif crc32(data) != checksum or channel not in topics:
                return  # the end that a power cut leaves of a file
            else:
                yield topics[channel], kind, at_ns, data, head


def _turn_of(executed: ExecutedTurn[TurnCommand], at_ns: int) -> Turn:
    command, rewards = executed.command, executed.rewards
    steps = len(rewards)
    # Rounded to four decimals without `round`, which takes four times as long. In the
    # order of the members: an episode has many turns.
    return Turn(
        executed.attempt,
        command.seq,
        command.actions[:steps],
        rewards,
        steps,
        executed.score,
        executed.success,
        executed.ended,
        executed.digest or digest_state(executed.state),
        int(executed.simulate_s * 1e7 + 0.5) / 1e4,
        int(command.think_ms * 1e4 + 0.5) / 1e4,
        timestamp(at_ns / 10**9),
    )


def digest_after(executed: ExecutedTurn[TurnCommand]) -> str:
    """The digest of the state after the turn."""
    return executed.digest or digest_state(executed.state)


def _number_of(path: Path) -> int:
    return int(path.stem)
