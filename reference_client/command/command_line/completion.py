"""Completion in shells: `proctor completion SHELL` prints what a shell is to source.

At each Tab the shell starts `proctor`; click answers with the words and flags of
arguments.py. This module adds ids of runs and names of benchmarks. They are read from
the server, for which it waits a second at most, however slowly the server sends; there
are none when there is no answer.
"""

from __future__ import annotations

import contextlib
import json
import re
import threading
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any
from urllib.parse import urlsplit

import click
from click.shell_completion import CompletionItem, get_completion_class

from reference_client.command.command_line.chosen_server import (
    resolve_server,
)
from reference_client.printable_text import printable
from reference_client.protocol.http_connection import HttpConnection, ascii_place
from reference_record.command_line.click_commands import Options
from reference_record.command_line.default_server import DEFAULT_URL

if TYPE_CHECKING:
    from reference_client.command.output.printer import Printer

_ID = re.compile("[A-Za-z0-9_-]{1,64}")  # of runs and benchmarks: nothing to quote
TIMEOUT_S = 1.0  # in which an answer must be complete


def completion(args: Options, printer: Printer) -> int:
    """`proctor completion bash|zsh|fish`."""
    shell = get_completion_class(args.shell)
    assert shell is not None, "the option allows shells that the library has"
    code = shell(click.Command("proctor"), {}, "proctor", "_PROCTOR_COMPLETE").source()
    printer.answer(code, code.rstrip("\n"))
    return 0


def complete_runs(
    given: Mapping[str, Any], incomplete: str
) -> Iterator[CompletionItem]:
    """The latest runs: id, with state, benchmark and policy."""
    for run in _read(given, "/v1/runs").get("runs", []):
        about = f"{run['state']} {run['benchmark_id']} {run['policy']['name']}"
        yield from _item(run["run_id"], about, incomplete)


def complete_benchmarks(
    given: Mapping[str, Any], incomplete: str, *, is_board: bool
) -> Iterator[CompletionItem]:
    """The benchmarks of the server: id, with title; and `verify`, where it may stand.

    given: the options before the word.
    """
    for benchmark in _read(given, "/v1/benchmarks").get("benchmarks", []):
        yield from _item(benchmark["benchmark_id"], benchmark["title"], incomplete)
    if is_board:
        yield from _item("verify", "check the history", incomplete)


def _item(word: str, about: str, incomplete: str) -> Iterator[CompletionItem]:
    """The word, if it fits, with one printable line: texts of a server are not safe."""
    if _ID.fullmatch(word) and word.startswith(incomplete):
        yield CompletionItem(word, help=" ".join(printable(about).split()))


def _read(given: Mapping[str, Any], path: str) -> Any:
    """GET `path` with the flags given so far; {} if there is no answer.

    A Tab must not end in a traceback; the command itself reports what is wrong. Time
    limits of a socket begin again with each byte: only a thread that is left behind
    bounds the whole, name resolution included.
    """
    answer: dict[str, Any] = {}
    names = ("ca", "host", "port", "token", "url")
    args = Options(command="", **{name: given.get(name) for name in names})
    args.url = args.url or DEFAULT_URL
    reader = threading.Thread(target=_receive, args=(args, path, answer), daemon=True)
    reader.start()
    reader.join(TIMEOUT_S)
    return dict(answer)


def _receive(args: Options, path: str, members: dict[str, Any]) -> None:
    with contextlib.suppress(Exception):
        resolve_server(args)
        limits, check = (TIMEOUT_S, TIMEOUT_S), args.credential.check_connection
        connection = HttpConnection(args.url, limits, _buffer, check)
        lines = {"Host": ascii_place(args.url), "Connection": "close"}
        lines |= connection.proxy_headers
        if args.credential.token:
            lines["Authorization"] = f"Bearer {args.credential.token}"
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
