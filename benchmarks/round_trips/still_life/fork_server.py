"""The fork server of still_life_server.py. `python -m … FD`."""

import socket
import sys

from benchmarks.round_trips.still_life.world import BENCHMARKS
from reference_sim import benchmark_registry
from reference_sim.process import simulator_main
from reference_sim.process.fork_server import ForkServer

if __name__ == "__main__":
    benchmark_registry._BENCHMARKS.update(BENCHMARKS)  # noqa: SLF001 - see there
    simulator_main.log_to_stderr()
    ForkServer(socket.socket(fileno=int(sys.argv[1]))).run()
