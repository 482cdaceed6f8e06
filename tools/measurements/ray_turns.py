"""`python -m tools.measurements.ray_turns`: what a turn costs on a Ray cluster.

Run in .venv-cluster. Starts a cluster of this machine and plays turns alternately with
a local simulator process and with one on Ray, so that both see the same load; calls of
an actor by Ray itself are measured beside them. Prints what a turn takes besides
simulating and drawing, and how long it takes until a simulator plays.
"""

from __future__ import annotations

import asyncio
import statistics
import time
from typing import Any

from reference_sim import benchmark_registry
from reference_sim.mujoco import rendering
from reference_sim.process.pool import SimulatorHandle, SimulatorPool
from reference_sim.process.ray.ray_pool import RayPool
from tests.support.sim.ray_cluster import RayCluster

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


async def play(handle: SimulatorHandle, action: Any) -> float:
    """Milliseconds of a turn without simulating and drawing."""
    started = time.perf_counter()
    played = await handle.play([action], observe_all=False)
    taken = time.perf_counter() - started
    timing = played.timing
    return 1e3 * (taken - timing.simulate_s - timing.render_s)


async def measure_case(pools: list[SimulatorPool], name: str) -> None:
    benchmark, images, turns = CASES[name]
    found = benchmark_registry.resolve(benchmark, images=images)
    plan, space = found.episodes[0], found.manifest["action_space"]
    action = {part: [0.0] * shape["size"] for part, shape in space.items()}
    handles, starts = [], []
    for pool in pools:
        started = time.perf_counter()
        handles.append(await pool.acquire(found.world))
        starts.append(time.perf_counter() - started)
    for handle in handles:
        await handle.begin(
            plan.task,
            plan.seed,
            split=plan.split,
            max_steps=2 * turns,
            success_rule="any_step",
        )
    taken: list[list[float]] = [[], []]
    for number in range(2 * turns - 2):
        taken[number % 2].append(await play(handles[number % 2], action))
    medians = [statistics.median(one) for one in taken]
    tails = [statistics.quantiles(one, n=20)[-1] for one in taken]
    for handle in handles:
        handle.discard()
    print(
        f"{name:20} local {medians[0]:6.2f} (p95 {tails[0]:6.2f}) ms   "
        f"on Ray {medians[1]:6.2f} (p95 {tails[1]:6.2f}) ms   "
        f"first use {starts[0]:5.2f} and {starts[1]:5.2f} s",
        flush=True,
    )


async def measure_calls() -> None:
    """The same bytes as answers of an actor's method, for comparison."""
    import numpy as np
    import ray

    class Echo:
        def answer(self, size: int) -> Any:
            return np.zeros(size, np.uint8)

    actor = ray.remote(num_cpus=0)(Echo).remote()
    for name, size in (("state only", 300), ("4 × 480 × 640 raw", 4 * 480 * 640 * 3)):
        taken = []
        for _ in range(200):
            started = time.perf_counter()
            await actor.answer.remote(size)
            taken.append(1e3 * (time.perf_counter() - started))
        p95 = statistics.quantiles(taken, n=20)[-1]
        median = statistics.median(taken)
        print(f"{name:20} a call of Ray {median:6.2f} (p95 {p95:6.2f}) ms")


async def measure() -> None:
    pools: list[SimulatorPool] = [SimulatorPool(spares=0), RayPool("ray", "CPU=1")]
    for pool in pools:
        await pool.start()
    try:
        for name in CASES:
            await measure_case(pools, name)
    finally:
        for pool in pools:
            await pool.close()
    await measure_calls()


def main() -> None:
    rendering.find_backend()
    cluster = RayCluster(1)
    try:
        asyncio.run(measure())
    finally:
        cluster.close()


if __name__ == "__main__":
    main()
