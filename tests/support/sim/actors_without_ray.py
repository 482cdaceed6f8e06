"""Stands for a Ray cluster: actors are processes of this machine, room is a number."""

import asyncio
import secrets
import subprocess
import sys
from collections.abc import Callable

from reference_sim.process.ray.actor_process import ROOM_UNKNOWN, CannotUseRay
from reference_sim.process.ray.launcher_messages import ActorReady, Room
from reference_sim.process.ray.machine_check import make_check
from reference_sim.process.ray.simulator_actor import SECRET_BYTES, SimulatorActor
from reference_sim.process.simulator_process import ResourceShortage
from tests.support.forking.fork_server import Main, shared_forks, stand_in
from tests.support.paths import ROOT

_PREPARE = f"{__name__}:prepare_actor"


def prepare_actor() -> Main:
    """Give the program of an actor; its secret is the only argument."""

    def serve(arguments: list[str]) -> int:
        actor = SimulatorActor(make_check(), "127.0.0.1")
        sys.stdout.write(f"{actor.open()[1]}\n")
        sys.stdout.flush()
        actor.serve(bytes.fromhex(arguments[0]))

    return serve


class LauncherWithoutRay:
    """What a LauncherClient does. room: how many more actors the cluster can hold.
    names: the resources that its machines have. is_joined: whether there is a cluster.
    is_slow: it has room, as it says, for what it does not start. is_silent: it says
    nothing of its room. requested: how many
    actors wait for room. bad_starts: how many of the next ones end before they are
    ready. started: what the actors took, in the order of their start."""

    def __init__(self, room: int) -> None:
        self.room, self.requested = room, 0
        self.names = {"CPU"}
        self.is_slow = self.is_silent = False
        self.started: list[dict[str, float]] = []
        self.actors: dict[int, subprocess.Popen[str]] = {}
        self.is_joined, self.is_open, self.bad_starts = True, True, 0
        self._more_room = asyncio.Event()
        self._last_number = 0

    def add_room(self, more: int = 1) -> None:
        self.room += more
        self._more_room.set()

    def add_resource(self, name: str) -> None:
        self.names.add(name)
        self._more_room.set()

    async def open(self) -> list[int]:
        self.is_open = self.is_joined
        if not self.is_joined:
            raise CannotUseRay("there is no cluster")
        return []

    async def find_room(self, resources: dict[str, float]) -> Room:
        if self.is_silent:
            return ROOM_UNKNOWN
        lacking = {n: x for n, x in resources.items() if n not in self.names}
        return Room(0, lacking, is_free=self.is_slow and not lacking)

    async def start_actor(
        self, resources: dict[str, float], on_end: Callable[[], None]
    ) -> tuple[int, ActorReady]:
        await self.open()
        self.requested += 1
        try:
            while self.room < 1 or not resources.keys() <= self.names:
                self._more_room.clear()
                await self._more_room.wait()
        finally:
            self.requested -= 1
        self.room -= 1
        if self.bad_starts:
            self.bad_starts -= 1
            self.room += 1
            raise ResourceShortage("its machine is gone")
        self.started.append(resources)
        self._last_number += 1
        number = self._last_number
        secret = secrets.token_bytes(SECRET_BYTES)
        actor = subprocess.Popen(  # noqa: ASYNC220 - a millisecond
            [*stand_in(shared_forks(_PREPARE)), secret.hex()],
            cwd=ROOT,
            stdout=subprocess.PIPE,
            text=True,
        )
        self.actors[number] = actor
        assert actor.stdout is not None
        port = int(await asyncio.to_thread(actor.stdout.readline))
        return number, ActorReady(number, "127.0.0.1", port, secret)

    def kill(self, number: int) -> None:
        actor = self.actors.pop(number, None)
        if actor is not None:
            actor.kill()
            actor.wait()
            assert actor.stdout is not None
            actor.stdout.close()
            self.add_room()

    async def close(self) -> None:
        for number in list(self.actors):
            self.kill(number)
