"""The process that is connected to a Ray cluster, for one server.

`python -m reference_sim.process.ray.launcher FD`: starts and kills actors on command,
as `fork_server.py` forks processes. It is a process of its own, because Ray ends the
process that is connected to it when the cluster is gone, reads pickles, and brings
threads, signal handlers and lines on the terminal: the server has none of that. No turn
passes through here.

It ends with its parent, and the actors end with it. The output of Ray is dropped; that
of actors is in the logs of Ray.
"""

from __future__ import annotations

import asyncio
import contextlib
import logging
import os
import secrets
import select
import socket
import sys
import threading
import time
from functools import partial
from typing import Any

from reference_record.command_line.closed_output import leave_signals_to_parent
from reference_record.command_line.installation import install_command
from reference_sim.message_frames import frame, read_message
from reference_sim.process.ray.launcher_messages import (
    TO_LAUNCHER,
    ActorEnded,
    ActorReady,
    Connect,
    Connected,
    FindRoom,
    FromLauncher,
    KillActor,
    Rejected,
    Room,
    StartActor,
)
from reference_sim.process.ray.machine_check import mismatch
from reference_sim.process.ray.simulator_actor import SECRET_BYTES, SimulatorActor

_SHUTDOWN_TIMEOUT_S = 8.0
_CHECK_TIMEOUT_S = 60.0
_RAY_NAMES = {"CPU": "num_cpus", "GPU": "num_gpus", "memory": "memory"}
_log = logging.getLogger(__name__)


class CannotUse(Exception):
    """The cluster cannot be used; the text is one sentence."""


def actor_options(resources: dict[str, float]) -> dict[str, Any]:
    """Ray's options for an actor that needs these, and no more when it is lost."""
    options: dict[str, Any] = {"num_cpus": 0, "max_restarts": 0}
    options |= {"max_task_retries": 0, "scheduling_strategy": "SPREAD"}
    for name, amount in resources.items():
        if name in _RAY_NAMES:
            options[_RAY_NAMES[name]] = int(amount) if name == "memory" else amount
        else:
            options.setdefault("resources", {})[name] = amount
    return options


def has_room(machine: dict[str, Any], resources: dict[str, float]) -> bool:
    """Whether a machine of `ray.nodes()` could hold a simulator when it is empty."""
    present = machine["Resources"]
    enough = all(present.get(name, 0) >= need for name, need in resources.items())
    return bool(machine["Alive"]) and enough


def find_lacking(
    machines: list[dict[str, Any]], resources: dict[str, float]
) -> dict[str, float]:
    """The resources that no machine has; all, if no machine has them together."""
    if any(has_room(machine, resources) for machine in machines):
        return {}
    alone = {
        name: amount
        for name, amount in resources.items()
        if not any(has_room(machine, {name: amount}) for machine in machines)
    }
    return alone or resources


class Launcher:
    """Actors of one server, by number."""

    def __init__(
        self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter
    ) -> None:
        self._reader, self._writer = reader, writer
        self._tasks: dict[int, asyncio.Task[None]] = {}
        self._actors: dict[int, Any] = {}
        self._answering: set[asyncio.Task[None]] = set()

    async def run(self) -> None:
        """Returns when the parent has ended."""
        connect = await read_message(self._reader, TO_LAUNCHER)
        if not isinstance(connect, Connect):
            return
        try:
            self._join(connect)
            machines = await self._check_machines(connect)
        except CannotUse as problem:
            self._send(Rejected(str(problem)))
            return
        self._send(Connected(machines))
        while (command := await read_message(self._reader, TO_LAUNCHER)) is not None:
            match command:
                case StartActor(number):
                    self._tasks[number] = asyncio.create_task(self._run_actor(command))
                case KillActor(number):
                    self._kill(number)
                case FindRoom():
                    task = asyncio.create_task(self._answer(command))
                    self._answering.add(task)
                    task.add_done_callback(self._answering.discard)
                case _:
                    return

    def close(self) -> None:
        """Kill every actor and leave the cluster."""
        for number in list(self._tasks):
            self._kill(number)
        if "ray" in sys.modules:
            self._ray.shutdown()

    def _send(self, message: FromLauncher) -> None:
        self._writer.write(frame(message))

    # The cluster

    def _join(self, connect: Connect) -> None:
        """Blocks for seconds. Raises CannotUse."""
        try:
            import ray
        except ImportError as error:
            raise CannotUse(
                f"Ray is not installed here: {install_command('server,ray')}"
            ) from error
        self._ray = ray
        # log_to_driver=False: prints of actors stay in the logs of Ray.
        init = partial(ray.init, log_to_driver=False, logging_level=logging.CRITICAL)
        address, how = connect.address, "does it have that address?"
        if address == "ray":
            address, how = "auto", "run `ray start` on this machine first"
        try:
            try:
                init(address)
            except ConnectionAbortedError:
                # Ray's server for clients was slow to start a process for this one.
                init(address)
        except Exception as error:
            text = f"no Ray cluster at {address} ({_first_line(error)}); {how}"
            raise CannotUse(text) from error
        self._actor_class = ray.remote(SimulatorActor)
        self._machine = connect.machine

    async def _answer(self, question: FindRoom) -> None:
        room = Room(question.number, {}, is_free=False, is_known=False)
        try:
            nodes = await asyncio.to_thread(self._ray.nodes)
            lacking = find_lacking(nodes, question.resources)
            free = await asyncio.to_thread(self._ray.available_resources)
            is_free = all(free.get(n, 0) >= x for n, x in question.resources.items())
            room = Room(question.number, lacking, is_free=is_free)
        except Exception as error:  # noqa: BLE001 - Ray raises what it likes
            _log.warning("the machines cannot be listed: %s", _first_line(error))
        self._send(room)

    async def _check_machines(self, connect: Connect) -> list[int]:
        """How many could hold a simulator, for each kind. Raises CannotUse.

        One that does not answer is left out: its end may not have been noticed yet.
        """
        from ray.util.scheduling_strategies import NodeAffinitySchedulingStrategy

        kinds = connect.simulators
        if not kinds:
            return []
        nodes = await asyncio.to_thread(self._ray.nodes)
        machines = [
            machine
            for machine in nodes
            if any(has_room(machine, kind) for kind in kinds)
        ]
        remote = self._ray.remote(num_cpus=0, max_retries=0)(mismatch)

        async def check(machine: dict[str, Any]) -> bool:
            address = machine["NodeManagerAddress"]
            place = NodeAffinitySchedulingStrategy(machine["NodeID"], soft=False)
            asking = remote.options(scheduling_strategy=place).remote(self._machine)
            try:
                why = await asyncio.wait_for(asking, _CHECK_TIMEOUT_S)
            except self._ray.exceptions.RayTaskError as error:
                why = f"cannot run a simulator: {_first_line(error)}"
            except Exception as error:  # noqa: BLE001 - Ray raises what it likes
                _log.warning("machine %s is left out: %s", address, _first_line(error))
                return False
            if why is not None:
                raise CannotUse(f"machine {address} of the Ray cluster {why}")
            return True

        checked = await asyncio.gather(*map(check, machines))
        fit = [
            machine for machine, is_fit in zip(machines, checked, strict=True) if is_fit
        ]
        return [sum(has_room(machine, kind) for machine in fit) for kind in kinds]

    # One actor

    async def _run_actor(self, start: StartActor) -> None:
        """Start it, and report its end, whatever ends it."""
        number, reason = start.number, "was killed"
        try:
            reason = await self._start_and_watch(start)
        except asyncio.CancelledError:
            raise
        except Exception as error:  # noqa: BLE001 - Ray raises what it likes
            reason = _first_line(error)
        finally:
            self._tasks.pop(number, None)
            self._forget(number)
            self._send(ActorEnded(number, reason))

    async def _start_and_watch(self, start: StartActor) -> str:
        """Returns why it did not start; raises when it has ended."""
        placed = self._actor_class.options(**actor_options(start.resources))
        actor = self._actors[start.number] = placed.remote(self._machine)
        host, port, why = await actor.open.remote()
        if not port:
            return f"machine {host} of the Ray cluster {why}"
        secret = secrets.token_bytes(SECRET_BYTES)
        ended = actor.serve.remote(secret)
        self._send(ActorReady(start.number, host, port, secret))
        await ended
        return "ended"

    def _kill(self, number: int) -> None:
        task = self._tasks.get(number)
        if task is not None:
            task.cancel()
        self._forget(number)

    def _forget(self, number: int) -> None:
        actor = self._actors.pop(number, None)
        if actor is not None:
            # It may have ended, and so may the cluster.
            with contextlib.suppress(Exception):
                self._ray.kill(actor, no_restart=True)


def _first_line(error: BaseException) -> str:
    """The error of an actor, in one line; Ray puts a traceback before it."""
    cause = getattr(error, "cause", None)
    if isinstance(cause, BaseException):
        return f"{type(cause).__name__}: {_first_line(cause)}"
    text = str(error).strip().partition("\n")[0]
    return text or type(error).__name__


def _end_with_parent(connection: socket.socket) -> None:
    """In a thread: ends the process when the parent has ended, whatever Ray does."""
    hang_up = select.poll()
    hang_up.register(connection, getattr(select, "POLLRDHUP", 0))
    hang_up.poll()
    time.sleep(_SHUTDOWN_TIMEOUT_S)
    os._exit(0)


def _keep_own_stderr() -> None:
    """Our log lines alone go to the standard error; what Ray prints is dropped."""
    stream = os.fdopen(os.dup(2), "w", buffering=1)
    handler = logging.StreamHandler(stream)
    handler.setFormatter(logging.Formatter("%(levelname)s launcher: %(message)s"))
    _log.addHandler(handler)
    _log.propagate = False
    nowhere = os.open(os.devnull, os.O_WRONLY)
    os.dup2(nowhere, 1)
    os.dup2(nowhere, 2)


async def _main(connection: socket.socket) -> None:
    reader, writer = await asyncio.open_unix_connection(sock=connection)
    launcher = Launcher(reader, writer)
    try:
        await launcher.run()
        await writer.drain()
    except ConnectionError:  # the parent has ended
        pass
    finally:
        launcher.close()


if __name__ == "__main__":
    _keep_own_stderr()
    parent = socket.socket(fileno=int(sys.argv[1]))
    threading.Thread(target=_end_with_parent, args=(parent.dup(),), daemon=True).start()
    os.environ.setdefault("RAY_USAGE_STATS_ENABLED", "0")
    leave_signals_to_parent()
    asyncio.run(_main(parent))
