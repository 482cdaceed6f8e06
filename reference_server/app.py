"""One server: its parts put together, opened in order, and closed in order.

Each part is configured and connected in `assembly/` and here, and nowhere else.
"""

from __future__ import annotations

import socket
import typing
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from dataclasses import dataclass
from typing import Protocol

from reference_server.accounts.account_service import AccountService
from reference_server.accounts.draw_leaves import DrawLeaves
from reference_server.assembly.node_parts import make_node
from reference_server.assembly.routes import make_endpoints, make_router, traced
from reference_server.assembly.run_parts import (
    Pools,
    RunParts,
    Secrets,
    make_board,
    make_imports,
)
from reference_server.assembly.stored_parts import StoredParts
from reference_server.cluster.node_routes import NodeRoutes
from reference_server.cluster.server_node import ServerNode
from reference_server.cluster.shared_queue import SharedQueue
from reference_server.http.application import Application
from reference_server.http.auth import Tokens
from reference_server.http.connections.connection_limits import ConnectionLimiter
from reference_server.http.event_streams import SharedStreams
from reference_server.http.handlers import SOFTWARE_VERSION, TURN_PATH, Handlers
from reference_server.http.tokens.token_file import TokenFile
from reference_server.monitoring.health import health_routes
from reference_server.monitoring.metrics import ServerState, metrics_route
from reference_server.monitoring.metrics_listener import MetricsListener
from reference_server.monitoring.readiness import Readiness
from reference_server.process.lifespan import CannotServe, end_server
from reference_server.profiles.physical.cell_handlers import CellHandlers
from reference_server.records.record_imports import RecordImports
from reference_server.rules.run_owner import NodeRefused
from reference_server.runs.benchmarks import log_unplayable
from reference_server.settings import Settings
from reference_server.storage.connection.server_lock import lock_of
from reference_server.storage.runs.run_store import StoreFailed
from reference_server.telemetry.counters import COUNTERS

if typing.TYPE_CHECKING:
    from reference_server.monitoring.traces import Traces


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
    stored = StoredParts.of(settings)
    pools, secrets = Pools.of(settings), Secrets.of(settings)
    node = make_node(settings, stored.store, secrets, tokens, stored.records)
    path = settings.account_service
    accounts = AccountService(path, tokens) if path else None
    runs = RunParts.of(settings, stored, pools, secrets, node, accounts=accounts)
    queue = node_routes = None
    if node is not None:
        queue = SharedQueue(node.nodes, node.connections, runs.registry.admission)
        node_routes = NodeRoutes(node, queue, runs.service)
    imports = make_imports(settings, stored, pools.replays, runs.disk_bound, node)
    streams = SharedStreams(settings.max_event_streams)
    board = make_board(stored, runs.service, secrets, accounts, runs.cells)
    judged = runs.cells.judged
    handlers = Handlers(settings, runs.service, streams, board, imports, judged)
    readiness = _readiness_of(stored, pools, runs)
    state = _StateReader(runs, pools, streams, limiter)
    metrics = MetricsListener(
        metrics_socket,
        [metrics_route(COUNTERS, state.read), *health_routes(readiness)],
    )
    endpoints = make_endpoints(handlers, CellHandlers.of(runs), tokens)
    append = None if board is None else board.append_of_draw
    draws = None if accounts is None else DrawLeaves(tokens, append)
    router = make_router(
        handlers,
        endpoints,
        readiness,
        node,
        node_routes,
        tokens=tokens,
        accounts=accounts,
        draws=draws,
    )
    turns = endpoints[TURN_PATH]
    direct = turns if node_routes is None else node_routes.turns(turns)
    server = _Server(
        settings,
        stored,
        pools,
        secrets,
        runs,
        node,
        queue,
        imports,
        TokenFile(settings.tokens_file_path, tokens),
        accounts,
        metrics,
        traces,
    )
    return Application(
        traced(router, traces, settings, node),
        server.lifespan,
        server.begin_drain,
        lambda: runs.executor.turns_in_progress,
        # A span begins in front of the router.
        direct if traces is None else None,
    )


def _readiness_of(stored: StoredParts, pools: Pools, runs: RunParts) -> Readiness:
    check_writable = stored.store.transactions.check_writable
    checks = {"database": check_writable, "simulators": pools.sessions.check_start}
    if stored.recordings is not None:
        checks["recordings"] = stored.recordings.check_writable
    return Readiness(checks, lambda: runs.registry.is_ending)


@dataclass(frozen=True, slots=True)
class _StateReader:
    """Reads the numbers of the page of metrics, without the database."""

    runs: RunParts
    pools: Pools
    streams: SharedStreams
    limiter: ConnectionLimiter

    def read(self) -> ServerState:
        registry, pool = self.runs.registry, self.pools.sessions
        return ServerState(
            version=SOFTWARE_VERSION,
            is_draining=registry.is_ending,
            connections=self.limiter.count,
            event_streams=self.streams.count,
            sessions=self.runs.executor.sessions,
            turns=self.runs.executor.turns_in_progress,
            runs=registry.count_open(),
            oldest_queued_s=registry.admission.oldest_queued_s(),
            simulators={"lent": pool.busy, "idle": pool.idle},
            simulators_max=pool.size_max,
            simulator_starts=pool.starts,
            kept_bytes=self.runs.disk_bound.used_bytes,
            kept_bytes_max=self.runs.disk_bound.max_bytes,
        )


@dataclass(frozen=True, slots=True)
class _Server:
    """The parts that are opened and closed, in an order in which each has its own."""

    settings: Settings
    stored: StoredParts
    pools: Pools
    secrets: Secrets
    runs: RunParts
    node: ServerNode | None
    queue: SharedQueue | None
    imports: RecordImports | None
    token_file: TokenFile
    accounts: AccountService | None
    metrics: MetricsListener
    traces: Traces | None

    @asynccontextmanager
    async def lifespan(self) -> AsyncIterator[None]:
        """The parts are open while it is entered. Raises CannotServe."""
        stored, runs, secrets = self.stored, self.runs, self.secrets
        async with _explained(), _locked(self.settings):
            await stored.store.open()
            secrets.open()
            await _open_all(self.traces, stored.records, runs.disk_bound, runs.registry)
            why_unplayable = runs.executor.why_unplayable
            runs.registry.work.start(log_unplayable(stored.store, why_unplayable))
            await _open_all(runs.cells)
            await self.pools.sessions.start()
            runs.driver.open()
            await _open_all(self.token_file, self.imports, self.node, self.queue)
            await _open_all(self.accounts)
            runs.retention.open()
            await self.metrics.open()
            try:
                yield
            finally:
                await _close_all(self.token_file, self.accounts, self.metrics)
                await _close_all(runs.retention)
                await _close_all(runs.driver, self.imports, runs.executor)
                # Recordings are written before other nodes may claim their runs.
                await _close_all(runs.registry, stored.records, self.queue, self.node)
                await _close_all(runs.disk_bound)
                await _close_all(self.pools.replays, self.pools.sessions)
                await _close_all(stored.store, self.traces)

    async def begin_drain(self) -> None:
        """Begin to end: nothing new is taken in from now on."""
        self.runs.registry.begin_ending()
        if self.node is not None:
            self.node.membership.stop_claiming()
        await self.runs.driver.stop_playing()


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
    lock = lock_of(settings.database_url, end_server, is_shared=is_shared)
    await lock.acquire()
    try:
        yield
    finally:
        await lock.release()


class _Opened(Protocol):
    async def open(self) -> None: ...


class _Closed(Protocol):
    async def close(self) -> None: ...


async def _open_all(*parts: _Opened | None) -> None:
    for part in parts:
        if part is not None:
            await part.open()


async def _close_all(*parts: _Closed | None) -> None:
    for part in parts:
        if part is not None:
            await part.close()
