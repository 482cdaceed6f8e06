"""The signed records of completed runs, and the keys that sign them.

A record is signed when it is first fetched. Only its statement is stored: all other
files follow from the run and its recordings. Each statement names the one that was
signed before it. This module decides no rule of runs, and knows no HTTP.
"""

from __future__ import annotations

import asyncio
import contextlib
import logging
import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import Any, Final, Literal

import msgspec

from reference_record.broken import UnusableRecord
from reference_record.contents.benchmark_manifest import (
    is_deterministic,
    manifest_file,
    texts_of,
)
from reference_record.contents.replay_verdict import ReplaySummary, write_verdict
from reference_record.contents.statement import (
    BenchmarkFacts,
    EpisodeLine,
    Evaluation,
    PolicyFacts,
    RecordingFacts,
    RunFacts,
    SecondJudgement,
    Statement,
    digests_by_name,
)
from reference_record.formats.envelope import read_envelope
from reference_record.formats.names import (
    ARCHIVE_BYTES_MAX,
    EPISODES_MAX,
    STATEMENT,
    recording_name,
)
from reference_record.generated.protocol_version import PROTOCOL_VERSION
from reference_record.keys import SigningKey, load_or_make
from reference_record.texts.counted_text import counted
from reference_record.texts.timestamps import timestamp
from reference_record.unsigned_record import Record, UnsignedRecord, host_of, read_files
from reference_server.files.object_storage import StorageFailed
from reference_server.files.private_files import restrict
from reference_server.process.age_guard import AgeGuard
from reference_server.process.hourly_work import HOUR_S, HourlyWork
from reference_server.records.recordings import Recordings
from reference_server.rules.runs.lifecycle import ENDED_STATES
from reference_server.rules.runs.run import Episode, PublicKey, RunHead
from reference_server.storage.record_store import NotTheNext, RecordStore
from reference_server.storage.runs.run_store import Store, StoreFailed
from reference_sim.engine import engine_fingerprint

log = logging.getLogger("proctor.records")

# The clocks of files and nodes may differ.
LEFTOVERS_S = 3 * HOUR_S
RUNS_PER_READ = 200
# The most bytes in an archive of the manifest and the statement; and of each
# recording's line, names and headers.
OTHER_FILES_BYTES = 2**26
BYTES_BESIDE_A_RECORDING = 2**11


@dataclass(frozen=True, slots=True)
class HostSettings:
    """promise: of replays, on the same engine.

    keep_days: after these a run that has ended loses its recordings; 0: never.
    known_keys: keyid → whose key it is, of other hosts.
    """

    name: str
    key_path: Path
    promise: Literal["exact", "outcome"] = "outcome"
    keep_days: float = 0.0
    known_keys: Mapping[str, str] = field(default_factory=dict)


_LOST_SHOWN: Final = 8


class RecordUnavailable(Exception):
    """The run has no record: it was not recorded, or its recordings were removed."""


def open_key(path: Path) -> SigningKey:
    """The key in a file, made when there is none. Raises UnusableRecord, OSError."""
    restrict(path)  # a volume that is mounted may give it to a group
    return load_or_make(path)


class RunRecords:
    """Records of this server's runs."""

    def __init__(
        self, store: Store, recordings: Recordings, settings: HostSettings
    ) -> None:
        self._store, self._recordings, self._settings = store, recordings, settings
        self._signed = RecordStore(store.transactions)
        # One statement after another: each names the one before.
        self._signing = asyncio.Lock()
        self._guard = AgeGuard(settings.keep_days, "the recordings", log)
        self._has_leftovers, self._leftovers_since_wall = True, 0.0
        self._removing = HourlyWork(self._remove, "recordings could not be removed")

    async def open(self) -> None:
        """Read or make the key. Raises UnusableRecord, OSError and StoreFailed.

        In a cluster `use_key` is called later: a node that is refused retires no key.
        """
        self._recordings.open()
        await self._recordings.check_storage()
        self._key = open_key(self._settings.key_path)
        if not self._recordings.is_shared:
            await self.use_key()
        self._removing.open()

    async def use_key(self) -> None:
        """Store that its key signs from now on, and no other. Raises StoreFailed."""
        await self._signed.use_key(self._key.keyid, self._key.public_key, time.time())

    @property
    def key(self) -> SigningKey:
        """The key that signs, once it is open."""
        return self._key

    @property
    def host_name(self) -> str:
        """The name of this host in statements."""
        return self._settings.name

    async def close(self) -> None:
        """Returns when all that was recorded is written: then others may go on."""
        await self._removing.close()
        await self._recordings.close()

    async def _remove(self) -> None:
        try:
            if self._has_leftovers:
                await self.remove_leftovers(self._leftovers_since_wall)
                # Nodes that come and go leave new ones at any time.
                self._has_leftovers = self._recordings.is_shared
                self._leftovers_since_wall = time.time() - LEFTOVERS_S
            await self.remove_deleted()
            if self._settings.keep_days:
                await self._guard.delete(self._store.newest_change, self._remove_old)
        except (StoreFailed, OSError) as error:
            log.warning("recordings are not removed: %s", error)

    async def remove_leftovers(self, since_wall: float = 0.0) -> None:
        """Remove the drafts and parts that are left where a server was killed.

        Parts stay until the run is completed: its results may have to be joined again.
        since_wall: only of runs that wrote something since then.
        """
        await asyncio.to_thread(self._recordings.remove_drafts)
        find = self._recordings.runs_with_leftovers
        run_ids = await asyncio.to_thread(find, since_wall)
        for start in range(0, len(run_ids), RUNS_PER_READ):
            heads = await self._store.heads(run_ids[start : start + RUNS_PER_READ])
            for run_id, head in heads.items():
                if head.state == "completed":
                    await self._remove_unused(run_id)

    async def _remove_unused(self, run_id: str) -> None:
        """Remove files of a completed run that none of its results names."""
        window = await self._store.read_window(run_id, 0, None)
        episodes = () if window is None else window[1]
        fences = {e.index: e.recording.fence for e in episodes if e.recording}
        await asyncio.to_thread(self._recordings.remove_unused, run_id, fences)

    async def remove_deleted(self) -> None:
        """Remove what is left of deleted runs: a server may end before it is removed.

        Also what was being written when the run was deleted.
        """
        run_ids = await asyncio.to_thread(self._recordings.run_ids)
        for start in range(0, len(run_ids), RUNS_PER_READ):
            some = run_ids[start : start + RUNS_PER_READ]
            for run_id in sorted(await self._store.deleted_ids(some)):
                await self._recordings.remove_run(run_id)

    async def remove_old(self, now_wall: float, *, is_dry: bool = False) -> list[str]:
        """Remove the recordings of runs that ended too long ago; gives their ids.

        is_dry: removes nothing.
        """
        removed: list[str] = []
        before = now_wall - self._settings.keep_days * 86_400
        run_ids = await asyncio.to_thread(self._recordings.run_ids)
        for start in range(0, len(run_ids), RUNS_PER_READ):
            heads = await self._store.heads(run_ids[start : start + RUNS_PER_READ])
            old = [i for i, head in heads.items() if _ended_since(head, before)]
            for run_id in old:
                # It may have been resumed while others were removed.
                for head in (await self._store.heads([run_id])).values():
                    if _ended_since(head, before):
                        if not is_dry:
                            await self._recordings.remove_run(run_id)
                        removed.append(run_id)
        return removed

    async def _remove_old(self) -> int:
        return len(await self.remove_old(time.time()))

    async def remove_run(self, run_id: str) -> None:
        """The run was deleted: remove its recordings, here or within the hour."""
        with contextlib.suppress(StorageFailed):
            await self._recordings.remove_run(run_id)

    async def keys(self) -> list[PublicKey]:
        """REC-101: every key that signed, the newest first."""
        return await self._signed.keys()

    async def key_names(self, own: str) -> dict[str, str]:
        """keyid → whose key it is: REC-117, those of others and every one of ours."""
        ours = {key.keyid: own for key in await self.keys()}
        return {**self._settings.known_keys, **ours}

    async def sign_verdict(self, replay: ReplaySummary, statement_sha256: str) -> bytes:
        """REC-118: this server's verdict on a record that it has replayed."""
        return write_verdict(
            replay,
            statement_sha256=statement_sha256,
            name=self.host_name,
            at=timestamp(time.time()),
            key=self._key,
        )

    async def fetch(
        self,
        run: RunHead,
        episodes: Sequence[Episode],
        score: Mapping[str, Any],
        second: Sequence[SecondJudgement] = (),
    ) -> Record:
        """REC-102: the record of a completed run, signed if it was not (REC-109).

        second: the second judgements of its episodes. Raises RecordUnavailable.
        """
        # In a thread: it takes 0.4 s for the longest benchmark.
        manifest = await asyncio.to_thread(
            manifest_file, run.manifest, run.manifest_sha256
        )
        lines = [_line(episode) for episode in episodes]
        try:
            await self._recordings.make_here(run.run_id, map(_file_of, episodes))
        except OSError as error:
            raise StoreFailed(str(error)) from error
        _refuse_too_large(lines)
        recordings = {
            recording_name(episode.index): self.recording_path(run.run_id, episode)
            for episode in episodes
        }
        read = partial(
            read_files, manifest=manifest, lines=lines, recordings=recordings
        )
        try:
            files = await asyncio.to_thread(read)
            statement = await self._signed.find_statement(run.run_id)
            if statement is None:
                return await self._sign(run, episodes, score, files, second)
        except (OSError, UnusableRecord) as error:
            raise RecordUnavailable(_what_is_lost(recordings, error)) from error
        return await asyncio.to_thread(_reopened, run.run_id, files, statement)

    async def _sign(
        self,
        run: RunHead,
        episodes: Sequence[Episode],
        score: Mapping[str, Any],
        files: UnsignedRecord,
        second: Sequence[SecondJudgement],
    ) -> Record:
        """Sign the record, unless another fetch of it has signed it meanwhile.

        In a cluster a node signs again what came behind the statement of another one.
        """
        async with self._signing:
            while True:
                statement = await self._signed.find_statement(run.run_id)
                if statement is not None:
                    reopen = partial(_reopened, run.run_id, files, statement)
                    return await asyncio.to_thread(reopen)
                evaluation = await self._evaluation(run, episodes, score)
                evaluation.second_judgements = msgspec.convert(
                    second, list[SecondJudgement]
                )
                record = await asyncio.to_thread(files.sign, evaluation, self._key)
                statement = b"".join(record.contents[STATEMENT].blocks())
                try:
                    await self._signed.add_statement(
                        run.run_id,
                        statement,
                        record.statement_sha256,
                        evaluation.previous_statement_sha256,
                    )
                except NotTheNext:
                    continue
                return record

    def recording_path(self, run_id: str, episode: Episode) -> Path:
        """REC-107: the file that a record has, too."""
        return self._recordings.path(run_id, *_file_of(episode))

    async def recording_size(self, run_id: str, episode: Episode) -> int | None:
        """Bytes of the recording of an episode; None if it has none (any more)."""
        if episode.recording is None:
            return None
        path = self.recording_path(run_id, episode)
        try:
            await self._recordings.make_here(run_id, [_file_of(episode)])
        except OSError as error:
            raise StoreFailed(str(error)) from error
        is_there = await asyncio.to_thread(path.is_file)
        return episode.recording.bytes if is_there else None

    async def _evaluation(
        self, run: RunHead, episodes: Sequence[Episode], score: Mapping[str, Any]
    ) -> Evaluation:
        last = max(e.result.finished_at_wall for e in episodes if e.result)
        submission: Mapping[str, Any] = run.submission
        policy = submission["policy"]
        return Evaluation(
            run=RunFacts(
                run.run_id,
                "push" if run.is_push else "pull",
                submission.get("options"),
                dict(run.images),
            ),
            benchmark=BenchmarkFacts(
                run.manifest["benchmark_id"],
                run.manifest["version"],
                dict(texts_of(run.manifest)),
            ),
            manifest_sha256=run.manifest_sha256,
            policy=PolicyFacts(policy["name"], policy.get("version")),
            score=dict(score),
            engine=engine_fingerprint(),
            protocol_version=PROTOCOL_VERSION,
            host=host_of(self._settings.name, self._key),
            started_at=timestamp(run.created_at_wall),
            finished_at=timestamp(last),
            attempts_by_submitter=await self._signed.count_attempts(run),
            previous_statement_sha256=await self._signed.last_statement_sha256(),
            promise=(
                self._settings.promise if is_deterministic(run.manifest) else "none"
            ),
        )


def _file_of(episode: Episode) -> tuple[int, int]:
    """Its index, and the fence of its owner, which name the file of its recording."""
    return episode.index, 0 if episode.recording is None else episode.recording.fence


def _ended_since(run: RunHead, before: float) -> bool:
    return run.state in ENDED_STATES and run.updated_at_wall < before


def _line(episode: Episode) -> EpisodeLine:
    """REC-009, REC-106. Raises RecordUnavailable."""
    result, recording = episode.result, episode.recording
    if result is None or recording is None or recording.first_digest is None:
        raise RecordUnavailable(f"{episode.episode_id} was not recorded.")
    facts = RecordingFacts(
        recording_name(episode.index),
        recording.sha256,
        recording.bytes,
        recording.first_digest,
        recording.last_digest or recording.first_digest,
    )
    return EpisodeLine(
        episode_id=episode.episode_id,
        index=episode.index,
        task=episode.task,
        split=episode.split,
        outcome=result.outcome,
        success=result.outcome == "success",
        score=result.score,
        steps=result.steps,
        attempts=result.attempt,
        latency=dict(recording.latency),
        recording=facts,
        player=result.player,
    )


def _what_is_lost(
    recordings: Mapping[str, Path], error: OSError | UnusableRecord
) -> str:
    """Which recordings are gone. recordings: name in the record → file."""
    lost = [path.name for path in recordings.values() if not path.exists()]
    if not lost:
        return f"Its recordings cannot be read: {getattr(error, 'strerror', error)}."
    shown = ", ".join(lost[:_LOST_SHOWN]) + (", …" if len(lost) > _LOST_SHOWN else "")
    return (
        f"The server does not have {len(lost)} of its "
        f"{counted(len(recordings), 'recording')} any more: {shown}. The others can "
        "be fetched one by one; its operator may have a backup."
    )


def _refuse_too_large(lines: Sequence[EpisodeLine]) -> None:
    """Before anything is read or signed. Raises RecordUnavailable."""
    size = sum(line.recording.bytes for line in lines if line.recording)
    beside = OTHER_FILES_BYTES + BYTES_BESIDE_A_RECORDING * len(lines)
    if size + beside > ARCHIVE_BYTES_MAX or len(lines) > EPISODES_MAX:
        raise RecordUnavailable(
            f"It has {len(lines)} recordings of {size} bytes: more than a record can "
            "have. Each of them can be fetched."
        )


def _reopened(run_id: str, files: UnsignedRecord, statement: bytes) -> Record:
    """The record that was signed before."""
    payload = read_envelope(STATEMENT, statement).payload
    signed = digests_by_name(msgspec.json.decode(payload, type=Statement[Any]))
    changed = [
        name for name in files.digests if files.digests[name] != signed.get(name)
    ]
    if changed:
        log.warning("run %s: %s is not as it was signed", run_id, changed[0])
    return files.with_statement(statement)
