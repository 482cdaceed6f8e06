"""What FlagEval's API refuses: names in use, invalid bodies, unknown requests."""

from __future__ import annotations

from typing import Any

import httpx
import pytest

from conformance.policy.scripted_chat import ScriptedChat
from tests.support.profiles.flageval_client import (
    KEY,
    get_evaldiffs,
    get_progress,
    is_refused,
    model_info,
    post,
    post_evaluation,
    submit_evaluation,
    wait_until_finished,
)
from tests.support.servers import ReferenceServer


@pytest.mark.parametrize(
    ("change", "about"),
    [
        ({"domain": "Audio"}, "/domain"),
        ({"region": "nowhere"}, "/region"),
        ({"eval_infos": []}, "/eval_infos"),
        ({"domain": "NLP", "mode": ""}, "NLP needs `mode`"),
        ({"mode": "no_such_thing"}, "/mode is not a known benchmark"),
        ({"mode": "tabletop_state"}, "/mode must name a question-answering benchmark"),
        ({"user_id": "seven"}, "/user_id"),
        ({"special_event": "y" * 201}, "/special_event"),
    ],
)
def test_an_invalid_evaluation_is_refused(
    client: httpx.Client, chat: ScriptedChat, change: dict[str, Any], about: str
) -> None:
    body = {
        "eval_infos": [model_info(chat, "f")],
        "domain": "MM",
        "mode": "calibration",
    }
    answer = client.post("/evaluation", json=body | change)
    assert answer.status_code == 200
    assert is_refused(answer.json(), about)
    assert "request_id" not in answer.json()


@pytest.mark.parametrize(
    ("change", "about"),
    [
        ({"eval_model": ""}, "/eval_infos/0/eval_model"),
        ({"eval_model": None}, "/eval_infos/0/eval_model"),
        ({"eval_url": "http://127.0.0.1:1/v1"}, "/eval_infos/0/eval_url must end with"),
        ({"eval_url": "ftp://x/chat/completions"}, "/eval_infos/0/eval_url"),
        ({"eval_url": "http://10.0.0.1/v1/chat/completions"}, "/eval_infos/0/eval_url"),
        ({"num_concurrent": 0}, "/eval_infos/0/num_concurrent"),
        ({"num_retry": -1}, "/eval_infos/0/num_retry"),
        ({"batch_size": "many"}, "/eval_infos/0/batch_size"),
        ({"thinking": "yes"}, "/eval_infos/0/thinking"),
        ({"retry_time": 0}, "/eval_infos/0/retry_time"),
        ({"gen_kwargs": "temperature"}, "/eval_infos/0/gen_kwargs must be name=number"),
        ({"gen_kwargs": "stop=\n"}, "/eval_infos/0/gen_kwargs must be name=number"),
        ({"model": ""}, "/eval_infos/0/model"),
        ({"tokenizer": "t" * 201}, "/eval_infos/0/tokenizer"),
        ({"api_key": KEY + "\n"}, "/eval_infos/0/api_key"),
    ],
)
def test_an_invalid_model_is_refused(
    client: httpx.Client, chat: ScriptedChat, change: dict[str, Any], about: str
) -> None:
    answer = post_evaluation(client, model_info(chat, "g") | change)
    assert is_refused(answer, about)
    assert chat.requests == []


def test_unknown_runs_and_runs_of_other_accounts_are_refused(
    server: ReferenceServer, client: httpx.Client, chat: ScriptedChat
) -> None:
    request_id = submit_evaluation(client, model_info(chat, "h-mine"))
    wait_until_finished(client, request_id)
    none = {"request_id": "run_none"}
    for path in ("/stop_evaluation", "/resume_evaluation"):
        assert is_refused(post(client, path, **none), "There is no run run_none")
        assert is_refused(post(client, path), "/request_id")
        assert is_refused(post(client, path, request_id="a b"), "/request_id")
    assert is_refused(get_evaldiffs(client, "run_none"), "There is no run run_none")
    assert is_refused(client.get("/evaldiffs").json(), "Content-Type (none)")
    with server.client("bob") as bob:
        assert is_refused(get_evaldiffs(bob, request_id), "There is no run")
        assert is_refused(get_progress(bob, request_id), "There is no run")
        answer = post(bob, "/stop_evaluation", request_id=request_id)
        assert is_refused(answer, "There is no run")
        diffs = post(bob, "/evaluation_diffs", request_ids=[request_id])
        assert is_refused(diffs, "There is no run")
    many = ".".join([request_id] * 17)  # more runs than a request may have
    diffs = post(client, "/evaluation_diffs", request_ids=[many])
    assert is_refused(diffs, "/request_ids/0")
    with server.client("reader") as reader:
        assert get_evaldiffs(reader, request_id)["err_code"] == 0
        answer = post(reader, "/stop_evaluation", request_id=request_id)
        assert is_refused(answer, "scope")


def test_other_datasets_are_not_compared(
    client: httpx.Client, chat: ScriptedChat
) -> None:
    ours = submit_evaluation(client, model_info(chat, "i-ours"))
    body = {
        "benchmark_id": "calibration",
        "policy": {"name": "i-native"},
        "options": {"tasks": ["score"]},
    }
    other = client.post("/v1/runs", json=body).json()["run_id"]
    answer = post(client, "/evaluation_diffs", request_ids=[ours, other])
    assert is_refused(answer, "i-native: the datasets differ")
