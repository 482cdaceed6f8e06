"""A chat model as a policy: its requests, how its text is read, what is a fault."""

import base64
import io
import json
from collections.abc import Iterator
from typing import Any, cast

import httpx
import msgspec
import pytest
from PIL import Image

from conformance.policy.scripted_chat import ScriptedChat
from conformance.profiles.flageval import ANSWERS_IN_TEXT
from reference_server.push import chat_calls
from reference_server.push.calls_with_retries import PolicyFault
from reference_server.push.chat_calls import NO_ANSWER, ChatPolicy, read_answer
from reference_sim import benchmark_registry
from reference_sim.benchmarks.question_answering.questions import action, draw
from reference_sim.benchmarks.tabletop.scene import TabletopScene
from tests.support.paths import ROOT
from tests.support.push_runs import (
    episodes,
    push_submission,
    wait_for_state,
)
from tests.support.server.runs import make_run
from tests.support.waiting import wait_until

pytestmark = pytest.mark.slow("starts servers or kits")

NONE = action()
MARKED = json.loads(
    (ROOT / "spec" / "vectors" / "answers" / "marked.json").read_text()
)["vectors"]


@pytest.mark.parametrize(
    ("said", "answer"),
    [
        ("A", action(choice=0)),
        ("d", action(choice=3)),
        ("(B)", action(choice=1)),
        ("C)", action(choice=2)),
        ("C.", action(choice=2)),
        ("Answer: B", action(choice=1)),
        ("**answer: b.**", action(choice=1)),
        ("They are red.\n\nB\n", action(choice=1)),
        ("<think>It is A.</think>B", action(choice=1)),
        ("<think>A</think>\nSo\n**B**", action(choice=1)),
        ("Z", action(choice=25)),
        ("3", action(number=3)),
        ("Answer: 12.", action(number=12)),
        ("0.25", action(number=0.25)),
        ("0.2, 0.75", action(point=(0.2, 0.75))),
        ("(0.2,0.75)", action(point=(0.2, 0.75))),
        ("[1 0]", action(point=(1, 0))),
        ("Answer: 0.5 0.5.", action(point=(0.5, 0.5))),
        ("**B**.", action(choice=1)),
        ("`(c)`.", action(choice=2)),
        ("Answer: **3**.", action(number=3)),
        ("**Answer:** 3.", action(number=3)),
        ("**Answer: `0.2, 0.75.`**", action(point=(0.2, 0.75))),
    ],
)
def test_answers_are_parsed_from_text(said: str, answer: Any) -> None:
    assert read_answer(said) == answer


@pytest.mark.parametrize(
    "said",
    [
        *("", " \n ", "I do not know", "A or B", "A B", "AB", "A) left", "B\nor so"),
        *("-3", "three", "1e3", "1234567", "3 cubes", "0x10", "٣", "½", "NaN", "inf"),
        *("0.2; 0.3", "0.2, 0.3, 0.4", "x=0.2, y=0.3", "0.2,", "<think>B"),
        *("3..", "**B.**.", "**", "*.*"),
        *("Answer:", "Answer: Answer: B", "(B", "B]", "{}", "\x00", "B" * 100_000),
    ],
)
def test_unreadable_text_is_no_answer(said: str) -> None:
    assert read_answer(said) == NONE


@pytest.mark.parametrize("vector", MARKED, ids=lambda vector: vector["description"])
def test_answers_inside_of_text_are_read_as_the_vectors_have_it(vector: Any) -> None:
    assert read_answer(vector["text"]) == {**NONE, **(vector["answer"] or {})}


def test_the_kit_uses_answers_of_the_vectors() -> None:
    scores = {v["text"]: (v["answer"] or {}).get("number", [0.0])[0] for v in MARKED}
    assert {text: scores[text] for text in ANSWERS_IN_TEXT} == ANSWERS_IN_TEXT


@pytest.mark.parametrize(
    ("said", "answer"),
    [
        ("D", action(choice=3)),
        ("E", NONE),
        ("999999", action(number=999_999)),
        ("1, 1", action(point=(1, 1))),
        ("0.5, 1.5", NONE),
        ("320, 240", NONE),
    ],
)
def test_values_outside_the_action_space_are_no_answer(said: str, answer: Any) -> None:
    run, nothing = make_run(), cast("Any", None)
    manifest: Any = benchmark_registry.resolve("question_answering").manifest
    run.manifest = manifest
    assert ChatPolicy(run, nothing, nothing)._values(read_answer(said)) == answer


# --- over the wire ---


@pytest.fixture
def chat() -> Iterator[ScriptedChat]:
    with ScriptedChat("0.25") as server:
        yield server


def test_a_chat_model_cannot_play_a_robot_benchmark(
    client: httpx.Client, chat: ScriptedChat
) -> None:
    body = push_submission(chat.url, protocol="openai_chat") | {
        "benchmark_id": "tabletop_state"
    }
    del body["options"]
    run_id = client.post("/v1/runs", json=body).json()["run_id"]
    run = wait_for_state(client, run_id)
    assert run["state"] == "failed"
    assert "A chat model cannot play tabletop_state" in run["reason"]
    assert chat.requests == []


def test_questions_are_sent_with_their_pictures(
    client: httpx.Client, chat: ScriptedChat
) -> None:
    """Every answer is A. Expect what the scenes say of that, item by item."""
    chat.reply = "A"
    body = push_submission(chat.url, protocol="openai_chat", max_concurrent=2) | {
        "benchmark_id": "question_answering",
        "images": {"codec": "png", "width": 320, "height": 240},
    }
    del body["options"]
    run_id = client.post("/v1/runs", json=body).json()["run_id"]
    wait_until(lambda: len(chat.requests) >= 18, "enough was asked", 60)
    assert client.post(f"/v1/runs/{run_id}/stop", json={}).status_code == 200
    scored = [e["result"] for e in episodes(client, run_id) if "result" in e]
    assert len(scored) >= 12
    scene = TabletopScene("fast")
    texts = set()
    for result in scored:
        question, shown = draw(scene, result["task"], result["seed"], result["split"])
        is_right = question.is_right(action(choice=0), shown)
        assert result["score"] == float(is_right), result
        texts.add(question.text)
    assert len({result["score"] for result in scored}) == 2
    for request in chat.requests:
        (url,) = request.image_urls
        head, _, data = url.partition(",")
        assert head == "data:image/png;base64"
        with Image.open(io.BytesIO(base64.b64decode(data))) as picture:
            assert picture.size == (320, 240)
    assert texts <= {request.question for request in chat.requests}


def test_raw_images_are_refused_for_chat_models(
    client: httpx.Client, chat: ScriptedChat
) -> None:
    body = push_submission(chat.url, protocol="openai_chat") | {
        "benchmark_id": "question_answering",
        "images": {"codec": "raw", "width": 320, "height": 240},
    }
    del body["options"]
    run = wait_for_state(client, client.post("/v1/runs", json=body).json()["run_id"])
    assert run["state"] == "failed"
    assert "png or jpeg" in run["reason"]


# --- large answers ---

LARGE = 2**16


@pytest.mark.parametrize(
    ("content", "read"), [("A", "A"), (None, ""), ([{"text": "A"}], ""), (1, "")]
)
def test_of_a_large_completion_only_the_text_is_read(content: Any, read: str) -> None:
    choice = {
        "message": {"role": "assistant", "content": content},
        "logprobs": {"content": [{"token": "a", "logprob": 0.5}] * 1000},
    }
    body = msgspec.json.encode({"id": "x", "choices": [choice], "usage": [0] * LARGE})
    found = chat_calls._read(body)
    assert set(found["choices"][0]["message"]) == {"content"}
    assert len(found) == len(found["choices"][0]) == 1
    assert chat_calls._content(found) == read


@pytest.mark.parametrize("choices", [[0] * LARGE, [{}] * LARGE, {}, "a" * LARGE])
def test_a_large_answer_that_is_no_completion_is_a_fault(choices: Any) -> None:
    body = msgspec.json.encode({"choices": choices, "more": "a" * LARGE})
    with pytest.raises(PolicyFault, match="not a chat completion"):
        chat_calls._content(chat_calls._read(body))


def test_of_a_long_text_only_its_end_is_searched() -> None:
    """FLE-022: eight megabytes took seconds of the event loop."""
    end = "\n" + "a" * (chat_calls._TEXT_CHARS_MAX - 1)
    assert read_answer("\\boxed{B}" + end[9:])["choice"] == [1.0]
    assert read_answer("\\boxed{B}" + end) == NONE


def test_of_a_long_text_only_its_end_is_split() -> None:
    assert read_answer("a\n" * LARGE + "(B)\n")["choice"] == [1.0]
    assert read_answer("B" + "a" * LARGE)["choice"] == [NO_ANSWER]
