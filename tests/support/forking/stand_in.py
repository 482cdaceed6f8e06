"""`stand_in.py SOCKET ARGUMENT…`: stands for a process that fork_server.py forks.

Has its environment, directory and output; passes signals on, and ends with its exit
code. When this process is killed, the forked one is killed. Imports little: it starts
once for each kit and each server.
"""

import contextlib
import json
import os
import signal
import socket
import sys


def ask(
    server: socket.socket,
    arguments: list[str],
    environment: dict[str, str],
    directory: str,
    output: list[int],
) -> None:
    """Let a fork server start one. output: descriptors of its stdout and stderr."""
    job = {"arguments": arguments, "environment": environment, "directory": directory}
    request = json.dumps(job).encode() + b"\n"
    sent = socket.send_fds(server, [request], output)
    server.sendall(request[sent:])


def main() -> int:
    path, *arguments = sys.argv[1:]
    directory = os.getcwd()  # noqa: PTH109 - pathlib takes 10 ms to import
    with socket.socket(socket.AF_UNIX) as server:
        server.connect(path)

        def pass_on(number: int, _frame: object) -> None:
            with contextlib.suppress(OSError):
                server.send(bytes([number]))

        ask(server, arguments, dict(os.environ), directory, [1, 2])
        for number in (signal.SIGTERM, signal.SIGINT):
            signal.signal(number, pass_on)
        with server.makefile("rb") as answers:
            answers.readline()  # its process id
            return int(answers.readline() or b"1")


if __name__ == "__main__":
    sys.exit(main())
