"""Mutants of benchmarks: which are listed, and what their digest covers."""

from __future__ import annotations

from copy import deepcopy
from typing import Any

import msgspec

from reference_record.contents import benchmark_manifest
from reference_server.runs import (
    benchmarks,
)
from reference_server.runs.benchmarks import Benchmarks
from reference_sim import benchmark_registry
from tests.mutants import Row, instead_of, mutant, mutants, put


@mutant("BEN-001", through=instead_of(Benchmarks, "summaries"))
def does_not_list_calibration(right: Any, self: Benchmarks) -> Any:
    """The kit cannot find the benchmark that it plays."""
    return [b for b in right(self) if b["benchmark_id"] != "calibration"]


@mutant("BEN-002", through=instead_of(Benchmarks, "view"))
async def answers_for_unknown_benchmarks(
    right: Any, self: Benchmarks, benchmark_id: str
) -> Any:
    """A misspelt benchmark seems to exist."""
    is_known = benchmark_id in benchmark_registry.benchmark_ids()
    return await right(self, benchmark_id if is_known else "calibration")


@mutant("BEN-003", "BEN-004")
def hashes_a_benchmark_anew_each_time() -> None:
    """Two runs of the same benchmark cannot be compared."""
    right = Benchmarks.view
    count = iter(range(10**9))

    async def wrong(self: Benchmarks, benchmark_id: str) -> Any:
        shown = await right(self, benchmark_id)
        return shown | {"manifest_sha256": f"{next(count):064x}"}

    put(Benchmarks, "view", wrong)


@mutant("BEN-006", through=instead_of(benchmark_manifest, "manifest_of"))
def hashes_the_texts_of_a_benchmark(right: Any, benchmark: Any) -> Any:
    """A host that mends a typing error in a description gets another benchmark."""
    return {**right(benchmark), "description": benchmark["description"]}


@mutant("BEN-006", through=instead_of(benchmark_manifest, "canonical_json"))
def hashes_numbers_as_its_language_writes_them(right: Any, manifest: Any) -> Any:
    """Servers in two languages show different digests of one benchmark."""
    written = right(manifest)
    wrong = msgspec.json.encode(manifest, order="deterministic")
    assert wrong != written
    return wrong


@mutant("BEN-005", "BEN-006", through=instead_of(benchmarks, "manifest_sha256"))
def hashes_the_first_hundred_episodes(right: Any, manifest: Any) -> Any:
    """Runs of different episodes are compared as if they were the same."""
    episodes = manifest["episodes"]
    if len(episodes) <= 100:
        return right(manifest)
    hashed = {**manifest, "episodes": episodes[:100], "total": len(episodes)}
    return right(hashed)


@mutant("CAL-001", through=instead_of(Benchmarks, "view"))
async def offers_another_calibration(
    right: Any, self: Benchmarks, benchmark_id: str
) -> Any:
    """The kit plays another benchmark than the one it knows."""
    body = await right(self, benchmark_id)
    if benchmark_id == "calibration":
        body["max_attempts"] = 4
    return body


@mutants(
    Row(
        "declares_an_orientation_that_overlaps",
        ("CONV-001",),
        "A policy reads the height of a pose as a part of its quaternion.",
        ("ee_pose", "orientation", {"start": 2}),
    ),
    Row(
        "declares_numbers_without_a_part",
        ("CONV-001",),
        "A policy has to guess what the first joint's number is.",
        ("joint_position", "all", {"start": 1, "size": 6}),
    ),
    Row(
        "declares_a_quaternion_as_angles",
        ("CONV-002",),
        "A policy reads the first three numbers of a quaternion as angles.",
        ("ee_pose", "orientation", {"rotation": "euler_xyz"}),
    ),
    Row(
        "declares_one_end_of_a_gripper",
        ("CONV-003",),
        "A policy has to guess by which number the gripper is closed.",
        ("gripper", "all", {"gripper_closed": 1.0}),
    ),
)
def declares_other_parts(change: tuple[str, str, dict[str, Any]]) -> None:
    """The state of `tabletop` is declared with one part changed."""
    right, (vector, part, members) = Benchmarks.view, change

    async def wrong(self: Benchmarks, benchmark_id: str) -> Any:
        shown: Any = deepcopy(await right(self, benchmark_id))
        if benchmark_id == "tabletop":
            space = shown["observation_space"]["state"][vector]
            space["parts"][part] |= members
        return shown

    put(Benchmarks, "view", wrong)
