"""The servers of this user on this machine: their tokens, and where they listen.

A server that made its token leaves an entry in the user's folder of state. The folder
has one for each machine, since several may share a home, and in it a file for each
address and port. The entry names the listening socket and its process. An address and a
port prove nothing: another user may have them by now, or a tunnel to another machine.
"""

from __future__ import annotations

import contextlib
import json
import os
import socket
import struct
import subprocess
from collections import defaultdict
from collections.abc import Iterator
from dataclasses import dataclass
from ipaddress import IPv4Address, IPv6Address, ip_address
from pathlib import Path

from reference_record.command_line.replaced_file import replace_file
from reference_record.formats.private_file import read_private
from reference_record.formats.user_folders import state_folder

_ENTRY_BYTES_MAX = 1 << 16
_LSOF_S = 5.0
_LISTENING = "0A"  # as the kernel writes the state of a socket
_KERNEL_TABLES = (Path("/proc/net/tcp"), Path("/proc/net/tcp6"))
_EVERY = (IPv4Address("0.0.0.0"), IPv6Address("::"))  # noqa: S104 - compared alone
_LOOPBACKS = (IPv4Address("127.0.0.1"), IPv6Address("::1"))
_Address = IPv4Address | IPv6Address


@dataclass(frozen=True, slots=True)
class LocalServer:
    """token_file: of its token. pid: its process. inode: of its listening socket."""

    token_file: str
    pid: int
    inode: int

    def is_at(self, address: str, port: int) -> bool | None:
        """Whether a connection to this address leads to it; None: nothing listens."""
        place = _plain(address)
        if not _KERNEL_TABLES[0].exists():
            return self._is_of_process(place, port)
        listeners = _listeners(port)
        nearest = filter(None, (listeners[text] for text in _takers(place)))
        found = next(nearest, None)
        return None if found is None else found == {(os.getuid(), self.inode)}

    def _is_of_process(self, place: _Address, port: int) -> bool | None:
        """As is_at, where lsof knows it. It shows no process of another user.

        A socket counts for its own family alone: one of the other may be another's.
        """
        family = f"-i{place.version}TCP:{port}"
        which = ["-u", str(os.getuid()), "-p", str(self.pid), family]
        command = ["lsof", "-nP", "-a", *which, "-sTCP:LISTEN", "-Fn"]
        try:
            shown = subprocess.run(
                command, check=False, capture_output=True, text=True, timeout=_LSOF_S
            )
        except (OSError, subprocess.TimeoutExpired):
            return False
        hosts = ("*", f"[{place}]" if place.version == 6 else str(place))
        if any(f"n{host}:{port}" in shown.stdout.splitlines() for host in hosts):
            return True
        with contextlib.suppress(OSError):
            socket.create_connection((str(place), port), _LSOF_S).close()
            return False
        return None


def entry_file(address: str, port: int) -> Path:
    """Where a server that listens there has its entry. RuntimeError without a home."""
    place = ip_address(address)
    return _folder() / f"{place if place in _EVERY else _plain(address)}-{port}"


def publish(listener: socket.socket, token_file: Path) -> None:
    """Leave the entry of a server of this process in place of an earlier one.

    Entries of files that are gone, or that the server had at another port, are removed.
    Raises OSError, and RuntimeError without a home.
    """
    path = entry_file(*listener.getsockname()[:2])
    inode = os.fstat(listener.fileno()).st_ino
    entry = {"token_file": str(token_file.absolute()), "pid": os.getpid()}
    path.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
    _remove_outdated(path, entry["token_file"])
    path.unlink(missing_ok=True)  # its rights may be those of others
    replace_file(path, json.dumps(entry | {"inode": inode}), is_private=True)


def find(url_host: str, port: int) -> Iterator[tuple[str, LocalServer]]:
    """Each address of the host, and the server of this user that takes it there.

    Left out are entries that other users could have written. Raises OSError for a host
    without an address, and RuntimeError without a home.
    """
    found = socket.getaddrinfo(url_host, port, type=socket.SOCK_STREAM)
    for address in dict.fromkeys(str(place[0]) for *_, place in found):
        for taker in (_plain(address), *_EVERY):
            with contextlib.suppress(OSError, ValueError, TypeError):
                yield address, _read(entry_file(str(taker), port))


def token_files() -> Iterator[Path]:
    """Those of all servers of this user that had an entry, on any machine."""
    for path in sorted(_folder().parent.glob("*/*")):
        with contextlib.suppress(OSError, ValueError, TypeError):
            yield Path(_read(path).token_file)


def _folder() -> Path:
    return state_folder() / "servers" / (socket.gethostname() or "localhost")


def _read(path: Path) -> LocalServer:
    return LocalServer(**json.loads(read_private(path, _ENTRY_BYTES_MAX)))


def _remove_outdated(path: Path, token_file: object) -> None:
    for other in path.parent.iterdir():
        with contextlib.suppress(OSError, ValueError, TypeError):
            server = _read(other)
            address, _, port = other.name.rpartition("-")
            is_earlier = server.token_file == token_file and (
                server.is_at(address, int(port)) is not True
            )
            is_gone = not Path(server.token_file).exists()
            if other != path and (is_earlier or is_gone):
                other.unlink()


def _plain(address: str) -> _Address:
    """The address at which a connection arrives."""
    place = ip_address(address)
    place = getattr(place, "ipv4_mapped", None) or place
    return _LOOPBACKS[_EVERY.index(place)] if place in _EVERY else place


def _takers(place: _Address) -> list[str]:
    """How the kernel writes the sockets that may take it, the nearest first."""
    takers: tuple[_Address, ...] = (place, _EVERY[1])
    if place.version == 4:
        takers = (place, IPv6Address(f"::ffff:{place}"), *_EVERY)
    return [_as_words(taker) for taker in takers]


def _as_words(place: _Address) -> str:
    words = struct.unpack(f"={len(place.packed) // 4}I", place.packed)
    return "".join(f"{word:08X}" for word in words)


def _listeners(port: int) -> defaultdict[str, set[tuple[int, int]]]:
    """User and inode of each socket that listens at the port, by its address."""
    found = defaultdict[str, set[tuple[int, int]]](set)
    for table in filter(Path.exists, _KERNEL_TABLES):
        for line in table.read_text().splitlines()[1:]:
            parts = line.split()
            address, _, at = parts[1].partition(":")
            if parts[3] == _LISTENING and int(at, 16) == port:
                found[address].add((int(parts[7]), int(parts[9])))
    return found
