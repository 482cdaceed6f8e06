"""`python -m … SERVER [PARSER] [LOOP]`: one of the ASGI servers with app.py behind it.

Prints `ready` and its address when it accepts requests. Each is configured as its
documentation recommends for one process: no access log, HTTP/1.1.
"""

from __future__ import annotations

import asyncio
import socket
import sys
import threading
import time
from collections.abc import Callable
from typing import Any

HOST = "127.0.0.1"
APP = "benchmarks.libraries.sample_app:app"
_UNTIL_S = 20.0


def main() -> None:
    kind, *options = sys.argv[1:]
    # asyncio sets TCP_NODELAY only where the protocol is named.
    listener = socket.socket(socket.AF_INET, socket.SOCK_STREAM, socket.IPPROTO_TCP)
    listener.bind((HOST, 0))
    port: int = listener.getsockname()[1]
    threading.Thread(target=_say_when_it_listens, args=(port,), daemon=True).start()
    _SERVERS[kind](listener, *options)


def _say_when_it_listens(port: int) -> None:
    end = time.monotonic() + _UNTIL_S
    while time.monotonic() < end:
        try:
            socket.create_connection((HOST, port)).close()
        except ConnectionRefusedError:
            time.sleep(0.01)
        else:
            print(f"ready http://{HOST}:{port}", flush=True)
            return


def _uvicorn(listener: socket.socket, parser: str, loop: str) -> None:
    import uvicorn

    chosen: dict[str, Any] = {"http": parser, "loop": loop}
    config = uvicorn.Config(
        APP, log_level="warning", access_log=False, server_header=False, **chosen
    )
    uvicorn.Server(config).run(sockets=[listener])


def _granian(listener: socket.socket) -> None:
    from granian import Granian
    from granian.constants import HTTPModes, Interfaces, Loops

    port = listener.getsockname()[1]
    listener.close()  # it takes none that is there
    Granian(
        APP,
        HOST,
        port,
        interface=Interfaces.ASGI,
        http=HTTPModes.http1,
        loop=Loops.uvloop,
        websockets=False,
        log_enabled=False,
    ).serve()


def _hypercorn(listener: socket.socket) -> None:
    import uvloop
    from hypercorn.asyncio import serve
    from hypercorn.config import Config

    from benchmarks.libraries.sample_app import app

    config = Config()
    config.bind = [f"fd://{listener.detach()}"]
    config.include_server_header = False
    config.loglevel = "WARNING"
    shown: Any = app
    with asyncio.Runner(loop_factory=uvloop.new_event_loop) as runner:
        runner.run(serve(shown, config))


_SERVERS: dict[str, Callable[..., None]] = {
    "uvicorn": _uvicorn,
    "granian": _granian,
    "hypercorn": _hypercorn,
}

if __name__ == "__main__":
    main()
