"""A Ray cluster of this machine, for tests that run in .venv-cluster."""

import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

MEMORY_BYTES = 80 * 2**20  # of each machine's object store; Ray's least


def start_again(start: Callable[[], Any]) -> Any:
    """A second time, if a busy machine needed more than the 30 s that Ray allows."""
    try:
        return start()
    except Exception:  # noqa: BLE001 - Ray raises nothing more special
        return start()


class RayCluster:
    """A head without room, and machines with room for one simulator each. Each is what
    Ray takes for a machine. RAY_ADDRESS names the cluster while it runs."""

    def __init__(self, machines: int) -> None:
        os.environ["RAY_USAGE_STATS_ENABLED"] = "0"
        os.environ.pop("RAY_ADDRESS", None)
        import ray
        from ray.cluster_utils import Cluster

        head = {"num_cpus": 0, "include_dashboard": False}
        head["object_store_memory"] = MEMORY_BYTES
        self._cluster = start_again(
            lambda: Cluster(initialize_head=True, head_node_args=head)
        )
        self._ray = ray
        self.machines = [self.add_machine() for _ in range(machines)]
        os.environ["RAY_ADDRESS"] = self._cluster.address
        # For its state; it starts nothing.
        ray.init(self._cluster.address, log_to_driver=False, configure_logging=False)

    def add_machine(self, resources: dict[str, float] | None = None) -> Any:
        """One with room for a simulator, and these besides."""
        settings: dict[str, Any] = {"num_cpus": 1, "object_store_memory": MEMORY_BYTES}
        settings["resources"] = resources or {}
        return start_again(lambda: self._cluster.add_node(**settings))

    def remove_machine_of(self, pid: int) -> None:
        """End the machine whose actor this is, as if its power had failed."""
        (place,) = [
            one["Address"]["NodeID"]
            for one in self.actors().values()
            if one["Pid"] == pid and one["State"] == "ALIVE"
        ]
        (machine,) = [one for one in self.machines if one.node_id == place]
        self.machines.remove(machine)
        self._cluster.remove_node(machine, allow_graceful=False)

    def actors(self) -> dict[str, Any]:
        """By id, with Pid, State and Address."""
        found: dict[str, Any] = self._ray._private.state.actors()
        return found

    def living_actors(self) -> list[str]:
        """Of simulators: those that run, and those that wait for room."""
        return [one for one, it in self.actors().items() if it["State"] != "DEAD"]

    def actor_processes(self) -> list[int]:
        """Those that exist, whatever Ray knows of them."""
        pids = [int(one["Pid"]) for one in self.actors().values()]
        return [pid for pid in pids if pid and Path(f"/proc/{pid}").exists()]

    def requested(self) -> int:
        """Simulators without room, as Ray's autoscaler sees them."""
        from ray.autoscaler.v2.sdk import get_cluster_status

        demands = get_cluster_status(self._cluster.address).resource_demands
        return sum(
            shape.count
            for demand in demands.ray_task_actor_demand
            for shape in demand.bundles_by_count
            if shape.bundle.get("CPU") == 1
        )

    def close(self) -> None:
        self._ray.shutdown()
        self._cluster.shutdown()
        os.environ.pop("RAY_ADDRESS", None)
