"""What FlagEval's API refuses: names in use, invalid bodies, unknown requests."""

from __future__ import annotations

from typing import Any

import httpx
import pytest

from conformance.policy.scripted_chat import ScriptedChat
from tests.support.profiles.flageval_client import (
    KEY,
    is_refused,
    model_info,
    post_evaluation,
)


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
