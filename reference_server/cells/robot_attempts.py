"""Attempts on a robot: people prepare and judge them, and a stop may end them.

For a session whose benchmark a simulator plays, every function here does nothing or
plays as ever. `cells/` decides and waits; this module connects a session to its cell.
"""

from __future__ import annotations

import asyncio
import contextlib
import time
from collections.abc import AsyncIterator, Awaitable, Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any, Protocol

import msgspec

from reference_record.comparison.judge_agreement import second_sample
from reference_server.cells.cell_trial import CellTrial
from reference_server.cells.cells import Cells
from reference_server.cells.robot_cell import cell_of
from reference_server.rules.refusal import Refused
from reference_server.rules.runs import effects
from reference_server.rules.runs.run import Run, Session
from reference_server.telemetry.slow_waits import LongWait
from reference_sim.process.observation_encoding import EncodedObservation
from reference_sim.process.pool import ChunkReply, SimulatorHandle, Timing

# A request that waits for a person is answered after so long; the client repeats it.
HOLD_S = 2.0
# A client that sends no request for so long is away, whatever its lease: a person would
# prepare the robot in vain. It loses nothing, for the attempt is not counted.
AWAY_S = 15.0
_NOTHING_PLAYED = ChunkReply(
    executed=0,
    rewards=[],
    ended=True,
    terminated=True,
    truncated=False,
    success=False,
    score=0.0,
    steps=0,
    observation=None,
    observations=None,
    timing=Timing(0.0, 0.0, 0.0),
)
# The reasons of the library of robots, for the person who judges.
_END_TEXTS = {
    "watchdog": "the watchdog of the robot stopped it",
    "server": "it was stopped",
    "connection": "the connection to the robot was lost",
}


class PlayedSession(Protocol):
    """A session that plays, with its resources; `session_resources.py` has it."""

    run_id: str
    session: Session
    handle: SimulatorHandle | None
    task: asyncio.Future[Any] | None
    trial: CellTrial | None
    wait: LongWait
    heard_at: float

    @property
    def run(self) -> Run: ...


@dataclass(frozen=True, slots=True)
class RobotAttempts:
    """The attempts of all sessions that robots play."""

    cells: Cells

    def plays(self, run: Run) -> bool:
        """Whether a robot plays the run."""
        return "physical" in run.manifest

    async def take(self, resources: PlayedSession) -> None:
        """Wait until the session has the cell. Raises TrialLeft."""
        queue = self.cells.find(resources.run)
        if queue is None:
            return
        episode = resources.session.episode
        assert episode is not None
        trial, run = resources.trial, resources.run
        if trial is None or trial.episode_id != episode.episode_id:
            names = [each.episode_id for each in run.episodes]
            drawn = second_sample(run.manifest["physical"], run.run_id, names)
            trial = CellTrial(
                run.run_id,
                episode.episode_id,
                episode.attempt,
                episode.task,
                episode.episode_id in drawn,
                *_ties(resources),
                queue,
            )
            resources.trial = trial
        resources.wait.begin("the robot, and a person who prepares it")
        await queue.take(trial)

    def take_over(self, before: PlayedSession, resources: PlayedSession) -> None:
        """A trial goes on with the next session of its worker (ATT-004)."""
        trial = before.trial
        if trial is None:
            return
        if resources.handle is None:
            trial.leave("its worker was attached again")
            return
        before.trial, resources.trial = None, trial
        trial.hold, trial.is_heard = _ties(resources)
        if before.session.held:
            trial.hold(True)

    def is_judged(self, resources: PlayedSession) -> bool:
        """Whether a person has judged the attempt, and no turn has shown it."""
        trial = resources.trial
        return (
            trial is not None
            and trial.judgement is not None
            and resources.session.busy is None
            and resources.handle is not None
        )

    async def wait_until_ready(self, resources: PlayedSession) -> None:
        """Wait until a person has prepared the robot. Raises TrialLeft, TrialVoid."""
        trial = resources.trial
        if trial is not None:
            assert resources.handle is not None
            await cell_of(trial).wait_until_ready(trial, resources.handle)

    def begun(self, resources: PlayedSession, observation: EncodedObservation) -> None:
        """The robot is reset, and the policy may play. Raises TrialVoid."""
        trial = resources.trial
        if trial is not None:
            cell_of(trial).begun(trial)
            cell_of(trial).live.keep(observation)
            cell_of(trial).turn_ended(trial)

    @contextlib.asynccontextmanager
    async def kept_alive(self, resources: PlayedSession) -> AsyncIterator[None]:
        trial = resources.trial
        if trial is None or resources.handle is None:
            yield
            return
        async with cell_of(trial).kept_alive(resources.handle):
            yield

    def play(
        self,
        resources: PlayedSession,
        actions: Sequence[Mapping[str, Sequence[float]]],
        *,
        observe_all: bool,
        seq: int,
        think_ms: float,
        requested: Sequence[Mapping[str, Sequence[float]]] | None,
    ) -> Awaitable[ChunkReply]:
        """The chunk; if it ends an attempt on a robot, with a person's judgement.

        Raises what the handle raises, TrialLeft and TrialVoid.
        """
        handle, trial = resources.handle, resources.trial
        assert handle is not None
        work = partial(
            handle.play,
            actions,
            observe_all=observe_all,
            seq=seq,
            think_ms=think_ms,
            requested=requested,
        )
        return work() if trial is None else self._play_trial(resources, trial, work)

    async def _play_trial(
        self,
        resources: PlayedSession,
        trial: CellTrial,
        work: Callable[[], Awaitable[ChunkReply]],
    ) -> ChunkReply:
        handle, seq = resources.handle, resources.session.seq
        assert handle is not None
        cell, played = cell_of(trial), _NOTHING_PLAYED
        if cell.may_play(trial):
            async with cell.kept_alive(handle):
                played = await work()
                cell.live.keep(played.observation)
        if not played.ended:
            cell.turn_ended(trial)
            return played
        cell.ended(trial, _END_TEXTS.get(played.stopped, "it came to its end"))
        await handle.record_end()
        resources.wait.begin("a person, who judges the attempt")
        judgement = await cell.judgement(trial)
        judged = await handle.judge(judgement.success, judgement.score, seq)
        return msgspec.structs.replace(
            played,
            success=judgement.success,
            score=judgement.score,
            steps=judged.steps,
            terminated=judged.terminated,
            truncated=judged.truncated,
        )

    async def await_turn(self, resources: PlayedSession) -> None:
        """Wait for the work of the session, but not for ever for a person.

        Raises Refused with the reason, which the author of a policy is shown: a
        request that is repeated waits for the same work (PHY-015).
        """
        task = resources.task
        assert task is not None
        resources.heard_at = time.monotonic()
        hold_s = HOLD_S if self.plays(resources.run) else None
        while not task.done():
            await asyncio.wait([task], timeout=hold_s)
            trial = resources.trial
            if task.done() or trial is None or resources.run.is_push:
                continue
            if text := trial.wait_text():
                raise Refused("no_capacity", text, requirement="PHY-015")


def _ties(
    resources: PlayedSession,
) -> tuple[Callable[[bool], None], Callable[[], bool]]:
    """The members `hold` and `is_heard` of a trial of the session."""
    session = resources.session
    return (
        lambda held: effects.hold_lease(session, held, time.monotonic()),
        lambda: _is_heard(resources),
    )


def _is_heard(resources: PlayedSession) -> bool:
    """Whether the client still waits for the attempt that a person prepares."""
    silent_s = time.monotonic() - resources.heard_at
    return resources.run.is_push or silent_s < AWAY_S
