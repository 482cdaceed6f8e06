"""Episodes begin: a simulator is lent, or a robot taken, until step 0 can be shown.

Where the simulator breaks, the fault is recorded (FAULT-001) and the episode begins
again, until its faults fail the run. A trial of a robot that does not count begins
again from a new reset (PHY-016).
"""

from __future__ import annotations

import asyncio
import logging
import re
import time

from reference_server.cells.cell_trial import TrialLeft, TrialVoid
from reference_server.cells.robot_attempts import RobotAttempts
from reference_server.records.recordings import RecordingFailed
from reference_server.rules.refusal import Refused
from reference_server.rules.runs import effects
from reference_server.runs.admission.disk_bound import DiskBound
from reference_server.runs.run_writer import RunWriter
from reference_server.runs.sessions.attempt_recorder import AttemptRecorder
from reference_server.runs.sessions.session_resources import (
    ResourceManager,
    SessionResources,
)
from reference_server.runs.sessions.session_spans import add_times, name_session
from reference_server.telemetry.counters import COUNTERS
from reference_server.telemetry.spans import span
from reference_sim.process.pool import (
    Begin,
    EpisodeStart,
    LastingFault,
    RecordingPlan,
    SimulatorFault,
    TaskUnplayable,
)

log = logging.getLogger("proctor.sessions")

# How long a session waits after each beginning in a row that failed, the last one from
# then on: what broke may be away for seconds, in which all would fail without pauses.
BEGIN_PAUSES_S = (0.5, 1.5, 4.0, 10.0)
LOOK_S = 0.25
# Errors that end an attempt through no fault of the policy; the episode begins again.
FAULTS = (SimulatorFault, TaskUnplayable, RecordingFailed)


class EpisodeBeginnings:
    """Begins the episodes of all sessions. disk_bound: at it no episode begins."""

    def __init__(
        self,
        writer: RunWriter,
        resources: ResourceManager,
        robots: RobotAttempts,
        recorder: AttemptRecorder,
        disk_bound: DiskBound,
    ) -> None:
        self._writer, self._resources, self._robots = writer, resources, robots
        self._recorder, self._disk_bound = recorder, disk_bound
        self._latest_fault = "", ""  # the run, and the text in the log

    async def begin(self, resources: SessionResources) -> tuple[EpisodeStart, float]:
        """Begin the session's episode, again after each fault, until it fails the run.

        Returns the beginning and the seconds spent waiting for a simulator.
        """
        queue_s, failed = 0.0, 0
        while True:
            if failed:
                queue_s += await self._pause(resources, failed)
            episode = resources.session.episode
            assert episode is not None
            self._disk_bound.check()
            try:
                await self._robots.take(resources)
                queue_s += await self._resources.acquire_simulator(resources)
                resources.ensure_live()
                await self._robots.wait_until_ready(resources)
                assert resources.handle is not None
                plan = await self._recorder.begin(resources)
                with span("simulator begins") as starting:
                    alive = self._robots.kept_alive(resources)
                    resources.wait.begin(
                        f"the simulator, which begins {episode.episode_id}"
                    )
                    name_session(starting, resources)
                    async with alive:
                        begin = begin_command(resources, plan)
                        beginning = await resources.handle.begin(begin)
                    add_times(starting, beginning.timing)
                self._robots.begun(resources, beginning.observation)
            except (TrialVoid, TrialLeft) as over:
                await self.void(resources, over)
                continue
            except FAULTS as error:
                if resources.trial is not None and resources.trial.was_stopped:
                    await self.void(resources, TrialVoid(str(error)))
                    continue
                await self.record_fault(resources, error)
                failed = 0 if isinstance(error, LastingFault) else failed + 1
                continue
            resources.ensure_live()
            resources.session.instruction = beginning.instruction
            return beginning, queue_s

    async def _pause(self, resources: SessionResources, failed: int) -> float:
        """Give a simulator that cannot begin time to come back; returns the seconds.

        failed: beginnings in a row. Refused as soon as the session has ended.
        """
        pause_s = BEGIN_PAUSES_S[min(failed, len(BEGIN_PAUSES_S)) - 1]
        resources.wait.begin(f"another beginning, after {failed} that failed")
        until = time.monotonic() + pause_s
        while (left_s := until - time.monotonic()) > 0:
            await asyncio.sleep(min(left_s, LOOK_S))
            resources.ensure_live()
        return pause_s

    async def void(
        self, resources: SessionResources, over: TrialVoid | TrialLeft
    ) -> None:
        """PHY-016: a trial does not count; its attempt begins from a new reset."""
        resources.ensure_live()
        session, episode = resources.session, resources.session.episode
        assert episode is not None
        if isinstance(over, TrialLeft):  # and the session has not
            raise Refused("unavailable", "No request came for the attempt.")
        self._resources.return_simulator(resources, kill=True)
        self._recorder.end_void_attempt(resources, f"void: {over}")
        effects.void_attempt(resources.run, session)
        await self._writer.commit(resources.run)
        resources.ensure_live()
        resources.fault = {
            "episode_id": episode.episode_id,
            "faults": episode.faults,
            "detail": f"The trial does not count, and is played again: {over}.",
            "is_void": True,
        }

    async def record_fault(self, resources: SessionResources, error: Exception) -> None:
        """Record a fault (FAULT-001); returns when the episode may begin again."""
        resources.ensure_live()
        if resources.trial is not None:  # a robot is stopped before all else
            resources.trial.fault(str(error))
        self._resources.return_simulator(resources, kill=True)
        run, session, episode = (
            resources.run,
            resources.session,
            resources.session.episode,
        )
        assert episode is not None
        COUNTERS.simulator_faults += 1
        detail = episode.without_sealed_seed(str(error))
        # One line for what every simulator of the run meets, such as an edited file.
        fault = run.run_id, re.sub(r"\d+", "0", detail)  # at another step, too
        is_new = fault != self._latest_fault
        self._latest_fault = fault
        level = logging.WARNING if is_new else logging.INFO
        log.log(level, "run %s, %s: %s", run.run_id, episode.episode_id, detail)
        self._recorder.add_simulator_fault(resources, detail)
        session.busy = "turning"
        ended = effects.record_fault(
            run,
            session,
            detail,
            unplayable=isinstance(error, TaskUnplayable),
            now_wall=time.time(),
        )
        self._resources.release_sessions(ended)
        await self._writer.commit(run)
        resources.ensure_live()
        resources.fault = {
            "episode_id": episode.episode_id,
            "faults": episode.faults,
            "detail": detail,
        }


def begin_command(resources: SessionResources, plan: RecordingPlan | None) -> Begin:
    """Return the message that begins the session's episode in a simulator."""
    manifest, episode = resources.run.manifest, resources.session.episode
    assert episode is not None
    return Begin(
        episode.task,
        episode.seed,
        manifest["max_steps"],
        manifest["success_rule"],
        split=episode.split,
        recording=plan,
        is_sealed=episode.is_sealed,
    )
