"""FlagEval's wire as a client uses it: a request, and what it is answered.

The plain verbs are set-up and raise SetUpFailed; `try_` gives the body of the answer,
for `expect` to judge.
"""

import time
import uuid
from dataclasses import dataclass
from typing import Any

from conformance.client.check_context import Story
from conformance.client.http_client import Wire
from conformance.policy.chat import ScriptedChat
from conformance.policy.push_run import is_here
from conformance.verdicts import expect
from conformance.verdicts.expect import SetUpFailed, Violation

LONGEST_S = 15.0
# Of `calibration`, as profiles/flageval.yaml has it.
DATASETS = {"score": 4, "count": 2}
_POLL_S = 0.02


def fresh(name: str) -> str:
    """Give a name that nobody has used yet."""
    return f"{uuid.uuid4().hex[:12]}-{name}"


def info(chat: ScriptedChat, name: str, **members: Any) -> dict[str, Any]:
    """Give one of eval_infos; the model is asked by the evaluation's name."""
    given = {"eval_model": name, "model": name, "eval_url": chat.completions_url}
    return given | {"tokenizer": "none", "num_retry": 0} | members


def ask(
    story: Story,
    path: str,
    body: Any,
    *,
    method: str = "POST",
    wire: Wire | None = None,
) -> dict[str, Any]:
    """Send a request; its answer has status 200 in any case."""
    wire = wire or story.wire
    answer = wire.request(method, f"{wire.base_url}{path}", json=body)
    return dict(expect.ok(answer))


def refused(told: dict[str, Any]) -> None:
    """Expect a refusal."""
    expect.equal(told.get("err_code"), 1, "err_code")


def refused_in_form(told: dict[str, Any]) -> None:
    """Expect a refusal as FLE-002 has it."""
    refused(told)
    messages = [told.get("err_msg"), told.get("err_message")]
    expect.true(
        messages[0] and messages[0] == messages[1],
        "one text in err_msg and err_message",
        messages,
    )
    expect.true("request_id" not in told, "no request_id", told)


def succeeded(told: dict[str, Any]) -> dict[str, Any]:
    """Expect success; what was asked for."""
    expect.equal(told.get("err_code"), 0, "err_code")
    return expect.Expected(told)


def try_begin(story: Story, *infos: dict[str, Any], **members: Any) -> dict[str, Any]:
    """Ask for evaluations on calibration; the answer is raw."""
    body = {"eval_infos": list(infos), "domain": "MM", "mode": "calibration"}
    told = ask(story, "/evaluation", body | members)
    for task in told.get("eval_tasks", []):
        shown = story.call("get_run", run_id=str(task.get("run_id")))
        if shown.status == 200:
            story.adopt(shown.json)
    return told


@dataclass(frozen=True)
class Requested:
    """Evaluations that were begun."""

    story: Story
    request_id: str
    run_ids: list[str]

    def progress(self) -> dict[str, Any]:
        """Read the progress, whose members are under test."""
        body = {"request_id": self.request_id, "domain": "MM"}
        return succeeded(ask(self.story, "/evaluation_progress", body))

    def results(self) -> dict[str, Any]:
        """Read the results, by eval_model."""
        body = {"request_id": self.request_id}
        told = ask(self.story, "/evaldiffs", body, method="GET")
        results: dict[str, Any] = succeeded(told)["eval_results"]
        return results

    def finished(self) -> dict[str, Any]:
        """Wait for the end; the progress then."""
        deadline = time.monotonic() + LONGEST_S
        while not (told := self.progress())["finished"]:
            if time.monotonic() > deadline:
                raise Violation(f"an end within {LONGEST_S:g} s", expect.shown(told))
            time.sleep(_POLL_S)
        return told

    def command(self, path: str) -> None:
        """Stop or resume."""
        succeeded(ask(self.story, path, {"request_id": self.request_id}))


def begin(story: Story, *infos: dict[str, Any], **members: Any) -> Requested:
    """Begin evaluations; SetUpFailed if the server cannot reach the kit's model."""
    told = try_begin(story, *infos, **members)
    if told.get("err_code") != 0:
        raise SetUpFailed(
            f"`/evaluation` was refused: {told.get('err_msg')}",
            allowed=not is_here(story.context.settings.url),
        )
    ids = {task["eval_model"]: task["run_id"] for task in told["eval_tasks"]}
    named = [ids[one["eval_model"]] for one in infos]
    return Requested(story, told["request_id"], named)


def evaluated(story: Story, *infos: dict[str, Any], **members: Any) -> Requested:
    """Begin evaluations and wait for their end."""
    requested = begin(story, *infos, **members)
    requested.finished()
    return requested
