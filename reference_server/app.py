"""The ASGI application: the parts put together, and what holds for every response.

It decides no rule; each part is configured and connected here and nowhere else.
"""

from __future__ import annotations

import asyncio
import logging
import time
from collections.abc import AsyncIterator, Awaitable, Callable, Mapping
from contextlib import asynccontextmanager
from functools import partial
from typing import Any, Protocol

from starlette.requests import Request
from starlette.responses import Response
from starlette.routing import BaseRoute, Route, Router
from starlette.types import ASGIApp, Lifespan, Message, Receive, Scope, Send

from reference_record.formats.merkle_tree import leaf_hash
from reference_server.generated.protocol_version import PROTOCOL_VERSION
from reference_server.http.allowed_hosts import AllowedHosts
from reference_server.http.auth import Tokens
from reference_server.http.dispatch import ACCOUNT, Operation, perform
from reference_server.http.event_streams import SharedStreams
from reference_server.http.handlers import Handlers
from reference_server.http.pages.page_routes import Pages
from reference_server.http.problems import problem_response
from reference_server.http.tokens.token_file import TokenFile
from reference_server.profiles.operation_tables import profile_tables
from reference_server.push.driver import PROTOCOLS, Driver
from reference_server.push.egress import EgressPolicy
from reference_server.push.key_encryption import KeyEncryption
from reference_server.push.policy_server_validator import PolicyServerValidator
from reference_server.records.board_history import BoardHistory
from reference_server.records.record_imports import ImportSettings, RecordImports
from reference_server.records.recordings import Recordings
from reference_server.records.run_records import HostSettings, RunRecords
from reference_server.rules.capacity import Quota
from reference_server.rules.imported_record import ImportUsage
from reference_server.rules.refusal import Refused
from reference_server.rules.run import Run
from reference_server.rules.submission import SubmissionLimits
from reference_server.runs.benchmarks import Benchmarks
from reference_server.runs.board_service import BoardService
from reference_server.runs.registry import RunRegistry
from reference_server.runs.seed_secret import SeedSecret
from reference_server.runs.service import RunService
from reference_server.runs.session_executor import SessionExecutor
from reference_server.settings import Settings
from reference_server.storage.board_store import BoardStore
from reference_server.storage.import_store import ImportStore
from reference_server.storage.store import Store
from reference_server.system.hourly_work import HourlyWork
from reference_server.system.log_output import (
    ACCESS_LOG,
    REQUEST_ID,
    log_event,
    request_id_of,
)
from reference_sim.process.pool import SimulatorPool

log = logging.getLogger("proctor.app")
access_log = logging.getLogger(ACCESS_LOG)

_VERSION_HEADER = (b"proctor-version", PROTOCOL_VERSION.encode())


def build(settings: Settings, tokens: Tokens) -> Application:
    """One server, its parts connected. Nothing runs before the lifespan begins."""
    recordings, store, records, board_store = _storage_of(settings)
    pool = SimulatorPool(
        settings.max_simulators, settings.spare_simulators, settings.turn_timeout_s
    )

    # Called only while the server runs; by then both parts are there.
    def on_run_lost(run: Run) -> None:
        executor.discard_sessions(run)

    def on_change(run: Run) -> None:
        driver.on_run_changed(run)

    registry = _registry_of(settings, store, on_run_lost, on_change)
    seed_secret = SeedSecret(settings.seed_secret_path)
    executor = _executor_of(settings, registry, pool, seed_secret, recordings)
    egress = EgressPolicy(settings.allow_private_policies)
    key_encryption = KeyEncryption(settings.sealing_key_path)
    policy_server_validator = PolicyServerValidator(
        egress, key_encryption, tuple(PROTOCOLS)
    )
    service = _service_of(
        settings,
        registry,
        executor,
        benchmarks=Benchmarks(settings.max_chunk, seed_secret),
        validator=policy_server_validator,
        records=records,
        is_kept=None if board_store is None else board_store.keeps_run,
    )
    retention = _retention_of(settings, service)
    board = _board_of(board_store, service)
    imports = _imports_of(settings, store, pool, records)
    streams = SharedStreams(settings.max_event_streams)
    handlers = Handlers(settings, service, streams, board, imports)
    driver = Driver(service, egress, key_encryption, settings.max_body_bytes)
    token_file = TokenFile(settings.tokens_file_path, tokens)

    @asynccontextmanager
    async def lifespan(_app: Any) -> AsyncIterator[None]:
        await store.open()
        key_encryption.open()
        seed_secret.open()
        await _open_records(records, board)
        await registry.open()
        await pool.start()
        if imports is not None:
            await imports.open()
        driver.open()
        await asyncio.to_thread(token_file.read)
        following = asyncio.create_task(token_file.follow())
        retention.open()
        try:
            yield
        finally:
            following.cancel()
            parts = (retention, driver, imports, executor, registry)
            for part in (*parts, records, pool, store):
                await _close(part)

    return Application(_router(handlers, tokens, lifespan), registry.release_waiters)


class _Part(Protocol):
    async def close(self) -> None: ...


async def _close(part: _Part | None) -> None:
    if part is not None:
        await part.close()


def _registry_of(
    settings: Settings,
    store: Store,
    on_run_lost: Callable[[Run], None],
    on_change: Callable[[Run], None],
) -> RunRegistry:
    return RunRegistry(
        store,
        settings.max_active_runs,
        on_run_lost,
        on_change,
        unused_s=settings.unused_s_max,
        quota=_quota(settings),
    )


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


def _router(handlers: Handlers, tokens: Tokens, lifespan: Lifespan[Any]) -> Router:
    table = handlers.table() | profile_tables(handlers)
    settings = handlers.settings
    hosts = AllowedHosts.parse(settings.allowed_hosts)
    routes: list[BaseRoute] = [
        Route(path, _Endpoint(operations, tokens, settings.max_body_bytes, hosts))
        for path, operations in table.items()
    ]
    if settings.pages == "off":
        return Router(routes, False, _not_found, lifespan=lifespan)
    # Behind the operations: no turn looks at their routes.
    pages = Pages(hosts, settings.public_url)
    default = pages.lead_from_root(_not_found)
    router = Router(routes + pages.routes(), False, default, lifespan=lifespan)
    pages.use_api(router)
    return router


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
    pictures = settings.recordings == "pictures"
    return Recordings(settings.records_path, pictures=pictures)


def _store_of(settings: Settings, recordings: Recordings | None) -> Store:
    if recordings is None:
        return Store(settings.database_url)
    return Store(
        settings.database_url, recordings.finish_unplayed, recordings.remove_parts
    )


def _records_of(
    settings: Settings, store: Store, recordings: Recordings | None
) -> RunRecords | None:
    if recordings is None:
        return None
    host = HostSettings(
        settings.public_url or settings.host,
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
    )
    return RecordImports(ImportStore(store), pool, records, imports)


async def _open_records(records: RunRecords | None, board: BoardService | None) -> None:
    if records is not None and board is not None:
        await records.open()
        await board.open()


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
        self._tokens = tokens
        self._max_body = max_body
        self._hosts = hosts

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        operation = self._operations.get(scope["method"])
        if operation is None:
            response = self._not_allowed(scope["method"])
        else:
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

    on_shutdown: to be called when the server begins to end; ends waiting requests.
    """

    def __init__(self, app: ASGIApp, on_shutdown: Callable[[], None]) -> None:
        self._app = app
        self.on_shutdown = on_shutdown

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        if scope["type"] != "http":
            await self._app(scope, receive, send)
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
            log_event(
                access_log,
                "request",
                method=scope["method"],
                path=scope["path"],
                status=status,
                ms=round(1000 * (time.perf_counter() - started), 1),
                account=scope.get(ACCOUNT),
                client=(scope.get("client") or ("-",))[0],
            )


def _header(scope: Scope, name: bytes) -> bytes | None:
    return next((value for key, value in scope["headers"] if key == name), None)
