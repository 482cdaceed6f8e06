"""Shared by the tests of FlagEval's API: a server, a model, a client's requests."""

from typing import Any

import httpx

from conformance.policy.scripted_chat import ScriptedChat
from tests.support.waiting import wait_until

KEY = "sk-this-is-nobodys-business"
TASKS = {"score": 4, "count": 2}


def model_info(chat: ScriptedChat, name: str, **more: Any) -> dict[str, Any]:
    members = {
        "eval_model": name,
        "model": name,
        "eval_url": chat.completions_url,
        "tokenizer": "Qwen/Qwen3-8B",
        "num_retry": 0,
    }
    return members | more


def post_evaluation(client: httpx.Client, *infos: dict[str, Any], **more: Any) -> Any:
    body = {"eval_infos": list(infos), "domain": "MM", "mode": "calibration"} | more
    answer = client.post("/evaluation", json=body)
    assert answer.status_code == 200, answer.text
    assert KEY not in answer.text
    return answer.json()


def submit_evaluation(client: httpx.Client, *infos: dict[str, Any], **more: Any) -> str:
    answer = post_evaluation(client, *infos, **more)
    assert answer["err_code"] == 0, answer
    return str(answer["request_id"])


def post(client: httpx.Client, path: str, **body: Any) -> Any:
    answer = client.post(path, json=body)
    assert answer.status_code == 200, answer.text
    return answer.json()


def get_progress(client: httpx.Client, request_id: str) -> Any:
    return post(client, "/evaluation_progress", request_id=request_id, domain="MM")


def wait_until_finished(client: httpx.Client, request_id: str) -> Any:
    wait_until(lambda: get_progress(client, request_id)["finished"], "it has finished")
    return get_progress(client, request_id)


def get_evaldiffs(client: httpx.Client, request_id: str) -> Any:
    """As their scripts do: a GET with a body."""
    answer = client.request("GET", "/evaldiffs", json={"request_id": request_id})
    assert answer.status_code == 200, answer.text
    return answer.json()


def is_refused(answer: Any, about: str) -> bool:
    assert answer["err_code"] == 1
    assert answer["err_msg"] == answer["err_message"]
    assert about in answer["err_msg"], answer
    return set(answer) == {"err_code", "err_msg", "err_message"}
