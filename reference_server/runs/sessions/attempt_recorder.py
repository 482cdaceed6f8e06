"""The files of the attempts that sessions play: recordings, and what a restart needs.

A recording is complete on disk before its result counts; a kept session lets the next
process go on with an attempt. Where nothing is recorded, nothing is written. This
module knows no simulator and no rule.
"""

from __future__ import annotations

import logging
from dataclasses import dataclass

import msgspec

from reference_server.failover.kept_sessions import (
    EpisodeEnding,
    KeptSession,
    KeptSessions,
    ended_before,
    kept_session,
)
from reference_server.failover.session_recovery import FoundSession, can_go_on
from reference_server.records.recordings import Recordings
from reference_server.rules.refusal import Refused
from reference_server.rules.runs import effects
from reference_server.runs.sessions.session_resources import SessionResources
from reference_server.storage.runs.run_store import StoreFailed
from reference_server.telemetry.spans import span
from reference_sim.process.pool import ChunkReply, RecordingPlan

log = logging.getLogger("proctor.sessions")


@dataclass(frozen=True, slots=True)
class AttemptRecorder:
    """Records the attempts of all sessions. recordings: None records nothing."""

    recordings: Recordings | None

    async def begin(
        self, resources: SessionResources, found: FoundSession | None = None
    ) -> RecordingPlan | None:
        """Say where what begins now, or goes on, is recorded.

        From now on a restart finds the session with it, and its end is recorded, too.
        found: the attempt goes on. Raises Refused.
        """
        episode = resources.session.episode
        if self.recordings is None or episode is None:
            return None
        try:
            plan = await self.recordings.begin(
                resources.run,
                episode,
                is_continued=found is not None,
                pictures=resources.trial is not None and resources.trial.is_drawn,
            )
        except StoreFailed as error:
            raise Refused("unavailable", f"{error}.") from error
        await self.keep(resources, found)
        resources.ensure_live()
        resources.recorded = episode.index, episode.attempt
        return plan

    async def finish(
        self,
        resources: SessionResources,
        played: ChunkReply,
        now_wall: float,
        clipped: int,
    ) -> None:
        """Complete the recording on disk, before its result counts. Raises Refused."""
        session, episode = resources.session, resources.session.episode
        if self.recordings is None or episode is None:
            return
        result = effects.result_of(session, played, now_wall, clipped)
        if resources.trial is not None and resources.trial.judgement is not None:
            judgement = resources.trial.judgement
            self.recordings.add_judgement(resources.run, episode, judgement)
        resources.wait.begin("the recording, which is written")
        try:
            with span("finish recording"):
                recording = await self.recordings.finish(resources.run, episode, result)
        except StoreFailed as error:
            raise Refused("unavailable", f"{error}.") from error
        resources.ensure_live()
        episode.recording, resources.recorded = recording, None

    def add_policy_fault(self, resources: SessionResources, fault: str) -> None:
        session = resources.session
        if self.recordings is not None and session.episode is not None:
            self.recordings.add_fault(
                resources.run, session.episode, session.seq, "policy_fault", fault
            )

    def add_simulator_fault(self, resources: SessionResources, detail: str) -> None:
        session = resources.session
        if self.recordings is not None and session.episode is not None:
            seq = session.seq if session.busy == "playing" else 0
            self.recordings.add_fault(
                resources.run, session.episode, seq, "simulator_fault", detail
            )

    def end_void_attempt(self, resources: SessionResources, why: str) -> None:
        """End the recording of an attempt that does not count."""
        episode = resources.session.episode
        if self.recordings is None or resources.recorded is None or episode is None:
            return
        self.recordings.end_attempt(resources.run, episode.index, episode.attempt, why)

    async def keep(
        self, resources: SessionResources, found: FoundSession | None = None
    ) -> None:
        """Let a restart find the session, as it is when it gets an episode."""
        kept = self._kept_sessions
        if kept is None or not can_go_on(resources.run):
            return
        resources.kept = (
            kept_session(resources.session, resources.ended, resources.fault)
            if found is None
            else found.kept
        )
        await _write_kept(resources, kept, resources.kept)

    async def keep_ending(
        self, resources: SessionResources, played: ChunkReply, sent: int
    ) -> None:
        """Let a restart find how the episode has ended, if its result is stored.

        sent: how many actions the turn had.
        """
        kept, session = self._kept_sessions, resources.session
        if kept is None or resources.kept is None or session.episode is None:
            return
        ended = ended_before(played, sent, session.episode.index)
        ending = EpisodeEnding(session.seq, session.request, ended)
        session_then = msgspec.structs.replace(resources.kept, ending=ending)
        await _write_kept(resources, kept, session_then)

    @property
    def _kept_sessions(self) -> KeptSessions | None:
        return None if self.recordings is None else self.recordings.sessions


async def _write_kept(
    resources: SessionResources, kept: KeptSessions, session: KeptSession
) -> None:
    try:
        await kept.keep(resources.run, session)
    except OSError as error:  # only a restart would need it
        log.warning("run %s: a session is not kept: %s", resources.run_id, error)
        kept.remove(resources.run, resources.session.worker_id)
