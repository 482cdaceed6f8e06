"""What the tests of FlagEval's wire share: a server, a model, and a client's words."""

from __future__ import annotations

import time
from collections.abc import Iterator
from typing import Any

import httpx
import pytest

from conformance.policy.chat import ScriptedChat
from tests.conftest import PATIENCE_S, House
from tests.push_parts import calling

KEY = "sk-this-is-nobodys-business"
TASKS = {"score": 4, "count": 2}


@pytest.fixture(scope="module")
def house(tmp_path_factory: pytest.TempPathFactory) -> Iterator[House]:
    path = tmp_path_factory.mktemp("flageval")
    yield from calling(path, PROCTOR_PROFILES="flageval")
    kept = [p.read_bytes() for p in path.rglob("*") if p.is_file()]
    assert KEY.encode() not in b"".join(kept)


@pytest.fixture
def client(house: House) -> Iterator[httpx.Client]:
    with house.client() as opened:
        yield opened


@pytest.fixture
def chat() -> Iterator[ScriptedChat]:
    with ScriptedChat("1") as server:
        yield server


def info(chat: ScriptedChat, name: str, **more: Any) -> dict[str, Any]:
    members = {
        "eval_model": name,
        "model": name,
        "eval_url": chat.completions_url,
        "tokenizer": "Qwen/Qwen3-8B",
        "num_retry": 0,
    }
    return members | more


def started(client: httpx.Client, *infos: dict[str, Any], **more: Any) -> Any:
    body = {"eval_infos": list(infos), "domain": "MM", "mode": "calibration"} | more
    answer = client.post("/evaluation", json=body)
    assert answer.status_code == 200, answer.text
    assert KEY not in answer.text
    return answer.json()


def accepted(client: httpx.Client, *infos: dict[str, Any], **more: Any) -> str:
    told = started(client, *infos, **more)
    assert told["err_code"] == 0, told
    return str(told["request_id"])


def post(client: httpx.Client, path: str, **body: Any) -> Any:
    answer = client.post(path, json=body)
    assert answer.status_code == 200, answer.text
    return answer.json()


def progress(client: httpx.Client, request_id: str) -> Any:
    return post(client, "/evaluation_progress", request_id=request_id, domain="MM")


def finished(client: httpx.Client, request_id: str) -> Any:
    deadline = time.monotonic() + PATIENCE_S
    while not (told := progress(client, request_id))["finished"]:
        assert time.monotonic() < deadline, told
        time.sleep(0.02)
    return told


def evaldiffs(client: httpx.Client, request_id: str) -> Any:
    """As their scripts do: a GET with a body."""
    answer = client.request("GET", "/evaldiffs", json={"request_id": request_id})
    assert answer.status_code == 200, answer.text
    return answer.json()


def is_refused(told: Any, about: str) -> bool:
    assert told["err_code"] == 1
    assert told["err_msg"] == told["err_message"]
    assert about in told["err_msg"], told
    return set(told) == {"err_code", "err_msg", "err_message"}
