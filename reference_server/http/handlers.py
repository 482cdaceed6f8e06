"""The operations of the spec, one HTTP handler each.

A handler reads the request, calls one use case of `runs/service.py` and writes the
response. It holds no rule, no state and no SQL.
"""

from __future__ import annotations

import hashlib
import importlib.metadata
import time
from collections.abc import Awaitable, Callable, Iterator
from dataclasses import dataclass, field
from functools import partial
from urllib.parse import urlsplit

from starlette.requests import Request
from starlette.responses import Response, StreamingResponse

from reference_record.formats.names import record_file_name
from reference_record.generated import answers
from reference_record.texts.timestamps import timestamp
from reference_record.unsigned_record import blocks_of
from reference_server.generated import models
from reference_server.http.board_handlers import BoardHandlers
from reference_server.http.bodies import request_bodies
from reference_server.http.codec import JSON, MSGPACK
from reference_server.http.connections.connection_limits import HEADER_BYTES
from reference_server.http.connections.forwarded_urls import base_url_of
from reference_server.http.dispatch import (
    VERSION_MAX,
    VERSION_MIN,
    Operation,
    OperationCall,
)
from reference_server.http.event_streams import EVENT_STREAM, EventStream, SharedStreams
from reference_server.records.record_imports import RecordImports
from reference_server.rules import comparison
from reference_server.rules.imported_record import RecordImport
from reference_server.rules.refusal import Refused, no_profile
from reference_server.rules.runs.lifecycle import Attach, Detach, Heartbeat, Predict
from reference_server.runs.board_service import BoardService
from reference_server.runs.service import RunService
from reference_server.settings import Settings
from reference_server.views import run_views
from reference_server.views.import_view import import_view

ARCHIVE, BYTES = "application/zip", "application/octet-stream"
SOFTWARE_VERSION = importlib.metadata.version("proctor-eval")
IDLE_TIMEOUT_S_MIN = 1.0
# The operation that is asked most often.
TURN_PATH = "/v1/runs/{run_id}/workers/{worker_id}/predict"
PAGE = 100  # RUN-025: items on a page when no limit is sent
# RUN-032: `push` is always among them, and so are its members of a submit.
PROFILES: tuple[answers.Profile, ...] = (
    *("core", "sessions", "control", "faults", "accounts", "submit_once", "lists"),
    *("waiting", "observations", "conventions", "strict_http"),
    *("msgpack", "compare", "events", "push", "limits"),
    *("attribution", "reasons", "subsets", "sealed_seeds", "deletion"),
)


@dataclass(frozen=True, slots=True)
class Handlers:
    """The operations of the spec, over the use cases."""

    settings: Settings
    service: RunService
    streams: SharedStreams = field(default_factory=SharedStreams)
    board: BoardService | None = None
    # None where no records are taken in.
    imports: RecordImports | None = None
    # How people judged a run.
    judged: Callable[[str], answers.JudgedRun | None] | None = None

    def table(self) -> dict[str, dict[str, Operation]]:
        """path → method → operation; equal to the spec, as a test proves."""
        run, worker = "/v1/runs/{run_id}", "/v1/runs/{run_id}/workers/{worker_id}"
        pages, both = ("cursor", "limit"), (JSON, MSGPACK)
        # Everything but a predict is short.
        control = partial(
            Operation, max_body_bytes=self.settings.max_control_body_bytes
        )
        return {
            TURN_PATH: {  # paths are matched in this order: frequent ones first
                "POST": Operation(self.predict, "run", models.Predict, both, both)
            },
            worker: {
                "PUT": control(
                    self.attach_worker, "run", models.AttachWorker, both, both
                ),
                "DELETE": Operation(
                    self.detach_worker,
                    "run",
                    writes=(),
                    query=("session_id",),
                    required_query=("session_id",),
                ),
            },
            f"{worker}/heartbeat": {
                "POST": control(self.heartbeat, "run", models.Heartbeat)
            },
            "/v1/runs": {
                "GET": Operation(self.list_runs, query=pages),
                "POST": control(
                    self.submit_run,
                    "run",
                    models.SubmitRun,
                    headers=("idempotency-key",),
                ),
            },
            run: {
                "GET": Operation(self.get_run, headers=("if-none-match", "prefer")),
                "DELETE": Operation(self.delete_run, "run", writes=()),
            },
            f"{run}/stop": {"POST": control(self.stop_run, "run", models.StopRun)},
            f"{run}/resume": {"POST": Operation(self.resume_run, "run")},
            f"{run}/episodes": {"GET": Operation(self.list_episodes, query=pages)},
            f"{run}/events": {
                "GET": Operation(
                    self.stream_events,
                    writes=(EVENT_STREAM,),
                    headers=("last-event-id",),
                )
            },
            f"{run}/score": {"GET": Operation(self.get_score)},
            "/v1": {"GET": Operation(self.describe_service, scope=None)},
            "/v1/benchmarks": {"GET": Operation(self.list_benchmarks)},
            "/v1/benchmarks/{benchmark_id}": {"GET": Operation(self.get_benchmark)},
            f"{run}/record": {"GET": Operation(self.fetch_record, writes=(ARCHIVE,))},
            f"{run}/episodes/{{episode_id}}/recording": {
                "GET": Operation(self.fetch_recording, writes=(BYTES,))
            },
            **self._board_operations(),
            "/v1/keys": {"GET": Operation(self.list_keys, scope=None)},
            **self._import_operations(pages),
            "/v1/comparisons": {
                "GET": Operation(
                    self.compare_runs,
                    query=("baseline", "runs", "tolerance"),
                    required_query=("baseline", "runs"),
                )
            },
        }

    def _import_operations(
        self, pages: tuple[str, ...]
    ) -> dict[str, dict[str, Operation]]:
        record = "/v1/records/{import_id}"
        return {
            "/v1/records": {
                "GET": Operation(self.list_imports, query=pages),
                "POST": Operation(
                    self.import_record,
                    "run",
                    reads=(ARCHIVE,),
                    has_streamed_body=True,
                ),
            },
            record: {
                "GET": Operation(self.get_import),
                "DELETE": Operation(self.delete_import, "run", writes=()),
            },
            f"{record}/archive": {
                "GET": Operation(self.fetch_imported_record, writes=(ARCHIVE,))
            },
        }

    def _board_operations(self) -> dict[str, dict[str, Operation]]:
        return BoardHandlers(
            self.board,
            _number,
            PAGE,
            self.settings.max_control_body_bytes,
            is_public=self.settings.public_board == "on",
        ).table()

    # --- control plane ---

    async def describe_service(self, call: OperationCall) -> Response:
        """SVC-001, SVC-002."""
        settings = self.settings
        limits: answers.Limits = {
            "max_body_bytes": settings.max_body_bytes,
            "max_workers": settings.max_workers,
            "max_chunk": settings.max_chunk,
            "idle_timeout_s_min": IDLE_TIMEOUT_S_MIN,
            "idle_timeout_s_max": settings.idle_timeout_s_max,
            "wait_s_max": settings.wait_s_max,
            "max_header_bytes": HEADER_BYTES,
            "header_timeout_s": settings.request_timeout_s,
            "body_timeout_s": settings.request_timeout_s,
            "heartbeat_s_max": settings.heartbeat_s_max,
            "unused_s_max": settings.unused_s_max,
            "max_control_body_bytes": settings.max_control_body_bytes,
            "max_open_runs": settings.max_open_runs,
            "max_idempotency_keys": settings.max_idempotency_keys,
            "max_stored_bytes": settings.max_stored_bytes,
            "max_record_bytes": settings.max_record_bytes,
            "max_waiting_imports": settings.max_waiting_imports,
            "max_imported_bytes": settings.max_imported_bytes,
        }
        if settings.runs_keep_days:
            limits["run_keep_days"] = settings.runs_keep_days
        service: answers.Service = {
            "name": "Proctor reference server",
            "version": SOFTWARE_VERSION,
            "protocol": {"min": VERSION_MIN, "max": VERSION_MAX},
            "profiles": [
                *PROFILES,
                *(() if settings.recordings == "off" else ("record",)),
                *self._board_profiles(),
                *(("record_import",) if settings.takes_records else ()),
                *(("physical",) if self.service.benchmarks.have_robots() else ()),
                *(("hosting",) if settings.account_service else ()),
                *settings.enabled_profiles,
            ],
            "limits": limits,
            "encodings": [JSON, MSGPACK],
            "image_codecs": ["raw", "png", "jpeg"],
            "server_time": timestamp(time.time()),
        }
        return call.answer(service)

    def _board_profiles(self) -> tuple[answers.Profile, ...]:
        if self.board is None:
            return ()
        is_public = self.settings.public_board == "on"
        return ("board", "public_board") if is_public else ("board",)

    async def list_benchmarks(self, call: OperationCall) -> Response:
        return call.answer({"benchmarks": self.service.benchmarks.summaries()})

    async def get_benchmark(self, call: OperationCall) -> Response:
        return call.answer(
            await self.service.benchmarks.view(call.path["benchmark_id"])
        )

    async def submit_run(self, call: OperationCall) -> Response:
        key = call.headers.get("idempotency-key")
        submission = call.body.model_dump()
        # RUN-002, RUN-003, RUN-004 and RUN-005 are decided there.
        run = await self.service.submit_run(call.account, submission, key)
        body = await self.service.view_stored(run, self.base_url(call))
        response = call.answer(body, 201)
        response.headers["Location"] = self._place(call, f"/v1/runs/{run.run_id}")
        return response

    async def list_runs(self, call: OperationCall) -> Response:
        limit = int(call.query.get("limit", PAGE))
        before = _number(call.query.get("cursor"))
        # One more than is shown says whether there is another page (RUN-009).
        runs = await self.service.list_runs(
            call.reader, before, limit + 1, self.base_url(call)
        )
        more = len(runs) > limit
        return call.answer(
            {
                "runs": [body for _, body in runs[:limit]],
                "next_cursor": str(runs[limit - 1][0]) if more else None,
            }
        )

    async def get_run(self, call: OperationCall) -> Response:
        """With If-None-Match and Prefer it waits for a change.

        RUN-011, RUN-012, RUN-013: an ETag per view, 304 after the wait and not before.
        RUN-031: no wait when the caller has another view.
        """
        wanted = call.headers.get("if-none-match")
        wait_s = float(call.headers.get("prefer", "wait=0").removeprefix("wait="))
        deadline = time.monotonic() + min(wait_s, self.settings.wait_s_max)
        registry, run_id = self.service.registry, call.path["run_id"]
        while True:
            # Taken before the run is read; a waiting request keeps no run in memory.
            change = registry.change_event(run_id)
            view = await self.service.view_run(call.reader, run_id, self.base_url(call))
            if self.judged is not None and (judged := self.judged(run_id)):
                view["judged"] = judged
            response = call.answer(view)
            etag = _etag(bytes(response.body))
            response.headers["ETag"] = etag
            if wanted == "*":
                wanted = etag  # it names the run as it was when the request came
            if wanted is None or not _matches(wanted, etag):
                return response
            left_s = deadline - time.monotonic()
            if left_s <= 0:
                return Response(status_code=304, headers={"ETag": etag})
            await registry.wait_for_change(change, left_s)

    async def stop_run(self, call: OperationCall) -> Response:
        body = call.body.model_dump()
        run = await self.service.stop_run(
            call.account,
            call.path["run_id"],
            body.get("mode", "abort"),
            body.get("reason"),
            of_all_accounts=call.stopper is None,
        )
        return call.answer(await self.service.view_stored(run, self.base_url(call)))

    async def resume_run(self, call: OperationCall) -> Response:
        run = await self.service.resume_run(call.account, call.path["run_id"])
        return call.answer(await self.service.view_stored(run, self.base_url(call)))

    async def delete_run(self, call: OperationCall) -> Response:
        await self.service.delete_run(call.account, call.path["run_id"])
        return Response(status_code=204)

    async def list_episodes(self, call: OperationCall) -> Response:
        start = _number(call.query.get("cursor")) or 0  # EPI-006
        end = start + int(call.query.get("limit", PAGE))
        episodes, total = await self.service.list_episodes(
            call.reader, call.path["run_id"], start, end
        )
        next_cursor = str(end) if end < total else None
        return call.answer({"episodes": episodes, "next_cursor": next_cursor})

    async def stream_events(self, call: OperationCall) -> Response:
        base_url = self.base_url(call)
        stream = EventStream(
            self.service.registry,
            call.path["run_id"],
            call.account,
            partial(self.service.current_view, base_url),
            base_url,
            self.streams,
            sees_all=call.reader is None,
        )
        return await stream.answer(call.headers.get("last-event-id"))

    async def get_score(self, call: OperationCall) -> Response:
        score = await self.service.get_score(call.reader, call.path["run_id"])
        return call.answer(score)

    # --- records ---

    async def list_keys(self, call: OperationCall) -> Response:
        """REC-101."""
        keys = await self.service.list_keys()
        return call.answer({"keys": [run_views.key_view(key) for key in keys]})

    async def fetch_record(self, call: OperationCall) -> Response:
        run_id = call.path["run_id"]
        record = await self.service.fetch_record(call.reader, run_id)
        check = partial(self.service.check_readable, call.reader, run_id)
        return _Download(
            record.stream(), record.size, ARCHIVE, record_file_name(run_id), check
        )

    async def fetch_recording(self, call: OperationCall) -> Response:
        run_id, episode_id = call.path["run_id"], call.path["episode_id"]
        path, size = await self.service.find_recording(call.reader, run_id, episode_id)
        check = partial(self.service.check_readable, call.reader, run_id)
        name = f"{run_id}-{episode_id}.mcap"
        return _Download(blocks_of(path), size, BYTES, name, check)

    # --- records that are handed in ---

    async def import_record(self, call: OperationCall) -> Response:
        """REC-112."""
        declared = call.request.headers.get("content-length", "0")
        parts = request_bodies.stream_body(call.request)
        record_import = await self._imports().receive(
            call.account, int(declared), parts
        )
        response = call.answer(await self._import_view(call, record_import), 202)
        path = f"/v1/records/{record_import.import_id}"
        response.headers["Location"] = self._place(call, path)
        return response

    async def list_imports(self, call: OperationCall) -> Response:
        """REC-120."""
        limit = int(call.query.get("limit", PAGE))
        before = _number(call.query.get("cursor"))
        imports = await self._imports().page(call.reader, before, limit + 1)
        more = len(imports) > limit
        return call.answer(
            {
                "imports": [
                    await self._import_view(call, record_import)
                    for record_import in imports[:limit]
                ],
                "next_cursor": str(imports[limit - 1].number) if more else None,
            }
        )

    async def get_import(self, call: OperationCall) -> Response:
        record_import = await self._imports().find(call.reader, call.path["import_id"])
        return call.answer(await self._import_view(call, record_import))

    async def delete_import(self, call: OperationCall) -> Response:
        await self._imports().delete(call.account, call.path["import_id"])
        return Response(status_code=204)

    async def fetch_imported_record(self, call: OperationCall) -> Response:
        import_id = call.path["import_id"]
        record = await self._imports().archive(call.reader, import_id)
        name = f"import-{import_id}.proctor"
        check = partial(self._imports().find, call.reader, import_id)
        return _Download(record.stream(), record.size, ARCHIVE, name, check)

    async def _import_view(
        self, call: OperationCall, record_import: RecordImport
    ) -> answers.RecordImport:
        imports = self._imports()
        trust = await imports.trust(record_import, self.base_url(call))
        return import_view(
            record_import, trust, imports.episodes_replayed(record_import)
        )

    def _imports(self) -> RecordImports:
        if self.imports is None:
            raise no_profile("This server takes no records in.")
        return self.imports

    async def compare_runs(self, call: OperationCall) -> Response:
        tolerance = float(call.query.get("tolerance", comparison.TOLERANCE))
        run_ids = [call.query["baseline"], *call.query["runs"].split(",")]
        return call.answer(
            await self.service.compare_runs(call.reader, run_ids, tolerance)
        )

    # --- data plane ---

    async def attach_worker(self, call: OperationCall) -> Response:
        body = call.body.model_dump()
        command = Attach(
            call.path["worker_id"],
            body["attach_key"],
            body.get("takeover", False),
            body.get("assumes"),
            player=body.get("player"),
            first_episodes=body.get("first_episodes"),
        )
        return call.answer(
            await self.service.attach_worker(call.account, call.path["run_id"], command)
        )

    async def predict(self, call: OperationCall) -> Response:
        body = call.body
        command = Predict(
            call.path["worker_id"],
            body.session_id,
            body.seq,
            [action.values for action in body.actions],
            "all" if body.observe == "all" else "last",
        )
        return call.answer(
            await self.service.predict(call.account, call.path["run_id"], command)
        )

    async def heartbeat(self, call: OperationCall) -> Response:
        body = call.body.model_dump()
        session_id, reason = body["session_id"], body.get("reason")
        command = Heartbeat(call.path["worker_id"], session_id, reason=reason)
        return call.answer(
            await self.service.heartbeat(call.account, call.path["run_id"], command)
        )

    async def detach_worker(self, call: OperationCall) -> Response:
        command = Detach(call.path["worker_id"], call.query["session_id"])
        await self.service.detach_worker(call.account, call.path["run_id"], command)
        return Response(status_code=204)

    def base_url(self, call: OperationCall) -> str:
        """RUN-016, RUN-033: where the caller reaches this server; no slash at the end.

        CLU-002: of several nodes, the one address that clients are given.
        """
        return self.url_of(call.request)

    def url_of(self, request: Request) -> str:
        """The same for any request, such as one for a page."""
        settings = self.settings
        if settings.public_url:
            return settings.public_url.rstrip("/")
        return base_url_of(request, settings.trusted_proxies)

    def _place(self, call: OperationCall, path: str) -> str:
        """RUN-001, REC-112: the Location of something new, also under a base path."""
        return urlsplit(self.base_url(call)).path + path


class _Download(StreamingResponse):
    """A file that is read while it is sent, by a thread.

    check_content: raises Refused once it may not be read any more.
    """

    def __init__(
        self,
        blocks: Iterator[bytes],
        size: int,
        media_type: str,
        name: str,
        check_content: Callable[[], Awaitable[object]],
    ) -> None:
        headers = {
            "Content-Length": str(size),
            "Content-Disposition": f'attachment; filename="{name}"',
        }
        super().__init__(blocks, media_type=media_type, headers=headers)
        self.check_content = check_content


def _etag(view: bytes) -> str:
    """RUN-030: another one for every other view."""
    return f'"{hashlib.sha256(view).hexdigest()[:32]}"'


def _matches(if_none_match: str, etag: str) -> bool:
    tags = [tag.strip().removeprefix("W/") for tag in if_none_match.split(",")]
    return etag in tags


def _number(cursor: str | None) -> int | None:
    if cursor is None:
        return None
    if not cursor.isdecimal() or len(cursor) > 15:
        raise Refused(
            "invalid_request",
            "The cursor is invalid.",
            errors=[("query:cursor", "must be the next_cursor of an earlier page")],
        )
    return int(cursor)
