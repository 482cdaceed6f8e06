"""Sessions as a restart finds them: one small file for each that plays an episode.

    RECORDS/RUN_ID/sessions/WORKER.fence2.session

It is written when the session gets an episode, never in a turn: together with the
recording of the attempt it is all that another process needs to go on. Like recordings
the files are named after the fence of their owner, so that an earlier one, which was
paused, changes nothing of its successor's.
"""

from __future__ import annotations

import asyncio
import contextlib
import hashlib
import logging
import re
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import TypeAlias, TypeVar

import msgspec

from reference_record.generated.answers import Fault, Observe
from reference_server.rules.runs.run import Player, Run, Session
from reference_sim.process.pool import ChunkReply

log = logging.getLogger("proctor.records")

FOLDER = "sessions"
_NAME = re.compile(r"(?P<worker>[0-9a-f]{32})\.fence(?P<fence>[0-9]+)\.session")
_VERSION = 1
Done = TypeVar("Done")
Request: TypeAlias = tuple[Sequence[Mapping[str, Sequence[float]]], Observe]


class EndedBefore(msgspec.Struct, frozen=True):
    """The turn that ended the episode before: what it answers beside its results.

    left: actions that were not executed. index: of that episode.
    """

    played: ChunkReply
    left: int
    index: int


class EpisodeEnding(msgspec.Struct, frozen=True):
    """The turn that ends the session's episode, before its result is stored."""

    seq: int
    request: Request | None
    ended: EndedBefore


class KeptSession(msgspec.Struct, frozen=True):
    """A session as it was when it got the episode that it plays.

    index, attempt: of the episode. seq, request: of the turn with which that came; 0
    and None for its attach. ended, fault: of that turn. steps, think_s: of the attempt,
    which another session may have begun. ending: once the episode has ended; it counts
    if the result of the episode is stored.
    """

    worker_id: str
    session_id: str
    attach_key: str
    max_attempts: int | None
    player: Player | None
    attempt_player: Player | None
    index: int
    attempt: int
    seq: int
    request: Request | None
    ended: EndedBefore | None
    fault: Fault | None
    steps: int
    think_s: float
    ending: EpisodeEnding | None = None
    first_episodes: int | None = None
    version: int = _VERSION


def ended_before(played: ChunkReply, sent: int, index: int) -> EndedBefore:
    """sent: how many actions the turn had."""
    without = msgspec.structs.replace(played, observation=None)
    return EndedBefore(without, sent - played.executed, index)


def kept_session(
    session: Session, ended: EndedBefore | None, fault: Fault | None
) -> KeptSession:
    """The session as it is now, with an episode."""
    episode = session.episode
    assert episode is not None, "a session without an episode is not kept"
    return KeptSession(
        session.worker_id,
        session.session_id,
        session.attach_key,
        session.max_attempts,
        session.player,
        session.attempt_player,
        episode.index,
        episode.attempt,
        session.seq,
        session.request,
        ended,
        fault,
        session.steps,
        session.think_s,
        first_episodes=session.first_episodes,
    )


_decode = msgspec.msgpack.Decoder(KeptSession).decode


class KeptSessions:
    """The files of all sessions below the folder of recordings.

    One thread carries out all that is asked for, in order. is_of_machine: other owners
    write elsewhere, so that only what the last owner has left is the truth.
    """

    def __init__(self, folder: Path, *, is_of_machine: bool = False) -> None:
        self._folder, self._is_of_machine = folder, is_of_machine
        self._thread = ThreadPoolExecutor(1, "sessions")
        self._removing: dict[str, asyncio.Future[None]] = {}

    def close(self) -> None:
        """Returns when everything that was begun is done."""
        self._thread.shutdown()

    async def keep(self, run: Run, session: KeptSession) -> None:
        """Raises OSError. The file is whole, or is not there."""
        await self._in_thread(_write, self._path(run, session.worker_id), session)

    def remove(self, run: Run, worker_id: str) -> None:
        """The session has ended; `settle` waits for it."""
        path = self._path(run, worker_id)
        removing = asyncio.ensure_future(self._in_thread(_remove, path, run.fence))
        self._removing[run.run_id] = removing
        removing.add_done_callback(lambda done: self._forget(run.run_id, done))

    def _forget(self, run_id: str, done: asyncio.Future[None]) -> None:
        if self._removing.get(run_id) is done:
            del self._removing[run_id]

    async def settle(self, run: Run) -> None:
        """No session that has ended is there any more."""
        if removing := self._removing.get(run.run_id):
            await asyncio.wait([removing])

    async def read(self, run: Run) -> list[KeptSession]:
        """The sessions that the last owner of the run had."""
        oldest = run.fence - 1 if self._is_of_machine else 0
        folder = self._folder / run.run_id / FOLDER
        return await self._in_thread(_read, folder, oldest)

    def _path(self, run: Run, worker_id: str) -> Path:
        worker = hashlib.sha256(worker_id.encode()).hexdigest()[:32]
        name = f"{worker}.fence{run.fence}.session"
        return self._folder / run.run_id / FOLDER / name

    async def _in_thread(self, work: Callable[..., Done], *given: object) -> Done:
        loop = asyncio.get_running_loop()
        return await loop.run_in_executor(self._thread, work, *given)


def _write(path: Path, session: KeptSession) -> None:
    path.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
    draft = path.with_suffix(".draft")
    draft.touch(mode=0o600)
    draft.write_bytes(msgspec.msgpack.encode(session))
    draft.replace(path)


def _remove(path: Path, fence: int) -> None:
    """The file of a worker, and those of earlier owners."""
    worker = path.name.partition(".")[0]
    for other in list(path.parent.glob(f"{worker}.*")):
        name = _NAME.fullmatch(other.name)
        if name and int(name["fence"]) <= fence:
            other.unlink(missing_ok=True)
    with contextlib.suppress(OSError):  # others play on
        path.parent.rmdir()


def _read(folder: Path, oldest_fence: int) -> list[KeptSession]:
    newest: dict[str, tuple[int, Path]] = {}
    for path in folder.glob("*.session"):
        if name := _NAME.fullmatch(path.name):
            of_worker = int(name["fence"]), path
            newest[name["worker"]] = max(
                newest.get(name["worker"], of_worker), of_worker
            )
    sessions: list[KeptSession] = []
    for fence, path in newest.values():
        if fence < oldest_fence:
            continue
        try:
            session = _decode(path.read_bytes())
        except (OSError, msgspec.MsgspecError) as error:
            log.warning("a session cannot go on: %s: %s", path, error)
            continue
        if session.version == _VERSION:
            sessions.append(session)
    return sessions
