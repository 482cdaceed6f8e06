"""Chat models as the policy of a push run (CHAT). The kit serves the model."""

import base64
from typing import Any

from conformance.client.check_context import CheckContext
from conformance.client.run_client import RunClient
from conformance.policy.push_run import (
    chat_server,
    expect_end,
    expect_policy_fault,
    pointers_of,
    push_body,
    require_permitted,
)
from conformance.policy.scripted_chat import ScriptedChat
from conformance.runner.requirement import requirement
from conformance.verdicts import expect
from conformance.verdicts.expect import NotApplicable

PNG = b"\x89PNG\r\n\x1a\n"
SCORE = "0.25"
REASONING = "It may be one.\n1\n" * 500


def submit_chat_run(
    context: CheckContext, chat: ScriptedChat, *tasks: str, **config: Any
) -> RunClient:
    """Submit a run with the chat model as its policy."""
    images = config.pop("images", None)
    config = {"protocol": "openai_chat"} | config
    body = push_body(chat.url, *tasks, **config)
    if images is not None:
        body["images"] = images
    answer = context.call("submit_run", json=body)
    if "/policy_server/protocol" in pointers_of(answer):
        raise NotApplicable(f"server does not support protocol {config['protocol']}")
    require_permitted(answer, chat.url)
    text = f"`submit_run` with {config['protocol']}"
    return context.adopt(expect.require(answer, 201, text))


def expect_scores(run: RunClient) -> list[float]:
    """Expect the end of the run, and give its scores."""
    expect_end(run, "completed")
    return [episode["result"]["score"] for episode in run.episodes()]


@requirement("CHAT-001")
def test_chat_001_a_turn_is_a_question(context: CheckContext) -> None:
    """One episode with an image and one without. Expect a request for each. Each
    contains instruction, image, model name and parameters, of which one is 0."""
    if "png" not in context.service["image_codecs"]:
        raise NotApplicable("server does not offer the codec png")
    with chat_server(context, SCORE) as chat:
        numbers = {"temperature": 0, "top_p": 0.5, "max_tokens": 64}
        images = {"codec": "png", "width": 16, "height": 12}
        config = {"images": images, "model": "m-1", "generation": numbers}
        run = submit_chat_run(context, chat, "score", "echo", **config)
        expect_end(run, "completed")
        requests = {request.question: request for request in chat.requests}
        due = [f"Calibration task {task}." for task in ("echo", "score")]
        expect.equal(sorted(requests), due, "questions")
        expect.equal(len(chat.requests), 2, "requests")
        for request in requests.values():
            members = {"model": "m-1", **numbers}
            sent = {name: request.body.get(name) for name in members}
            expect.equal(sent, members, "members of the request")
            roles = [message["role"] for message in request.body["messages"]]
            expect.equal(roles, ["user"], "roles")
        expect.equal(requests[due[1]].image_urls, [], "pictures of the task score")
        (url,) = requests[due[0]].image_urls or [""]
        head, _, data = url.partition(",")
        expect.equal(head, "data:image/png;base64", "the picture's URL")
        expect.true(base64.b64decode(data).startswith(PNG), "a png", data[:40])


@requirement("CHAT-002")
def test_chat_002_the_last_line_is_the_answer(context: CheckContext) -> None:
    """Replies with a number: alone, formatted, after reasoning, below other numbers.
    Two of them are long. Expect the score to be that number each time."""
    forms = [SCORE, f" {SCORE}\n", f"Answer: {SCORE}", f"**answer: {SCORE}**"]
    forms += [f"`{SCORE}`", f"1\n{SCORE}\n\n", f"<think>1</think>{SCORE}", f"{SCORE}."]
    forms += [f"<think>\n1\n</think>\n0\n\n**{SCORE}**\n"]
    forms += [f"**{SCORE}**.", f"Answer: **{SCORE}**.", f"**Answer:** {SCORE}."]
    forms += [f"**Answer: {SCORE}**.", f"*{SCORE}.*"]
    forms += [REASONING + SCORE, f"<think>{REASONING}</think>{REASONING}{SCORE}"]
    with chat_server(context) as chat:
        replies = iter(forms)
        chat.reply = lambda _: next(replies)
        run = submit_chat_run(context, chat, *["score"] * len(forms), max_concurrent=1)
        expect.equal(expect_scores(run), [float(SCORE)] * len(forms), "scores")


@requirement("CHAT-003")
def test_chat_003_text_without_a_number_is_no_fault(context: CheckContext) -> None:
    """Replies of letters, points, sentences and nothing to a question for a number.
    Expect episodes of score 0, each in its first attempt."""
    words: list[Any] = ["A", "0.2, 0.3", "I do not know", "-1", "1 or 0", "", None]
    words += ["<think>1", "one", "1 apple"]
    with chat_server(context) as chat:
        replies = iter(words)
        chat.reply = lambda _: next(replies)
        run = submit_chat_run(context, chat, *["score"] * len(words), max_concurrent=1)
        expect.equal(expect_scores(run), [0.0] * len(words), "scores")
        attempts = [episode["result"]["attempt"] for episode in run.episodes()]
        expect.equal(attempts, [1] * len(words), "attempts")
        faults = [e["policy_fault"] for e in run.episodes() if "policy_fault" in e]
        expect.equal(faults, [], "faults of the policy")


@requirement("CHAT-004")
def test_chat_004_invalid_completion_is_a_fault(context: CheckContext) -> None:
    """Responses without choices, without a message, and with another structure. Expect
    `policy_fault` each time."""
    bodies: list[Any] = [{"choices": []}, {"choices": [{}]}, {"text": SCORE}, [SCORE]]
    for body in bodies:
        with chat_server(context) as chat:
            chat.body = body
            expect_policy_fault(submit_chat_run(context, chat, "score"))


@requirement("CHAT-005")
def test_chat_005_a_completion_continues_the_instruction(context: CheckContext) -> None:
    """A model that continues a text, and one whose answer has no text. Expect a prompt
    with model and parameters, of which one is 0, the score of the answer, and a fault.
    """
    config = {"protocol": "openai_completions", "model": "m-1"}
    with chat_server(context, SCORE) as chat:
        numbers = {"temperature": 0, "top_p": 0.5}
        run = submit_chat_run(context, chat, "score", generation=numbers, **config)
        expect.equal(expect_scores(run), [float(SCORE)], "scores")
        (request,) = chat.requests
        expect.equal(request.is_chat, False, "a request to chat/completions")
        due = {"prompt": "Calibration task score.", "model": "m-1", **numbers}
        sent = {name: request.body.get(name) for name in due}
        expect.equal(sent, due, "members of the request")
        chat.body = {"choices": [{"message": {"content": SCORE}}]}
        expect_policy_fault(submit_chat_run(context, chat, "score", **config))
