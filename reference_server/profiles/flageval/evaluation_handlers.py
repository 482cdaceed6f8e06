"""The HTTP handlers of the profile `flageval`: FlagEval's automatic evaluation.

An evaluation is a push run whose policy is a chat model and has the evaluation's name.
A `request_id` is the ids of its runs, so that there is no state here. Each handler
translates a request into calls of `runs/service.py` and the results back; whether
something is allowed is decided there and in the rules. See spec/profiles/flageval.yaml
and docs/evaluate/flageval.md.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any, TypeVar

from pydantic import BaseModel
from starlette.responses import Response

from reference_record.generated.answers import ImageChoice
from reference_server.http import codec
from reference_server.http.bodies import request_bodies
from reference_server.http.bodies.bounded_parsing import read_message
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
    EvalDiff,
    EvaluationView,
    failures_of,
    progress,
    refusal_response,
    success_response,
)
from reference_server.push.chat_calls import is_playable_by_chat
from reference_server.rules.refusal import Refused
from reference_server.rules.runs.run import Run
from reference_server.runs.service import RunCommand, RunService

Body = TypeVar("Body", bound=BaseModel)
_NAME_IS_USED = "must be unique in the account"


@dataclass(frozen=True, slots=True)
class FlagevalHandlers:
    """The operations of FlagEval over the use cases of this server."""

    handlers: Handlers

    @property
    def service(self) -> RunService:
        return self.handlers.service

    def table(self) -> dict[str, dict[str, Operation]]:
        """path → method → operation."""
        operation = partial(
            Operation,
            refusal_response=refusal_response,
            local_account=self.handlers.settings.flageval_account,
        )
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
        """FLE-001, FLE-003: a run for each model, all checked before one is stored."""
        requested: EvaluationRequest = call.body
        requested.check()
        benchmark_id = self._benchmark_id(requested)
        images = await self._images(benchmark_id)
        runs: list[Run] = []
        for number in range(len(requested.eval_infos)):
            submission = requested.submission(number, benchmark_id, images)
            try:
                runs.append(await self.service.prepare_run(call.account, submission))
            except Refused as refused:
                raise translate_refusal(refused, number) from refused
            await self._check_name(call.account, requested, number)
        # FLE-004: the name is the Idempotency-Key, so that a repeat returns its run.
        created = [
            await self.service.store_run(
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
                "benchmark_id": benchmark_id,
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
        evaluations = await self._evaluated(call.account, requested.request_id)
        results = {
            evaluation.eval_model: evaluation.result(
                await self._baseline(call.account, evaluation, evaluations)
            )
            for evaluation in evaluations
        }
        members = {"eval_results": results, "tolerance": TOLERANCE}
        return success_response(failures_of(evaluations), **members)

    async def stop(self, call: OperationCall) -> Response:
        """FLE-012."""
        await self._apply_to_each(call, "stop")
        return success_response()

    async def resume(self, call: OperationCall) -> Response:
        """FLE-013."""
        await self._apply_to_each(call, "resume")
        return success_response()

    async def progress(self, call: OperationCall) -> Response:
        evaluations = await self._evaluated(call.account, call.body.request_id)
        return success_response(failures_of(evaluations), **progress(evaluations))

    async def diffs_by_id(self, call: OperationCall) -> Response:
        """FLE-015: with GET a map, as FlagEval's server answers."""
        return success_response(eval_diffs=await self._diffs(call), tolerance=TOLERANCE)

    async def diffs_as_list(self, call: OperationCall) -> Response:
        """FLE-015: with POST a list, as FlagEval's document has it."""
        diffs_by_id = await self._diffs(call)
        diffs = [diff | {"request_id": name} for name, diff in diffs_by_id.items()]
        return success_response(eval_diffs=diffs, tolerance=TOLERANCE)

    async def _diffs(self, call: OperationCall) -> dict[str, EvalDiff]:
        requested = await self._read_query_or_body(
            call, DiffsRequest, "request_ids", lambda text: text.split(",")
        )
        first, *others = requested.request_ids
        bases = await self._evaluated(call.account, first)
        base = next(
            (evaluation for evaluation in bases if evaluation.is_baseline), bases[0]
        )
        return {
            name: (await self._evaluated(call.account, name))[0].diff(base)
            for name in others
        }

    def _benchmark_id(self, requested: EvaluationRequest) -> str:
        """FLE-023: what the host maps the mode to, or the benchmark that it names."""
        modes = self.handlers.settings.mode_table
        mapped = modes.find(requested.domain, requested.mode)
        if mapped is None and self.service.benchmarks.offers(requested.mode):
            return requested.mode
        return mapped or modes.find_any(requested.domain, requested.mode)

    async def _images(self, benchmark_id: str) -> ImageChoice | None:
        """Image options that a chat model accepts; None for the benchmark's default."""
        try:
            benchmark = await self.service.benchmarks.view(benchmark_id)
        except Refused as refused:
            raise Refused(
                "invalid_request",
                refused.detail,
                errors=[("/mode", f"is mapped to {benchmark_id}, which is missing")],
            ) from refused
        if not is_playable_by_chat(benchmark):
            raise Refused(
                "invalid_request",
                f"A chat model cannot play {benchmark_id}.",
                errors=[("/mode", "must name a question-answering benchmark")],
            )
        if "png" not in benchmark["image_codecs"]:
            return None
        return {"codec": "png", **benchmark["image_sizes"][0]}

    async def _check_name(
        self, account: str, requested: EvaluationRequest, number: int
    ) -> None:
        """FLE-003: a name that another evaluation has is refused."""
        name = requested.eval_infos[number].eval_model
        try:
            await self.service.check_key(
                account, idempotency_key(name), requested.digest(number)
            )
        except Refused as refused:
            raise Refused(
                refused.code,
                f"An evaluation with a different body is named {name}.",
                errors=[(f"/eval_infos/{number}/eval_model", _NAME_IS_USED)],
            ) from refused

    async def _baseline(
        self, account: str, evaluation: EvaluationView, beside: Sequence[EvaluationView]
    ) -> EvaluationView | None:
        """FLE-010: itself if it is one, else of this request, else an earlier one."""
        if evaluation.is_baseline:
            return evaluation
        name = evaluation.base_model_name + BASELINE
        bases = [candidate for candidate in beside if candidate.is_baseline]
        bases.sort(key=lambda candidate: candidate.eval_model != name)
        if bases:
            return bases[0]
        existing = await self.service.find_by_key(account, idempotency_key(name))
        if existing is None:
            return None
        return (await self._evaluated(account, existing.run_id))[0]

    async def _evaluated(self, account: str, request_id: str) -> list[EvaluationView]:
        """The evaluations of a request, if they are the account's (FLE-016)."""
        read = self.service.registry.reader.read_view
        return [
            await read(run_id, account, EvaluationView.from_run, end=None)
            for run_id in request_id.split(".")
        ]

    async def _apply_to_each(self, call: OperationCall, command: RunCommand) -> None:
        """Apply a command to each run that allows it; refuse it if none does."""
        ids = call.body.request_id.split(".")
        for run_id in ids:  # before any is changed: does each exist?
            await self.service.find_run(call.account, run_id)
        refusals: list[Refused] = []
        for run_id in ids:
            try:
                await self.service.command_run(command, call.account, run_id)
            except Refused as refused:
                if refused.code != "illegal_transition":
                    raise
                refusals.append(refused)
        if len(refusals) == len(ids):
            raise refusals[0]

    async def _read_query_or_body(
        self,
        call: OperationCall,
        model: type[Body],
        name: str,
        read: Callable[[str], Any],
    ) -> Body:
        """FLE-008: from the query, or from the body that FlagEval's client sends."""
        if name in call.query:
            return codec.validate(model, {name: read(call.query[name])})
        codec.media_type_of(call.request, (JSON,))
        limit = self.handlers.settings.max_body_bytes
        body = await request_bodies.read_body(call.request, limit)
        return await read_message(model, body, JSON)
