"""The automatic evaluation of FlagEval: the profile `flageval` (FLE).

The kit serves the evaluated model; its reply to a question of calibration is the score
of the episode.
"""

import threading
from collections.abc import Callable
from functools import partial
from typing import Any

from conformance.client.check_context import CheckContext
from conformance.oracle.expected_score import is_close
from conformance.policy.push_run import chat_server
from conformance.policy.scripted_chat import ChatRequest, ScriptedChat
from conformance.profiles.flageval import (
    ANSWERS_IN_TEXT,
    DATASETS,
    END_TIMEOUT_S,
    begin,
    call_flageval,
    evaluate,
    expect_refused,
    expect_refused_in_form,
    expect_success,
    info,
    try_begin,
    unique_name,
)
from conformance.runner.requirement import requirement
from conformance.verdicts import expect

KEY = "sk-of-the-conformance-kit-only"


def hold_questions(
    chat: ScriptedChat, word: str
) -> tuple[threading.Event, threading.Event]:
    """Hold questions with a word; give the events `received` and `release`."""
    arrived, released = threading.Event(), threading.Event()

    def say(request: ChatRequest) -> str:
        if word in request.question or word == request.body.get("model"):
            arrived.set()
            released.wait(END_TIMEOUT_S)
        return "1"

    chat.reply = say
    return arrived, released


def reply_by_model(**words: str) -> Callable[[ChatRequest], str]:
    """Reply by the end of the model's name."""

    def say(request: ChatRequest) -> str:
        model = str(request.body.get("model"))
        return next(word for name, word in words.items() if model.endswith(name))

    return say


@requirement("FLE-001")
def test_fle_001_an_evaluation_is_a_run(context: CheckContext) -> None:
    """Two models are evaluated. Expect a run of each, with its name, in order."""
    names = [unique_name("one"), unique_name("two")]
    with chat_server(context) as chat:
        answer = expect_success(try_begin(context, *(info(chat, n) for n in names)))
        expect.true(answer["request_id"], "a request_id")
        tasks = answer["eval_tasks"]
        expect.equal([task["eval_model"] for task in tasks], names, "eval_tasks")
        for name, task in zip(names, tasks, strict=True):
            run = expect.ok(context.call("get_run", run_id=task["run_id"]))
            expect.equal(run["policy"]["name"], name, "the policy's name")
            expect.equal(run["mode"], "push", "the run's mode")


@requirement("FLE-002")
def test_fle_002_refusals_have_err_code_1(context: CheckContext) -> None:
    """Invalid requests, unknown ids, and a late stop. Expect `err_code` 1 and the same
    text in both message members."""
    call, none = partial(call_flageval, context), {"request_id": "no-such-request"}
    with chat_server(context) as chat:
        wrong = [
            try_begin(context, info(chat, unique_name("x"), num_concurrent=0)),
            try_begin(context, info(chat, unique_name("x")), domain="Audio"),
            try_begin(context, info(chat, unique_name("x")), mode="no_such_benchmark"),
            try_begin(context),
            *(call(path, none) for path in ("/stop_evaluation", "/resume_evaluation")),
            call("/evaluation_progress", none | {"domain": "MM"}),
            call("/evaldiffs", none, method="GET"),
            call("/evaluation_diffs", {"request_ids": []}),
        ]
        done = evaluate(context, info(chat, unique_name("x")))
        wrong.append(call("/stop_evaluation", {"request_id": done.request_id}))
        for answer in wrong:
            expect_refused_in_form(answer)


def runs_named(context: CheckContext, name: str) -> int:
    """Count the newest runs of a policy with this name."""
    page = expect.ok(context.call("list_runs", params={"limit": 100}))
    return [run["policy"]["name"] for run in page["runs"]].count(name)


@requirement("FLE-003")
def test_fle_003_a_name_is_used_once(context: CheckContext) -> None:
    """A name occurs twice, or was used with another chip, after a new name. Expect
    refusals, and no run under the new name."""
    used, new = unique_name("used"), unique_name("new")
    with chat_server(context) as chat:
        begin(context, info(chat, used))
        for second in (info(chat, used, chip="Other-1"), info(chat, new)):
            expect_refused(try_begin(context, info(chat, new), second))
        expect.equal(runs_named(context, new), 0, "runs of a refused request")


@requirement("FLE-004")
def test_fle_004_a_repeated_request_starts_no_run(context: CheckContext) -> None:
    """The same body is sent twice, and with a default and another key. Expect the same
    request_id, and one run."""
    name = unique_name("once")
    with chat_server(context) as chat:
        first = begin(context, info(chat, name))
        for more in ({}, {"batch_size": 1, "api_key": KEY}):
            again = expect_success(try_begin(context, info(chat, name, **more)))
            expect.equal(again["request_id"], first.request_id, "request_id")
        expect.equal(runs_named(context, name), 1, "runs of that name")


@requirement("FLE-005")
def test_fle_005_questions_have_the_parameters(context: CheckContext) -> None:
    """With and without parameters and a key. Expect them in every question, or none."""
    with chat_server(context) as chat:
        numbers = "temperature=0.5,top_k=20,max_gen_toks=64"
        asked = info(chat, unique_name("asked"), api_key=KEY, gen_kwargs=numbers)
        evaluate(context, asked | {"model": "the-model"})
        expect.equal(len(chat.requests), sum(DATASETS.values()), "questions")
        for request in chat.requests:
            due: dict[str, object] = {"temperature": 0.5, "top_k": 20, "max_tokens": 64}
            due["model"] = "the-model"
            sent = {name: request.body.get(name) for name in due}
            expect.equal(sent, due, "members of the question")
            header = request.headers.get("authorization")
            expect.equal(header, f"Bearer {KEY}", "the key")
        chat.requests.clear()
        evaluate(context, info(chat, unique_name("bare"), api_key="EMPTY"))
        keys = {request.headers.get("authorization") for request in chat.requests}
        expect.equal(list(keys), [None], "the key EMPTY")


@requirement("FLE-006")
def test_fle_006_key_is_in_no_response(context: CheckContext) -> None:
    """A key in a valid request and in a refused one, and an invalid key; the model
    echoes it. Expect it in no response."""
    with chat_server(context, reply=KEY) as chat:
        name = unique_name("secret")
        answer = [try_begin(context, info(chat, name, api_key=KEY))]
        answer.append(try_begin(context, info(chat, name, api_key=KEY, chip="Other-1")))
        answer.append(
            try_begin(context, info(chat, unique_name("x"), api_key=f"{KEY}\n"))
        )
        answer.append(try_begin(context, info(chat, unique_name("x"), api_key=[KEY])))
        done = begin(context, info(chat, unique_name("y"), api_key=KEY))
        done.finished()
        answer += [done.results(), done.progress()]
        run = context.call("get_run", run_id=done.run_ids[0])
        for text in (*map(repr, answer), run.body.decode()):
            expect.true(KEY not in text, "no key in an answer", text.replace(KEY, "…"))


@requirement("FLE-007")
def test_fle_007_accuracy_is_the_mean_of_a_task(context: CheckContext) -> None:
    """Two models with different replies. Expect the values of `get_score` per task."""
    with chat_server(context, reply_by_model(good="1", fair="0.5")) as chat:
        names = [unique_name("good"), unique_name("fair")]
        done = evaluate(context, *(info(chat, name) for name in names))
        results = done.results()
        expect.equal(sorted(results), sorted(names), "eval_models")
        for name, run_id in zip(names, done.run_ids, strict=True):
            score = expect.ok(context.call("get_score", run_id=run_id))
            due = {task: group["mean"] for task, group in score["by_task"].items()}
            details = results[name]["details"]
            accuracies = {detail["dataset"]: detail["accuracy"] for detail in details}
            expect.equal(accuracies, due, "accuracy")
            expect.equal(sorted(accuracies), sorted(DATASETS), "datasets")


@requirement("FLE-008")
def test_fle_008_request_id_in_the_query_or_in_a_body(context: CheckContext) -> None:
    """The id is sent in the query and in a body. Expect the same results."""
    with chat_server(context) as chat:
        done = evaluate(context, info(chat, unique_name("asked")))
        path = f"/evaldiffs?request_id={done.request_id}"
        by_query = expect_success(call_flageval(context, path, None, method="GET"))[
            "eval_results"
        ]
        expect.equal(by_query, done.results(), "results by query")


@requirement("FLE-009")
def test_fle_009_status_letters(context: CheckContext) -> None:
    """A model that waits, is stopped and is resumed; one that is unreachable. Expect R,
    C, R or S, S, and OOR, in results and progress."""
    with chat_server(context) as chat:
        arrived, released = hold_questions(chat, "count")
        name = unique_name("watched")
        watched = begin(context, info(chat, name))
        arrived.wait(END_TIMEOUT_S)
        for letter, command in (("R", "/stop_evaluation"), ("C", "/resume_evaluation")):
            expect.equal(watched.progress()["status"], letter, "status")
            expect.equal(watched.results()[name]["status"], letter, "its status")
            watched.command(command)
        released.set()
        expect.equal(watched.finished()["status"], "S", "status at the end")
        expect.equal(watched.results()[name]["status"], "S", "its status at the end")
        chat.status = 500
        failed_model = begin(context, info(chat, unique_name("failed_model")))
        ended = failed_model.finished()["status"]
        expect.equal(ended, "OOR", "status of a model that is gone")


@requirement("FLE-010")
def test_fle_010_diff_is_baseline_minus_accuracy(context: CheckContext) -> None:
    """A model alone; with the baseline of its request; with an earlier baseline. Expect
    null, then the difference of the accuracies."""
    base = unique_name("base")
    with chat_server(context, reply_by_model(origin="1", worse="0.75")) as chat:
        alone, later = f"{base}-1-worse", f"{base}-2-worse"
        done = evaluate(context, info(chat, alone, base_model_name=base))
        details = done.results()[alone]["details"]
        none = [d["diff"] for d in details]
        expect.equal(none, [None, None], "diff without baseline")
        infos = [info(chat, f"{base}-nvidia-origin"), info(chat, later)]
        beside = evaluate(context, *infos).results()[later]
        for result in (beside, done.results()[alone]):
            diffs = {d["dataset"]: d["diff"] for d in result["details"]}
            expect.true(is_close(diffs.get("score"), 0.25), "diff of score 0.25", diffs)
            expect.true(is_close(diffs.get("count"), 1.0), "diff of count 1", diffs)


@requirement("FLE-011")
def test_fle_011_release_compares_with_the_baseline(context: CheckContext) -> None:
    """With a baseline: models that are equal, slightly worse, much worse, unfinished.
    Expect release of the equal one only, as `count` is 0 or 1; and of none without a
    baseline."""
    words = reply_by_model(origin="1", twin="1", worse="0.97", bad="0", alone="1")
    with chat_server(context, words) as chat:
        base = unique_name("base")
        names = [f"{base}-{end}" for end in ("nvidia-origin", "twin", "worse", "bad")]
        done = evaluate(context, *(info(chat, name) for name in names))
        releases = [done.results()[name]["release"] for name in names]
        expect.equal(releases, [True, True, False, False], "release")
        alone_name = unique_name("alone")
        alone = evaluate(context, info(chat, alone_name))
        released_alone = alone.results()[alone_name]["release"]
        expect.equal(released_alone, False, "release without a baseline")
        arrived, released = hold_questions(chat, "count")
        late = begin(context, info(chat, f"{base}-late", base_model_name=base))
        arrived.wait(END_TIMEOUT_S)
        release = late.results()[f"{base}-late"]["release"]
        expect.equal(release, False, "release before the end")
        released.set()


@requirement("FLE-012")
def test_fle_012_stop_ends_unfinished_evaluations(context: CheckContext) -> None:
    """One of two models is finished when the request is stopped. Expect S and C, and
    the first dataset of the second unchanged."""
    with chat_server(context) as chat:
        fast, slow = unique_name("fast"), unique_name("slow")
        arrived, released = hold_questions(chat, slow)
        both = begin(context, info(chat, fast), info(chat, slow))
        arrived.wait(END_TIMEOUT_S)
        deadline = threading.Event()
        while both.results()[fast]["status"] == "R" and not deadline.wait(0.02):
            pass
        both.command("/stop_evaluation")
        released.set()
        statuses = {name: shown["status"] for name, shown in both.results().items()}
        expect.equal(statuses, {fast: "S", slow: "C"}, "status")
        states = [context.call("get_run", run_id=i).json["state"] for i in both.run_ids]
        expect.equal(states, ["completed", "stopped"], "states of the runs")


@requirement("FLE-013")
def test_fle_013_resume_repeats_no_scored_question(context: CheckContext) -> None:
    """An evaluation is stopped in the second dataset, and resumed. Expect no question
    of the first dataset again, and completion."""
    with chat_server(context) as chat:
        arrived, released = hold_questions(chat, "count")
        flageval_request = begin(context, info(chat, unique_name("resumed")))
        arrived.wait(END_TIMEOUT_S)
        flageval_request.command("/stop_evaluation")
        released.set()
        chat.requests.clear()
        flageval_request.command("/resume_evaluation")
        expect.equal(flageval_request.finished()["status"], "S", "status at the end")
        again = [r.question for r in chat.requests if "score" in r.question]
        expect.equal(again, [], "questions asked again")


@requirement("FLE-014")
def test_fle_014_progress_counts_datasets(context: CheckContext) -> None:
    """Two models; one waits in its second dataset, and goes on. Expect 3/4, and count
    0/2; then 4/4, and no dataset that is open."""
    with chat_server(context) as chat:
        fast, slow = unique_name("fast"), unique_name("slow")
        released = threading.Event()

        def say(request: ChatRequest) -> str:
            if request.body.get("model") == slow and "count" in request.question:
                released.wait(END_TIMEOUT_S)
            return "1"

        chat.reply = say
        both, pause = (
            begin(context, info(chat, fast), info(chat, slow)),
            threading.Event(),
        )
        for _ in range(int(END_TIMEOUT_S / 0.05)):
            answer = both.progress()
            if answer["datasets_progress"] == "3/4" or answer["finished"]:
                break
            pause.wait(0.05)
        due: dict[str, Any] = {"datasets_progress": "3/4", "running_dataset": "count"}
        expect.members(answer, due | {"running_progress": "0/2", "finished": False})
        released.set()
        due = {
            "datasets_progress": "4/4",
            "running_dataset": "",
            "running_progress": "",
        }
        expect.members(both.finished(), due, "at the end")


@requirement("FLE-015")
def test_fle_015_requests_compared_with_the_first(context: CheckContext) -> None:
    """Three requests of one or two models; in the first the second is a baseline.
    Expect the differences of the first models of the others from it. GET returns a map,
    POST a list, with the same values."""
    words = reply_by_model(origin="1", twin="1", worse="0.5")
    with chat_server(context, words) as chat:
        requests = (("worse", "nvidia-origin"), ("twin",), ("worse", "twin"))
        ids = [
            evaluate(context, *(info(chat, unique_name(e)) for e in ends)).request_id
            for ends in requests
        ]
        compare = partial(call_flageval, context, "/evaluation_diffs")
        body = {"request_ids": ids}
        diffs = expect_success(compare(body, method="GET"))["eval_diffs"]
        expect.equal(sorted(diffs), sorted(ids[1:]), "request ids")
        releases = [diffs[name]["release"] for name in ids[1:]]
        expect.equal(releases, [True, False], "release")
        details = {d["dataset"]: d for d in diffs[ids[2]]["details"]}
        expect.members(details["score"], {"base_acc": 1, "accuracy": 0.5, "diff": 0.5})
        listed = expect_success(compare(body))["eval_diffs"]
        expect.true(isinstance(listed, list), "a list with POST", listed)
        expect.equal([entry["request_id"] for entry in listed], ids[1:], "request ids")
        for entry in listed:
            due = diffs[entry["request_id"]]["details"]
            expect.equal(entry["details"], due, "details")


@requirement("FLE-016")
def test_fle_016_cannot_use_requests_of_another_account(context: CheckContext) -> None:
    """Another account reads, stops, resumes and compares. Expect refusals."""
    call = partial(call_flageval, context, http_client=context.second_account)
    with chat_server(context) as chat:
        arrived, released = hold_questions(chat, "count")
        ours = begin(context, info(chat, unique_name("ours")))
        arrived.wait(END_TIMEOUT_S)
        named = {"request_id": ours.request_id}
        for answer in (
            *(call(path, named) for path in ("/stop_evaluation", "/resume_evaluation")),
            call("/evaluation_progress", named | {"domain": "MM"}),
            call("/evaldiffs", named, method="GET"),
            call("/evaluation_diffs", {"request_ids": [ours.request_id] * 2}),
        ):
            expect_refused(answer)
        expect.equal(ours.progress()["status"], "R", "status of ours")
        released.set()


@requirement("FLE-018")
def test_fle_018_members_that_are_null_have_defaults(context: CheckContext) -> None:
    """Only required members; others are null; numbers of -1. Expect evaluations that
    complete, also without a mode and a region."""
    optional = ["tokenizer", "api_key", "batch_size", "num_concurrent", "gen_kwargs"]
    optional += ["thinking", "retry_time", "max_gen_toks", "chip", "base_model_name"]
    with chat_server(context) as chat:
        bare = info(chat, unique_name("bare"))
        del bare["tokenizer"]
        nulls = info(chat, unique_name("nulls")) | dict.fromkeys(optional)
        numbers = info(chat, unique_name("numbers"), retry_time=-1, max_gen_toks=-1)
        top = {"region": None, "special_event": None, "user_id": None}
        expect_success(try_begin(context, bare))
        done = begin(context, nulls, numbers, **top)
        expect.equal(done.finished()["status"], "S", "status at the end")
        limits = {request.body.get("max_tokens") for request in chat.requests}
        expect.equal(limits, {None}, "max_tokens")


@requirement("FLE-019")
def test_fle_019_a_completions_url_gets_a_prompt(context: CheckContext) -> None:
    """Two models, one with a URL of completions. Expect a prompt there alone."""
    with chat_server(context) as chat:
        names = [unique_name("text"), unique_name("chat")]
        text = info(chat, names[0], eval_url=chat.text_completions_url)
        done = evaluate(context, text, info(chat, names[1]))
        expect.equal(done.progress()["status"], "S", "status at the end")
        for request in chat.requests:
            expect.equal(
                "prompt" in request.body,
                request.body.get("model") == names[0],
                "a prompt",
            )
            expect.equal(
                request.is_chat, request.body.get("model") == names[1], "path of a chat"
            )


@requirement("FLE-020")
def test_fle_020_a_failure_says_why(context: CheckContext) -> None:
    """Models that answer 401 and 500, beside one that answers. Expect name, reason and
    status of both in the messages, and success for the other."""
    with chat_server(context) as chat:
        for status in (401, 500):
            chat.status = status
            name = unique_name("failed")
            failed = begin(context, info(chat, name))
            message = failed.finished()["err_msg"]
            body = {"request_id": failed.request_id}
            answer = call_flageval(context, "/evaldiffs", body, method="GET")
            run = expect.ok(context.call("get_run", run_id=failed.run_ids[0]))
            for said in (message, answer.get("err_msg")):
                parts = (name, run["reason"], str(status))
                holds = all(part in str(said) for part in parts)
                expect.true(holds, f"{' and '.join(parts)} in err_msg", said)


@requirement("FLE-021")
def test_fle_021_a_baseline_of_nothing_releases_nothing(context: CheckContext) -> None:
    """Baseline and model score 0; then a baseline that scores. Expect no release with a
    warning, then release without one, in `/evaldiffs` and `/evaluation_diffs`."""
    with chat_server(context) as chat:
        for reply, releases in (("no idea", False), ("1", True)):
            chat.reply = reply
            base = unique_name("base")
            names = [f"{base}-nvidia-origin", f"{base}-twin"]
            done = evaluate(context, *(info(chat, name) for name in names))
            compared = evaluate(context, info(chat, unique_name("other")))
            body = {"request_ids": [done.request_id, compared.request_id]}
            answer = expect_success(call_flageval(context, "/evaluation_diffs", body))
            for result in (*done.results().values(), *answer["eval_diffs"]):
                expect.equal(result["release"], releases, "release")
                expect.equal("warning" in result, not releases, "a warning")


@requirement("FLE-022")
def test_fle_022_answers_are_read_from_sentences(context: CheckContext) -> None:
    """Replies with an answer inside of text, one model for each. Expect each answer as
    the score."""
    names = {unique_name("reader"): text for text in ANSWERS_IN_TEXT}
    with chat_server(context, reply=lambda ask: names[ask.body["model"]]) as chat:
        results = evaluate(context, *(info(chat, name) for name in names)).results()
        for name, text in names.items():
            accuracies = {d["dataset"]: d["accuracy"] for d in results[name]["details"]}
            due = ANSWERS_IN_TEXT[text]
            message = f"{due} read from {text!r}"
            expect.true(is_close(accuracies.get("score"), due), message, accuracies)
