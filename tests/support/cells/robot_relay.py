"""A connection between a server and a robot that can be cut or become silent."""

import contextlib
import select
import socket
import threading
from pathlib import Path
from typing import Self


class RobotRelay:
    """Listens at `here` and passes bytes on to the robot at `there`. silent: nothing
    passes any more, and no end is seen: as a cable that was pulled."""

    def __init__(self, here: Path, there: Path) -> None:
        self._there = there
        self.silent = threading.Event()
        self._open: list[socket.socket] = []
        self._listener = socket.socket(socket.AF_UNIX)
        self._listener.bind(str(here))
        self._listener.listen(4)
        threading.Thread(target=self._accept, daemon=True).start()

    def cut(self) -> None:
        """End the connection at both ends."""
        for end in self._open:
            with contextlib.suppress(OSError):
                end.shutdown(socket.SHUT_RDWR)

    def restore(self) -> None:
        """Let new connections pass; those that were cut or silent end."""
        self.cut()
        self.silent.clear()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self._listener.close()
        self.cut()

    def _accept(self) -> None:
        while True:
            try:
                server, _ = self._listener.accept()
            except OSError:
                return
            robot = socket.socket(socket.AF_UNIX)
            try:
                robot.connect(str(self._there))
            except OSError:
                server.close()
                continue
            self._open = [server, robot]
            ends = server, robot
            threading.Thread(target=self._pass, args=ends, daemon=True).start()

    def _pass(self, server: socket.socket, robot: socket.socket) -> None:
        other = {server: robot, robot: server}
        with server, robot, contextlib.suppress(OSError):
            while True:
                for end in select.select([server, robot], [], [])[0]:
                    data = end.recv(1 << 16)
                    if not data:
                        return
                    if not self.silent.is_set():
                        other[end].sendall(data)
