"""The ASGI application: the parts put together, and what holds for every response.

It decides no rule; each part is configured and connected here and nowhere else.
"""

from __future__ import annotations

import logging
import signal
import socket
import time
import typing
from collections.abc import AsyncIterator, Awaitable, Callable, Mapping
from contextlib import AbstractAsyncContextManager, asynccontextmanager
from functools import partial
from typing import Protocol

from starlette.requests import Request
from starlette.responses import Response
from starlette.routing import BaseRoute, Route, Router
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from reference_record.formats.merkle_tree import leaf_hash
from reference_record.formats.opened_seeds import load_opened_seeds
from reference_server.cluster.server_node import ServerNode
from reference_server.generated.protocol_version import PROTOCOL_VERSION
from reference_server.http.allowed_hosts import AllowedHosts
from reference_server.http.auth import Tokens
from reference_server.http.connections.connection_limits import ConnectionLimiter
from reference_server.http.dispatch import (
    ACCOUNT,
    OPERATION,
    Operation,
    operation_name,
    perform,
)
from reference_server.http.event_streams import SharedStreams
from reference_server.http.handlers import SOFTWARE_VERSION, Handlers
from reference_server.http.pages.page_routes import Pages
from reference_server.http.pages.page_sessions import PATH as PAGES_PATH
from reference_server.http.problems import problem_response
from reference_server.http.tokens.token_file import TokenFile
from reference_server.monitoring.health import health_routes
from reference_server.monitoring.metrics import ReadState, ServerState, metrics_route
from reference_server.monitoring.metrics_listener import MetricsListener
from reference_server.monitoring.readiness import Readiness
from reference_server.monitoring.request_spans import RequestSpans
from reference_server.profiles.operation_tables import profile_tables
from reference_server.push.driver import PROTOCOLS, Driver
from reference_server.push.egress import EgressPolicy
from reference_server.push.key_encryption import KeyEncryption
from reference_server.push.policy_server_validator import PolicyServerValidator
from reference_server.records.board_history import BoardHistory
from reference_server.records.record_imports import ImportSettings, RecordImports
from reference_server.records.recordings import Recordings
from reference_server.records.run_records import HostSettings, RunRecords
from reference_server.records.shared_folder import check_shared, show_node
from reference_server.rules.capacity import Quota
from reference_server.rules.imported_record import ImportUsage
from reference_server.rules.refusal import Refused
from reference_server.rules.run_owner import NodeRefused
from reference_server.rules.submission import SubmissionLimits
from reference_server.runs.benchmarks import Benchmarks
from reference_server.runs.board_service import BoardService
from reference_server.runs.registry import RunRegistry
from reference_server.runs.service import (
    RunService,
    no_command_elsewhere,
    no_views_elsewhere,
)
from reference_server.runs.session_executor import SessionExecutor
from reference_server.settings import Settings
from reference_server.storage.board_store import BoardStore
from reference_server.storage.import_store import ImportStore
from reference_server.storage.node_store import NodeStore
from reference_server.storage.server_lock import lock_of
from reference_server.storage.store import Store, StoreFailed
from reference_server.system.counters import COUNTERS
from reference_server.system.hourly_work import HourlyWork
from reference_server.system.lifespan import CannotServe, run_lifespan
from reference_server.system.log_output import (
    ACCESS_LOG,
    REQUEST_ID,
    log_event,
    request_id_of,
)
from reference_server.system.seed_secret import SeedSecret
from reference_sim.process.pool import SimulatorPool
from reference_sim.process.ray.ray_pool import RayPool

if typing.TYPE_CHECKING:
    from reference_server.monitoring.traces import Traces

log = logging.getLogger("proctor.app")
access_log = logging.getLogger(ACCESS_LOG)

_VERSION_HEADER = (b"proctor-version", PROTOCOL_VERSION.encode())


def build(
    settings: Settings,
    tokens: Tokens,
    limiter: ConnectionLimiter,
    metrics_socket: socket.socket | None = None,
    traces: Traces | None = None,
) -> Application:
    """One server, its parts connected. Nothing runs before the lifespan begins.

    limiter: of its connections. metrics_socket: bound; no metrics and traces if None.
    """
    recordings, store, records, board_store = _storage_of(settings)
    pool, replay_pool = _pools_of(settings)

    node = _node_of(settings, store, records, lambda: service)
    registry = _registry_of(settings, store, node)
    seed_secret = SeedSecret(settings.seed_secret_path)
    executor = _executor_of(settings, registry, pool, seed_secret, recordings)
    egress = EgressPolicy(settings.allow_private_policies)
    key_encryption = KeyEncryption(settings.sealing_key_path)
    service = _service_of(
        settings,
        registry,
        executor,
        benchmarks=Benchmarks(settings.max_chunk, seed_secret),
        validator=PolicyServerValidator(egress, key_encryption, tuple(PROTOCOLS)),
        records=records,
        is_kept=None if board_store is None else board_store.keeps_run,
        node=node,
    )
    retention = _retention_of(settings, service)
    board = _board_of(board_store, service)
    imports = _imports_of(settings, store, replay_pool, records)
    streams = SharedStreams(settings.max_event_streams)
    handlers = Handlers(settings, service, streams, board, imports)
    driver = Driver(service, egress, key_encryption, settings.max_body_bytes)
    token_file = TokenFile(settings.tokens_file_path, tokens)

    @asynccontextmanager
    async def lifespan() -> AsyncIterator[None]:
        async with _explained(), _locked(settings):
            await store.open()
            key_encryption.open()
            seed_secret.open()
            await _open_all(traces, records, registry)
            await pool.start()
            driver.open()
            await _open_all(imports, node, token_file)
            retention.open()
            await metrics.open()
            try:
                yield
            finally:
                # What is recorded is written before others may claim its run.
                await _close_all(token_file, metrics, retention, driver, imports)
                await _close_all(executor, registry, records, node, replay_pool)
                await _close_all(pool, store, traces)

    readiness = _readiness_of(store, pool, registry)
    read_state = partial(_read_state, registry, executor, pool, streams, limiter)
    metrics = _metrics_of(metrics_socket, readiness, read_state)
    app = _router(handlers, tokens, readiness, node, traces=traces)
    return Application(app, lifespan, partial(_drain, registry, driver, node), executor)


def _traced(
    app: ASGIApp, traces: Traces | None, settings: Settings, node: ServerNode | None
) -> ASGIApp:
    if traces is None:
        return app

    def trusts(scope: Scope) -> bool:
        is_of_node = node is not None and node.is_passed_on(scope)
        return is_of_node or settings.traces_parent == "all"

    return RequestSpans(app, traces, trusts)


def _end_server() -> None:
    signal.raise_signal(signal.SIGTERM)


@asynccontextmanager
async def _explained() -> AsyncIterator[None]:
    """A check before the start may no longer hold: one sentence says so."""
    try:
        yield
    except StoreFailed as error:
        raise CannotServe(f"cannot use the database ({error})") from error
    except NodeRefused as error:
        raise CannotServe(str(error)) from error


@asynccontextmanager
async def _locked(settings: Settings) -> AsyncIterator[None]:
    """While the server uses its database, as the only one or as one of its nodes."""
    is_shared = settings.cluster == "on"
    lock = lock_of(settings.database_url, _end_server, is_shared=is_shared)
    await lock.acquire()
    try:
        yield
    finally:
        await lock.release()


async def _drain(
    registry: RunRegistry, driver: Driver, node: ServerNode | None
) -> None:
    """Begin it: nothing new is taken in from now on."""
    registry.begin_ending()
    if node is not None:
        node.membership.stop_claiming()
    await driver.stop_playing()


def _readiness_of(
    store: Store, pool: SimulatorPool, registry: RunRegistry
) -> Readiness:
    checks = {"database": store.check_writable, "simulators": pool.check_start}
    return Readiness(checks, is_draining=lambda: registry.is_ending)


def _metrics_of(
    listener: socket.socket | None, readiness: Readiness, read_state: ReadState
) -> MetricsListener:
    routes = [metrics_route(COUNTERS, read_state), *health_routes(readiness)]
    return MetricsListener(listener, routes)


def _read_state(
    registry: RunRegistry,
    executor: SessionExecutor,
    pool: SimulatorPool,
    streams: SharedStreams,
    limiter: ConnectionLimiter,
) -> ServerState:
    """For the page of metrics, which is there without the database, too."""
    return ServerState(
        version=SOFTWARE_VERSION,
        is_draining=registry.is_ending,
        connections=limiter.count,
        event_streams=streams.count,
        sessions=executor.sessions,
        turns=executor.turns_in_progress,
        runs=registry.count_open(),
        oldest_queued_s=registry.admission.oldest_queued_s(),
        simulators={"lent": pool.busy, "idle": pool.idle},
        simulators_max=pool.size_max,
        simulator_starts=pool.starts,
    )


class _Opened(Protocol):
    async def open(self) -> None: ...


class _Part(Protocol):
    async def close(self) -> None: ...


async def _open_all(*parts: _Opened | None) -> None:
    for part in parts:
        if part is not None:
            await part.open()


async def _close_all(*parts: _Part | None) -> None:
    for part in parts:
        if part is not None:
            await part.close()


def _registry_of(
    settings: Settings, store: Store, node: ServerNode | None
) -> RunRegistry:
    return RunRegistry(
        store,
        settings.max_active_runs,
        unused_s=settings.unused_s_max,
        quota=_quota(settings),
        ownership=None if node is None else node.membership,
        other_queues=None if node is None else node.queue,
    )


def _node_of(
    settings: Settings,
    store: Store,
    records: RunRecords | None,
    service: Callable[[], RunService],
) -> ServerNode | None:
    """service: is there once the server is put together."""
    if settings.cluster == "off":
        return None
    nodes = NodeStore(store, settings.node_lease_s)
    url = settings.node_url or f"http://{settings.host}:{settings.port}"
    folder = settings.records_path

    def announce(node_id: str) -> None:
        if records is not None and folder is not None:
            show_node(folder, node_id)

    async def on_joined() -> None:
        if records is not None and folder is not None:
            keyid, host = records.key.keyid, settings.host_name
            # Once more: nodes that started at the same moment were not there before.
            try:
                await check_shared(nodes, url, folder, keyid, host)
            except OSError as error:
                raise StoreFailed(f"the folder of recordings: {error}") from error
            await records.use_key()

    return ServerNode(
        nodes,
        url,
        settings.node_lease_s,
        service,
        announce=announce,
        on_joined=on_joined,
        end_server=_end_server,
    )


def _pools_of(settings: Settings) -> tuple[SimulatorPool, SimulatorPool]:
    """For sessions, and for replays of records: those are files of this machine."""
    limits = settings.max_simulators, settings.spares, settings.turn_timeout_s
    if settings.simulators == "local":
        pool = SimulatorPool(*limits)
        return pool, pool
    pool = RayPool(
        settings.simulators,
        settings.ray_resources,
        *limits,
        recordings=None if settings.recordings == "off" else settings.records_path,
    )
    return pool, SimulatorPool(1, 0, settings.turn_timeout_s)


def _executor_of(
    settings: Settings,
    registry: RunRegistry,
    pool: SimulatorPool,
    seed_secret: SeedSecret,
    recordings: Recordings | None,
) -> SessionExecutor:
    return SessionExecutor(
        registry,
        pool,
        seed_secret,
        unused_s=settings.unused_s_max,
        heartbeat_s_max=settings.heartbeat_s_max,
        recordings=recordings,
    )


def _router(
    handlers: Handlers,
    tokens: Tokens,
    readiness: Readiness,
    node: ServerNode | None,
    *,
    traces: Traces | None,
) -> ASGIApp:
    table = handlers.table() | profile_tables(handlers)
    settings = handlers.settings
    hosts = AllowedHosts.parse(settings.allowed_hosts)
    endpoints: dict[str, ASGIApp] = {
        path: _Endpoint(operations, tokens, settings.max_body_bytes, hosts)
        for path, operations in table.items()
    }
    if node is not None:
        endpoints = node.routed(endpoints)
    routes: list[BaseRoute] = [Route(*one) for one in endpoints.items()]
    routes += health_routes(readiness)
    if settings.pages == "off":
        router = Router(routes, False, _not_found)
        return _traced(router, traces, settings, node)
    node_id = str if node is None else node.node_id
    find_entry_id = None if handlers.board is None else handlers.board.entry_id_of_run
    pages = Pages(hosts, settings.public_url, node_id, find_entry_id)
    shown: ASGIApp = Router(pages.routes(), False, pages.lead_from_root(_not_found))
    if node is not None:
        shown = node.routed_pages(shown, pages.show_away)
    # Behind the operations: no turn looks at their routes.
    router = Router(routes, False, shown)
    pages.use_api(router)
    return _traced(router, traces, settings, node)


def _storage_of(
    settings: Settings,
) -> tuple[Recordings | None, Store, RunRecords | None, BoardStore | None]:
    """What outlives the process; no records and no leaderboard without recordings."""
    recordings = _recordings_of(settings)
    store = _store_of(settings, recordings)
    records = _records_of(settings, store, recordings)
    board_store = None if records is None else BoardStore(store, leaf_hash)
    return recordings, store, records, board_store


def _recordings_of(settings: Settings) -> Recordings | None:
    if settings.recordings == "off":
        return None
    return Recordings(
        settings.records_path,
        pictures=settings.recordings == "pictures",
        is_shared=settings.cluster == "on",
    )


def _store_of(settings: Settings, recordings: Recordings | None) -> Store:
    is_shared = settings.cluster == "on"
    if recordings is None:
        return Store(settings.database_url, is_shared=is_shared)
    return Store(
        settings.database_url,
        recordings.finish_unplayed,
        recordings.remove_parts,
        is_shared=is_shared,
    )


def _records_of(
    settings: Settings, store: Store, recordings: Recordings | None
) -> RunRecords | None:
    if recordings is None:
        return None
    host = HostSettings(
        settings.host_name,
        settings.signing_key_path,
        settings.record_promise,
        settings.records_keep_days,
        settings.key_names,
    )
    return RunRecords(store, recordings, host)


def _service_of(
    settings: Settings,
    registry: RunRegistry,
    executor: SessionExecutor,
    *,
    benchmarks: Benchmarks,
    validator: PolicyServerValidator,
    records: RunRecords | None,
    is_kept: Callable[[str, bool], Awaitable[bool]] | None,
    node: ServerNode | None,
) -> RunService:
    return RunService(
        SubmissionLimits(settings.max_workers, settings.idle_timeout_s_max),
        benchmarks,
        registry,
        executor,
        validator.validate_and_encrypt,
        validator.digest_key,
        records,
        deletes_played=settings.delete_played_runs == "on",
        is_kept=is_kept,
        views_elsewhere=no_views_elsewhere if node is None else node.views.fetch,
        command_elsewhere=no_command_elsewhere if node is None else node.commands.apply,
    )


def _retention_of(settings: Settings, service: RunService) -> HourlyWork:
    """DEL-007."""
    keep_days = settings.runs_keep_days
    work = partial(service.delete_old, keep_days) if keep_days else None
    return HourlyWork(work, "old runs could not be deleted")


def _board_of(
    board_store: BoardStore | None, service: RunService
) -> BoardService | None:
    """None where nothing is recorded: its history is signed by the key of records."""
    if board_store is None or service.records is None:
        return None
    history = BoardHistory(board_store, service.records)
    return BoardService(service.registry, service.benchmarks, board_store, history)


def _imports_of(
    settings: Settings, store: Store, pool: SimulatorPool, records: RunRecords | None
) -> RecordImports | None:
    if records is None or not settings.takes_records:
        return None
    most = ImportUsage(settings.max_waiting_imports, settings.max_imported_bytes)
    imports = ImportSettings(
        settings.imports_path,
        most,
        settings.max_record_bytes,
        settings.import_replay_s_max,
        [load_opened_seeds(path) for path in settings.opened_seeds_paths],
    )
    return RecordImports(ImportStore(store), pool, records, imports)


def _quota(settings: Settings) -> Quota:
    return Quota(
        settings.max_open_runs, settings.max_idempotency_keys, settings.max_stored_bytes
    )


class _Endpoint:
    """One path for every method, so that a 405 can name those that it has (ERR-010)."""

    def __init__(
        self,
        operations: Mapping[str, Operation],
        tokens: Tokens,
        max_body: int,
        hosts: AllowedHosts,
    ) -> None:
        self._operations = operations
        self._names = {
            method: operation_name(operation)
            for method, operation in operations.items()
        }
        self._tokens = tokens
        self._max_body = max_body
        self._hosts = hosts

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        operation = self._operations.get(scope["method"])
        if operation is None:
            response = self._not_allowed(scope["method"])
        else:
            scope[OPERATION] = self._names[scope["method"]]
            request = Request(scope, receive)
            response = await perform(
                request, operation, self._tokens, self._max_body, self._hosts
            )
        await response(scope, receive, send)

    def _not_allowed(self, method: str) -> Response:
        detail = f"{method} is not a method of this path."
        allowed = {"Allow": ", ".join(sorted(self._operations))}
        return problem_response(Refused("method_not_allowed", detail), allowed)


async def _not_found(scope: Scope, receive: Receive, send: Send) -> None:
    refused = Refused("not_found", "Unknown path.")  # ERR-009
    await problem_response(refused)(scope, receive, send)


class Application:
    """What holds for every response: its version, and that a defect is a problem too.

    One layer around the router, not a framework's stack of them: a turn passes every
    layer three times.

    lifespan: the parts, open while it is entered. begin_drain: to be called when the
    server begins to end; ends waiting requests, and from then on nothing new begins.
    executor: has the turns that are to be finished.
    """

    def __init__(
        self,
        app: ASGIApp,
        lifespan: Callable[[], AbstractAsyncContextManager[None]],
        begin_drain: Callable[[], Awaitable[None]],
        executor: SessionExecutor,
    ) -> None:
        self._app, self._lifespan = app, lifespan
        self._executor = executor
        self.begin_drain = begin_drain

    def turns_in_progress(self) -> int:
        return self._executor.turns_in_progress

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        if scope["type"] != "http":  # no web sockets: it is the lifespan
            await run_lifespan(self._lifespan(), receive, send)
            return
        response_started = False
        status = 0
        started = time.perf_counter()
        request_id = request_id_of(_header(scope, b"x-request-id"))
        REQUEST_ID.set(request_id)

        async def send_versioned(message: Message) -> None:
            nonlocal response_started, status
            if message["type"] == "http.response.start":
                response_started, status = True, message["status"]
                message["headers"].append(_VERSION_HEADER)  # VER-001
                message["headers"].append((b"x-request-id", request_id.encode()))
            await send(message)

        try:
            await self._app(scope, receive, send_versioned)
        except Exception:
            if response_started:  # too late for a problem; the connection is closed
                raise
            log.exception("a request failed")
            refused = Refused("internal_error", "Internal server error.")
            await problem_response(refused)(scope, receive, send_versioned)
        finally:
            took_s = time.perf_counter() - started
            operation = scope.get(OPERATION) or _other(scope["path"])
            COUNTERS.requests[operation, status // 100].add(took_s)
            log_event(
                access_log,
                "request",
                method=scope["method"],
                path=scope["path"],
                status=status,
                ms=round(1000 * took_s, 1),
                account=scope.get(ACCOUNT),
                client=(scope.get("client") or ("-",))[0],
            )


def _other(path: str) -> str:
    """What a request that is no operation counts as."""
    return "pages" if path.startswith(PAGES_PATH) else "other"


def _header(scope: Scope, name: bytes) -> bytes | None:
    return next((value for key, value in scope["headers"] if key == name), None)
