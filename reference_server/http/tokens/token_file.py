"""Tokens in a file that may change while the server runs.

A line is `account:scopes:sha256=HEX`; lines that begin with `#` and empty ones are
skipped. Only hashes stand in it (AUTH-006). The server reads the file again when it
changes, off the event loop, and before it refuses a token that it does not know; what
cannot be read changes nothing and is logged once.
"""

from __future__ import annotations

import asyncio
import contextlib
import fcntl
import logging
import os
import re
import stat
from collections.abc import Iterator, Mapping
from pathlib import Path

from reference_record.command_line.replaced_file import replace_file
from reference_server.files.file_faults import describe_file_fault
from reference_server.files.private_files import create_empty, restrict
from reference_server.http.auth import BadTokens, Caller, Tokens, parse_entry

log = logging.getLogger("proctor.tokens")

LOOK_S = 1.0
BYTES_MAX = 4 * 2**20
_LINE = re.compile(r"[^:\s]+:[a-z_+]+:sha256=[0-9A-Fa-f]{64}")
HEAD = "# account:scopes:sha256=HEX, written by `proctor admin token`\n"


class TokenFile:
    """Keeps the tokens of a server as the file says."""

    def __init__(self, path: Path, tokens: Tokens) -> None:
        self._path, self._tokens = path, tokens
        self._reading, self._looks = asyncio.Lock(), 0
        self._stat: tuple[int, int, int] | None = None
        tokens.add_source(self.look_again)
        self._seen: bytes | Exception | None = None
        self._accounts: dict[str, str] = {}
        self._following: asyncio.Task[None] | None = None

    async def open(self) -> None:
        """Read the file, and again whenever it changes. Raises as `read`."""
        await asyncio.to_thread(self.read)
        self._following = asyncio.create_task(self.follow())

    async def close(self) -> None:
        if self._following is not None:
            self._following.cancel()

    def read(self) -> None:
        """Take over what the file says; a file that never was says nothing.

        Blocks. Raises OSError and BadTokens, and then changes nothing.
        """
        try:
            _require_private(self._path)
            self._stat = _stat_of(self._path)
            content = read_bytes(self._path)
        except FileNotFoundError:
            if self._seen is None:
                return
            raise
        if content != self._seen:
            by_hash = parse(content, self._path)
            self._tokens.replace_those_of_file(by_hash)
            self._seen = content
            self._log_change(by_hash)

    async def follow(self) -> None:
        """Read the file again whenever it changes, until cancelled."""
        complaint = ""
        while True:
            await asyncio.sleep(LOOK_S)
            try:
                async with self._reading:
                    await asyncio.to_thread(self.read)
                complaint = ""
            except (OSError, BadTokens) as error:
                why = describe_file_fault(error, self._path)
                if why != complaint:
                    text = "%s cannot be used, the tokens read before stay valid: %s"
                    log.error(text, self._path, why)  # noqa: TRY400 - no traceback
                complaint = why

    async def look_again(self) -> None:
        """Read the file if it has changed: a token in it may have just been added.

        One look serves all who asked before it began, and costs one `stat` as long as
        the file is the same: wrong tokens, however many, read nothing.
        """
        asked_at = self._looks
        async with self._reading:
            if self._looks == asked_at:
                self._looks += 1
                await asyncio.to_thread(self._read_if_changed, self._path)

    def _read_if_changed(self, path: Path) -> None:
        with contextlib.suppress(OSError, BadTokens):  # `follow` reports it
            if _stat_of(path) != self._stat:
                self.read()

    def _log_change(self, by_hash: Mapping[str, Caller]) -> None:
        before = self._accounts
        self._accounts = {hashed: caller.account for hashed, caller in by_hash.items()}
        for what, here, there in (
            ("added", self._accounts, before),
            ("revoked", before, self._accounts),
        ):
            for hashed in here.keys() - there.keys():
                log.info("token %s of %s %s", token_id(hashed), here[hashed], what)


def token_id(hashed: str) -> str:
    """The name of a token in logs and lists, which cannot be used as a token."""
    return hashed[:12]


def _stat_of(path: Path) -> tuple[int, int, int]:
    status = path.stat()
    return status.st_mtime_ns, status.st_size, status.st_ino


def _require_private(path: Path) -> None:
    """Take the access of others from the file; it is not used if they can write it."""
    if path.is_file():
        with contextlib.suppress(OSError):  # in a file system that is only read
            restrict(path)
    if stat.S_IMODE(path.stat().st_mode) & 0o022:
        raise BadTokens(f"{path} can be written by others than its owner: chmod 600")


def read_bytes(path: Path) -> bytes:
    """The content of the file. Raises OSError, also for a pipe or a large file."""
    with open(path, "rb", opener=_open_without_waiting) as file:
        if not stat.S_ISREG(os.fstat(file.fileno()).st_mode):
            raise OSError(f"{path} is no regular file")
        content = file.read(BYTES_MAX + 1)
    if len(content) > BYTES_MAX:
        raise OSError(f"{path} is larger than {BYTES_MAX} bytes")
    return content


def _open_without_waiting(path: str, flags: int) -> int:
    """A pipe would block for ever."""
    return os.open(path, flags | os.O_NONBLOCK)


def parse(content: bytes, path: Path) -> dict[str, Caller]:
    """The callers in a file, by the hashes of their tokens. Raises BadTokens."""
    try:
        lines = content.decode().splitlines()
    except UnicodeDecodeError as error:
        raise BadTokens(f"{path} is no UTF-8 text") from error
    callers: dict[str, Caller] = {}
    for number, line in enumerate(lines, start=1):
        if not line.strip() or line.startswith("#"):
            continue
        where = f"line {number} of {path}"
        hashed, caller = parse_line(line, where)
        if hashed in callers:
            raise BadTokens(f"{where} repeats the token {token_id(hashed)}")
        callers[hashed] = caller
    return callers


def parse_line(line: str, where: str) -> tuple[str, Caller]:
    """The hash and the caller of a line. Raises BadTokens."""
    if ":sha256=" not in line:
        raise BadTokens(f"{where} has no sha256=HEX: tokens are stored as hashes")
    entry = parse_entry(line, where)
    # `account:read:zz:sha256=HEX` would be an entry whose token is `zz:sha256=HEX`.
    if not _LINE.fullmatch(line.strip()):
        raise BadTokens(f"{where} is not account:scopes:sha256=HEX with 64 digits")
    return entry


@contextlib.contextmanager
def edited_lines(path: Path) -> Iterator[list[str]]:
    """The lines of the file, to be changed; they replace the file at once.

    Two who edit at the same time do so one after the other. Raises OSError and, for a
    file that the server would refuse, BadTokens.
    """
    path = path.resolve()  # a link stays one, to the file that is replaced
    lock = path.with_name(f"{path.name}.lock")
    create_empty(lock)
    with lock.open() as held:
        fcntl.flock(held, fcntl.LOCK_EX)
        restrict(path)
        content = read_bytes(path) if path.exists() else b""
        parse(content, path)
        lines = (content.decode() or HEAD).splitlines()
        yield lines
        content = "".join(f"{line}\n" for line in lines).encode()
        parse(content, path)
        replace_file(path, content, is_private=True)
