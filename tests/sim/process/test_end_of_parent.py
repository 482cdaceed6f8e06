"""A simulator whose server was killed ends, and leaves no traceback in its log.

The thread that waits for the end is left out here: which of the two sees it first is
chance.
"""

import socket
import subprocess
import sys

import pytest

from reference_sim import benchmark_registry
from reference_sim.message_frames import frame
from reference_sim.process import simulator_main
from tests.support.servers import TIMEOUT_S

pytestmark = pytest.mark.slow("starts interpreters")

SERVE = """
import socket, sys
from reference_sim.process import simulator_main
simulator_main._exit_with_parent = lambda connection: None
simulator_main.log_to_stderr()
simulator_main.serve(socket.socket(fileno=int(sys.argv[1])))
"""
SETTINGS = dict(benchmark_registry.resolve("calibration").world.settings)
BUILD = bytes(frame(simulator_main.Build("calibration", SETTINGS, {})))


def output_after_the_end(last_bytes: bytes, *, read_first: bool) -> str:
    """The log of a simulator whose parent sends this and is killed. read_first: whether
    the parent has read what the simulator said before."""
    ours, theirs = socket.socketpair()
    process = subprocess.Popen(
        [sys.executable, "-c", SERVE, str(theirs.fileno())],
        pass_fds=[theirs.fileno()],
        stderr=subprocess.PIPE,
        text=True,
    )
    theirs.close()
    ours.settimeout(TIMEOUT_S)
    ours.recv(1, socket.MSG_PEEK)  # it has begun
    if read_first:
        ours.recv(2**16)
    ours.sendall(last_bytes)
    ours.close()
    _, said = process.communicate(timeout=TIMEOUT_S)
    assert process.returncode == 0, said
    return said


@pytest.mark.parametrize("read_first", [True, False])
@pytest.mark.parametrize(
    "last_bytes",
    [b"", BUILD, BUILD[:2], BUILD[:-1]],
    ids=["nothing", "command", "head", "half"],
)
def test_a_killed_server_is_no_failure_of_its_simulators(
    last_bytes: bytes, read_first: bool
) -> None:
    """Killed before it read an answer, or within a command."""
    assert output_after_the_end(last_bytes, read_first=read_first) == ""
