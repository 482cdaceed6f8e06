"""Has records read by a process of its own (`verify_process.py`), within bounds.

The server itself parses nothing of a record: of what that process writes it takes so
many bytes, in so much time, and of the types that it expects.
"""

from __future__ import annotations

import asyncio
import signal
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Final, TypeVar

import msgspec

from reference_record.broken import BrokenRecord
from reference_record.contents.statement import RecordedResult
from reference_record.formats.names import EPISODES_MAX
from reference_server.process.child_environment import child_environment
from reference_server.records.examination_turns import ExaminationTurns
from reference_server.records.verify_process import (
    CHOICE_BYTES_MAX,
    BrokenPart,
    Found,
    RecordFacts,
    Replayable,
    takes_too_much,
)
from reference_sim.replay.foreign_manifest import BenchmarkChoice

# A file that takes a fifth of it alone has the lowest priority on a busy machine.
EXAMINE_S_MAX: Final = 600.0
# A request waits so long for the records of others, after its body was received.
WAIT_S_MAX: Final = 60.0
# Examinations at once, of all accounts: each may take a processor that is idle
# otherwise.
EXAMINED_AT_ONCE: Final = 4
FOUND_BYTES_MAX: Final = 2**17
RESULT_BYTES_MAX: Final = 2**8
REPLAYABLE_BYTES_MAX: Final = CHOICE_BYTES_MAX + EPISODES_MAX * RESULT_BYTES_MAX

_RESULTS: Final = msgspec.json.Decoder(RecordedResult)
# Exit codes of a process that the system or its operator has ended.
_BY_OTHERS: Final = (-signal.SIGKILL, -signal.SIGTERM)
T = TypeVar("T")


class ExaminationFailed(Exception):
    """The record could not be read to its end, perhaps for a cause outside of it."""


class Recorded:
    """A verified record, as its replay needs it.

    choice: as the record has it, unchecked.

    Each result is decoded when it is its turn: there may be 65,000.
    """

    def __init__(self, choice: BenchmarkChoice, lines: bytes) -> None:
        self.choice, self._lines = choice, lines

    def results(self) -> Iterator[RecordedResult]:
        """The results of the episodes that have a recording, by index."""
        return map(_RESULTS.decode, self._lines.splitlines())


class RecordVerifier:
    """Reads records of all accounts."""

    def __init__(self) -> None:
        self._turns = ExaminationTurns(EXAMINED_AT_ONCE)

    @property
    def waiting(self) -> int:
        """Records that have been received and are not being examined yet."""
        return self._turns.waiting

    async def examine(self, account: str, path: Path) -> RecordFacts:
        """REC-113: what the record says.

        Raises BrokenRecord, NoTurn if those of others took too long, OSError and
        ExaminationFailed.
        """
        async with self._turns.place(account, WAIT_S_MAX):
            said = await _run("examine", path, FOUND_BYTES_MAX)
        report = _decoded(said, Found)
        if report.facts is None:
            raise _broken(report.broken)
        return report.facts

    async def read_for_replay(self, path: Path) -> Recorded:
        """Read an examined record. Raises as `examine` does, except for NoTurn."""
        said = await _run("replay", path, REPLAYABLE_BYTES_MAX)
        head, _, lines = said.partition(b"\n")
        replayable = _decoded(head, Replayable)
        if replayable.choice is None:
            raise _broken(replayable.broken)
        return Recorded(replayable.choice, lines)


def _decoded(said: bytes, type_: type[T]) -> T:
    try:
        return msgspec.json.decode(said, type=type_)
    except msgspec.DecodeError as error:
        raise ExaminationFailed("what was found in it cannot be read") from error


def _broken(part: BrokenPart | None) -> BrokenRecord:
    if part is None:
        raise ExaminationFailed("nothing was found in it")
    return BrokenRecord(part.file, part.rule, part.detail)


async def _run(task: str, path: Path, bytes_max: int) -> bytes:
    """Run the process; returns its output. Raises as `RecordVerifier.examine`."""
    process = await asyncio.create_subprocess_exec(
        *(sys.executable, "-P", "-m", "reference_server.records.verify_process"),
        *(task, str(path)),
        stdin=asyncio.subprocess.DEVNULL,
        stdout=asyncio.subprocess.PIPE,
        env=child_environment(),
        start_new_session=True,  # a terminal's Ctrl-C is the server's to handle
    )
    assert process.stdout is not None
    try:
        async with asyncio.timeout(EXAMINE_S_MAX):
            said = await _read(process.stdout, bytes_max)
            status = await process.wait()
    except TimeoutError as error:
        text = f"it was not read through in {EXAMINE_S_MAX:g} s"
        raise ExaminationFailed(text) from error
    finally:
        if process.returncode is None:
            process.kill()
            await process.wait()
    _check_status(status)
    return said


def _check_status(status: int) -> None:
    """Raise what the end of the process means; negative: the signal that ended it."""
    if status in _BY_OTHERS or status > 0:
        raise ExaminationFailed(f"the process that read it ended with {status}")
    if status != 0:  # its bound of time, or of memory where Python has no error
        raise takes_too_much()


async def _read(stream: asyncio.StreamReader, bytes_max: int) -> bytes:
    said = bytearray()
    while part := await stream.read(2**16):
        said += part
        if len(said) > bytes_max:
            raise ExaminationFailed(f"more than {bytes_max} bytes were found in it")
    return bytes(said)
