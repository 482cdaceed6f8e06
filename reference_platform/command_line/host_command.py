"""`proctor-host`: starts the platform on a Unix socket, and a server that uses it.

Options behind `--` are for the server. Both end together: with a signal, or when one
of them ends.
"""

from __future__ import annotations

import asyncio
import contextlib
import fcntl
import os
import secrets
import shutil
import socket
import sqlite3
import sys
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import uvicorn

from reference_platform.accounts.account_rules import Account, SignUp
from reference_platform.accounts.openid import OpenIdProvider
from reference_platform.http.server_calls import ServerRuns
from reference_platform.mail.outbox import BadMailServer, MailServer
from reference_platform.parts import Parts
from reference_platform.platform_app import make_application
from reference_platform.sandbox.sandbox_interface import (
    MIB,
    Limits,
    SandboxUnavailable,
)
from reference_platform.storage.platform_database import BadDatabase, unusable
from reference_platform.storage.submissions_folder import (
    SUBMISSIONS,
    lock_of,
    note_folder,
)
from reference_platform.submissions.hosted_parts import (
    HostedParts,
    sockets_of,
)
from reference_platform.submissions.sandboxed_runner import PolicyTimes
from reference_platform.tracks.served_benchmarks import note_served
from reference_record.command_line.click_commands import (
    Command,
    Options,
    WrongUsage,
    amount,
    count,
    option,
    parse_options,
)
from reference_record.command_line.closed_output import ending_signals
from reference_server.files.private_files import create_empty
from reference_server.rules.refusal import Refused
from reference_server.settings import Settings
from reference_server.settings.allowed_hosts import is_loopback, own_address
from reference_server.settings.setting_options import read_settings

DATABASE = "var/platform.sqlite"
ADMINISTRATOR = "organiser"
SOCKET_CHARS_MAX = 100
END_S = 30.0
SERVER_WORDS: tuple[str, ...] = ("-m", "reference_server")
# The names of the environment, for what a command line should not show.
SMTP_VARIABLE = "PROCTOR_HOST_SMTP"
OPENID_VARIABLE = "PROCTOR_HOST_OPENID_SECRET"


class CannotStart(Exception):
    """The platform cannot start; the text says why and what to do."""


def build_command() -> Command:
    return Command(
        "proctor-host",
        "",
        [
            option(
                "--database", f"file of the platform ({DATABASE})", default=DATABASE
            ),
            option(
                "--smtp",
                "mail server, smtp://USER:PASSWORD@HOST:PORT or smtps://…; "
                f"${SMTP_VARIABLE}; without it no mail is sent",
                envvar=SMTP_VARIABLE,
            ),
            option(
                "--mail-from", "sender of mail (proctor@localhost)",
                default="proctor@localhost",
            ),
            option("--openid-issuer", "provider of a second sign-in", metavar="URL"),
            option("--openid-client-id", "of this host there", default=""),
            option(
                "--openid-client-secret", f"of this host there; ${OPENID_VARIABLE}",
                envvar=OPENID_VARIABLE, default="",
            ),
            option("--openid-name", "the provider on pages (OpenID)", default="OpenID"),
            option(
                "--administrator",
                f"first account, made if there is none ({ADMINISTRATOR})", default="",
            ),
            option(
                "--administrator-email",
                "its address then, which gets the mail of a host; the page Account "
                "changes it later", default="",
            ),
            option(
                "--submissions",
                f"folder of hosted submissions ({SUBMISSIONS}); off: none are run",
                default=SUBMISSIONS, metavar="FOLDER",
            ),
            option(
                "--sandboxes", "how many policies run at a time (1)",
                type=count, default=1, metavar="N",
            ),
            option(
                "--ray", "run the sandboxes on this Ray cluster, such as auto",
                default="", metavar="ADDRESS",
            ),
            option(
                "--policy-cpus", "processors of one sandbox (2)",
                type=amount, default=Limits().cpus, metavar="N",
            ),
            option(
                "--policy-memory-mib", "memory of one sandbox (4096)",
                type=amount, default=Limits().memory_bytes / MIB, metavar="N",
            ),
            option(
                "--policy-start-s", "how long a policy may take until it listens (120)",
                type=amount, default=PolicyTimes().listen_s, metavar="S",
            ),
            option(
                "--policy-call-s", "how long it may take for an answer (30)",
                type=amount, default=PolicyTimes().call_s, metavar="S",
            ),
        ],
        help_text="Host a challenge: accounts, keys, tracks and a server, as one "
        "command. Options of the server stand behind --.",
        epilog="proctor-host -- --port 8460 --public-url https://eval.example.org",
    )  # fmt: skip


def start() -> int:
    """The exit code; a failure to start is 2 and one line on stderr."""
    ours, theirs = _split(sys.argv[1:])
    try:
        options = parse_options(build_command(), ours)
        settings = read_settings(theirs)
        with _locked(Path(options.database)):
            note_folder(Path(options.database), options.submissions)
            return asyncio.run(_Host.of(options, settings, theirs).run())
    except (CannotStart, WrongUsage, BadDatabase, BadMailServer, OSError) as error:
        print(f"proctor-host: {error}", file=sys.stderr)
        return 2


def _split(arguments: Sequence[str]) -> tuple[Sequence[str], Sequence[str]]:
    if "--" not in arguments:
        return arguments, ()
    at = arguments.index("--")
    return arguments[:at], arguments[at + 1 :]


@contextlib.contextmanager
def _locked(database: Path) -> Iterator[None]:
    lock = lock_of(database)
    try:
        create_empty(lock)
    except OSError as error:
        raise CannotStart(unusable(database, error)) from error
    with lock.open() as held:
        try:
            fcntl.flock(held, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError as error:
            text = f"another proctor-host uses {database}; end it, or name another file"
            raise CannotStart(f"{text} with --database") from error
        yield


@dataclass(frozen=True, slots=True)
class _Host:
    """The platform and its server."""

    parts: Parts
    options: Options
    url: str
    socket_path: str
    server_command: Sequence[str]

    @classmethod
    def of(cls, options: Options, settings: Settings, theirs: Sequence[str]) -> _Host:
        path = Path(options.database)
        socket_path = str(path.absolute().with_suffix(".sock"))
        if len(socket_path) > SOCKET_CHARS_MAX:
            raise CannotStart(f"the path {socket_path} is too long for a Unix socket")
        mail = MailServer(options.smtp, options.mail_from) if options.smtp else None
        if mail is None:
            text = "no mail is sent without --smtp: it waits, and pages say so"
            print(f"proctor-host: {text}", file=sys.stderr)
        port = settings.port or _free_port(settings.host)
        host = own_address(settings.host)
        host = f"[{host}]" if ":" in host else host
        url = f"http://{host}:{port}"
        command = [
            *(sys.executable, *SERVER_WORDS, *theirs),
            *("--port", str(port), "--account-service", socket_path),
            *("--policy-sockets", str(sockets_of(Path(options.submissions)))),
        ]
        if settings.allowed_hosts:  # the platform is a client of its server, too
            command += ["--allowed-hosts", f"{settings.allowed_hosts},{host}"]
        return cls(
            Parts.of(
                path,
                mail,
                public_url=settings.public_url,
                openid=_openid(options),
                local_url=url if is_loopback(settings.host) else "",
            ),
            options,
            url,
            socket_path,
            command,
        )

    async def run(self) -> int:
        """Until a signal, or until one of both ends."""
        self.parts.database.wait_briefly()
        runs = ServerRuns(self.url)
        hosted = await self._hosted(runs)
        config = uvicorn.Config(
            make_application(self.parts, runs, hosted),
            # The server is the only client, and names its own.
            proxy_headers=True,
            forwarded_allow_ips="*",
            log_level="warning",
            server_header=False,
            timeout_graceful_shutdown=2,
        )
        platform = _Platform(config)
        listener = await asyncio.to_thread(_listen, self.socket_path)
        serving = asyncio.create_task(platform.serve([listener]))
        try:
            while not platform.started:
                if serving.done():
                    return 2
                await asyncio.sleep(0.01)
            return await self._run_server(runs)
        finally:
            platform.should_exit = True
            await serving
            self.parts.database.close()

    async def _hosted(self, runs: ServerRuns) -> HostedParts | None:
        """None, with a line on stderr, where this host cannot run submissions."""
        if self.options.submissions == "off":
            return None
        folder = await asyncio.to_thread(Path(self.options.submissions).absolute)
        try:
            hosted = HostedParts.of(
                folder,
                self.parts.submissions,
                runs.tokens,
                self.url,
                at_once=self.options.sandboxes,
                times=PolicyTimes(
                    self.options.policy_start_s, self.options.policy_call_s
                ),
                limits=Limits(
                    self.options.policy_cpus, int(self.options.policy_memory_mib * MIB)
                ),
                cluster=self.options.ray,
                history=runs,
            )
            await hosted.try_sandbox()
        except (SandboxUnavailable, OSError) as error:
            text = "This host runs no submissions"
            print(f"proctor-host: {text}: {error}", file=sys.stderr)
            return None
        print(f"proctor-host: sandboxes: {hosted.enforcement()}", file=sys.stderr)
        return hosted

    async def _run_server(self, runs: ServerRuns) -> int:
        server = await asyncio.create_subprocess_exec(
            *_ending_with_us(), *self.server_command
        )
        loop = asyncio.get_running_loop()
        for number in ending_signals():
            loop.add_signal_handler(number, _end, server, number)
        ended = asyncio.create_task(server.wait())
        announced = asyncio.create_task(self._announce(runs))
        try:
            await asyncio.wait((ended, announced), return_when=asyncio.FIRST_COMPLETED)
            if announced.done():
                announced.result()
            code = await ended
            return code if code >= 0 else 128 - code  # as a shell shows a signal
        finally:
            announced.cancel()
            if server.returncode is None:
                server.terminate()
                with contextlib.suppress(TimeoutError):
                    await asyncio.wait_for(server.wait(), END_S)

    async def _announce(self, runs: ServerRuns) -> None:
        """Once the server has its port, which another program may have."""
        await runs.server_has_started.wait()
        await self._note_served(runs)
        await self._make_administrator()
        print(f"proctor-host: {self.url}/hosting", flush=True)

    async def _note_served(self, runs: ServerRuns) -> None:
        """Only tracks that are put need them: a host without them is no worse."""
        try:
            benchmarks = await runs.read_benchmarks()
            await self.parts.database.until_free()
            note_served(self.parts.database, benchmarks)
        except (Refused, sqlite3.OperationalError) as error:
            text = "which benchmarks the server has is not known to `track put` now"
            print(f"proctor-host: {text}: {error}", file=sys.stderr)

    async def _make_administrator(self) -> None:
        """The first account, which can approve the others."""
        accounts = self.parts.accounts
        there = [one for one in accounts.in_state("approved") if one.is_administrator]
        if there:
            for text in ignored_options(self.options, there):
                print(f"proctor-host: {text}", file=sys.stderr)
            return
        password = secrets.token_urlsafe(12)
        name = self.options.administrator or ADMINISTRATOR
        filled = SignUp(
            account=name, full_name="Administrator", organisation="Host",
            email=self.options.administrator_email or "administrator@localhost.local",
            password=password, agrees=True,
        )  # fmt: skip
        await accounts.register(filled, "administrator")
        accounts.decide(name, "approve", "", "proctor-host")
        text = f"proctor-host: administrator {name}, password, shown this once:"
        print(f"{text}\n{password}", flush=True)


def ignored_options(options: Options, there: Sequence[Account]) -> list[str]:
    """A sentence on each option of the first account that came too late.

    there: the administrators.
    """
    texts = []
    names = [account.account for account in there]
    described = ", ".join(f"{one.account} with {one.email}" for one in there)
    if options.administrator not in ("", *names):
        texts.append(
            f"--administrator {options.administrator} is ignored, as there is "
            f"{described}; `proctor admin account add` makes another account"
        )
    email = options.administrator_email
    if email.lower() not in ("", *(account.email.lower() for account in there)):
        texts.append(
            f"--administrator-email {email} is ignored, as there is {described}; "
            "change the address on the page Account"
        )
    return texts


def _ending_with_us() -> Sequence[str]:
    """Words that make a program end when this process is killed, if there are any."""
    if shutil.which("setpriv") is None:
        return ()
    return ("setpriv", "--pdeathsig", "KILL", "--")


class _Platform(uvicorn.Server):
    """Signals are for the host, which ends it last."""

    @contextlib.contextmanager
    def capture_signals(self) -> Iterator[None]:
        yield


def _end(server: asyncio.subprocess.Process, number: int) -> None:
    """A second signal ends the server at once, as it does by itself."""
    with contextlib.suppress(ProcessLookupError):
        server.send_signal(number)


def _openid(options: Options) -> OpenIdProvider | None:
    if not options.openid_issuer:
        return None
    return OpenIdProvider(
        options.openid_issuer, options.openid_client_id, options.openid_client_secret,
        options.openid_name,
    )  # fmt: skip


def _listen(path: str) -> socket.socket:
    """A socket that only this user can connect to; another one there was left over."""
    Path(path).unlink(missing_ok=True)
    listener = socket.socket(socket.AF_UNIX)
    before = os.umask(0o177)
    try:
        listener.bind(path)
    finally:
        os.umask(before)
    return listener


def _free_port(host: str) -> int:
    family = socket.AF_INET6 if ":" in host else socket.AF_INET
    with socket.socket(family) as listener:
        listener.bind((host, 0))
        port: int = listener.getsockname()[1]
    return port
