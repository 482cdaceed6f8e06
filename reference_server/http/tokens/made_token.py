"""The token of a server that was given none: made once, and the same at every start.

It is kept in a file beside the database, which only its owner may read. So that the
clients of this machine find it, an entry in the owner's folder of state names the file
and the listening socket; `reference_client/protocol/credentials.py` reads it.
"""

from __future__ import annotations

import contextlib
import re
import shlex
import socket
from collections.abc import Mapping
from pathlib import Path

from reference_record.command_line.installation import in_checkout, make_here
from reference_record.command_line.written_output import writing
from reference_record.formats import local_servers
from reference_record.formats.private_file import read_or_create
from reference_server.files.file_faults import describe_file_fault
from reference_server.files.private_files import restrict
from reference_server.http.auth import LOCAL, Caller, hash_of, new_secret


class BadTokenFile(Exception):
    """The file cannot be used; the text says why and what to do."""


def read_or_make(path: Path) -> str:
    """The secret in the file, made if it is missing."""
    try:
        secret = read_or_create(path, lambda: new_secret().encode() + b"\n").decode()
    except (OSError, UnicodeError) as error:
        why = describe_file_fault(error, path)
        raise BadTokenFile(f"cannot use the token in {path} ({why})") from error
    if not re.fullmatch(r"[!-~]{16,512}", secret):
        text = f"there is no token in {path}; remove it, and one is made"
        raise BadTokenFile(text)
    restrict(path)
    return secret


def callers_of(path: Path | None) -> Mapping[str, Caller]:
    """Who has the token of the file, by its hash, where a server has made one."""
    if path is None or not path.exists():
        return {}
    return {hash_of(path.read_text().strip()): LOCAL}


def startup_lines(
    secret: str, path: Path, url: str, *, is_shown: bool = True
) -> list[str]:
    """The lines that show the token and how to use it, each to be copied as it is.

    They hold in every folder, and fit a terminal of 40 columns where the path is short.
    is_shown: False: the token itself stays in its file.
    """
    place = path.absolute()
    argument = f"$(cat {shlex.quote(str(place))})"
    lines = [f"token, kept in {place}"]
    if is_shown:
        lines = [f"{lines[0]}:", secret]
    return [
        *lines,
        "try:",
        'curl -H "Authorization: Bearer \\',
        f'{argument}" \\',
        f"{url}/v1/benchmarks",
        *certify_lines(url, argument),
    ]


def certify_lines(url: str, argument: str) -> list[str]:
    """The command that judges the server; argument: the token as the shell reads it."""
    if in_checkout():
        make, between = make_here(), " "
        if make != "make":  # a path may be long
            between = " \\\n "
        command = f"{make}{between}conformance \\".splitlines()
        return ["certify:", *command, f" URL={url} \\", f' TOKEN="{argument}"']
    run = [f'PROCTOR_TOKEN="{argument}" \\', "proctor-conformance \\", f" --url {url}"]
    return ["certify:", "pip install proctor-conformance", *run]


def publish(listener: socket.socket, path: Path | None) -> None:
    """Let clients of this account find the token of the server at `listener`.

    Without a file, remove the entry, which would name the token of an earlier server.
    Raises WrongUsage, which says how clients get the token without the entry, and
    RuntimeError where there is no home directory.
    """
    entry = local_servers.entry_file(*listener.getsockname()[:2])
    if path is None:
        with contextlib.suppress(OSError):
            entry.unlink(missing_ok=True)
        return
    export = f"export PROCTOR_TOKEN=$(cat {shlex.quote(str(path.absolute()))})"
    way_out = "for clients here, or name a folder for both with XDG_STATE_HOME"
    with writing(entry, export, way_out):
        local_servers.publish(listener, path)
