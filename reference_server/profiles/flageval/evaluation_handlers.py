"""The profile `flageval`: FlagEval's automatic evaluation, over our own push runs.

An evaluation is a run whose policy is a chat model; its name is the policy's. A request
is its runs: `request_id` holds their ids, so nothing is remembered here. See
spec/profiles/flageval.yaml and docs/flageval.md.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import Any, TypeVar

from pydantic import BaseModel
from starlette.responses import Response

from reference_server.http import codec
from reference_server.http.codec import JSON
from reference_server.http.dispatch import Operation, OperationCall
from reference_server.http.handlers import Handlers
from reference_server.profiles.flageval.evaluation_requests import (
    DiffsRequest,
    EvaluationRequest,
    ProgressRequest,
    RequestReference,
    idempotency_key,
    translate_refusal,
)
from reference_server.profiles.flageval.evaluation_responses import (
    BASELINE,
    TOLERANCE,
    EvaluationView,
    progress,
    refusal_response,
    success_response,
)
from reference_server.push.chat_calls import is_playable_by_chat
from reference_server.rules.lifecycle import Event, Stop, legal
from reference_server.rules.refusal import Refused
from reference_server.rules.run import Run

Body = TypeVar("Body", bound=BaseModel)


@dataclass(frozen=True, slots=True)
class FlagevalHandlers:
    """The operations, over the routes of this server."""

    handlers: Handlers

    def table(self) -> dict[str, dict[str, Operation]]:
        """path → method → operation."""
        operation = partial(Operation, refusal_response=refusal_response)
        diffs = partial(operation, query=("request_ids",))
        return {
            "/evaluation": {
                "POST": operation(self.evaluation, "run", EvaluationRequest)
            },
            "/evaldiffs": {"GET": operation(self.evaldiffs, query=("request_id",))},
            "/stop_evaluation": {"POST": operation(self.stop, "run", RequestReference)},
            "/resume_evaluation": {
                "POST": operation(self.resume, "run", RequestReference)
            },
            "/evaluation_progress": {
                "POST": operation(self.progress, body=ProgressRequest)
            },
            "/evaluation_diffs": {
                "GET": diffs(self.diffs_by_id),
                "POST": diffs(self.diffs_as_list),
            },
        }

    async def evaluation(self, call: OperationCall) -> Response:
        """A run for each model: all are checked before any is there."""
        requested: EvaluationRequest = call.body
        requested.check()
        images = await self._images(requested)
        runs: list[Run] = []
        for number, info in enumerate(requested.eval_infos):
            submission = requested.submission(number, images)
            try:
                runs.append(await self.handlers.prepare_run(call.account, submission))
            except Refused as refused:
                raise translate_refusal(refused, number) from refused
            existing = await self.handlers.registry.find_by_key(
                call.account, idempotency_key(info.eval_model)
            )
            digest = requested.digest(number)
            if existing is not None and existing.body_sha256 != digest:
                raise Refused(
                    "idempotency_conflict",
                    f"An evaluation of another body is named {info.eval_model}.",
                    errors=[(f"/eval_infos/{number}/eval_model", "is used once")],
                )
        created = [
            await self.handlers.registry.add(
                run, idempotency_key(info.eval_model), requested.digest(i)
            )
            for i, (run, info) in enumerate(
                zip(runs, requested.eval_infos, strict=True)
            )
        ]
        tasks = [
            {
                "eval_model": info.eval_model,
                "run_id": run.run_id,
                "model": info.model,
                "chip": info.chip,
                "datasets": list(dict.fromkeys(e.task for e in run.episodes)),
            }
            for run, info in zip(created, requested.eval_infos, strict=True)
        ]
        request_id = ".".join(run.run_id for run in created)
        return success_response(request_id=request_id, eval_tasks=tasks)

    async def evaldiffs(self, call: OperationCall) -> Response:
        requested = await self._read_query_or_body(
            call, RequestReference, "request_id", str
        )
        ones = await self._evaluated(call, requested.request_id)
        results = {
            one.eval_model: one.result(await self._baseline(call, one, ones))
            for one in ones
        }
        return success_response(eval_results=results, tolerance=TOLERANCE)

    async def stop(self, call: OperationCall) -> Response:
        stopped = partial(self.handlers.apply_stop, stop=Stop("abort"))
        await self._apply_to_each(call, "stop_abort", stopped)
        return success_response()

    async def resume(self, call: OperationCall) -> Response:
        await self._apply_to_each(call, "resume_run", self.handlers.apply_resume)
        return success_response()

    async def progress(self, call: OperationCall) -> Response:
        return success_response(
            **progress(await self._evaluated(call, call.body.request_id))
        )

    async def diffs_by_id(self, call: OperationCall) -> Response:
        """As their server answers: a map."""
        return success_response(eval_diffs=await self._diffs(call), tolerance=TOLERANCE)

    async def diffs_as_list(self, call: OperationCall) -> Response:
        """As their document has it: a list."""
        found = await self._diffs(call)
        diffs = [{"request_id": name} | diff for name, diff in found.items()]
        return success_response(eval_diffs=diffs, tolerance=TOLERANCE)

    async def _diffs(self, call: OperationCall) -> dict[str, dict[str, Any]]:
        requested = await self._read_query_or_body(
            call, DiffsRequest, "request_ids", lambda text: text.split(",")
        )
        first, *others = requested.request_ids
        bases = await self._evaluated(call, first)
        base = next((one for one in bases if one.is_baseline), bases[0])
        return {
            name: (await self._evaluated(call, name))[0].diff(base) for name in others
        }

    async def _images(self, requested: EvaluationRequest) -> Mapping[str, Any] | None:
        """What a chat model can be shown; None for the benchmark's own choice."""
        try:
            benchmark = await self.handlers.benchmarks.view(requested.benchmark_id)
        except Refused as refused:
            raise Refused(
                "invalid_request", refused.detail, errors=[("/mode", "names none")]
            ) from refused
        if not is_playable_by_chat(benchmark):
            raise Refused(
                "invalid_request",
                f"{requested.benchmark_id} is not answered in words.",
                errors=[("/mode", "names no questions")],
            )
        codecs, size = benchmark["image_codecs"], benchmark["image_sizes"][0]
        return {"codec": "png", **size} if "png" in codecs else None

    async def _baseline(
        self, call: OperationCall, one: EvaluationView, beside: Sequence[EvaluationView]
    ) -> EvaluationView | None:
        """Itself, if it is one; else that of this request; else an earlier one."""
        if one.is_baseline:
            return one
        name = one.base_model_name + BASELINE
        bases = [other for other in beside if other.is_baseline]
        bases.sort(key=lambda other: other.eval_model != name)
        if bases:
            return bases[0]
        existing = await self.handlers.registry.find_by_key(
            call.account, idempotency_key(name)
        )
        if existing is None:
            return None
        return (await self._evaluated(call, existing.run_id))[0]

    async def _evaluated(
        self, call: OperationCall, request_id: str
    ) -> list[EvaluationView]:
        look = self.handlers.registry.read_view
        return [
            await look(run_id, call.account, EvaluationView.from_run, end=None)
            for run_id in request_id.split(".")
        ]

    async def _apply_to_each(
        self, call: OperationCall, event: Event, act: Callable[[OperationCall], Any]
    ) -> None:
        """Those of the request's runs that may; refused when none of them may."""
        ids = call.body.request_id.split(".")
        runs = [
            await self.handlers.registry.get(run_id, call.account) for run_id in ids
        ]
        may = [run.run_id for run in runs if legal(run, event)]
        for run_id in may or ids[:1]:
            await act(replace(call, path={"run_id": run_id}))

    async def _read_query_or_body(
        self,
        call: OperationCall,
        model: type[Body],
        name: str,
        read: Callable[[str], Any],
    ) -> Body:
        """From the query, or from the body that their client sends with a GET."""
        if name in call.query:
            return codec.validate(model, {name: read(call.query[name])})
        codec.media_type_of(call.request, (JSON,))
        limit = self.handlers.settings.max_body_bytes
        body = await codec.read_body(call.request, limit)
        return codec.validate(model, codec.decode(body, JSON))
