"""The commands that pages print for a terminal, each with the server that it needs."""

from __future__ import annotations

import shlex

from reference_record.command_line.default_server import DEFAULT_URL


def server_command(url: str, *words: str) -> str:
    """A command to copy, which reaches the server at a URL.

    url: empty where no server is known. Commands find the default one by themselves.
    """
    url = url.rstrip("/")
    place = () if url in ("", DEFAULT_URL) else ("--url", url)
    return shlex.join(["proctor", *words, *place])


def server_check(url: str, file: str) -> str:
    """The command that checks a record with the keys of the server at a URL.

    url: empty where no server is known. Other than `server_command`, the default one is
    named, too: `verify` asks no server by itself.
    """
    server = url.rstrip("/")
    place = ("--server", server) if server else ()
    return shlex.join(["proctor", "verify", file, *place])
