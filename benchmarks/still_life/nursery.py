"""The nursery of a server with still lifes: see server.py. `python -m … FD`."""

from __future__ import annotations

import socket
import sys

from benchmarks.still_life.world import BENCHMARKS
from reference_sim import catalog, worker
from reference_sim.runners.nursery import Nursery

if __name__ == "__main__":
    catalog._BENCHMARKS.update(BENCHMARKS)  # noqa: SLF001 - see server.py
    worker.log_to_stderr()
    Nursery(socket.socket(fileno=int(sys.argv[1]))).tend()
