"""One robot cell: its trial, its operator, and the robot that is to be stopped.

`cell_rules.py` decides; here is what waits and what is sent. A stop is sent before
anything is decided, written or answered.
"""

from __future__ import annotations

import asyncio
import contextlib
import logging
import time
from collections import Counter
from collections.abc import AsyncIterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

from reference_record.texts.timestamps import timestamp
from reference_server.cells import cell_rules
from reference_server.cells.act_log import ActLine, ActLog
from reference_server.cells.cell_queue import CellQueue
from reference_server.cells.cell_rules import (
    CellEvent,
    CellState,
    Judgement,
    OperatorAct,
)
from reference_server.cells.cell_trial import CellTrial, RobotLink, TrialVoid
from reference_server.cells.newest_pictures import LiveView
from reference_server.rules.refusal import Refused
from reference_sim.benchmark_registry import SimulatorConfig

log = logging.getLogger("proctor.cells")

ALIVE_SHARE = 4  # so many messages `alive` in the time of the watchdog


class RobotCell:
    """physical: of the manifest; see reference_sim/external/physical_cell.py.

    queue: of all cells of the benchmark. cameras: their names. command: by which its
    robot is reached; empty for that of the benchmark.
    """

    def __init__(
        self,
        cell_id: str,
        physical: Mapping[str, Any],
        acts: ActLog,
        queue: CellQueue,
        *,
        cameras: Sequence[str] = (),
        command: Sequence[str] = (),
    ) -> None:
        self.cell_id, self.physical, self._acts = cell_id, physical, acts
        self.cameras, self.live = cameras, LiveView()
        self.queue, self._command = queue, command
        self.state = CellState()
        self.trial: CellTrial | None = None
        self.phase_since = time.monotonic()
        self._silence: asyncio.TimerHandle | None = None
        self._restore([line for line in acts.lines if line.get("cell") == cell_id])

    def _restore(self, acts: Sequence[ActLine]) -> None:
        """Go on counting where the server ended: trials and voids."""
        self.state.number = max((line.get("trial", 0) for line in acts), default=0)
        voids = Counter(line["reason"] for line in acts if line.get("act") == "void")
        self.state.voids.update(voids)

    # --- what the operator does ---

    def act(self, act: OperatorAct) -> None:
        """Carry out an act. Raises Refused; a stop is sent in any case (PHY-004)."""
        if act.act == "stop":
            self.send_stop()
        refusal = cell_rules.refuse_act(self.state, act, self.physical["rubric"])
        if refusal is not None:
            raise Refused.from_verdict(refusal)
        self._log(act)
        trial, phase = self.trial, self.state.phase
        cell_rules.apply_act(self.state, act, self.physical["rubric"])
        if trial is not None:
            if act.act == "void":
                trial.voided = act.reason
                self.trial = None
            if act.act == "stop":
                trial.was_stopped = phase == "resetting"
                if phase == "playing":
                    trial.hold(True)
            if self.state.judgement is not None:
                trial.judgement = self._named(self.state.judgement)
            if act.act in ("void", "judge"):
                trial.hold(False)
        if self.state.phase == "free":
            self.trial = None
        self._note_change()

    def send_stop(self) -> None:
        """Send the stop to the robot, whatever the cell does."""
        if self.trial is not None and self.trial.link is not None:
            self.trial.link.signal("stop")

    def _log(self, act: OperatorAct) -> None:
        line: ActLine = {"act": act.act, "operator": act.operator}
        if self.trial is None:
            line["cell"] = self.cell_id
        else:
            line |= {**self._logged(self.trial), "phase": self.state.phase}
        if act.act == "judge":
            line |= {"success": bool(act.success), "met": list(act.met)}
            line |= {"note": act.note, "blind": self.physical["blind"]}
            line["drawn"] = self.trial is not None and self.trial.is_drawn
        if act.act == "void":
            line["reason"] = act.reason
        self._acts.add(**line)

    def _logged(self, trial: CellTrial) -> ActLine:
        """The members of a line of the log that name the trial at the cell."""
        return {
            "benchmark": self.benchmark_id,
            "cell": self.cell_id,
            "trial": self.state.number,
            "run": trial.run_id,
            "episode": trial.episode_id,
            "attempt": trial.attempt,
        }

    # --- what sessions do ---

    @property
    def benchmark_id(self) -> str:
        return self.queue.benchmark_id

    def may_take(self) -> bool:
        """Whether it is free for another trial."""
        return self.state.phase == "free" and not self.state.is_paused

    def take(self, trial: CellTrial) -> None:
        """Begin with a trial of the queue."""
        trial.at_cell, self.trial = self, trial
        notice = self.state.notice
        cell_rules.apply(self.state, "take")
        self.live.clear()
        self.state.notice, self.phase_since = notice, time.monotonic()

    def simulator_config(self, config: SimulatorConfig) -> SimulatorConfig:
        """That of the benchmark, with the robot of this cell."""
        if not self._command:
            return config
        plan = {**config.settings["plan"], "command": list(self._command)}
        return replace(config, settings={**config.settings, "plan": plan})

    async def wait_until_ready(self, trial: CellTrial, link: RobotLink) -> None:
        """Wait until a person has prepared the trial (PHY-008).

        Raises TrialLeft and TrialVoid.
        """
        trial.link = link
        link.signal("stop")  # a person is about to reach into the cell
        await self.queue.wait(
            lambda: self.trial is trial and self.state.phase == "resetting", trial
        )
        await self._acts.flush()

    def begun(self, trial: CellTrial) -> None:
        """The reset is done, and the robot may play. Raises TrialVoid."""
        if self.trial is not trial or not self._happen("begun"):
            raise TrialVoid("it was stopped during its reset")

    def may_play(self, trial: CellTrial) -> bool:
        return self.trial is trial and self.state.phase == "playing"

    @contextlib.asynccontextmanager
    async def kept_alive(self, link: RobotLink) -> AsyncIterator[None]:
        """While it is entered, the cell sees that this server waits for its reply."""
        self._cancel_silence()
        task = asyncio.create_task(self._say_alive(link))
        try:
            yield
        finally:
            task.cancel()

    async def _say_alive(self, link: RobotLink) -> None:
        while True:
            link.signal("alive")
            await asyncio.sleep(self.physical["watchdog_s"] / ALIVE_SHARE)

    def turn_ended(self, trial: CellTrial) -> None:
        """The policy has the turn: without another one the robot stops (PHY-006)."""
        loop = asyncio.get_running_loop()
        self._cancel_silence()
        self._silence = loop.call_later(
            self.physical["watchdog_s"], self._stop_silent, trial
        )

    def _stop_silent(self, trial: CellTrial) -> None:
        if self.may_play(trial):
            trial.hold(True)
            self.ended(trial, "the policy sent no turn in time")

    def _cancel_silence(self) -> None:
        if self._silence is not None:
            self._silence.cancel()
            self._silence = None

    def ended(self, trial: CellTrial, why: str) -> None:
        """The attempt has ended: stop the robot, and let a person judge."""
        self.send_stop()
        if self.trial is trial:
            self._happen("ended", why)

    async def judgement(self, trial: CellTrial) -> Judgement:
        """The judgement of a person. Raises TrialLeft, TrialVoid.

        The cell may have another trial by then: a turn may come late.
        """
        await self.queue.wait(lambda: trial.judgement is not None, trial)
        assert trial.judgement is not None
        await self._acts.flush()
        return trial.judgement

    def _named(self, judgement: Judgement) -> Judgement:
        """As it is recorded: with a name that is not the account's (PHY-031)."""
        name = self._acts.pseudonym(judgement.judge)
        blind = self.physical["blind"]
        return replace(judgement, judge=name, blind=blind, cell=self.cell_id)

    def fault(self, trial: CellTrial, why: str) -> None:
        """The robot broke: stop it; the attempt begins from a new reset.

        Called by the trial.
        """
        self._give_up(trial, "fault", why)

    def leave(self, trial: CellTrial, why: str) -> None:
        """The session of the trial has ended: stop the robot first.

        Called by the trial.
        """
        self._give_up(trial, "leave", why)

    def _give_up(self, trial: CellTrial, event: CellEvent, why: str) -> None:
        if self.trial is trial:
            self.send_stop()
            if self.state.phase == "done":  # its operator still reads the result
                trial.link = None
            else:
                line: ActLine = {"act": event, "reason": why, **self._logged(trial)}
                self._acts.add(**line)
                self._happen(event, why)
                self.trial = None
        self._note_change()

    def wait_text(self) -> str:
        """The reason why the trial at the cell waits; empty if it does not."""
        # A time that stands, so that a client shows the text once.
        begun_wall = time.time() - (time.monotonic() - self.phase_since)
        since = f"since {timestamp(begun_wall)[11:19]} UTC"
        if self.state.phase == "preparing":
            if self.state.operator is None:
                return f"No person operates the robot; the attempt waits {since}."
            return f"A person prepares the robot, {since}."
        if self.state.phase == "judging":
            return f"A person judges the attempt, {since}."
        return ""

    # --- changes ---

    @property
    def waiting(self) -> int:
        return self.queue.waiting

    def _happen(self, event: CellEvent, why: str = "") -> bool:
        has_changed = cell_rules.apply(self.state, event, why)
        self._note_change()
        return has_changed

    def _note_change(self) -> None:
        self.phase_since = time.monotonic()
        self.queue.offer()


def cell_of(trial: CellTrial) -> RobotCell:
    """The cell of a trial that was taken."""
    cell = trial.at_cell
    assert isinstance(cell, RobotCell), "a trial that waits is at no cell"
    return cell
