"""The operations of the spec, one function each: no rule, no state, no SQL."""

from __future__ import annotations

import hashlib
import secrets
import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from datetime import UTC, datetime
from functools import partial
from typing import Any

import msgspec
from starlette.responses import Response

from reference_server.generated import models
from reference_server.http.codec import JSON, MSGPACK
from reference_server.http.dispatch import (
    VERSION_MAX,
    VERSION_MIN,
    Operation,
    OperationCall,
)
from reference_server.http.event_streams import EVENT_STREAM, EventStream
from reference_server.push.policy_server_config import PolicyServerValidator
from reference_server.rules import comparison, effects
from reference_server.rules.lifecycle import (
    Attach,
    Detach,
    Heartbeat,
    Predict,
    Refuse,
    Resume,
    Stop,
    decide,
)
from reference_server.rules.refusal import Refused
from reference_server.rules.run import Episode, Run, RunHead
from reference_server.runs.benchmarks import Benchmarks
from reference_server.runs.registry import RunRegistry
from reference_server.runs.scores import ScoreCache
from reference_server.runs.session_executor import SessionExecutor
from reference_server.settings import Settings
from reference_server.views import run_views
from reference_server.views.turn_view import lease_view

SOFTWARE_VERSION = "0.1.0"
IDLE_TIMEOUT_S_MIN = 1.0
PAGE = 100
PROFILES: tuple[models.Profile, ...] = ("core", "msgpack", "compare", "events", "push")


@dataclass(frozen=True, slots=True)
class Handlers:
    """The operations over one server's parts."""

    settings: Settings
    benchmarks: Benchmarks
    registry: RunRegistry
    executor: SessionExecutor
    policy_server_validator: PolicyServerValidator = field(
        default_factory=PolicyServerValidator
    )
    scores: ScoreCache = field(default_factory=ScoreCache)

    def table(self) -> dict[str, dict[str, Operation]]:
        """path → method → operation; the same as the spec's, as a test proves."""
        run, worker = "/v1/runs/{run_id}", "/v1/runs/{run_id}/workers/{worker_id}"
        pages = ("cursor", "limit")
        both = (JSON, MSGPACK)
        return {
            # Paths are tried in this order, and this is the one that is asked for.
            f"{worker}/predict": {
                "POST": Operation(self.predict, "run", models.Predict, both, both)
            },
            "/v1": {"GET": Operation(self.describe_service, scope=None)},
            "/v1/benchmarks": {"GET": Operation(self.list_benchmarks)},
            "/v1/benchmarks/{benchmark_id}": {"GET": Operation(self.get_benchmark)},
            "/v1/runs": {
                "GET": Operation(self.list_runs, query=pages),
                "POST": Operation(
                    self.submit_run,
                    "run",
                    models.SubmitRun,
                    headers=("idempotency-key",),
                ),
            },
            run: {"GET": Operation(self.get_run, headers=("if-none-match", "prefer"))},
            f"{run}/stop": {"POST": Operation(self.stop_run, "run", models.StopRun)},
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
            "/v1/comparisons": {
                "GET": Operation(
                    self.compare_runs,
                    query=("baseline", "runs", "tolerance"),
                    required_query=("baseline", "runs"),
                )
            },
            worker: {
                "PUT": Operation(
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
                "POST": Operation(self.heartbeat, "run", models.Heartbeat)
            },
        }

    # --- control plane ---

    async def describe_service(self, call: OperationCall) -> Response:
        settings = self.settings
        service = models.Service(
            name="Proctor reference server",
            version=SOFTWARE_VERSION,
            protocol=models.ProtocolRange(min=VERSION_MIN, max=VERSION_MAX),
            profiles=[*PROFILES, *settings.enabled_profiles],
            limits=models.Limits(
                max_body_bytes=settings.max_body_bytes,
                max_workers=settings.max_workers,
                max_chunk=settings.max_chunk,
                idle_timeout_s_min=IDLE_TIMEOUT_S_MIN,
                idle_timeout_s_max=settings.idle_timeout_s_max,
                wait_s_max=settings.wait_s_max,
            ),
            encodings=[JSON, MSGPACK],
            image_codecs=["raw", "png", "jpeg"],
            server_time=run_views.timestamp(datetime.now(UTC).timestamp()),
        )
        return call.answer(service.model_dump())

    async def list_benchmarks(self, call: OperationCall) -> Response:
        return call.answer({"benchmarks": self.benchmarks.summaries()})

    async def get_benchmark(self, call: OperationCall) -> Response:
        return call.answer(await self.benchmarks.view(call.path["benchmark_id"]))

    async def submit_run(self, call: OperationCall) -> Response:
        submission = call.body.model_dump()
        key = call.headers.get("idempotency-key")
        # Equal JSON values are the same body, however they were written.
        canonical = msgspec.json.encode(submission, order="deterministic")
        body_sha256 = hashlib.sha256(canonical).hexdigest()
        run = await self.create_run(call.account, submission, key, body_sha256)
        response = call.answer(await self._render_stored(call, run), 201)
        response.headers["Location"] = f"/v1/runs/{run.run_id}"
        return response

    async def create_run(
        self,
        account: str,
        submission: dict[str, Any],
        key: str | None = None,
        body_sha256: str = "",
    ) -> Run:
        """A new run, whichever door it comes by; submission: schema SubmitRun."""
        run = await self.prepare_run(account, submission)
        return await self.registry.add(run, key, body_sha256)

    async def prepare_run(self, account: str, submission: dict[str, Any]) -> Run:
        """What the submission asks for, not stored yet. Raises Refused."""
        settings = self.settings
        submission = await self.policy_server_validator.validate_and_encrypt(submission)
        resolved = await self.benchmarks.resolve(submission)
        max_workers = submission.get("max_workers", settings.max_workers)
        idle = submission.get("idle_timeout_s", settings.idle_timeout_s_max)
        errors = []
        if max_workers > settings.max_workers:  # RUN-015
            errors.append(("/max_workers", f"at most {settings.max_workers}"))
        if idle > settings.idle_timeout_s_max:  # LEASE-007
            errors.append(("/idle_timeout_s", f"at most {settings.idle_timeout_s_max}"))
        if errors:
            raise Refused(
                "invalid_request",
                "More was asked for than is given here.",
                errors=errors,
            )
        now = time.time()
        return Run(
            run_id=f"run_{secrets.token_hex(12)}",
            number=0,
            account=account,
            state="queued",
            reason=None,
            retryable=None,
            manifest=resolved.manifest,
            manifest_sha256=resolved.manifest_sha256,
            submission=submission,
            max_workers=max_workers,
            idle_timeout_s=idle,
            images=resolved.images,
            created_at_wall=now,
            updated_at_wall=now,
            queue_until_wall=now + _queue_s(submission),
            episodes=[
                Episode(index, plan["task"], plan["split"], plan["seed"])
                for index, plan in enumerate(resolved.manifest["episodes"])
            ],
        )

    async def list_runs(self, call: OperationCall) -> Response:
        limit = int(call.query.get("limit", PAGE))
        before = _number(call.query.get("cursor"))

        def view(run: RunHead) -> tuple[int, dict[str, Any]]:
            return run.number, self._view(call, run)

        found = await self.registry.page(call.account, before, limit + 1, view)
        more = len(found) > limit
        return call.answer(
            {
                "runs": [body for _, body in found[:limit]],
                "next_cursor": str(found[limit - 1][0]) if more else None,
            }
        )

    async def get_run(self, call: OperationCall) -> Response:
        wanted = call.headers.get("if-none-match")
        wait_s = float(call.headers.get("prefer", "wait=0").removeprefix("wait="))
        deadline = time.monotonic() + min(wait_s, self.settings.wait_s_max)
        run_id, view = call.path["run_id"], partial(self._sweep_and_view, call)
        while True:
            # Before the look; and whoever waits keeps no run in memory.
            change = self.registry.change_event(run_id)
            response = call.answer(
                await self.registry.read_view(run_id, call.account, view)
            )
            etag = f'"{hashlib.sha256(bytes(response.body)).hexdigest()[:32]}"'
            response.headers["ETag"] = etag
            if wanted is None or not _matches(wanted, etag):
                return response
            left_s = deadline - time.monotonic()
            if left_s <= 0:
                return Response(status_code=304, headers={"ETag": etag})
            await self.registry.wait_for_change(change, left_s)

    async def stop_run(self, call: OperationCall) -> Response:
        stop = Stop(call.body.model_dump().get("mode", "abort"))
        return call.answer(
            await self._render_stored(call, await self.apply_stop(call, stop))
        )

    async def apply_stop(self, call: OperationCall, stop: Stop) -> Run:
        run = await self._run_accepting(call, stop)
        self.executor.release_sessions(effects.stop(run, stop.mode, time.time()))
        await self.registry.commit(run)
        return run

    async def resume_run(self, call: OperationCall) -> Response:
        return call.answer(
            await self._render_stored(call, await self.apply_resume(call))
        )

    async def apply_resume(self, call: OperationCall) -> Run:
        run = await self._run_accepting(call, Resume())
        if run.state in ("stopped", "failed"):
            effects.resume(run, time.time() + _queue_s(run.submission))
            await self.registry.commit(run)
        return run

    async def list_episodes(self, call: OperationCall) -> Response:
        limit = int(call.query.get("limit", PAGE))
        start = _number(call.query.get("cursor")) or 0
        end = start + limit

        def view(run: RunHead, page: Sequence[Episode]) -> dict[str, Any]:
            return {
                "episodes": [run_views.episode_view(e) for e in page],
                "next_cursor": str(end) if end < run.total else None,
            }

        run_id = call.path["run_id"]
        return call.answer(
            await self.registry.read_view(run_id, call.account, view, start, end)
        )

    async def stream_events(self, call: OperationCall) -> Response:
        view = partial(self._sweep_and_view, call)
        stream = EventStream(self.registry, call.path["run_id"], call.account, view)
        return await stream.answer(call.headers.get("last-event-id"))

    async def get_score(self, call: OperationCall) -> Response:
        run_id = call.path["run_id"]
        return call.answer(await self.scores.get(self.registry, run_id, call.account))

    async def compare_runs(self, call: OperationCall) -> Response:
        tolerance = float(call.query.get("tolerance", comparison.TOLERANCE))
        ids = [call.query["baseline"], *call.query["runs"].split(",")]
        runs, scored = [], []
        for run_id in ids:
            look = partial(self.registry.read_view, run_id, call.account, end=None)
            run, episodes = await look(
                lambda run, all_: (run, run_views.scored_episodes(all_))
            )
            runs.append(run)
            scored.append(episodes)
        _check_same_manifest(*runs)
        entries = [
            {"run_id": run_id} | comparison.compare(scored[0], episodes, tolerance)
            for run_id, episodes in zip(ids[1:], scored[1:], strict=True)
        ]
        return call.answer(run_views.comparison_view(runs[0], tolerance, entries))

    # --- data plane ---

    async def attach_worker(self, call: OperationCall) -> Response:
        body = call.body.model_dump()
        command = Attach(
            call.path["worker_id"],
            body["attach_key"],
            body.get("takeover", False),
            body.get("assumes"),
        )
        return call.answer(await self.executor.attach(await self._run(call), command))

    async def predict(self, call: OperationCall) -> Response:
        body = call.body
        command = Predict(
            call.path["worker_id"],
            body.session_id,
            body.seq,
            [action.values for action in body.actions],
            "all" if body.observe == "all" else "last",
        )
        return call.answer(await self.executor.predict(await self._run(call), command))

    async def heartbeat(self, call: OperationCall) -> Response:
        command = Heartbeat(call.path["worker_id"], call.body.session_id)
        session = self.executor.heartbeat(await self._run(call), command)
        return call.answer(lease_view(session))

    async def detach_worker(self, call: OperationCall) -> Response:
        command = Detach(call.path["worker_id"], call.query["session_id"])
        await self.executor.detach(await self._run(call), command)
        return Response(status_code=204)

    async def _run(self, call: OperationCall) -> Run:
        return await self.registry.get(call.path["run_id"], call.account)

    async def _run_accepting(self, call: OperationCall, command: Stop | Resume) -> Run:
        """The run, for which the protocol accepts the command now."""
        while True:
            run = await self._run(call)
            verdict = decide(run, command, self.executor.sweep(run))
            if not isinstance(verdict, Refuse):
                return run
            # The state that forbids it is told as well: it may not be lost then.
            if await self.registry.is_stored(run):
                raise Refused.from_verdict(verdict)

    async def _render_stored(self, call: OperationCall, run: Run) -> dict[str, Any]:
        return await self.registry.render_when_stored(
            run, lambda run: self._view(call, run)
        )

    def _view(self, call: OperationCall, run: RunHead) -> dict[str, Any]:
        return run_views.run_view(
            run, self.base_url(call), self.registry.queue_position(run)
        )

    def _sweep_and_view(
        self, call: OperationCall, run: RunHead, *_: object
    ) -> dict[str, Any]:
        if isinstance(run, Run):  # else nobody plays it
            self.executor.sweep(run)
        return self._view(call, run)

    def base_url(self, call: OperationCall) -> str:
        """Where the caller reaches this server; without a slash at the end."""
        base = self.settings.public_url or str(call.request.base_url)
        return base.rstrip("/")


def _queue_s(submission: Mapping[str, Any]) -> float:
    return float(submission.get("options", {}).get("queue_s", 0.0))


def _check_same_manifest(base: RunHead, *runs: RunHead) -> None:
    mismatched = [r.run_id for r in runs if r.manifest_sha256 != base.manifest_sha256]
    if mismatched:
        text = f"{', '.join(mismatched)}: another manifest than {base.run_id}"
        raise Refused(
            "not_comparable",
            "Episodes pair only within one manifest.",
            errors=[("query:runs", text)],
            requirement="CMP-009",
        )


def _matches(if_none_match: str, etag: str) -> bool:
    tags = [tag.strip().removeprefix("W/") for tag in if_none_match.split(",")]
    return "*" in tags or etag in tags


def _number(cursor: str | None) -> int | None:
    if cursor is None:
        return None
    if not cursor.isdecimal() or len(cursor) > 15:
        raise Refused(
            "invalid_request",
            "The cursor is not one of this server's.",
            errors=[("query:cursor", "is the next_cursor of a page before")],
        )
    return int(cursor)
