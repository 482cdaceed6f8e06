"""The API of FlagEval as a client uses it.

Plain functions are set-up and raise SetUpFailed; `try_` functions return the body of
the response, for `expect` to judge.
"""

import time
import uuid
from dataclasses import dataclass
from typing import Any

from conformance.client.check_context import CheckContext
from conformance.client.http_client import HttpClient
from conformance.policy.push_run import is_local
from conformance.policy.scripted_chat import ScriptedChat
from conformance.verdicts import expect
from conformance.verdicts.expect import SetUpFailed

END_TIMEOUT_S = 15.0
# Data set → its number of questions in `calibration`, as in profiles/flageval.yaml.
DATASETS = {"score": 4, "count": 2}
# Some of vectors/answers: the reply of a model → the number that it answers (FLE-022).
ANSWERS_IN_TEXT = {
    "The answer is 0.25": 0.25,
    "First 1, then 0.5.\nSo the answer is **0.5**.": 0.5,
    "I get \\boxed{0.75} metres": 0.75,
    "\\boxed{1}\nNo: \\boxed{0.25}, as I said.": 0.25,
    "<answer>0.5</answer>": 0.5,
    "0.75 </answer>": 0.75,
    "Half of 0.5 is a quarter.\n#### 0.25 of it": 0.0,
    "Half of 1.\n#### 0.5": 0.5,
    "The answer is not 1": 0.0,
    "I think that it is 1 or 0": 0.0,
}
_POLL_S = 0.02


def unique_name(name: str) -> str:
    """Give a name that was not used before."""
    return f"{uuid.uuid4().hex[:12]}-{name}"


def info(chat: ScriptedChat, name: str, **members: Any) -> dict[str, Any]:
    """Give one of eval_infos; the model has the name of the evaluation."""
    defaults = {"eval_model": name, "model": name, "eval_url": chat.completions_url}
    return defaults | {"tokenizer": "none", "num_retry": 0} | members


def call_flageval(
    context: CheckContext,
    path: str,
    body: Any,
    *,
    method: str = "POST",
    http_client: HttpClient | None = None,
) -> dict[str, Any]:
    """Send a request; every response has status 200."""
    http_client = http_client or context.http_client
    answer = http_client.request(method, f"{http_client.base_url}{path}", json=body)
    return dict(expect.ok(answer))


def expect_refused(answer: dict[str, Any]) -> None:
    expect.equal(answer.get("err_code"), 1, "err_code")


def expect_refused_in_form(answer: dict[str, Any]) -> None:
    """Expect a refusal in the form of FLE-002."""
    expect_refused(answer)
    messages = [answer.get("err_msg"), answer.get("err_message")]
    is_one = messages[0] and messages[0] == messages[1]
    expect.true(is_one, "one text in err_msg and err_message", messages)
    expect.true("request_id" not in answer, "no request_id", answer)


def expect_success(answer: dict[str, Any]) -> dict[str, Any]:
    """Expect success, and give the body."""
    expect.equal(answer.get("err_code"), 0, "err_code")
    return expect.ExpectedBody(answer)


def try_begin(
    context: CheckContext, *models: dict[str, Any], **members: Any
) -> dict[str, Any]:
    """Request evaluations on calibration; the answer is raw."""
    body = {"eval_infos": list(models), "domain": "MM", "mode": "calibration"}
    answer = call_flageval(context, "/evaluation", body | members)
    for task in answer.get("eval_tasks", []):
        run_answer = context.call("get_run", run_id=str(task.get("run_id")))
        if run_answer.status == 200:
            context.adopt(run_answer.json)
    return answer


@dataclass(frozen=True)
class FlagEvalRequest:
    """A request for evaluations that was accepted."""

    context: CheckContext
    request_id: str
    run_ids: list[str]

    def progress(self) -> dict[str, Any]:
        """Read the progress, whose members are under test."""
        body = {"request_id": self.request_id, "domain": "MM"}
        return expect_success(call_flageval(self.context, "/evaluation_progress", body))

    def results(self) -> dict[str, Any]:
        """Read the results, by eval_model."""
        body = {"request_id": self.request_id}
        answer = call_flageval(self.context, "/evaldiffs", body, method="GET")
        results: dict[str, Any] = expect_success(answer)["eval_results"]
        return results

    def finished(self) -> dict[str, Any]:
        """Wait for the end, and give the progress."""
        deadline = time.monotonic() + END_TIMEOUT_S
        while not (answer := self.progress())["finished"]:
            if time.monotonic() > deadline:
                raise expect.missed(
                    f"an end within {END_TIMEOUT_S:g} s", expect.format_value(answer)
                )
            time.sleep(_POLL_S)
        return answer

    def command(self, path: str) -> None:
        """Stop or resume."""
        expect_success(
            call_flageval(self.context, path, {"request_id": self.request_id})
        )


def begin(
    context: CheckContext, *models: dict[str, Any], **members: Any
) -> FlagEvalRequest:
    """Begin evaluations; SetUpFailed if the server cannot reach the kit's model."""
    answer = try_begin(context, *models, **members)
    if answer.get("err_code") != 0:
        raise SetUpFailed(
            f"`/evaluation` was refused: {answer.get('err_msg')}",
            allowed=not is_local(context.shared.settings.url),
        )
    ids = {task["eval_model"]: task["run_id"] for task in answer["eval_tasks"]}
    named = [ids[info["eval_model"]] for info in models]
    return FlagEvalRequest(context, answer["request_id"], named)


def evaluate(
    context: CheckContext, *models: dict[str, Any], **members: Any
) -> FlagEvalRequest:
    """Begin evaluations and wait for their end."""
    flageval_request = begin(context, *models, **members)
    flageval_request.finished()
    return flageval_request
