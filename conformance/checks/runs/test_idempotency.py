"""Repeated submits: Idempotency-Keys and equal bodies (RUN)."""

import json
import math
import uuid
from collections.abc import Iterator
from typing import Any

from conformance.checks.support.given_states import fail_run
from conformance.checks.support.submissions import (
    NAMES_OF_LANGUAGES,
    adopt_answer,
    runs_of,
    submit,
    uniquely_named_body,
    whole_submission,
)
from conformance.client.check_context import CheckContext
from conformance.exchanges.answer import Answer
from conformance.runner.requirement import requirement
from conformance.verdicts import expect
from conformance.verdicts.expect import SetUpFailed

LONGEST_KEY = 128
# More than a cache of the last hundred holds.
MANY_KEYS, FEW_KEYS = 104, 4
_ONE_FAULT = {"options": {"tasks": ["fault"]}}
_ONE_EPISODE = {"options": {"tasks": ["score"]}}
ONES = ("1.0", "1e0", "10E-1", "0.1e+1")


def new_key() -> dict[str, str]:
    """Give the header with a key that was never used."""
    return {"Idempotency-Key": uuid.uuid4().hex}


@requirement("RUN-003")
def test_run_003_can_repeat_submit_with_the_same_key(context: CheckContext) -> None:
    """The response was lost: the same key and body again, also concurrently. Expect the
    first run and its Location each time, and no other run; the same when the run has
    been stopped, when another one is completed, after many more keys, and when one has
    failed."""
    body, key = uniquely_named_body(context), new_key()
    first = context.call("submit_run", json=body, headers=key)
    run = context.adopt(expect.ok(first, 201))
    repeated = context.call_concurrently(
        *[lambda: submit(context, body, headers=key)] * 3
    )
    run.stop()
    for answer in [*repeated, submit(context, body, headers=key)]:
        expect.equal(expect.ok(answer, 201)["run_id"], run.id, "run_id")
        location = answer.headers.get("location")
        expect.equal(location, first.headers.get("location"), "Location")
    expect.equal(runs_of(context, body), [run.id], "the runs made of it")
    expect.equal(run.get()["state"], "stopped", "state after a repeated submit")
    body, key = uniquely_named_body(context) | _ONE_EPISODE, new_key()
    played = context.adopt(expect.ok(submit(context, body, headers=key), 201))
    played.until("ready")
    worker = played.worker()
    worker.attach()
    worker.play()
    played.until("completed")
    for _ in range(FEW_KEYS if context.shared.settings.quick else MANY_KEYS):
        answer = submit(context, context.submit_body(), headers=new_key())
        context.adopt(expect.require(answer, 201, "submit_run")).stop()
    again = expect.ok(submit(context, body, headers=key), 201)
    expect.equal(again["run_id"], played.id, "run_id when it is completed")
    body, key = uniquely_named_body(context) | _ONE_FAULT, new_key()
    broken = context.adopt(expect.ok(submit(context, body, headers=key), 201))
    broken.until("ready")
    fail_run(broken, fault=2)
    again = expect.ok(submit(context, body, headers=key), 201)
    expect.equal(again["run_id"], broken.id, "run_id when it has failed")
    expect_no_fresh_start(context)
    expect_one_run_of_a_race(context)


def expect_one_run_of_a_race(context: CheckContext) -> None:
    """Expect submits with a new key at the same time to make one run."""
    body, key = uniquely_named_body(context), new_key()
    answers = context.call_concurrently(
        *[lambda: submit(context, body, headers=key)] * 4
    )
    ids = {expect.ok(answer, 201)["run_id"] for answer in answers}
    expect.equal(len(ids), 1, "runs returned to four submits at the same time")
    expect.equal(len(runs_of(context, body)), 1, "runs made of them")


def expect_no_fresh_start(context: CheckContext) -> None:
    """Expect a repeated submit to change nothing of a run that is played."""
    body, key = uniquely_named_body(context), new_key()
    body |= {"options": {"tasks": ["fault"], "max_faults": 2}}
    worker = context.adopt(expect.ok(submit(context, body, headers=key), 201)).worker()
    worker.run.until("ready")
    worker.attach()
    worker.predict(context.action(fault=1))
    expect.ok(submit(context, body, headers=key), 201)
    worker.try_predict(context.action(fault=1))
    expect.equal(worker.run.get()["state"], "failed", "state after the second fault")


def other_bodies(context: CheckContext, body: dict[str, Any]) -> Iterator[Any]:
    """Give bodies that differ from a whole submission in one value each."""
    options, lease_s = body["options"], body["idle_timeout_s"]
    for name, value in body["policy"].items():
        yield body | {"policy": body["policy"] | {name: f"{value}."}}
    yield body | {"policy": {"name": body["policy"]["name"]}}
    tasks = options["tasks"]
    others: dict[str, list[Any]] = {"max_steps": [6], "success_rule": ["any_step"]}
    others |= {"max_attempts": [3], "max_faults": [1], "queue_s": [1.5, 0]}
    others["queue_s"] += [1.0004, math.nextafter(options["queue_s"], 2)]
    others["tasks"] = [tasks[::-1], [*tasks, "count"], tasks[:-1]]
    others["tasks"].append([*tasks[:-1], "echo"])
    for name, values in others.items():
        for value in values:
            yield body | {"options": options | {name: value}}
    if context.limits["idle_timeout_s_min"] < lease_s:
        yield body | {"idle_timeout_s": context.limits["idle_timeout_s_min"]}
        yield body | {"idle_timeout_s": math.nextafter(lease_s, 0)}
    if context.worker_count(2) > 1:
        yield body | {"max_workers": 2}
    for size in context.benchmark["image_sizes"][1:2]:
        yield body | {"images": body["images"] | size}


@requirement("RUN-004")
def test_run_004_cannot_use_a_key_for_another_body(context: CheckContext) -> None:
    """A used key is sent with bodies that differ in one value, deep or last in a list.
    Expect `idempotency_conflict` each time and no run; the key still names the first
    one, and a new key makes a run of another body."""
    body, key = whole_submission(context), new_key()
    body["options"] |= {"tasks": body["options"]["tasks"] * 20, "queue_s": 1.0001}
    first = expect.ok(submit(context, body, headers=key), 201)
    unique = uniquely_named_body(context)
    for other_body in [unique, *other_bodies(context, body)]:
        expect.refused(submit(context, other_body, headers=key), "idempotency_conflict")
    expect.equal(runs_of(context, unique), [], "the runs made of another body")
    repeated = expect.ok(submit(context, body, headers=key), 201)
    expect.equal(repeated["run_id"], first["run_id"], "run_id of the repeated body")
    expect.equal(runs_of(context, body), [first["run_id"]], "the runs made of it")
    expect.ok(submit(context, unique, headers=new_key()), 201)


@requirement("RUN-005")
def test_run_005_key_of_another_account_has_no_effect(context: CheckContext) -> None:
    """Two accounts use the same key, with different bodies and with the same body.
    Expect runs of its own for each account."""
    second_account = context.second_account
    ids = []
    for second in (uniquely_named_body(context), None):
        key, first = new_key(), uniquely_named_body(context)
        for body, http_client in (
            (first, context.http_client),
            (second or first, second_account),
        ):
            run = expect.ok(
                submit(context, body, headers=key, http_client=http_client), 201
            )
            expect.equal(run["policy"], body["policy"], "policy")
            ids.append(run["run_id"])
    expect.equal(len(set(ids)), len(ids), "different runs")


@requirement("RUN-026")
def test_run_026_keys_differ_in_any_character(context: CheckContext) -> None:
    """Keys that differ in the case of letters, in one character, in length, or by an
    escape; one of a single character, which others may have used before; and keys that
    name what objects of a language have, with a body that is always the same. Expect a
    run of its own for each, although the bodies differ."""
    key = (f"aB-{uuid.uuid4().hex}!~" + "x" * LONGEST_KEY)[: LONGEST_KEY - 1]
    keys = [key, f"{key}x", f"{key}y", key[:-1], key[1:], key.swapcase()]
    keys += [key.lower(), key[:64], key[:32], f'"{key[:32]}"', f"{key[:32]}=", "%20"]
    keys[-1] += key[:32]
    keys += [f"{key[:32]},1", f"{key[:32]},2", f"{key[:32]};1", f"{key[:32]};2"]
    keys += [f"%41{key[:32]}", f"A{key[:32]}", f"a+{key[:32]}", f"a%2B{key[:32]}"]
    ids = set()
    for name in keys:
        headers = {"Idempotency-Key": name}
        run = expect.ok(
            submit(context, uniquely_named_body(context), headers=headers), 201
        )
        ids.add(run["run_id"])
    expect.equal(len(ids), len(keys), "runs of different keys")
    headers = {"Idempotency-Key": "k"}
    shortest = submit(context, uniquely_named_body(context), headers=headers)
    if shortest.code != "idempotency_conflict":
        expect.ok(shortest, 201)
    body = {"benchmark_id": "calibration", "policy": {"name": "conformance kit"}}
    for name in NAMES_OF_LANGUAGES:
        first, again = (
            submit(context, body, headers={"Idempotency-Key": name}) for _ in range(2)
        )
        if context.offers("deletion") and first.code == "not_found":
            continue
        run_id = expect.ok(first, 201)["run_id"]
        expect.equal(expect.ok(again, 201)["run_id"], run_id, f"run_id for {name}")


@requirement("RUN-027")
def test_run_027_refused_submit_leaves_its_key_unused(context: CheckContext) -> None:
    """Submits with new keys are refused for many reasons; then comes a right body.
    Expect a run under each of the keys, and the same one again."""
    right = context.submit_body()
    limits = context.limits
    wrongs: list[dict[str, Any]] = [
        {"json": right | {"benchmark_id": "no_such_benchmark"}},
        {"json": right | {"surprise": 1}},
        {"json": right | {"max_workers": limits["max_workers"] + 1}},
        {"json": right | {"idle_timeout_s": limits["idle_timeout_s_max"] + 1}},
        {"content": b"{"},
        {"content": b"{}", "headers": {"Content-Type": "text/plain"}},
        {"json": right, "headers": {"Accept": "text/html"}},
        {"json": right, "headers": {"Proctor-Version": "0.0"}},
    ]
    for wrong in wrongs:
        key, body = new_key(), uniquely_named_body(context)
        as_json = {"Content-Type": "application/json"}
        headers = as_json | wrong.get("headers", {}) | key
        refused = context.call("submit_run", **(wrong | {"headers": headers}))
        if refused.status < 400:
            raise expect.SetUpFailed("a wrong `submit_run` was accepted")
        first, second = (submit(context, body, headers=key) for _ in range(2))
        run = expect.ok(first, 201)
        expect.equal(run["policy"]["name"], body["policy"]["name"], "policy name")
        expect.equal(expect.ok(second, 201)["run_id"], run["run_id"], "run_id")


def send_text(context: CheckContext, text: str, key: dict[str, str]) -> Answer:
    """Submit a body that is written in this way."""
    headers = {"Content-Type": "application/json"} | key
    answer = context.call("submit_run", content=text.encode(), headers=headers)
    return adopt_answer(context, answer)


@requirement("RUN-028")
def test_run_028_same_body_may_be_written_otherwise(context: CheckContext) -> None:
    """A body is repeated with other white space, escapes, numbers, orders of members.
    Expect the first run each time."""
    body, key = whole_submission(context), new_key()
    body["policy"]["submitter"] = "K\u00fc\u540d/\U0001f916"
    turned = {name: body[name] for name in reversed(body)}
    turned["policy"] = dict(reversed(body["policy"].items()))
    turned["options"] = dict(reversed(body["options"].items()))
    escaped = json.dumps(body).replace("kit", "\\u006b\\u0069t").replace("/", "\\/")
    texts = [json.dumps(body, ensure_ascii=False), json.dumps(body, indent=3), escaped]
    texts += [
        json.dumps(turned),
        f"\r\n\t {json.dumps(body, separators=(',', ':'))} \n",
    ]
    texts += [
        texts[0].replace('"queue_s": 1', f'"queue_s": {number}') for number in ONES
    ]
    first = expect.ok(submit(context, body, headers=key), 201)
    for text in texts:
        repeated = expect.ok(send_text(context, text, key), 201)
        expect.equal(repeated["run_id"], first["run_id"], f"run_id of {text!r}")
    unkeyed = expect.ok(submit(context, body), 201)
    if unkeyed["run_id"] == first["run_id"]:
        raise SetUpFailed("a submit without a key made no run; see RUN-029")


@requirement("RUN-029")
def test_run_029_every_submit_without_a_key_makes_a_run(context: CheckContext) -> None:
    """The same body without a key, with one, and without again. Expect four runs."""
    body = uniquely_named_body(context)
    for headers in ({}, new_key(), {}, {}):
        expect.ok(submit(context, body, headers=headers), 201)
