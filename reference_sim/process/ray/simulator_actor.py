"""The actor that is one simulator: what runs on a machine of the Ray cluster.

Its process is the simulator's process: Ray starts a process for each actor, so native
code that crashes takes nothing else along, and Ray's own accounting of memory, CPUs and
GPUs sees what simulates. Commands do not come by calls of Ray: the actor listens for
one connection of the server and then executes what a local simulator process would
execute, with pictures inside the messages.
"""

from __future__ import annotations

import hmac
import logging
import os
import socket
import time
from typing import Never

from reference_sim.process import simulator_main
from reference_sim.process.ray.launcher_messages import MachineCheck
from reference_sim.process.ray.machine_check import mismatch
from reference_sim.shared_frame_buffer import FRAME_BUFFER

SECRET_BYTES = 32
CONNECT_TIMEOUT_S = 60.0
_FIRST_BYTES_TIMEOUT_S = 5.0
# A machine that vanished without a word is noticed after 10 + 3 × 5 s.
_KEEPALIVE = {"TCP_KEEPIDLE": 10, "TCP_KEEPINTVL": 5, "TCP_KEEPCNT": 3}
_UNACKNOWLEDGED_MS = 25_000


def prepare(connection: socket.socket) -> None:
    """Send at once, and notice when the other machine is gone."""
    connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
    connection.setsockopt(socket.SOL_SOCKET, socket.SO_KEEPALIVE, 1)
    options = {**_KEEPALIVE, "TCP_USER_TIMEOUT": _UNACKNOWLEDGED_MS}
    for name, value in options.items():
        if (option := getattr(socket, name, None)) is not None:
            connection.setsockopt(socket.IPPROTO_TCP, option, value)


class SimulatorActor:
    """One simulator. `open` and `serve` are called once each, in this order.

    host: where it listens; if empty, at the address that Ray knows this machine by.
    """

    def __init__(self, check: MachineCheck, host: str = "") -> None:
        self._check, self._host = check, host
        self._listener: socket.socket | None = None

    def open(self) -> tuple[str, int, str]:
        """Listen; the machine's address and a port, or 0 and why there is none."""
        host = self._host or _address_in_cluster()
        if (why := mismatch(self._check)) is not None:
            return host, 0, why
        family = socket.AF_INET6 if ":" in host else socket.AF_INET
        self._listener = socket.socket(family, socket.SOCK_STREAM, socket.IPPROTO_TCP)
        self._listener.bind((host, 0))
        self._listener.listen(4)
        return host, int(self._listener.getsockname()[1]), ""

    def serve(self, secret: bytes) -> Never:
        """Execute commands of the server that knows the secret; ends the process."""
        simulator_main.log_to_stderr()
        FRAME_BUFFER.keep_private()
        connection = self._accept(secret)
        if connection is None:
            logging.getLogger(__name__).error("the server did not connect")
            os._exit(0)
        simulator_main.serve(connection)

    def _accept(self, secret: bytes) -> socket.socket | None:
        """The server's connection; any other one is closed."""
        assert self._listener is not None, "`open` was called"
        deadline = time.monotonic() + CONNECT_TIMEOUT_S
        with self._listener:
            while (left := deadline - time.monotonic()) > 0:
                self._listener.settimeout(left)
                try:
                    connection, _ = self._listener.accept()
                except OSError:
                    return None
                if _sends(connection, secret):
                    connection.settimeout(None)
                    prepare(connection)
                    return connection
                connection.close()
        return None


def _address_in_cluster() -> str:
    import ray

    return str(ray.util.get_node_ip_address())


def _sends(connection: socket.socket, secret: bytes) -> bool:
    """Whether the first bytes are the secret."""
    deadline = time.monotonic() + _FIRST_BYTES_TIMEOUT_S
    received = b""
    while len(received) < len(secret):
        try:
            connection.settimeout(max(0.01, deadline - time.monotonic()))
            some = connection.recv(len(secret) - len(received))
        except OSError:
            return False
        if not some:
            return False
        received += some
    return hmac.compare_digest(received, secret)
