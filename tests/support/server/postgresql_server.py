"""PostgreSQL for tests: from a wheel, in a folder of its own, without a network.

It is started as the account, and from the programs, that `make cluster` uses.
"""

from __future__ import annotations

import asyncio
import contextlib
import os
import secrets
import shutil
import signal
import subprocess
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any, Self

from tests.support.network.hosts import NETWORK, Host
from tests.support.processes import descendants
from tests.support.waiting import wait_until
from tools.local_cluster.local_postgresql import (
    ACCOUNT,
    AS_ACCOUNT,
    IS_ROOT,
    give,
    provide_programs,
)

PASSWORD = "of-tests"
# Of the Debian package libfaketime; a clock of its own needs it.
LIBFAKETIME = next(Path("/usr/lib").glob("*/faketime/libfaketime.so.1"), None)


class PostgresqlServer:
    """A server that runs once constructed, with databases that `create` makes.

    As a context manager it is removed at the end, with its data. has_clock: it has a
    clock of its own, which `shift_clock` changes. host: it listens there, too. primary:
    it is a standby of that one.
    """

    def __init__(
        self,
        *,
        has_clock: bool = False,
        host: Host | None = None,
        primary: PostgresqlServer | None = None,
    ) -> None:
        self._folder = Path(tempfile.mkdtemp(prefix="proctor-pg-"))
        self.host = host
        # Only root enters a host, and is the account there.
        self._as: dict[str, Any] = {"cwd": "/"} | (AS_ACCOUNT if host is None else {})
        self._data = self._folder / "data"
        self._data.mkdir(mode=0o700)
        self._clock = self._folder / "clock" if has_clock else None
        if has_clock:
            self.shift_clock(0)
        if IS_ROOT:
            self._folder.chmod(0o755)
        give(self._data)
        self.programs = provide_programs(self._folder)
        if primary is None:
            self._initialize()
        else:
            self._copy(primary)
        self.start()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.kill()
        shutil.rmtree(self._folder)

    def _initialize(self) -> None:
        password = self._folder / "password"
        password.write_text(PASSWORD)
        command: list[str | Path] = [
            *(self.programs / "initdb", "--pgdata", self._data, "--no-sync"),
            *("--username", "postgres", "--auth", "scram-sha-256"),
            *("--pwfile", password, "--encoding", "UTF8", "--no-locale"),
        ]
        self._run(command)
        if self.host is not None:
            with (self._data / "pg_hba.conf").open("a") as file:
                for database in ("all", "replication"):
                    file.write(f"host {database} all {NETWORK} scram-sha-256\n")

    def _copy(self, primary: PostgresqlServer) -> None:
        """Take what a primary has now, to follow it from then on."""
        assert primary.host is not None
        where = f"host={primary.host.address} user=postgres password={PASSWORD}"
        # A primary that is away is noticed, and one that is back is found soon.
        timeouts = "connect_timeout=2 keepalives_idle=2 keepalives_interval=1"
        command: list[str | Path] = [
            *(self.programs / "pg_basebackup", "--pgdata", self._data, "--no-sync"),
            *("--dbname", f"{where} {timeouts}", "--write-recovery-conf"),
            *("--checkpoint", "fast"),
        ]
        self._run(command)
        for file in self._data.glob(".s.PGSQL.*"):  # of the other one
            file.unlink()

    def _command(self, command: list[str | Path]) -> list[str | Path]:
        """As it is run where the server is."""
        return command if self.host is None else self.host.command(command, ACCOUNT)

    def _run(self, command: list[str | Path]) -> None:
        done = subprocess.run(
            self._command(command), check=False, capture_output=True, **self._as
        )
        assert done.returncode == 0, done.stderr.decode()

    def start(self) -> None:
        """Start it, again after `kill`; returns when it takes connections."""
        settings = {
            "listen_addresses": "" if self.host is None else self.host.address,
            "unix_socket_directories": str(self._data),
            "fsync": "off",
            # A node whose host was lost leaves its connections for some seconds.
            "max_connections": "40" if self.host is None else "100",
            "shared_buffers": "16MB",
        }
        options = [
            part for key in settings for part in ("-c", f"{key}={settings[key]}")
        ]
        with (self._folder / "log").open("ab") as log:
            self.process = subprocess.Popen(
                self._command([self.programs / "postgres", "-D", self._data, *options]),
                stdout=log,
                stderr=log,
                env=self._environment(),
                **self._as,
            )
        wait_until(self._is_ready, "PostgreSQL takes connections")

    def _is_ready(self) -> bool:
        assert self.process.poll() is None, (self._folder / "log").read_text()
        # No driver: one whose connection is refused leaves a transport behind.
        ready = self.programs / "pg_isready"
        command: list[str | Path] = [ready, "--quiet", "--host", self._data]
        return subprocess.run(command, check=False).returncode == 0

    def _environment(self) -> dict[str, str]:
        if self._clock is None:
            return dict(os.environ)
        return os.environ | {
            "LD_PRELOAD": str(LIBFAKETIME),
            "FAKETIME_TIMESTAMP_FILE": str(self._clock),
            "FAKETIME_NO_CACHE": "1",
            "FAKETIME_DONT_FAKE_MONOTONIC": "1",
        }

    def shift_clock(self, by_s: float) -> None:
        """Let its clock be wrong by so much, from the next look at it on."""
        assert self._clock is not None
        new = self._clock.with_suffix(".new")
        new.write_text(f"{by_s:+f}")
        new.chmod(0o644)
        new.replace(self._clock)

    def limit_files(self, size: int | None) -> None:
        """Let writes beyond a size fail, as on a full disk; None: no longer."""
        main = self.process.pid
        for pid in (main, *descendants(main)):
            limit = "unlimited" if size is None else str(size)
            command = ["prlimit", "--pid", str(pid), f"--fsize={limit}:"]
            # Its own account may: root may not where it has few capabilities.
            subprocess.run(command, check=False, capture_output=True, **self._as)

    def wait_for_standby(self, *, waits: bool) -> None:
        """Whether a commit waits until a standby has it, from now on."""
        names = "*" if waits else ""
        with (self._data / "postgresql.conf").open("a") as file:
            file.write(f"synchronous_standby_names = '{names}'\n")
        self.process.send_signal(signal.SIGHUP)

    def kill(self) -> None:
        """End it at once: each connection is lost."""
        with contextlib.suppress(ProcessLookupError):
            self.process.send_signal(signal.SIGQUIT)
        self.process.wait()

    def create(self) -> str:
        """The URL of a new, empty database."""
        name = f"test_{secrets.token_hex(6)}"
        self.execute("postgres", f"CREATE DATABASE {name}")
        return self.url(name)

    def url(self, name: str, password: str = PASSWORD) -> str:
        return f"postgresql://postgres:{password}@/{name}?host={self._data}"

    def execute(self, name: str, *statements: str) -> list[tuple[Any, ...]]:
        """The rows of the last of these statements, run in one transaction."""

        async def run() -> list[tuple[Any, ...]]:
            # Environments apart import this module with the fixtures, and have no such
            # package.
            import asyncpg

            connection = await asyncpg.connect(
                user="postgres", password=PASSWORD, host=str(self._data), database=name
            )
            try:
                if statements[0].startswith("CREATE DATABASE"):
                    await connection.execute(statements[0])
                    return []
                async with connection.transaction():
                    for statement in statements[:-1]:
                        await connection.execute(statement)
                    return [
                        tuple(row) for row in await connection.fetch(statements[-1])
                    ]
            finally:
                await connection.close()

        # In a loop of its own: the caller may be a coroutine.
        with ThreadPoolExecutor(1) as thread:
            return thread.submit(asyncio.run, run()).result()
