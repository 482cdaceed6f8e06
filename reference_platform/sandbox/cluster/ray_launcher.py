"""The process that places one sandbox on a Ray cluster.

`python -m reference_platform.sandbox.cluster.ray_launcher ADDRESS CPUS MEMORY_BYTES`
prints one line of JSON: where the sandbox is controlled, or why there is none. It is a
process of its own, because Ray ends the process that is connected to it when the
cluster is gone. When its standard input ends, it ends, and the actor with it.
"""

from __future__ import annotations

import asyncio
import contextlib
import json
import logging
import os
import secrets
import socket
import sys
import threading
import time
from typing import Any

from reference_platform.sandbox.cluster.node_messages import SECRET_BYTES
from reference_platform.sandbox.cluster.sandbox_node import serve_sandbox
from reference_record.command_line.installation import install_command

_INSTALL = f"Ray is not installed here: {install_command('server,ray')}."


class SandboxActor:
    """`open` and `serve` are called once each, in this order."""

    def __init__(self) -> None:
        self._listener: socket.socket | None = None

    def open(self) -> tuple[str, int]:
        import ray

        host = str(ray.util.get_node_ip_address())
        family = socket.AF_INET6 if ":" in host else socket.AF_INET
        self._listener = socket.socket(family, socket.SOCK_STREAM)
        self._listener.bind((host, 0))
        self._listener.listen(16)
        return host, int(self._listener.getsockname()[1])

    def serve(self, secret: bytes) -> None:
        """In the main thread of the process: bubblewrap ends with its thread."""
        assert self._listener is not None, "`open` was called"
        asyncio.run(serve_sandbox(self._listener, secret))


def main(address: str, cpus: str, memory_bytes: str) -> None:
    answer = os.fdopen(os.dup(1), "w")
    nowhere = os.open(os.devnull, os.O_WRONLY)
    os.dup2(nowhere, 1)  # Ray prints
    os.dup2(nowhere, 2)
    try:
        import ray
    except ImportError:
        _print(answer, {"problem": _INSTALL})
        return
    actor, is_over = None, threading.Event()
    threading.Thread(target=_wait_for_end, args=(is_over,), daemon=True).start()
    try:
        ray.init(address, log_to_driver=False, logging_level=logging.CRITICAL)
        placed = ray.remote(SandboxActor).options(
            num_cpus=float(cpus), memory=int(memory_bytes),
            max_restarts=0, max_task_retries=0, scheduling_strategy="SPREAD",
        )  # fmt: skip
        actor = placed.remote()
        host, port = ray.get(actor.open.remote())
        secret = secrets.token_bytes(SECRET_BYTES)
        serving = actor.serve.remote(secret)
        _print(answer, {"host": host, "port": port, "secret": secret.hex()})
        is_over.wait()
        ray.wait([serving], timeout=_END_S)
    except Exception as error:  # noqa: BLE001 - Ray raises what it likes
        text = str(error).strip().partition("\n")[0] or type(error).__name__
        _print(answer, {"problem": f"The Ray cluster at {address}: {text}"})
    finally:
        with contextlib.suppress(Exception):
            if actor is not None:
                ray.kill(actor, no_restart=True)
            ray.shutdown()


# How long the actor may take to remove its sandbox, before it is killed; then how long
# this process may take to leave the cluster, which removes what it has left there.
_END_S, _LEAVE_S = 20.0, 5.0


def _wait_for_end(is_over: threading.Event) -> None:
    """In a thread: Ray may wait for a place, or for a cluster, for ever."""
    sys.stdin.read()
    is_over.set()
    time.sleep(_END_S + _LEAVE_S)
    os._exit(0)


def _print(answer: Any, content: dict[str, Any]) -> None:
    with contextlib.suppress(OSError):
        answer.write(json.dumps(content) + "\n")
        answer.flush()


if __name__ == "__main__":
    os.environ.setdefault("RAY_USAGE_STATS_ENABLED", "0")
    main(*sys.argv[1:])
