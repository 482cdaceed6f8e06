"""Completion in shells: `proctor completion SHELL` prints what a shell is to source.

At each Tab the shell starts `proctor`, which ends here, before it imports what takes
long. Words and flags are those of arguments.py; ids of runs and names of benchmarks are
read from the server, for which this module waits a second at most, however slowly the
server sends, and is silent when there is no answer.
"""

from __future__ import annotations

import argparse
import contextlib
import json
import re
import threading
from collections.abc import Callable, Iterable, Mapping
from typing import TYPE_CHECKING, Any
from urllib.parse import urlsplit

import argcomplete
from argcomplete.shell_integration import shellcode

from reference_client.command.command_line.arguments import build_parser, resolve_server
from reference_client.printable_text import printable
from reference_client.protocol.http_connection import HttpConnection, ascii_place

if TYPE_CHECKING:
    from reference_client.command.output.printer import Printer

_ID = re.compile("[A-Za-z0-9_-]{1,64}")  # of runs and benchmarks: nothing to quote
TIMEOUT_S = 1.0  # in which an answer must be complete


def completion(args: argparse.Namespace, printer: Printer) -> int:
    """`proctor completion bash|zsh|fish`."""
    code = shellcode(["proctor"], shell=args.shell)
    printer.answer(code, code.rstrip("\n"))
    return 0


def complete() -> None:
    """Answers the shell and ends the process, if it was started at a Tab."""
    parser = build_parser()
    for command in parser.commands:
        for action in command._actions:  # noqa: SLF001  argparse lists them nowhere else
            if (completer := _completer_of(action)) is not None:
                # The attribute by which the library finds it.
                action.completer = completer  # type: ignore[attr-defined]
    argcomplete.autocomplete(parser, always_complete_options=False)


def _completer_of(action: argparse.Action) -> Callable[..., Mapping[str, str]] | None:
    if action.metavar in ("RUN", "BASELINE", "RUN|FILE"):
        return complete_runs
    if action.dest == "benchmark":
        return complete_benchmarks
    return None


def complete_runs(*, parsed_args: argparse.Namespace, **_: Any) -> dict[str, str]:
    """The latest runs: id → state, benchmark and policy."""
    return _words(
        (run["run_id"], f"{run['state']} {run['benchmark_id']} {run['policy']['name']}")
        for run in _read(parsed_args, "/v1/runs").get("runs", [])
    )


def complete_benchmarks(
    *, parsed_args: argparse.Namespace, action: argparse.Action, **_: Any
) -> dict[str, str]:
    """The benchmarks of the server: id → title; and `verify`, where that may stand."""
    benchmarks = _read(parsed_args, "/v1/benchmarks").get("benchmarks", [])
    words = _words(
        (benchmark["benchmark_id"], benchmark["title"]) for benchmark in benchmarks
    )
    is_board = "verify" in str(action.metavar)
    return words | ({"verify": "check the history"} if is_board else {})


def _words(pairs: Iterable[tuple[str, str]]) -> dict[str, str]:
    """Id → one printable line. A server's texts must not break the command line."""
    return {
        word: " ".join(printable(text).split())
        for word, text in pairs
        if _ID.fullmatch(word)
    }


def _read(args: argparse.Namespace, path: str) -> Any:
    """GET `path` with the flags given so far; {} if there is no answer.

    A Tab must not end in a traceback; the command itself reports what is wrong. Time
    limits of a socket begin again with each byte: only a thread that is left behind
    bounds the whole, name resolution included.
    """
    answer: dict[str, Any] = {}
    reader = threading.Thread(target=_receive, args=(args, path, answer), daemon=True)
    reader.start()
    reader.join(TIMEOUT_S)
    return dict(answer)


def _receive(args: argparse.Namespace, path: str, members: dict[str, Any]) -> None:
    with contextlib.suppress(Exception):
        resolve_server(args)
        connection = HttpConnection(args.url, (TIMEOUT_S, TIMEOUT_S), _buffer)
        lines = {"Host": ascii_place(args.url), "Connection": "close"}
        lines |= connection.proxy_headers
        if args.token:
            lines["Authorization"] = f"Bearer {args.token}"
        head = "".join(f"{name}: {value}\r\n" for name, value in lines.items())
        base = urlsplit(args.url).path.rstrip("/")
        target = connection.target_prefix + base + path
        with contextlib.closing(connection):
            answer = connection.send_request(
                f"GET {target} HTTP/1.1\r\n{head}\r\n".encode("ascii")
            )
        if answer.status == 200:
            members.update(json.loads(bytes(answer.body)))


def _buffer(size: int) -> memoryview:
    return memoryview(bytearray(size))
