"""Mutants of the profile `flageval`."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import msgspec
from starlette.responses import Response

from reference_server.http.codec import JSON
from reference_server.http.dispatch import OperationCall
from reference_server.profiles.flageval import (
    evaluation_handlers,
    evaluation_requests,
    evaluation_responses,
)
from reference_server.profiles.flageval.evaluation_handlers import FlagevalHandlers
from reference_server.profiles.flageval.evaluation_requests import (
    EvaluationRequest,
    RequestReference,
)
from reference_server.profiles.flageval.evaluation_responses import EvaluationView
from reference_server.push import chat_calls
from reference_server.rules.refusal import Refused
from tests.mutants import Json, instead_of, mutant, put


def change_result(change: Callable[[Json, Json, Any], None]) -> None:
    """Let `change(detail, group, base)` spoil each dataset of every result."""
    right: Any = EvaluationView.result

    def wrong(self: Any, base: EvaluationView | None) -> Any:
        result = right(self, base)
        for detail in result["details"]:
            change(detail, self.datasets[detail["dataset"]], base)
        return result

    put(EvaluationView, "result", wrong)


def change_body(operation: str, change: Callable[[Json, OperationCall], None]) -> None:
    """Let `change(body, call)` spoil the answers of one operation."""
    right = getattr(FlagevalHandlers, operation)

    async def wrong(self: FlagevalHandlers, call: OperationCall) -> Response:
        body = json.loads(bytes((await right(self, call)).body))
        change(body, call)
        return Response(msgspec.json.encode(body), media_type=JSON)

    put(FlagevalHandlers, operation, wrong)


def release_of_any(compared: Any) -> Json:
    """Give `release` as if every baseline said something."""
    return {"release": compared is not None and compared["release"]}


@mutant("FLE-001")
def returns_evaluations_in_another_order() -> None:
    """The result of one model is published as that of another."""
    change_body("evaluation", lambda body, _: body["eval_tasks"].reverse())


@mutant("FLE-002", through=instead_of(evaluation_handlers, "refusal_response"))
def omits_err_message(right: Any, refused: Refused) -> Any:
    """Scripts written from the document find no error text."""
    body = json.loads(bytes(right(refused).body))
    del body["err_message"]
    return Response(msgspec.json.encode(body), media_type=JSON)


@mutant("FLE-003")
def takes_a_used_name_for_a_repeat() -> None:
    """The second chip is never evaluated and gets the result of the first."""
    put(EvaluationRequest, "digest", lambda _self, _number: "same")


@mutant("FLE-004")
def refuses_a_repeat() -> None:
    """A client that lost the answer never learns the request_id."""
    put(EvaluationRequest, "digest", lambda self, _number: f"{id(self)}")


@mutant("FLE-005")
def ignores_generation_settings() -> None:
    """Every model runs at the default temperature of its server."""
    put(evaluation_requests, "_generation", lambda _text, _at: {})


@mutant("FLE-006")
def returns_api_keys() -> None:
    """API keys appear in the logs of scripts."""

    def wrong(body: Json, call: OperationCall) -> None:
        body["asked"] = [info.api_key for info in call.body.eval_infos]

    change_body("evaluation", wrong)


@mutant("FLE-007", "FLE-022")
def calls_the_success_rate_accuracy() -> None:
    """A model with partial scores everywhere has an accuracy of 0."""
    change_result(
        lambda detail, group, _: detail.update(accuracy=group["success_rate"])
    )


@mutant("FLE-008", through=instead_of(FlagevalHandlers, "_read_query_or_body"))
async def ignores_the_query(
    right: Any, self: FlagevalHandlers, call: OperationCall, *rest: Any
) -> Any:
    """Clients that cannot send a body with GET get no result."""
    return await right(self, replace(call, query={}), *rest)


@mutant("FLE-009", through=instead_of(evaluation_responses, "status_of"))
def reports_retryable_failures_as_final(right: Any, *arguments: Any) -> Any:
    """The run does not wait for a policy server that restarts."""
    status = right(*arguments)
    return "F" if status == "OOR" else status


@mutant("FLE-010", through=change_result)
def subtracts_the_other_way(detail: Json, _group: Json, _base: Any) -> None:
    """A model that got worse is reported as better."""
    if detail["diff"] is not None:
        detail["diff"] = -detail["diff"]


@mutant("FLE-011", through=instead_of(EvaluationView, "result"))
def releases_without_a_baseline(
    right: Any, self: EvaluationView, base: EvaluationView | None
) -> Any:
    """A chip is released because its baseline was never evaluated."""
    result = right(self, base)
    return result | {"release": base is None or result["release"]}


@mutant("FLE-012", through=instead_of(FlagevalHandlers, "stop"))
async def stops_the_first_model_alone(
    right: Any, self: FlagevalHandlers, call: OperationCall
) -> Any:
    """The other models continue to call their servers."""
    first, *_ = call.body.request_id.split(".")
    return await right(self, replace(call, body=RequestReference(request_id=first)))


@mutant("FLE-009", "FLE-013", through=instead_of(FlagevalHandlers, "resume"))
async def reports_success_without_resuming(
    _right: Any, self: FlagevalHandlers, call: OperationCall
) -> Any:
    """A script waits all night for a run that was never resumed."""
    await self._evaluated(call.account, call.body.request_id)
    return evaluation_responses.success_response()


@mutant("FLE-014")
def counts_models_instead_of_datasets() -> None:
    """Progress is reported in the wrong unit."""

    def wrong(body: Json, call: OperationCall) -> None:
        total = len(call.body.request_id.split("."))
        done = total if body["finished"] else 0
        body["datasets_progress"] = f"{done}/{total}"

    change_body("progress", wrong)


@mutant("FLE-015")
def always_answers_diffs_as_a_map() -> None:
    """Scripts written from the document expect a list and find none."""
    put(FlagevalHandlers, "diffs_as_list", FlagevalHandlers.diffs_by_id)


@mutant("FLE-016", through=instead_of(FlagevalHandlers, "_evaluated"))
async def shows_results_to_every_account(
    right: Any, self: FlagevalHandlers, _account: str, request_id: str
) -> Any:
    """An account that knows a request_id reads the results of others."""
    run = await self.service.registry.get(request_id.split(".", maxsplit=1)[0])
    return await right(self, run.account, request_id)


@mutant("FLE-018", through=instead_of(EvaluationRequest, "check"))
def requires_a_tokenizer(right: Any, self: EvaluationRequest) -> None:
    """A script that was written for FlagEval's server is refused."""
    right(self)
    if not all(info.tokenizer for info in self.eval_infos):
        raise Refused("invalid_request", "There is no tokenizer.")


@mutant("FLE-020")
def keeps_the_reason_of_a_failure() -> None:
    """A person with a wrong key sees OOR, and looks for the fault in the model."""
    put(evaluation_handlers, "failures_of", lambda _evaluations: "success")


@mutant("FLE-021")
def releases_what_is_as_bad_as_nothing() -> None:
    """Two models without a readable answer are released as equal."""
    put(evaluation_responses, "_gate", release_of_any)


@mutant("FLE-021", through=instead_of(EvaluationView, "diff"))
def compares_requests_with_a_baseline_of_nothing(
    right: Any, self: EvaluationView, base: EvaluationView
) -> Any:
    """Two requests without a readable answer are released as equal."""
    diff = right(self, base)
    diff.pop("warning", None)
    return diff | release_of_any(self.compare_with(base))


@mutant("FLE-022")
def reads_the_last_line_alone() -> None:
    """A model that answers in a sentence scores nothing."""
    put(chat_calls, "_marked", lambda _text: "")
