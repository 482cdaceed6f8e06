"""A submitter, its workers and those who look on, as a careful client behaves.

A request without an answer is sent again with the same keys and numbers until there is
one; a worker whose session has ended attaches again. They stop when their run has
completed.
"""

from __future__ import annotations

from collections.abc import Awaitable, Callable, Iterator
from dataclasses import dataclass
from typing import Any

from reference_server.rules.manifest import Submission
from reference_server.rules.refusal import Refused
from reference_server.rules.runs.lifecycle import Attach, Detach, Heartbeat, Predict
from reference_server.runs.service import RunService
from tests.simulation.history import History
from tests.simulation.network import Network, NoAnswer
from tests.simulation.world import World
from tests.support.sim.calibration_action import calibration_action

# Codes after which the same request is sent again.
AGAIN = ("unavailable", "no_capacity")
PAUSE_S = 0.5
# Long enough for a lease to end.
LONG_PAUSE_S = 40.0
MAX_WORKERS = 2


@dataclass
class Client:
    """One account's side of a run.

    numbers, attach_keys: of actions and attaches, unique in the schedule.
    """

    world: World
    network: Network
    history: History
    account: str
    numbers: Iterator[int]
    attach_keys: Iterator[int]

    async def ask(self, request: Callable[[RunService], Awaitable[Any]]) -> Any:
        """The answer, however often it takes. Raises Refused with what is final."""
        while True:
            try:
                return await self.network.call(request)
            except NoAnswer:
                await self.world.delay(PAUSE_S)
            except Refused as refused:
                if refused.code not in AGAIN:
                    raise
                await self.world.delay(PAUSE_S)

    async def submit(self, key: str, episodes: int) -> str:
        submission: Submission = {
            "benchmark_id": "calibration",
            "options": {"tasks": ["score"] * episodes},
            "policy": {"name": "simulated"},
            "mode": "pull",
            "max_workers": MAX_WORKERS,
            "idle_timeout_s": 10.0,
        }
        run = await self.ask(
            lambda server: server.submit_run(self.account, submission.copy(), key)
        )
        self.history.note_submitted(key, run.run_id)
        return str(run.run_id)

    async def view(self, run_id: str) -> dict[str, Any]:
        known = self.history.known_results(run_id)
        view: dict[str, Any] = await self.ask(
            lambda server: server.view_run(self.account, run_id, "")
        )
        self.history.note_counts(run_id, known, view, MAX_WORKERS)
        return view

    async def episodes(self, run_id: str) -> list[dict[str, Any]]:
        known = self.history.known_results(run_id)
        found, _ = await self.ask(
            lambda server: server.list_episodes(self.account, run_id, 0, 1000)
        )
        self.history.note_episodes(run_id, known, found)
        return list(found)

    async def score(self, run_id: str) -> dict[str, Any]:
        answer: dict[str, Any] = await self.ask(
            lambda server: server.get_score(self.account, run_id)
        )
        return answer

    async def is_complete(self, run_id: str) -> bool:
        return bool((await self.view(run_id))["state"] == "completed")

    # --- those who act ---

    async def work(self, run_id: str, worker_id: str) -> None:
        """Play until the run has completed."""
        while not await self.is_complete(run_id):
            key = f"{worker_id}-{next(self.attach_keys)}"
            try:
                turn = await self._attach(run_id, worker_id, key)
                await self._play(run_id, worker_id, turn)
            except Refused:  # stopped, not ready, superseded, or the session ended
                await self.world.delay(4 * PAUSE_S)

    async def _attach(self, run_id: str, worker_id: str, key: str) -> dict[str, Any]:
        takeover = self.world.happens(0.5)
        command = Attach(worker_id, key, takeover)
        turn: dict[str, Any] = await self.ask(
            lambda server: server.attach_worker(self.account, run_id, command)
        )
        self.history.note_turn(run_id, turn)
        return turn

    async def _play(self, run_id: str, worker_id: str, turn: dict[str, Any]) -> None:
        world, session_id = self.world, turn["session_id"]
        while not turn["done"]:
            if world.happens(world.chances.worker_pauses):
                await world.delay(LONG_PAUSE_S)
            if world.happens(0.1):
                await self._beat(run_id, Heartbeat(worker_id, session_id))
            actions = [self._action() for _ in range(world.chance.choice((1, 1, 3)))]
            command = Predict(worker_id, session_id, turn["seq"] + 1, actions)
            turn = await self._predict(run_id, command)
        if world.happens(0.5):
            leave = Detach(worker_id, session_id)
            await self.ask(lambda s: s.detach_worker(self.account, run_id, leave))

    async def _beat(self, run_id: str, command: Heartbeat) -> None:
        await self.ask(lambda server: server.heartbeat(self.account, run_id, command))

    async def _predict(self, run_id: str, command: Predict) -> dict[str, Any]:
        turn: dict[str, Any] = await self.ask(
            lambda server: server.predict(self.account, run_id, command)
        )
        sent = [action["vector"][0] for action in command.actions]
        self.history.note_turn(run_id, turn, sent)
        return turn

    def _action(self) -> dict[str, list[float]]:
        number, chance = next(self.numbers), self.world.chance
        end = float(chance.random() < 0.1)
        return calibration_action(vector=number, score=chance.random(), end=end)

    async def watch(self, run_id: str) -> None:
        """Read what there is again and again, until the run has completed."""
        while not await self.is_complete(run_id):
            await self.episodes(run_id)
            await self.world.delay(4 * PAUSE_S)

    async def meddle(self, run_id: str, times: int) -> None:
        """Stop and resume the run, and look at it, at any moment."""
        for _ in range(times):
            await self.world.delay(4.0)
            act = self.world.chance.choice(
                (self._stop, self._drain, self.resume, self.episodes, self.view)
            )
            try:
                await act(run_id)
            except Refused:
                await self.world.delay(PAUSE_S)

    async def _stop(self, run_id: str) -> None:
        await self.ask(lambda server: server.stop_run(self.account, run_id, "abort"))

    async def _drain(self, run_id: str) -> None:
        await self.ask(lambda server: server.stop_run(self.account, run_id, "drain"))

    async def resume(self, run_id: str) -> None:
        await self.ask(lambda server: server.resume_run(self.account, run_id))
