"""A Ray cluster of the local cluster's own: several machines that are all this one.

`python -m tools.local_cluster.ray_machines MACHINES CPUS`, where Ray is installed,
starts it, prints its address or why there is none, and ends it when its standard input
ends, as when the process that started it was killed. A line `add` there starts one more
machine; `add` and `list` print the process ids of those beside the head that run. A
process of its own: Ray brings threads and signal handlers. No other machine reaches any
of it.
"""

import asyncio
import contextlib
import importlib.util
import os
import signal
import sys
from pathlib import Path
from typing import Any

from tools.local_cluster.part_processes import NotStarted, start_apart

MACHINES = 3
PLACES = 16  # for simulators, of one machine
# Ray's CPUs are a number, not those of this machine. It starts as many processes at
# once as a machine has CPUs, so they are few, and a simulator takes a part of one.
CPUS = 1
RESOURCES = f"CPU={CPUS / PLACES}"
# On Linux, too, this lets Ray know this machine as 127.0.0.1 alone, and listen nowhere
# else; it is a setting of who starts Ray and of who joins it.
ENVIRONMENT = {"RAY_ENABLE_WINDOWS_OR_OSX_CLUSTER": "0", "RAY_USAGE_STATS_ENABLED": "0"}
END_S = 20.0
_STORE_BYTES = 80 * 2**20  # of each machine's object store; Ray's least
STARTED, _FAILED, LISTED = "started ", "failed ", "machines "
ADD, LIST = "add", "list"


async def start_ray(
    ends: contextlib.AsyncExitStack, folder: Path, temporary: Path
) -> tuple[asyncio.subprocess.Process, str]:
    """Start Ray, and give its process and address; `ends` ends it. Raises NotStarted.

    folder: of its log. temporary: for files that are not needed after it, among them
    the logs of Ray; its path is short, because that of a socket has 107 bytes at most.
    """
    if importlib.util.find_spec("ray") is None:
        raise NotStarted("Ray is not installed here; `make cluster` installs it")
    log = folder / "ray.log"
    process = await start_apart(
        ends,
        END_S,
        [sys.executable, "-m", __name__, str(MACHINES), str(CPUS)],
        log,
        end_signal=signal.SIGTERM,  # also while it starts
        env=os.environ | ENVIRONMENT | {"RAY_TMPDIR": str(temporary)},
        stdin=asyncio.subprocess.PIPE,
        stdout=asyncio.subprocess.PIPE,
    )
    assert process.stdout is not None
    # Ray may print, too.
    while read := await process.stdout.readline():
        line = read.decode(errors="replace").strip()
        if line.startswith(STARTED):
            return process, line.removeprefix(STARTED)
        if line.startswith(_FAILED):
            why = line.removeprefix(_FAILED)
            raise NotStarted(f"Ray did not start ({why}); {log} says more")
    raise NotStarted(f"Ray did not start; {log} says why")


def _run(machines: int, cpus: int) -> None:
    os.environ.pop("RAY_ADDRESS", None)
    from ray.cluster_utils import Cluster

    settings = {"num_cpus": cpus, "object_store_memory": _STORE_BYTES}
    head = settings | {"include_dashboard": False}

    def start_head() -> Cluster:
        return Cluster(initialize_head=True, head_node_args=head)

    try:
        try:
            cluster = start_head()
        except Exception:  # noqa: BLE001 - Ray raises what it likes
            # A busy machine needed more than the 30 s that Ray allows.
            cluster = start_head()
        for _ in range(machines - 1):
            cluster.add_node(**settings)
    except Exception as error:  # noqa: BLE001 - Ray raises what it likes
        why = str(error).strip().partition("\n")[0] or type(error).__name__
        print(f"{_FAILED}{why}", flush=True)
        return
    print(f"{STARTED}{cluster.address}", flush=True)
    for line in sys.stdin:
        if line.strip() == ADD:
            with contextlib.suppress(Exception):  # a slow one may join later
                cluster.add_node(**settings)
        print(LISTED, *_machines_of(cluster), flush=True)
    cluster.shutdown()


def _machines_of(cluster: Any) -> list[int]:
    """Process ids of those beside the head that run."""
    found = [one.all_processes["raylet"][0].process for one in cluster.worker_nodes]
    return [process.pid for process in found if process.poll() is None]


if __name__ == "__main__":
    _run(int(sys.argv[1]), int(sys.argv[2]))
