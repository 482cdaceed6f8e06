"""The reference server, with still lifes in its catalog.

`python -m benchmarks.still_life.server`, with the options of the server. Everything is
the server's own; its catalog and that of its simulator processes offer still lifes
beside the rest. There is a way for everybody, the Gymnasium adapter, but then its work
would be measured with the server's.
"""

from __future__ import annotations

import sys

from benchmarks.still_life.world import BENCHMARKS
from reference_server.__main__ import main
from reference_sim import benchmark_registry
from reference_sim.process import simulator_process

if __name__ == "__main__":
    benchmark_registry._BENCHMARKS.update(BENCHMARKS)  # noqa: SLF001 - see above
    simulator_process._FORK_SERVER_MODULE = "benchmarks.still_life.fork_server"  # noqa: SLF001
    sys.exit(main())
