"""The cost of a turn on a Ray cluster beside simulating and drawing.

Run in .venv-cluster. Starts a cluster of this machine and plays turns alternately with
a local simulator process and with one on Ray, so that both see the same load; calls of
an actor by Ray itself are measured beside them. The first use of a simulator is how
long it takes until it plays.
"""

import asyncio
import statistics
import time
from typing import Any

from benchmarks import measuring
from reference_sim import benchmark_registry
from reference_sim.mujoco import rendering
from reference_sim.process.pool import Begin, SimulatorHandle, SimulatorPool
from reference_sim.process.ray.ray_pool import RayPool
from tests.support.sim.ray_cluster import RayCluster

TITLE = "Turns on Ray"
CALLS, TRIED_DIVISOR = 200, 10
# name → benchmark, images, turns
CASES: dict[str, tuple[str, dict[str, Any] | None, int]] = {
    "state only": ("tabletop_state", None, 2000),
    "2 × 224 × 224 raw": (
        "tabletop",
        {"codec": "raw", "width": 224, "height": 224},
        300,
    ),
    "4 × 480 × 640 raw": (
        "mobile_bimanual",
        {"codec": "raw", "width": 640, "height": 480},
        100,
    ),
}


def measure(*, trying: bool) -> str:
    """A row for each case and way; milliseconds."""
    where = measuring.machine()
    rendering.find_backend()
    cluster = RayCluster(1)
    try:
        rows = asyncio.run(_rows(TRIED_DIVISOR if trying else 1))
    finally:
        cluster.close()
    head = ["", "p50, ms", "p95, ms", "first use, s"]
    return f"{measuring.table(head, rows)}\n\n{where}"


async def _rows(divisor: int) -> list[list[str]]:
    pools: list[SimulatorPool] = [SimulatorPool(spares=0), RayPool("ray", "CPU=1")]
    for pool in pools:
        await pool.start()
    try:
        rows = [
            row
            for name, (benchmark, images, turns) in CASES.items()
            for row in await _play_case(
                pools, name, benchmark, images, turns // divisor
            )
        ]
    finally:
        for pool in pools:
            await pool.close()
    return [*rows, *await _call_rows(CALLS // divisor)]


async def _play_case(
    pools: list[SimulatorPool],
    name: str,
    benchmark: str,
    images: dict[str, Any] | None,
    turns: int,
) -> list[list[str]]:
    resolved = benchmark_registry.resolve(benchmark, images=images)
    plan, space = resolved.episodes[0], resolved.manifest["action_space"]
    action = {part: [0.0] * shape["size"] for part, shape in space.items()}
    handles, starts_s = [], []
    for pool in pools:
        began_at = time.perf_counter()
        handles.append(await pool.acquire(resolved.world))
        starts_s.append(time.perf_counter() - began_at)
    for handle in handles:
        await handle.begin(
            Begin(
                plan.task,
                plan.seed,
                split=plan.split,
                max_steps=2 * turns,
                success_rule="any_step",
            )
        )
    taken: list[list[float]] = [[], []]
    for number in range(2 * turns - 2):
        taken[number % 2].append(await play(handles[number % 2], action))
    for handle in handles:
        handle.discard()
    return [
        _row(f"{name}, {place}", each, f"{start_s:.2f}")
        for place, each, start_s in zip(("local", "Ray"), taken, starts_s, strict=True)
    ]


async def play(handle: SimulatorHandle, action: Any) -> float:
    """Milliseconds of a turn without simulating and drawing."""
    began_at = time.perf_counter()
    played = await handle.play([action], observe_all=False)
    taken = time.perf_counter() - began_at
    timing = played.timing
    return 1e3 * (taken - timing.simulate_s - timing.render_s)


async def _call_rows(calls: int) -> list[list[str]]:
    """The same bytes as answers of an actor's method, for comparison."""
    import numpy as np
    import ray

    class Echo:
        def answer(self, size: int) -> Any:
            return np.zeros(size, np.uint8)

    actor = ray.remote(num_cpus=0)(Echo).remote()
    rows = []
    for name, size in (("state only", 300), ("4 × 480 × 640 raw", 4 * 480 * 640 * 3)):
        taken = []
        for _ in range(calls):
            began_at = time.perf_counter()
            await actor.answer.remote(size)
            taken.append(1e3 * (time.perf_counter() - began_at))
        rows.append(_row(f"{name}, a call of Ray", taken, "–"))
    return rows


def _row(name: str, taken: list[float], first: str) -> list[str]:
    median, p95 = statistics.median(taken), measuring.percentile(taken, 95)
    return [name, f"{median:.2f}", f"{p95:.2f}", first]
