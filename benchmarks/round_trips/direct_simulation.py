"""Baselines of throughput: the simulators without a protocol, and behind a TCP socket.

The second is the limit of any evaluation over a network: one process for each worker
executes the actions that it receives and sends the bytes of the observation; a client
thread sends and receives them. Nothing is named, checked, stored or scored.
"""

import itertools
import multiprocessing
import socket
import threading
import time
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from typing import Any, NamedTuple

from reference_sim import benchmark_registry
from reference_sim.episode import Episode
from reference_sim.interface import Observation

ACTIONS: dict[str, dict[str, list[float]]] = {
    "tabletop_state": {
        "joint_position": [0.0, 0.3, 0.0, 1.6, 0.0, 1.2416, 0.0],
        "gripper": [1.0],
    },
    "mobile_bimanual": {
        "joint_position": [0.0] * 12,
        "gripper": [0.0] * 4,
        "base_motion": [0.0] * 3,
    },
}
# Forked by a server that has imported what is slow, and touched no GL.
_FORKS = multiprocessing.get_context("forkserver")
_FORKS.set_forkserver_preload(["benchmarks.round_trips.direct_simulation"])
_COUNT_BYTES = 8  # executed steps, before the observation


class Case(NamedTuple):
    """chunk: actions in a turn."""

    benchmark: str
    workers: int
    chunk: int

    @property
    def request_bytes(self) -> int:
        return 8 * self.chunk * sum(map(len, ACTIONS[self.benchmark].values()))


def turns(case: Case, number: int) -> Iterator[tuple[int, Observation]]:
    """Plays the benchmark's episodes endlessly; yields executed steps and observation.

    The first turn of an episode executes no step.
    """
    resolved = benchmark_registry.resolve(case.benchmark)
    simulator = benchmark_registry.make(resolved.world)
    chunk = [ACTIONS[case.benchmark]] * case.chunk
    plans = resolved.episodes[number:] + resolved.episodes[:number]
    for plan in itertools.cycle(plans):
        episode = Episode(
            simulator,
            plan.task,
            plan.seed,
            split=plan.split,
            max_steps=resolved.manifest["max_steps"],
            success_rule=resolved.manifest["success_rule"],
        )
        yield 0, simulator.observe()
        while not episode.ended:
            yield sum(1 for _ in episode.play(chunk)), simulator.observe()


def measure_bare(case: Case, seconds: float) -> float:
    """Control steps per second of all processes together."""
    counted, barrier = _FORKS.SimpleQueue(), _FORKS.Barrier(case.workers)
    processes = [
        _FORKS.Process(target=_loop, args=(case, number, seconds, barrier, counted))
        for number in range(case.workers)
    ]
    for process in processes:
        process.start()
    speeds = [float(counted.get()) for _ in processes]
    for process in processes:
        process.join()
    return sum(speeds)


def _loop(case: Case, number: int, seconds: float, barrier: Any, counted: Any) -> None:
    playing, steps = turns(case, number), 0
    next(playing)  # the first image takes long
    barrier.wait()
    began = time.monotonic()
    while time.monotonic() < began + seconds:
        steps += next(playing)[0]
    counted.put(steps / (time.monotonic() - began))


def measure_over_tcp(case: Case, seconds: float) -> float:
    """The same over TCP: one socket and one client thread per worker."""
    results = _FORKS.SimpleQueue()
    processes = [
        _FORKS.Process(target=_serve, args=(case, number, results))
        for number in range(case.workers)
    ]
    for process in processes:
        process.start()
    addresses = [results.get() for _ in processes]
    barrier = threading.Barrier(case.workers)
    with ThreadPoolExecutor(case.workers) as threads:
        futures = [
            threads.submit(_play_over_tcp, case, port, size, seconds, barrier)
            for port, size in addresses
        ]
        total = sum(future.result() for future in futures)
    for process in processes:
        process.join()
    return total


def _serve(case: Case, number: int, results: Any) -> None:
    """Serves one connection until it is closed."""
    playing = turns(case, number)
    _, observation = next(playing)
    with socket.create_server(("127.0.0.1", 0)) as listener:
        size = sum(map(len, _parts(0, observation)))
        results.put((listener.getsockname()[1], size))
        connection, _ = listener.accept()
    with connection:
        connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        while connection.recv(case.request_bytes, socket.MSG_WAITALL):
            steps, observation = next(playing)
            for part in _parts(steps, observation):
                connection.sendall(part)


def _parts(steps: int, observation: Observation) -> list[bytes | memoryview]:
    """The small parts in one piece, and each image as a view of its memory."""
    state = b"".join(vector.tobytes() for vector in observation.state.values())
    pictures = (image.data.cast("B") for image in observation.images.values())
    return [steps.to_bytes(_COUNT_BYTES, "big") + state, *pictures]


def _play_over_tcp(
    case: Case, port: int, size: int, seconds: float, barrier: threading.Barrier
) -> float:
    request, steps = bytes(case.request_bytes), 0
    buffer = memoryview(bytearray(size))
    with socket.create_connection(("127.0.0.1", port)) as connection:
        connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        barrier.wait()
        began = time.monotonic()
        while time.monotonic() < began + seconds:
            connection.sendall(request)
            filled = 0
            while filled < size:
                count = connection.recv_into(buffer[filled:])
                assert count, "a simulator has ended"
                filled += count
            steps += int.from_bytes(buffer[:_COUNT_BYTES], "big")
        return steps / (time.monotonic() - began)
