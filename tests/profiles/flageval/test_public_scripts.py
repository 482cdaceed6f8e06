"""What FlagEval's own scripts send: absent and null members, modes, URLs, no token.

The bodies are those of its public client in shape: which members they have, in which
combination, with which kinds of values.
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from typing import Any

import httpx
import pytest

from conformance.policy.scripted_chat import ChatRequest, ScriptedChat
from reference_server.profiles.flageval.mode_table import ModeTable
from reference_server.rules.refusal import Refused
from tests.support.paths import ROOT
from tests.support.profiles.flageval_client import (
    get_evaldiffs,
    is_refused,
    model_info,
    post,
    post_evaluation,
    submit_evaluation,
    wait_until_finished,
)
from tests.support.push_runs import start_push_server
from tests.support.servers import TIMEOUT_S, ReferenceServer

pytestmark = pytest.mark.slow("starts servers")
MODES = (
    "NLP:*=calibration,NLP:XLC_infer=small_quiz,"
    "MM:FlagRelease=calibration,MM:XLC=missing"
)
QUIZ = ROOT / "examples" / "benchmarks" / "small_quiz.jsonl"
BODIES = json.loads(
    (ROOT / "spec" / "vectors" / "flageval" / "bodies.json").read_text()
)


@pytest.fixture(scope="module")
def host(tmp_path_factory: pytest.TempPathFactory) -> Iterator[ReferenceServer]:
    """A server that maps modes and needs no token."""
    yield from start_push_server(
        tmp_path_factory.mktemp("host"),
        PROCTOR_PROFILES="flageval",
        PROCTOR_FLAGEVAL_MODES=MODES,
        PROCTOR_BENCHMARKS=str(QUIZ),
        PROCTOR_FLAGEVAL_ACCOUNT="local",
    )


@pytest.fixture
def script(host: ReferenceServer) -> Iterator[httpx.Client]:
    """A script as it is: no token, and `Content-Type` in every request."""
    headers = {"Content-Type": "application/json"}
    with httpx.Client(
        base_url=host.url, headers=headers, trust_env=False, timeout=TIMEOUT_S
    ) as client:
        yield client


# --- bodies ---


@pytest.mark.parametrize("body", BODIES, ids=lambda body: body["description"])
def test_a_body_of_the_scripts_is_evaluated(
    script: httpx.Client, chat: ScriptedChat, body: Any
) -> None:
    sent = json.loads(json.dumps(body["request"]).replace("http://model/v1", chat.url))
    answer = post(script, "/evaluation", **sent)
    assert answer["err_code"] == 0, answer
    (info,), (task,) = sent["eval_infos"], answer["eval_tasks"]
    assert (task["eval_model"], task["benchmark_id"]) == (
        info["eval_model"],
        "calibration",
    )
    assert wait_until_finished(script, answer["request_id"])["status"] == "S"
    assert {r.is_chat for r in chat.requests} == {"chat" in info["eval_url"]}
    sent_members = {name: chat.requests[0].body.get(name) for name in body["asked"]}
    assert sent_members == body["asked"]


def test_limits_of_tokens_come_from_the_member_or_from_gen_kwargs(
    client: httpx.Client, chat: ScriptedChat
) -> None:
    cases: list[tuple[dict[str, Any], int | None]] = [
        ({"max_gen_toks": 64}, 64),
        ({"max_gen_toks": 64, "gen_kwargs": "max_gen_toks=32"}, 32),
        ({"max_gen_toks": -1}, None),
        ({"max_gen_toks": 0}, None),
    ]
    for number, (members, limit) in enumerate(cases):
        chat.requests.clear()
        info = model_info(chat, f"t-{number}") | members
        wait_until_finished(client, submit_evaluation(client, info))
        assert {r.body.get("max_tokens") for r in chat.requests} == {limit}


@pytest.mark.parametrize("name", ["retry_time", "max_gen_toks"])
def test_other_negative_numbers_are_refused(
    client: httpx.Client, chat: ScriptedChat, name: str
) -> None:
    answer = post_evaluation(client, model_info(chat, "o") | {name: -2})
    assert is_refused(answer, f"/eval_infos/0/{name}")


def test_a_completions_server_is_asked_without_pictures(
    client: httpx.Client, chat: ScriptedChat
) -> None:
    """A benchmark with images cannot be asked there. Expect the reason."""
    info = model_info(chat, "p", eval_url=f"{chat.text_completions_url}/")
    request_id = submit_evaluation(client, info, mode="question_answering")
    answer = wait_until_finished(client, request_id)
    assert "p: OOR: A completions server accepts no images" in answer["err_msg"]
    assert chat.requests == []


# --- modes ---


def test_modes_are_looked_up_in_the_table_of_the_host() -> None:
    table = ModeTable.parse("NLP:Qnext=a, NLP:*=b,MM:FlagRelease=c")
    assert table.find("NLP", "Qnext") == "a"
    assert table.find("NLP", "XLC") is None
    assert table.find_any("NLP", "XLC") == table.find_any("NLP", "") == "b"
    assert table.find("MM", "") == table.find("MM", "FlagRelease") == "c"
    assert ModeTable().find_any("MM", "") == "question_answering"
    with pytest.raises(Refused, match="maps the mode XLC of the domain MM") as caught:
        table.find_any("MM", "XLC")
    ((at, text),) = caught.value.errors
    assert (at, text.partition("host ")[2]) == ("/mode", "(mapped for MM: FlagRelease)")


def test_a_mode_of_the_host_hides_no_benchmark(
    script: httpx.Client, chat: ScriptedChat
) -> None:
    info = model_info(chat, "q")
    answer = post_evaluation(script, info, domain="NLP", mode="question_answering")
    assert answer["eval_tasks"][0]["benchmark_id"] == "question_answering"
    answer = post_evaluation(script, info, mode="XLC")
    assert is_refused(answer, "/mode is mapped to missing, which is missing")
    answer = post_evaluation(script, info, mode="RoboTrain")
    assert is_refused(answer, "maps the mode RoboTrain of the domain MM to nothing")


def test_a_question_file_is_a_dataset_of_nlp(
    script: httpx.Client, chat: ScriptedChat
) -> None:
    """A model that knows the numbers and says A to the rest, at both kinds of URL."""
    lines = [json.loads(line) for line in QUIZ.read_text().splitlines()]
    right = {line["question"]: line["answer"] for line in lines}

    def reply(request: ChatRequest) -> str:
        answer = right[request.question.partition("\n")[0]]
        return f"The answer is **{'A' if isinstance(answer, str) else answer}**."

    chat.reply = reply
    for url in (chat.completions_url, chat.text_completions_url):
        name = f"v-{url.rpartition('v1/')[2]}"
        info = model_info(chat, name, eval_url=url, num_concurrent=8)
        begun = post_evaluation(script, info, domain="NLP", mode="XLC_infer")
        assert begun["eval_tasks"][0]["datasets"] == ["arithmetic", "units", "space"]
        assert wait_until_finished(script, begun["request_id"])["status"] == "S"
        results = get_evaldiffs(script, begun["request_id"])["eval_results"]
        found = [d["accuracy"] for d in results[name]["details"]]
        assert found == [1.0, 0.25, 0.25]


# --- no token ---


@pytest.mark.parametrize(
    "headers",
    [
        {"Authorization": "Bearer wrong"},
        {"Host": "rebound.example"},
        {"X-Forwarded-For": "127.0.0.1"},
        {"Forwarded": "for=127.0.0.1"},
        {"Via": "1.1 proxy"},
        {"X-Real-IP": "10.0.0.1"},
        {"Origin": "http://localhost"},
        {"Sec-Fetch-Site": "cross-site"},
    ],
    ids=str,
)
def test_only_a_program_of_this_machine_needs_no_token(
    script: httpx.Client, headers: dict[str, str]
) -> None:
    body = {"request_id": "run_none"}
    answer = script.post("/stop_evaluation", json=body, headers=headers).json()
    assert is_refused(answer, "bearer token")
    assert is_refused(post(script, "/stop_evaluation", **body), "There is no run")


def test_the_account_without_a_token_is_of_this_profile_alone(
    script: httpx.Client, client: httpx.Client
) -> None:
    assert script.get("/v1/runs").status_code == 401
    answer = post(client, "/stop_evaluation", request_id="run_none")
    assert is_refused(answer, "There is no run")
    bare = httpx.post(f"{client.base_url}/stop_evaluation", json={}).json()
    assert is_refused(bare, "bearer token")
