"""`python -m reference_server`: start the server and print how to call it.

Reads the settings, binds the socket, checks that the database and the encryption key
can be used, listens, and runs uvicorn. A failure to start is one line on stderr
and an exit code; the parts of the server are put together in `app`.
"""

from __future__ import annotations

import gc

if __name__ == "__main__":
    gc.disable()  # a tenth of the start: nothing is garbage before it serves

import asyncio
import contextlib
import os
import re
import socket
import sys
from pathlib import Path
from typing import TYPE_CHECKING

import uvicorn

from reference_record.broken import UnusableRecord
from reference_record.command_line.click_commands import WrongUsage
from reference_record.command_line.closed_output import run_program
from reference_record.command_line.installation import install_command
from reference_record.command_line.listening import CannotListen, bind, listen
from reference_record.this_machine import unusable_temporary_folder
from reference_server.app import build
from reference_server.assembly.kept_files import StartRefused, open_kept_files
from reference_server.assembly.node_parts import compare_node, shared_folder
from reference_server.assembly.run_parts import Secrets
from reference_server.files.object_storage import storage_at
from reference_server.http.auth import BadTokens, Tokens
from reference_server.http.connections.bounded_connection import connection_factory
from reference_server.http.connections.connection_limits import (
    ConnectionLimiter,
    ConnectionLimits,
)
from reference_server.http.connections.draining_server import Drain, DrainingServer
from reference_server.http.handlers import SOFTWARE_VERSION
from reference_server.http.tokens import made_token
from reference_server.process import open_files
from reference_server.records.run_records import open_key
from reference_server.records.shared_folder import NotShared, watch_nodes
from reference_server.settings import Settings
from reference_server.settings.allowed_hosts import own_address
from reference_server.settings.setting_options import (
    misspelled_variables,
    read_settings,
)
from reference_server.storage.connection.existing_database import holds_runs
from reference_server.storage.connection.server_lock import lock_of
from reference_server.storage.folder_id import OtherFiles, claim_folder
from reference_server.storage.node_store import NodeStore
from reference_server.storage.runs.run_store import Store, StoreFailed
from reference_server.storage.tables.schema_version import OtherVersion
from reference_server.telemetry.log_output import log_config
from reference_sim import benchmark_registry
from reference_sim.gymnasium import BadBenchmark
from reference_sim.process.ray.actor_process import CannotUseRay
from reference_sim.process.ray.ray_pool import check_cluster
from reference_sim.ray_resources import format_resources, parse_resources
from reference_sim.replay import host_benchmarks

if TYPE_CHECKING:
    from reference_server.monitoring.traces import Traces

THREAD_SWITCH_S = 0.001


def main() -> int:
    """Returns the exit code; a failure to start is 2 and one line on stderr."""
    return run_program(_start)


def _start() -> int:
    try:
        for line in misspelled_variables(os.environ):
            _print_line(line)
        if line := unusable_temporary_folder():
            _print_line(line)
        settings = read_settings(sys.argv[1:])
        tokens = Tokens.parse(settings.tokens) if settings.tokens else None
    except WrongUsage as error:
        _print_line(str(error))
        return 2
    except BadTokens as error:
        _print_line(f"bad settings: {error}")
        return 2
    try:
        benchmark_registry.add(settings.benchmark_references, _print_line)
    except BadBenchmark as error:
        _print_line(str(error))
        return 2
    except KeyboardInterrupt:  # loading benchmarks may take a minute
        return 130
    with contextlib.ExitStack() as stack:
        try:
            listener = stack.enter_context(bind(settings.host, settings.port))
            metrics_listener = None
            if settings.metrics == "on":
                metrics_listener = stack.enter_context(
                    bind(settings.metrics_host, settings.metrics_port, "--metrics-port")
                )
        except CannotListen as error:
            _print_line(str(error))
            return 2
        return _serve(listener, metrics_listener, settings, tokens)


def _print_line(line: str) -> None:
    print(f"proctor: {line}{_option_of_make(line)}", file=sys.stderr, flush=True)


def _option_of_make(line: str) -> str:
    """How `make serve` passes on the option that the line advises."""
    advised = re.search(r" with (--[a-z-]+)", line)
    if advised is None or "MAKELEVEL" not in os.environ:
        return ""
    return f" (make serve ARGS='{advised[1]} …')"


def _serve(
    listener: socket.socket,
    metrics_listener: socket.socket | None,
    settings: Settings,
    configured: Tokens | None,
) -> int:
    try:
        port = listener.getsockname()[1]
        settings.node_url = settings.node_url or _url(settings.host, port)
        traces = _traces_of(settings)
        for check in _CHECKS:
            check(settings)
        path = settings.token_path
        # Where the output goes to a log, the secret is in there once.
        shows_token = sys.stdout.isatty() or not path.exists()
        made = None if configured else made_token.read_or_make(path)
        _publish(listener, None if made is None else path, is_own=made is not None)
        # Not before all is checked: who connects would wait in vain.
        listen(listener)
        if metrics_listener is not None:
            listen(metrics_listener, "--metrics-port")
    except (StartRefused, made_token.BadTokenFile, CannotListen) as error:
        _print_line(str(error))
        return 2
    tokens = configured or Tokens.of_local_account(str(made))
    limiter = ConnectionLimiter(_connection_limits(settings))
    app = build(settings, tokens, limiter, metrics_listener, traces)
    config = uvicorn.Config(
        app,
        http=connection_factory(limiter, app.direct),
        ws="none",  # none is offered, and it would have none of the bounds
        log_level=settings.log_level,
        log_config=log_config(
            settings.log_level,
            settings.log_format,
            access=settings.access_log == "on",
        ),
        access_log=False,  # ours has the account and the id of the request
        server_header=False,
    )
    message = _startup_message(settings, port, made, shows_token=shows_token)
    if metrics_listener is not None:
        at = _url(settings.metrics_host, metrics_listener.getsockname()[1])
        message += f"\nmetrics: {at}/metrics"
    drain = Drain(
        app.begin_drain,
        app.turns_in_progress,
        settings.drain_notice_s,
        settings.drain_s,
    )
    server = DrainingServer(config, message, drain)
    # Modules stay for good. Long lists bring about full collections, and each would go
    # through them for 70 ms in which nothing is answered.
    gc.freeze()
    gc.enable()
    # A large body is read in a thread. Whatever else runs waits for that thread so long
    # at each change of threads, and a turn has several; 5 ms are Python's default.
    sys.setswitchinterval(THREAD_SWITCH_S)
    # uvicorn shuts down in order and then raises Ctrl-C again. It exits by itself when
    # the start is refused; the log says why.
    try:
        with contextlib.suppress(KeyboardInterrupt):
            server.run(sockets=[listener])
    except SystemExit:
        if server.started:
            raise
    return 0 if server.started else 2


def _publish(listener: socket.socket, token_path: Path | None, *, is_own: bool) -> None:
    """Let programs of this account find the token, and the benchmarks of its own."""
    try:
        made_token.publish(listener, token_path)
        references = benchmark_registry.own_references() if is_own else {}
        host_benchmarks.publish(listener.getsockname()[1], references)
    except (WrongUsage, RuntimeError) as error:  # or there is no home directory
        if is_own:  # otherwise an earlier entry may stay, and nothing is missed
            _print_line(str(error))


def _check_database_and_keys(settings: Settings) -> None:
    try:
        runner = asyncio.Runner()
        has_runs = runner.run(_check_store(settings))
        runner.close()  # not on failure: a thread of the database driver may be alive
    except OtherFiles as error:
        raise StartRefused(str(error)) from error
    except StoreFailed as error:
        refused = f"cannot use the database ({error})"
        if not isinstance(error.__cause__, OtherVersion):  # its text has the ways out
            refused += "; choose another with --database"
        raise StartRefused(refused) from error
    made = open_kept_files(settings)
    if has_runs and made:
        names = ", ".join(str(path.absolute()) for path in made)
        _print_line(
            f"the database has runs, and without a file or folder that was made for "
            f"them: {names} is new; if a backup has it, stop the server and restore it"
        )
    beside = [] if has_runs else filter(holds_runs, settings.databases_beside)
    for other in beside:
        _print_line(
            f"the database has no run yet; those of {other} stay there, and cannot be "
            f"moved: to go on with them, start the server with --database {other}"
        )


def _check_storage(settings: Settings) -> None:
    """Refuse to start where finished recordings could not be kept."""
    storage = storage_at(settings.records_storage)
    if storage is None or settings.recordings == "off":
        return
    try:
        storage.check()
    except OSError as error:
        raise StartRefused(
            f"cannot use {storage.url} ({error}); see --records-storage"
        ) from error


def _check_cluster(settings: Settings) -> None:
    """Refuse to start a node that records, signs or draws apart from the others."""
    if settings.cluster == "off":
        return
    try:
        asyncio.run(_compare_node(settings))
    except StoreFailed as error:
        raise StartRefused(f"cannot use the database ({error})") from error
    except NotShared as error:
        raise StartRefused(str(error)) from error
    except (OSError, UnusableRecord) as error:
        raise StartRefused(
            f"cannot use {settings.records_path}, or the key in "
            f"{settings.signing_key_path} ({error}); see --records-dir and "
            "--signing-key"
        ) from error


async def _compare_node(settings: Settings) -> None:
    secrets = Secrets.of(settings)
    secrets.open()
    records = settings.recordings != "off"
    keyid = open_key(settings.signing_key_path).keyid if records else None
    store = Store(settings.database_url, is_shared=True)
    nodes = NodeStore(store, settings.node_lease_s)
    try:
        await compare_node(nodes, settings.node_url, settings, secrets, keyid)
        folder = shared_folder(settings)
        if folder is not None:
            await watch_nodes(nodes, settings.node_url, folder)
    finally:
        await store.close()


def _check_simulators(settings: Settings) -> None:
    """Each machine of a Ray cluster is looked at before the server listens."""
    if settings.simulators == "local":
        return
    kinds = _simulators_of(settings)
    try:
        machines = asyncio.run(
            check_cluster(settings.simulators, list(map(parse_resources, kinds)))
        )
    except (CannotUseRay, OSError) as error:
        raise StartRefused(f"cannot use Ray for simulators: {error}") from error
    for (resources, declared_by), machine in zip(kinds.items(), machines, strict=True):
        if not machine:
            of = f" of {', '.join(declared_by)}" if declared_by else ""
            _print_line(
                f"no machine of the Ray cluster has {resources} for a simulator{of} "
                "yet; turns are refused as no_capacity until one joins"
            )


# All that may refuse a start, beside the tokens.
_CHECKS = (
    _check_database_and_keys,
    _check_storage,
    _check_cluster,
    _check_simulators,
)


def _simulators_of(settings: Settings) -> dict[str, list[str]]:
    """Resources of simulators → the benchmarks that declare them.

    The setting comes first, with an empty list: it is for all other benchmarks.
    """
    default = format_resources(parse_resources(settings.ray_resources))
    kinds: dict[str, list[str]] = {default: []}
    for benchmark_id in benchmark_registry.benchmark_ids():
        declared = format_resources(benchmark_registry.ray_resources(benchmark_id))
        if declared not in ("", default):
            kinds.setdefault(declared, []).append(benchmark_id)
    return kinds


def _traces_of(settings: Settings) -> Traces | None:
    """The traces, if they are set. Their library is imported only then: it is large."""
    if not settings.traces:
        return None
    try:
        from reference_server.monitoring.traces import Traces

        return Traces(
            settings.traces,
            settings.traces_ratio,
            version=SOFTWARE_VERSION,
            instance=settings.node_url,
        )
    except ImportError as error:
        raise StartRefused(
            "--traces needs the packages of OpenTelemetry: "
            f"{install_command('server,traces')}"
        ) from error
    except ValueError as error:
        raise StartRefused(f"cannot use --traces: {error}") from error


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


async def _check_store(settings: Settings) -> bool:
    """Open it as the only server, or as a node; returns whether it has runs."""
    url, is_shared = settings.database_url, settings.cluster == "on"
    lock, store = lock_of(url, lambda: None, is_shared=is_shared), Store(url)
    try:
        await lock.acquire()
        upgraded = await store.open()
        if settings.folder_id_path is not None:
            await claim_folder(store.transactions, settings.folder_id_path)
        has_runs = bool(await store.page(None, None, 1))
    finally:
        await store.close()
        await lock.release()
    if upgraded is not None:
        _print_line(f"the database was upgraded to version {upgraded.after}")
    return has_runs


def _url(host: str, port: int) -> str:
    return f"http://[{host}]:{port}" if ":" in host else f"http://{host}:{port}"


def _startup_message(
    settings: Settings, port: int, secret: str | None, *, shows_token: bool
) -> str:
    url = _url(settings.host, port)
    lines = [f"Proctor listens at {url}"]
    if (here := own_address(settings.host)) != settings.host:
        url = _url(here, port)
        lines += ["from other machines:", _url(socket.gethostname(), port)]
    if secret is not None:
        lines += made_token.startup_lines(
            secret, settings.token_path, url, is_shown=shows_token
        )
    if settings.pages == "on":
        lines.append(f"pages: {url}/pages")
    lines += ["benchmarks:", *map("  {}".format, benchmark_registry.benchmark_ids())]
    if settings.enabled_profiles:
        lines.append(f"profiles: {', '.join(settings.enabled_profiles)}")
    if "://" not in settings.database:  # a URL may have a password
        lines.append(f"database: {settings.database}")
    return "\n".join(lines)


if __name__ == "__main__":
    sys.exit(main())
