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
from reference_server.http.dispatch import Call, Operation
from reference_server.http.handlers import Routes
from reference_server.http.problems import Refused
from reference_server.profiles.flageval.requests import (
    Diffs,
    Evaluation,
    Named,
    Progress,
    key_of,
    told_in_their_words,
)
from reference_server.profiles.flageval.responses import (
    BASELINE,
    TOLERANCE,
    Evaluated,
    answer,
    progress,
    refusal,
)
from reference_server.push.chat_calls import is_answered_in_words
from reference_server.rules.lifecycle import Event, Stop, legal
from reference_server.rules.run import Run

Asked = TypeVar("Asked", bound=BaseModel)


@dataclass(frozen=True, slots=True)
class Flageval:
    """The operations, over the routes of this server."""

    routes: Routes

    def table(self) -> dict[str, dict[str, Operation]]:
        """path → method → operation."""
        said = partial(Operation, refusal=refusal)
        diffs = partial(said, query=("request_ids",))
        return {
            "/evaluation": {"POST": said(self.evaluation, "run", Evaluation)},
            "/evaldiffs": {"GET": said(self.evaldiffs, query=("request_id",))},
            "/stop_evaluation": {"POST": said(self.stop, "run", Named)},
            "/resume_evaluation": {"POST": said(self.resume, "run", Named)},
            "/evaluation_progress": {"POST": said(self.progress, body=Progress)},
            "/evaluation_diffs": {
                "GET": diffs(self.diffs_by_id),
                "POST": diffs(self.diffs_in_a_list),
            },
        }

    async def evaluation(self, call: Call) -> Response:
        """A run for each model: all are checked before any is there."""
        asked: Evaluation = call.body
        asked.check()
        images = await self._images(asked)
        runs: list[Run] = []
        for number, info in enumerate(asked.eval_infos):
            submission = asked.submission(number, images)
            try:
                runs.append(await self.routes.new_run(call.account, submission))
            except Refused as refused:
                raise told_in_their_words(refused, number) from refused
            made = await self.routes.book.made_by(call.account, key_of(info.eval_model))
            if made is not None and made[0] != asked.digest(number):
                raise Refused(
                    "idempotency_conflict",
                    f"An evaluation of another body is named {info.eval_model}.",
                    errors=[(f"/eval_infos/{number}/eval_model", "is used once")],
                )
        kept = [
            await self.routes.book.add(run, key_of(info.eval_model), asked.digest(i))
            for i, (run, info) in enumerate(zip(runs, asked.eval_infos, strict=True))
        ]
        tasks = [
            {
                "eval_model": info.eval_model,
                "run_id": run.run_id,
                "model": info.model,
                "chip": info.chip,
                "datasets": list(dict.fromkeys(e.task for e in run.episodes)),
            }
            for run, info in zip(kept, asked.eval_infos, strict=True)
        ]
        request_id = ".".join(run.run_id for run in kept)
        return answer(request_id=request_id, eval_tasks=tasks)

    async def evaldiffs(self, call: Call) -> Response:
        asked = await self._asked(call, Named, "request_id", str)
        ones = await self._evaluated(call, asked.request_id)
        results = {
            one.eval_model: one.result(await self._baseline(call, one, ones))
            for one in ones
        }
        return answer(eval_results=results, tolerance=TOLERANCE)

    async def stop(self, call: Call) -> Response:
        stopped = partial(self.routes.stopped, stop=Stop("abort"))
        await self._all(call, "stop_abort", stopped)
        return answer()

    async def resume(self, call: Call) -> Response:
        await self._all(call, "resume_run", self.routes.resumed)
        return answer()

    async def progress(self, call: Call) -> Response:
        return answer(**progress(await self._evaluated(call, call.body.request_id)))

    async def diffs_by_id(self, call: Call) -> Response:
        """As their server answers: a map."""
        return answer(eval_diffs=await self._diffs(call), tolerance=TOLERANCE)

    async def diffs_in_a_list(self, call: Call) -> Response:
        """As their document has it: a list."""
        found = await self._diffs(call)
        diffs = [{"request_id": name} | diff for name, diff in found.items()]
        return answer(eval_diffs=diffs, tolerance=TOLERANCE)

    async def _diffs(self, call: Call) -> dict[str, dict[str, Any]]:
        asked = await self._asked(
            call, Diffs, "request_ids", lambda text: text.split(",")
        )
        first, *others = asked.request_ids
        bases = await self._evaluated(call, first)
        base = next((one for one in bases if one.is_baseline), bases[0])
        return {
            name: (await self._evaluated(call, name))[0].diff(base) for name in others
        }

    async def _images(self, asked: Evaluation) -> Mapping[str, Any] | None:
        """What a chat model can be shown; None for the benchmark's own choice."""
        try:
            benchmark = await self.routes.benchmarks.view(asked.benchmark_id)
        except Refused as refused:
            raise Refused(
                "invalid_request", refused.detail, errors=[("/mode", "names none")]
            ) from refused
        if not is_answered_in_words(benchmark):
            raise Refused(
                "invalid_request",
                f"{asked.benchmark_id} is not answered in words.",
                errors=[("/mode", "names no questions")],
            )
        codecs, size = benchmark["image_codecs"], benchmark["image_sizes"][0]
        return {"codec": "png", **size} if "png" in codecs else None

    async def _baseline(
        self, call: Call, one: Evaluated, beside: Sequence[Evaluated]
    ) -> Evaluated | None:
        """Itself, if it is one; else that of this request; else an earlier one."""
        if one.is_baseline:
            return one
        name = one.base_model_name + BASELINE
        bases = [other for other in beside if other.is_baseline]
        bases.sort(key=lambda other: other.eval_model != name)
        if bases:
            return bases[0]
        made = await self.routes.book.made_by(call.account, key_of(name))
        if made is None:
            return None
        return (await self._evaluated(call, made[1]))[0]

    async def _evaluated(self, call: Call, request_id: str) -> list[Evaluated]:
        look = self.routes.book.look
        return [
            await look(run_id, call.account, Evaluated.of, end=None)
            for run_id in request_id.split(".")
        ]

    async def _all(self, call: Call, event: Event, act: Callable[[Call], Any]) -> None:
        """Those of the request's runs that may; refused when none of them may."""
        ids = call.body.request_id.split(".")
        runs = [await self.routes.book.get(run_id, call.account) for run_id in ids]
        may = [run.run_id for run in runs if legal(run, event)]
        for run_id in may or ids[:1]:
            await act(replace(call, path={"run_id": run_id}))

    async def _asked(
        self,
        call: Call,
        model: type[Asked],
        name: str,
        read: Callable[[str], Any],
    ) -> Asked:
        """From the query, or from the body that their client sends with a GET."""
        if name in call.query:
            return codec.validate(model, {name: read(call.query[name])})
        codec.media_type_of(call.request, (JSON,))
        limit = self.routes.settings.max_body_bytes
        body = await codec.read_body(call.request, limit)
        return codec.validate(model, codec.decode(body, JSON))
