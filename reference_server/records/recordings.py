"""The recordings of this server's episodes on disk: begin, continue, finish, delete.

A simulator process appends the turns (`reference_sim/process/recorder.py`). Facts that
only the server knows (faults, how attempts end, the result) are appended here, in a
part of its own. No file is touched in the event loop: each episode has one thread that
does its work in order. A write that fails is reported when the episode begins again or
is finished, never dropped.

    RECORDS/RUN_ID/00042.parts/000001.part    an episode in play
    RECORDS/RUN_ID/00042.mcap                 an episode with its result

The nodes of a cluster share the folder. A node names the files of a run after the fence
with which it owns the run (00042.fence2.parts, 00042.fence2.mcap): an earlier owner or
its simulators may still write, but never to the files of its successor. Parts of
earlier owners belong to the recording, before those of later ones.
"""

from __future__ import annotations

import asyncio
import contextlib
import logging
import re
import shutil
import time
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from pathlib import Path
from tempfile import TemporaryFile
from typing import NamedTuple, Protocol, TypeVar
from weakref import WeakValueDictionary

import msgspec

from reference_record.recordings.open_attempt import (
    OpenAttempt,
    has_taken_over,
    read_attempt,
    take_over,
)
from reference_record.recordings.recording import (
    AttemptEvent,
    EpisodeResult,
    Fault,
    Message,
    RecordedJudgement,
)
from reference_record.recordings.recording_file import DRAFT_SUFFIX, join_parts
from reference_record.recordings.recording_parts import (
    NO_ROOM,
    append_part,
    remove_parts,
)
from reference_record.texts.timestamps import timestamp
from reference_server.failover.kept_sessions import KeptSessions
from reference_server.files.file_faults import describe_file_fault
from reference_server.files.file_sizes import size_of
from reference_server.files.object_storage import (
    IMPORTED,
    ObjectStorage,
    StorageFailed,
)
from reference_server.rules.refusal import Refused
from reference_server.rules.runs.run import Episode, Recording, Result, Run
from reference_server.storage.runs.run_store import StoreFailed
from reference_server.telemetry.counters import COUNTERS
from reference_server.telemetry.repeated_failures import RepeatedFailures
from reference_sim.process.pool import RecordingPlan

log = logging.getLogger("proctor.records")

# Episodes whose files are written at once.
THREADS = 4
FETCHED_AT_ONCE = 8
STORAGE_IS_AWAY = (
    "The storage of recordings is not available, and the log of the server says why"
)
# More than a full disk may have left for a file that is there.
CHECKED_BYTES = 2**16

# The name of the file and of the folder of parts: the index of the episode, and the
# fence of who writes, unless that is 0.
_EPISODE = re.compile(r"(?P<index>[0-9]{5})(?:\.fence(?P<fence>[1-9][0-9]*))?")

Done = TypeVar("Done")


class Key(NamedTuple):
    """The files of one episode: its run, its index there, the fence of their owner."""

    run_id: str
    episode: int
    fence: int


class GivenJudgement(Protocol):
    """The judgement of a person; `cells/` has it."""

    @property
    def judge(self) -> str: ...
    @property
    def success(self) -> bool: ...
    @property
    def score(self) -> float: ...
    @property
    def met(self) -> Sequence[int]: ...
    @property
    def note(self) -> str: ...
    @property
    def blind(self) -> bool: ...
    @property
    def cell(self) -> str: ...


_STORAGE_FAILURES = RepeatedFailures(log)


async def use_storage(
    storage: ObjectStorage, work: Callable[..., Done], *given: object
) -> Done:
    """Call work of the storage in a thread; a failure is logged, too."""
    try:
        return await asyncio.to_thread(work, *given)
    except StorageFailed as failed:
        _STORAGE_FAILURES.report(f"cannot use {storage.url}", str(failed))
        raise


@contextlib.contextmanager
def refused_while_away() -> Iterator[None]:
    """Refuse the request of a client that needs the storage. Raises Refused."""
    try:
        yield
    except StorageFailed as failed:
        raise Refused("unavailable", f"{STORAGE_IS_AWAY}.") from failed


class RecordingFailed(Exception):
    """A recording could not be written; what it says is on disk up to the last part."""


class Recordings:
    """All recordings below one folder.

    pictures: what cameras show is recorded, too. is_shared: other nodes write to the
    folder, too. keeps_sessions: what a restart needs to go on with sessions is beside
    the recordings. storage: has every finished recording; the folder is then of this
    machine alone.
    """

    def __init__(
        self,
        folder: Path,
        *,
        pictures: bool = False,
        is_shared: bool = False,
        keeps_sessions: bool = False,
        storage: ObjectStorage | None = None,
    ) -> None:
        self.is_shared = is_shared
        self._folder = folder
        self._pictures = pictures
        self.sessions: KeptSessions | None = None
        if keeps_sessions:
            is_of_machine = storage is not None
            self.sessions = KeptSessions(self._folder, is_of_machine=is_of_machine)
        self._storage = storage
        self._failures = RepeatedFailures(log)
        self._opened_at_wall = 0.0
        # One thread each: what is appended to an episode keeps its order.
        self._threads = [ThreadPoolExecutor(1, "recordings") for _ in range(THREADS)]
        self._pending: dict[Key, list[tuple[str, Message]]] = {}
        self._appending: set[asyncio.Task[None]] = set()
        # The task that holds one writes to that episode; gone when none is held.
        self._locks: WeakValueDictionary[Key, asyncio.Lock] = WeakValueDictionary()

    def open(self) -> None:
        """Make the folder, which its owner alone may read. Raises OSError."""
        self._folder.mkdir(mode=0o700, parents=True, exist_ok=True)
        self._opened_at_wall = time.time() - 1.0  # the clock of files lags behind

    async def check_storage(self) -> None:
        """Raises OSError if what keeps finished recordings cannot be reached."""
        if self._storage is not None:
            await use_storage(self._storage, self._storage.check)

    async def check_writable(self) -> None:
        """Raises OSError if no recording could begin, or none could be stored."""
        await asyncio.to_thread(_write_for_a_moment, self._folder)
        if self._storage is not None:
            await asyncio.to_thread(self._storage.look)

    async def close(self) -> None:
        """Returns when everything that was begun is written."""
        while self._appending:
            await asyncio.wait(self._appending)
        for threads in self._threads:
            threads.shutdown()
        if self.sessions is not None:
            self.sessions.close()

    # --- an episode ---

    async def begin(
        self,
        run: Run,
        episode: Episode,
        *,
        is_continued: bool = False,
        pictures: bool = False,
    ) -> RecordingPlan:
        """Where the next playing of the episode is recorded. Raises RecordingFailed.

        is_continued: the attempt goes on that `take_over` has found. pictures: they
        are recorded even where those of other episodes are not (PHY-029).
        """
        key = Key(run.run_id, episode.index, run.fence)
        await self._write(key)
        folder, pictures = str(self._parts(key)), pictures or self._pictures
        return RecordingPlan(folder, episode.attempt, pictures, is_continued)

    async def take_over(self, run: Run, episode: Episode) -> OpenAttempt | None:
        """The attempt in play; what earlier owners still write is read no more.

        None if it cannot be read.
        """
        key = Key(run.run_id, episode.index, run.fence)
        own, earlier = self._parts(key), self._parts_before(key)

        def read() -> OpenAttempt:
            if not has_taken_over(own):
                take_over(earlier, own)
            return read_attempt([own])

        try:
            return await self._in_thread(key, read)
        except (RecordingFailed, StoreFailed, msgspec.MsgspecError) as error:
            text = "run %s, episode %d: an attempt cannot go on: %s"
            log.warning(text, run.run_id, episode.index, error)
            return None

    def add_fault(
        self, run: Run, episode: Episode, seq: int, code: str, detail: str
    ) -> None:
        """REC-105: what broke in a turn of the attempt in play; written soon."""
        now = timestamp(time.time())
        fault = Fault(episode.attempt, seq, code, detail, now)
        self._append(Key(run.run_id, episode.index, run.fence), "/fault", fault)

    def add_judgement(self, run: Run, episode: Episode, given: GivenJudgement) -> None:
        """PHY-021: who judged the attempt in play, and how; written with its result."""
        judged = RecordedJudgement(
            episode.attempt,
            given.judge,
            given.success,
            given.score,
            given.met,
            given.note,
            given.blind,
            timestamp(time.time()),
            given.cell,
        )
        self._append(Key(run.run_id, episode.index, run.fence), "/judgement", judged)

    def end_attempt(self, run: Run, index: int, attempt: int, reason: str) -> None:
        """REC-105: an attempt is over without a result; written soon."""
        now = timestamp(time.time())
        ended = AttemptEvent(attempt, "ended", now, reason)
        self._append(Key(run.run_id, index, run.fence), "/attempt", ended)

    async def finish(self, run: Run, episode: Episode, result: Result) -> Recording:
        """Join all that was recorded of the episode with its result, durably.

        May be called again, with another result: as long as the parts are there, the
        last call decides. Raises RecordingFailed, also when what is on disk does not
        have the turns of the result: who counted it could not show how it came.
        """
        key = Key(run.run_id, episode.index, run.fence)
        await self._write(key)
        at_ns = int(result.finished_at_wall * 1e9)
        last: list[tuple[str, int, Message]] = []
        steps = None if result.outcome == "abandoned" else result.steps
        if result.outcome != "abandoned":
            ended = AttemptEvent(
                result.attempt, "ended", timestamp(result.finished_at_wall), "scored"
            )
            last.append(("/attempt", at_ns, ended))
        recorded = EpisodeResult(
            result.outcome,
            success=result.outcome == "success",
            score=result.score,
            steps=result.steps,
            attempts=result.attempt,
            at=timestamp(result.finished_at_wall),
        )
        last.append(("/result", at_ns, recorded))
        parts, target = self._parts(key), self._file(key)
        earlier = self._parts_before(key)
        work = partial(join_parts, parts, target, last, earlier, steps=steps)
        summary = await self._in_thread(key, work)
        await self._store(key)
        COUNTERS.recordings += 1
        COUNTERS.recording_bytes += summary.bytes
        latency = msgspec.structs.asdict(summary.latency)
        return Recording(
            summary.sha256,
            summary.bytes,
            summary.turns,
            summary.first_digest,
            summary.last_digest,
            latency,
            key.fence,
        )

    async def _store(self, key: Key) -> None:
        """Keep a finished recording where all nodes find it. Raises StoreFailed."""
        if self._storage is None:
            return
        target = self._file(key)
        try:
            await use_storage(
                self._storage, self._storage.put, _name_in_storage(key), target
            )
        except OSError as error:
            COUNTERS.recordings_failed += 1
            raise StoreFailed(STORAGE_IS_AWAY) from error

    async def make_here(self, run_id: str, files: Iterable[tuple[int, int]]) -> None:
        """Let recordings be below the folder, as far as they are stored.

        files: index of each episode, and the fence of its recording. Raises OSError,
        and Refused where the storage is away.
        """
        storage = self._storage
        if storage is None:
            return
        keys = [Key(run_id, index, fence) for index, fence in files]

        def fetch(key: Key) -> None:
            if not self._file(key).exists():
                with contextlib.suppress(FileNotFoundError):
                    storage.fetch(_name_in_storage(key), self._file(key))

        for start in range(0, len(keys), FETCHED_AT_ONCE):
            some = keys[start : start + FETCHED_AT_ONCE]
            with refused_while_away():
                await asyncio.gather(
                    *(use_storage(storage, fetch, key) for key in some)
                )

    async def finish_unplayed(self, run: Run) -> None:
        """Finish the recordings of results that no turn gave: of abandoned episodes.

        On return no changed episode of the run has a result without its recording, and
        no session is kept that has ended.
        """
        if self.sessions is not None:
            await self.sessions.settle(run)
        while missing := [
            (episode, episode.result)
            for episode in map(run.episodes.__getitem__, run.changed)
            if episode.result is not None and episode.recording is None
        ]:
            for episode, result in missing:
                try:
                    episode.recording = await self.finish(run, episode, result)
                except RecordingFailed as failed:
                    raise StoreFailed(str(failed)) from failed

    def remove_parts(self, run: Run, stored: set[int]) -> None:
        """These episodes are stored: where they have a result, the file is final."""
        for index in stored:
            if run.episodes[index].recording is not None:
                key = Key(run.run_id, index, run.fence)
                fences = range(run.fence + 1)
                folders = [self._parts(key._replace(fence=fence)) for fence in fences]
                self._threads_of(key).submit(_remove_all_parts, folders)

    def path(self, run_id: str, index: int, fence: int = 0) -> Path:
        """The file of an episode that has its result; fence: of its recording."""
        return self._file(Key(run_id, index, fence))

    def _file(self, key: Key) -> Path:
        return self._folder / f"{key.run_id}/{_name_of(key)}.mcap"

    def _parts(self, key: Key) -> Path:
        return self._folder / f"{key.run_id}/{_name_of(key)}.parts"

    def _parts_before(self, key: Key) -> list[Path]:
        """The folders to which earlier owners of the run wrote, the first one first.

        But for those of which a later owner has all that counts.
        """
        folders: list[Path] = []
        for fence in range(key.fence, 0, -1):
            if has_taken_over(self._parts(key._replace(fence=fence))):
                break
            folders.insert(0, self._parts(key._replace(fence=fence - 1)))
        return folders

    # --- runs ---

    async def remove_run(self, run_id: str) -> None:
        """Remove all that was recorded of a run. Raises StorageFailed."""
        folder = self._folder / run_id
        await asyncio.to_thread(_remove_folder, folder)
        if self._storage is not None:
            await use_storage(self._storage, self._storage.remove_folder, run_id)

    def sizes(self) -> dict[str, int]:
        """The id of each run that has recordings → their bytes. Blocks."""
        if self._storage is not None:
            of_storage = self._storage.sizes().items()
            return {name: size for name, size in of_storage if name != IMPORTED}
        return {
            run_id: size_of([self._folder / run_id])
            for run_id in self.run_ids()
            if (self._folder / run_id).is_dir()
        }

    def run_ids(self) -> list[str]:
        """The ids of the runs that have files here. Reads the folder, and blocks."""
        names = {path.name for path in self._folder.iterdir()}
        if self._storage is not None:
            names |= self._storage.folders()
        return sorted(name for name in names if not name.startswith("."))

    # --- what a crash has left ---

    def remove_drafts(self) -> None:
        """Remove files that were being joined when an earlier server ended. Blocks.

        In a shared folder they may belong to another node: there `remove_unused` does
        it.
        """
        if self.is_shared:
            return
        for draft in self._folder.glob("*/*" + DRAFT_SUFFIX):
            if _EPISODE.fullmatch(draft.stem):
                with contextlib.suppress(OSError):
                    if draft.stat().st_mtime < self._opened_at_wall:
                        draft.unlink()

    def runs_with_leftovers(self, since_wall: float = 0.0) -> list[str]:
        """Ids of runs where an episode has its file and others beside it. Blocks.

        since_wall: only runs in whose folders a name was added or removed since then.
        """
        return [run for run in self.run_ids() if self._has_leftovers(run, since_wall)]

    def _has_leftovers(self, run_id: str, since_wall: float) -> bool:
        with contextlib.suppress(OSError):
            if (self._folder / run_id).stat().st_mtime < since_wall:
                return False
        written = [(path.suffix, index) for path, index, _ in self._written(run_id)]
        counts = Counter(index for _, index in written)
        return any(suffix == ".mcap" and counts[index] > 1 for suffix, index in written)

    def remove_unused(self, run_id: str, fences: Mapping[int, int]) -> None:
        """Remove files of a completed run that none of its results names. Blocks.

        fences: index of an episode → fence of its stored recording.
        """
        for path, index, fence in self._written(run_id):
            if index in fences and (path.suffix, fence) != (".mcap", fences[index]):
                _remove(path)
        if self._storage is not None:
            names = self._storage.names_in(run_id)
            used = {_name_of(Key(run_id, *item)) + ".mcap" for item in fences.items()}
            self._storage.remove(
                f"{run_id}/{name}" for name in names if name not in used
            )

    def _written(self, run_id: str) -> Iterator[tuple[Path, int, int]]:
        """The files and folders of a run, each with its episode's index and fence."""
        try:
            paths = sorted((self._folder / run_id).iterdir())
        except OSError:  # it was removed meanwhile, or is a file
            return
        for path in paths:
            name = _EPISODE.fullmatch(path.stem)
            if name and path.suffix in (".parts", ".mcap", DRAFT_SUFFIX):
                yield path, int(name["index"]), int(name["fence"] or 0)

    # --- writing in order ---

    def _append(self, key: Key, topic: str, message: Message) -> None:
        self._pending.setdefault(key, []).append((topic, message))
        task = asyncio.create_task(self._append_soon(key))
        self._appending.add(task)
        task.add_done_callback(self._appending.discard)

    async def _append_soon(self, key: Key) -> None:
        try:
            await self._write(key)
        except (RecordingFailed, StoreFailed) as failed:  # `begin`, `finish` try again
            log.warning("run %s, episode %d: %s", key.run_id, key.episode, failed)

    async def _write(self, key: Key) -> None:
        """Write the messages that are not written yet. Raises RecordingFailed.

        One message at a time: if a write of several fails, the first ones may be in the
        file, and would be written twice.
        """
        if key not in self._pending and key not in self._locks:
            return
        lock = self._locks.setdefault(key, asyncio.Lock())
        async with lock:
            while messages := self._pending.get(key):
                work = partial(append_part, self._parts(key), *messages[0])
                await self._in_thread(key, work)
                del messages[0]
            self._pending.pop(key, None)

    def _threads_of(self, key: Key) -> ThreadPoolExecutor:
        return self._threads[hash(key) % THREADS]

    async def _in_thread(self, key: Key, work: Callable[[], Done]) -> Done:
        loop, threads = asyncio.get_running_loop(), self._threads_of(key)
        try:
            return await loop.run_in_executor(threads, work)
        except OSError as error:
            COUNTERS.recordings_failed += 1
            cause = str(error.strerror or error)
            self._failures.report("a recording could not be written", cause)
            text = f"The recording could not be written: {cause}"
            if error.errno in NO_ROOM:  # no episode is charged with it
                raise StoreFailed(text) from error
            raise RecordingFailed(text) from error


def _write_for_a_moment(folder: Path) -> None:
    try:
        with TemporaryFile(dir=folder) as file:
            file.write(bytes(CHECKED_BYTES))
    except OSError as error:
        raise OSError(describe_file_fault(error, folder)) from error


def _name_in_storage(key: Key) -> str:
    return f"{key.run_id}/{_name_of(key)}.mcap"


def _name_of(key: Key) -> str:
    return f"{key.episode:05d}" + (f".fence{key.fence}" if key.fence else "")


def _remove_all_parts(folders: Iterable[Path]) -> None:
    for folder in folders:
        remove_parts(folder)


def _remove(path: Path) -> None:
    """A file, or a folder with all that it has."""
    if path.is_dir():
        _remove_folder(path)
        return
    with contextlib.suppress(OSError):
        path.unlink()


def _remove_folder(folder: Path) -> None:
    """Remove the folder; errors are ignored, because leftovers cost only space."""
    shutil.rmtree(folder, ignore_errors=True)
