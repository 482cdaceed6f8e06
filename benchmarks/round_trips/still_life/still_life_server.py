"""The reference server with the benchmark `still_life`.

Run as a module, with the options of the server. The benchmark is added to the
registries of the server and of its simulator processes. The public way, the Gymnasium
adapter, would add its own cost to the measurement.
"""

import sys

from benchmarks.round_trips.still_life.world import BENCHMARKS
from reference_server.__main__ import main
from reference_sim import benchmark_registry
from reference_sim.process import simulator_process

FORK_SERVER = "benchmarks.round_trips.still_life.fork_server"

if __name__ == "__main__":
    benchmark_registry._BENCHMARKS.update(BENCHMARKS)  # noqa: SLF001 - see above
    simulator_process._FORK_SERVER_MODULE = FORK_SERVER  # noqa: SLF001 - the same
    sys.exit(main())
