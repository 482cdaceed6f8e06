"""`python -m reference_server`: start the server and print how to call it.

Reads the settings, opens the listening socket, checks that the database and the
encryption key can be used, and runs uvicorn. A failure to start is one line on stderr
and an exit code; the parts of the server are put together in `app`.
"""

from __future__ import annotations

import argparse
import asyncio
import contextlib
import socket
import sys
from collections.abc import Callable, Mapping
from typing import ClassVar

import uvicorn
from pydantic import ValidationError
from pydantic_settings import CliSettingsSource, SettingsError

from reference_server.app import build
from reference_server.http.auth import BadTokens, Tokens
from reference_server.http.connections.bounded_connection import connection_factory
from reference_server.http.connections.connection_limits import (
    ConnectionLimiter,
    ConnectionLimits,
)
from reference_server.http.tokens import made_token
from reference_server.http.tokens.token_file import TokenFile
from reference_server.push.key_encryption import KeyEncryption
from reference_server.runs.seed_secret import SeedSecret
from reference_server.settings import Settings
from reference_server.storage.store import Store, StoreFailed
from reference_server.system import open_files
from reference_server.system.log_output import log_config
from reference_sim import benchmark_registry
from reference_sim.gymnasium import BadBenchmark


class HelpFormatter(argparse.RawDescriptionHelpFormatter):
    """`--help` without the defaults that are empty, and with readable placeholders."""

    _PLACEHOLDERS: ClassVar[Mapping[str, str]] = {
        "str": "TEXT",
        "int": "N",
        "float": "SECONDS",
    }

    def _get_help_string(self, action: argparse.Action) -> str:
        return (action.help or "").removesuffix(" (default: )")

    def _metavar_formatter(
        self, action: argparse.Action, default_metavar: str
    ) -> Callable[[int], tuple[str, ...]]:
        names = super()._metavar_formatter(action, default_metavar)
        shown = self._PLACEHOLDERS
        if any(flag.endswith("-days") for flag in action.option_strings):
            shown = {**shown, "float": "DAYS"}
        return lambda size: tuple(shown.get(n, n) for n in names(size))


class Server(uvicorn.Server):
    """uvicorn, with a message when it accepts requests and a callback when it ends."""

    def __init__(
        self,
        config: uvicorn.Config,
        startup_message: str,
        on_shutdown: Callable[[], None],
    ) -> None:
        super().__init__(config)
        self._startup_message = startup_message
        self._on_shutdown = on_shutdown

    async def startup(self, sockets: list[socket.socket] | None = None) -> None:
        await super().startup(sockets)
        if self.started:
            print(self._startup_message, flush=True)

    async def shutdown(self, sockets: list[socket.socket] | None = None) -> None:
        self._on_shutdown()
        await super().shutdown(sockets)


def main() -> int:
    """Returns the exit code; a failure to start is 2 and one line on stderr."""
    try:
        source: CliSettingsSource[Settings] = CliSettingsSource(
            Settings, cli_parse_args=sys.argv[1:], formatter_class=HelpFormatter
        )
        settings = Settings(_cli_settings_source=source)
        tokens = Tokens.parse(settings.tokens) if settings.tokens else None
    except (ValidationError, SettingsError, BadTokens) as error:
        print(f"proctor: bad settings: {_one_line(error)}", file=sys.stderr)
        return 2
    try:
        benchmark_registry.add(settings.benchmarks, _print_line)
    except BadBenchmark as error:
        print(f"proctor: {error}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:  # loading benchmarks may take a minute
        return 130
    family = socket.AF_INET6 if ":" in settings.host else socket.AF_INET
    # asyncio sets TCP_NODELAY only if the protocol is given; without it each response
    # waits 40 ms for an acknowledgement.
    with socket.socket(family, socket.SOCK_STREAM, socket.IPPROTO_TCP) as listener:
        return _serve(listener, settings, tokens)


def _print_line(line: str) -> None:
    print(f"proctor: {line}", file=sys.stderr, flush=True)


def _serve(
    listener: socket.socket, settings: Settings, configured: Tokens | None
) -> int:
    listener.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    try:
        listener.bind((settings.host, settings.port))
    except OSError as error:
        _print_line(
            f"cannot listen on {settings.host}:{settings.port} "
            f"({error.strerror}); choose another with --port"
        )
        return 2
    try:
        _check_database_and_keys(settings)
        made = None if configured else made_token.read_or_make(settings.token_path)
        TokenFile(settings.tokens_file_path, Tokens({})).read()
    except (_CannotUse, made_token.BadTokenFile, BadTokens, OSError) as error:
        _print_line(str(error))
        return 2
    port = listener.getsockname()[1]
    made_token.publish(port, None if made is None else settings.token_path)
    tokens = configured or Tokens.of_local_account(str(made))
    app = build(settings, tokens)
    config = uvicorn.Config(
        app,
        http=connection_factory(ConnectionLimiter(_connection_limits(settings))),
        ws="none",  # none is offered, and it would have none of the bounds
        log_level=settings.log_level,
        log_config=log_config(
            settings.log_level,
            settings.log_format,
            access=settings.access_log == "on",
        ),
        access_log=False,  # ours has the account and the id of the request
        server_header=False,
        timeout_graceful_shutdown=5,
    )
    message = _startup_message(settings, port, made)
    server = Server(config, message, app.on_shutdown)
    # uvicorn shuts down in order and then raises Ctrl-C again.
    with contextlib.suppress(KeyboardInterrupt):
        server.run(sockets=[listener])
    return 0 if server.started else 1


class _CannotUse(Exception):
    """The database or the key cannot be used; the text says what to do."""


def _check_database_and_keys(settings: Settings) -> None:
    try:
        runner = asyncio.Runner()
        runner.run(_check_store(settings.database_url))
        runner.close()  # not on failure: a thread of the database driver may be alive
    except StoreFailed as error:
        raise _CannotUse(
            f"cannot use the database ({error}); choose another with --database"
        ) from error
    try:
        KeyEncryption(settings.sealing_key_path).open()
    except (OSError, ValueError) as error:
        raise _CannotUse(
            f"cannot use the key in {settings.sealing_key_path} ({error}); choose "
            "another with --sealing-key"
        ) from error
    try:
        SeedSecret(settings.seed_secret_path).open()
    except (OSError, ValueError) as error:
        raise _CannotUse(
            f"cannot use the secret of sealed seeds in {settings.seed_secret_path} "
            f"({error}); choose another with --seed-secret"
        ) from error
    if settings.seed_secret_path is None and ":memory:" not in settings.database:
        _print_line(
            "the seeds of sealed splits last until this server stops, and so do runs "
            "that have them: name a file with --seed-secret"
        )


def _connection_limits(settings: Settings) -> ConnectionLimits:
    files = open_files.raise_limit()
    allowed = open_files.connections_allowed(files, settings.max_simulators)
    if allowed < settings.max_connections:
        _print_line(
            f"at most {allowed} connections, not {settings.max_connections}: this "
            f"process may have {files} open files"
        )
    connections = min(settings.max_connections, allowed)
    return ConnectionLimits(
        connections=connections,
        per_address=min(settings.max_connections_per_address, connections * 3 // 4),
        header_timeout_s=settings.request_timeout_s,
        body_grace_s=settings.request_timeout_s,
        body_bytes=settings.max_body_bytes,
    )


async def _check_store(url: str) -> None:
    store = Store(url)
    try:
        await store.open()
    finally:
        await store.close()


def _startup_message(settings: Settings, port: int, secret: str | None) -> str:
    name = f"[{settings.host}]" if ":" in settings.host else settings.host
    url = f"http://{name}:{port}"
    lines = [f"Proctor is listening at {url}"]
    if secret is not None:
        path = settings.token_path
        kept = "" if path is None else f"  (kept in {path.absolute()})"
        lines += [
            f"token: {secret}{kept}",
            "try:",
            f"  curl -H 'Authorization: Bearer {secret}' {url}/v1/benchmarks",
            "certify:",
            f"  make conformance URL={url} TOKEN={secret}",
        ]
    if settings.pages == "on":
        lines.append(f"pages: {url}/pages")
    lines.append(f"benchmarks: {', '.join(benchmark_registry.benchmark_ids())}")
    if settings.enabled_profiles:
        lines.append(f"profiles: {', '.join(settings.enabled_profiles)}")
    if "://" not in settings.database:  # a URL may have a password
        lines.append(f"database: {settings.database}")
    return "\n".join(lines)


def _one_line(error: Exception) -> str:
    if isinstance(error, ValidationError):
        faults = error.errors(include_url=False)
        return "; ".join(f"{'.'.join(map(str, f['loc']))}: {f['msg']}" for f in faults)
    return str(error)


if __name__ == "__main__":
    sys.exit(main())
