"""The driver without a network: pauses of its workers, failures of the database, and
that no part of an API key is in a text that comes from a policy server.
"""

import asyncio
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from conformance.policy.scripted_policy import PolicyCall, PolicyReply, ScriptedPolicy
from reference_server.generated import models
from reference_server.http.problems import PROBLEM_JSON
from reference_server.process.backoff import Backoff
from reference_server.push import calls_with_retries
from reference_server.push.calls_with_retries import (
    ANSWER_BYTES_MAX,
    CallLimits,
    HttpCalls,
    PolicyFault,
)
from reference_server.push.driver import PROTOCOLS, Driver
from reference_server.push.egress import EgressPolicy
from reference_server.push.key_encryption import KeyEncryption
from reference_server.push.policy_calls import Description, ProctorPolicy, answer_fault
from reference_server.rules.policy_server import PolicyServerConfig
from reference_server.rules.refusal import Refused
from reference_server.rules.runs.lifecycle import Attach
from reference_server.rules.runs.run import Episode, Run
from reference_server.storage.runs.run_store import StoreFailed
from reference_sim.process.pool import NoCapacity, SimulatorPool
from tests.support.server import server_parts as rest
from tests.support.server.server_parts import (
    ServerParts,
    calibration_run,
    expect_refusal,
    open_server_parts,
)
from tests.support.servers import TIMEOUT_S

ORDER: Any = {"url": "http://127.0.0.1:9", "protocol": "proctor", "max_concurrent": 1}


class FaultyPolicy:
    """A policy that goes wrong as often as `faults` says, and then plays."""

    def __init__(self, faults: int = 0) -> None:
        self.faults = faults

    def __call__(self, *_: Any) -> "FaultyPolicy":
        return self

    async def describe(self) -> Description:
        return Description(1)

    async def reset(self, _turn: Any) -> None:
        """There is nothing to forget."""

    async def predict(self, turn: Any) -> models.Predict:
        if self.faults:
            self.faults -= 1
            raise PolicyFault("It said nonsense.")
        command = rest.predict_command(turn, end=1)
        return models.Predict(
            session_id=command.session_id,
            seq=command.seq,
            actions=[
                models.Action(
                    values={n: list(v) for n, v in command.actions[0].items()}
                )
            ],
        )


def push_run() -> Run:
    run = calibration_run("score")
    run.submission = {**run.submission, "mode": "push", "policy_server": ORDER}
    return run


def make_driver(parts: ServerParts) -> Driver:
    return make_driver_with(parts, KeyEncryption())


def make_driver_with(parts: ServerParts, key_encryption: KeyEncryption) -> Driver:
    return Driver(parts.service, EgressPolicy("all"), key_encryption, 65536)


async def wait_until_completed(parts: ServerParts) -> Run:
    while True:
        change, run = (
            parts.registry.change_event("run_1"),
            await parts.registry.get("run_1"),
        )
        if run.state in ("completed", "failed"):
            assert run.state == "completed", run.reason
            return run
        await parts.registry.wait_for_change(change, 10)


@pytest.fixture
def backoff(monkeypatch: pytest.MonkeyPatch) -> list[float]:
    """How long workers wanted to pause; none of them does."""
    asked: list[float] = []
    right = Backoff.next_s

    def next_s(self: Backoff) -> float:
        asked.append(right(self))
        return 0.0

    monkeypatch.setattr(Backoff, "next_s", next_s)
    return asked


def matches_backoff(asked: list[float], *due: float) -> bool:
    return len(asked) == len(due) and all(
        0.79 * d <= a <= 1.21 * d for a, d in zip(asked, due, strict=True)
    )


async def test_waits_for_a_simulator_back_off(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, backoff: list[float]
) -> None:
    """And begins anew with short pauses after a turn."""
    monkeypatch.setitem(PROTOCOLS, "proctor", FaultyPolicy())
    right, refused = SimulatorPool.acquire, 7

    async def acquire(self: SimulatorPool, *given: Any, **named: Any) -> Any:
        if len(backoff) < refused:
            raise NoCapacity("All simulators are busy.")
        return await right(self, *given, **named)

    monkeypatch.setattr(SimulatorPool, "acquire", acquire)
    async with open_server_parts(tmp_path / "proctor.sqlite") as parts:
        push_driver = make_driver(parts)
        await parts.registry.add(push_run(), None, "")
        run = await wait_until_completed(parts)
        assert [e.attempt for e in run.episodes] == [1]
        await push_driver.close()
    assert matches_backoff(backoff, 0.2, 0.4, 0.8, 1.6, 3.2, 5.0, 5.0), backoff


async def test_a_worker_pauses_after_a_fault_of_its_policy(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, backoff: list[float]
) -> None:
    monkeypatch.setitem(PROTOCOLS, "proctor", FaultyPolicy(faults=2))
    async with open_server_parts(tmp_path / "proctor.sqlite") as parts:
        push_driver = make_driver(parts)
        await parts.registry.add(push_run(), None, "")
        await wait_until_completed(parts)
        await push_driver.close()
    assert matches_backoff(backoff, 0.2, 0.4), backoff


async def test_a_session_without_a_simulator_is_not_stored(
    monkeypatch: pytest.MonkeyPatch, parts: ServerParts
) -> None:
    """No stored part of the run has changed; clients that wait are notified."""

    async def acquire(*_: Any, **__: Any) -> Any:
        raise NoCapacity("All simulators are busy.")

    monkeypatch.setattr(SimulatorPool, "acquire", acquire)
    run = await parts.registry.add(calibration_run("score"), None, "")
    assert await parts.registry.writer.is_stored(run)
    saved: list[str] = []

    async def save(run: Run) -> list[Episode]:
        saved.append(run.state)
        return []

    monkeypatch.setattr(parts.store, "save", save)
    with expect_refusal("no_capacity"):
        await parts.executor.attach(run, Attach("w", "key"))
    await parts.registry.close()
    assert (run.state, run.workers, saved) == ("ready", {}, [])


async def test_loading_a_run_is_retried(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """PUSH-017: no client requests it meanwhile."""
    monkeypatch.setitem(PROTOCOLS, "proctor", FaultyPolicy())
    monkeypatch.setattr(Backoff, "next_s", lambda _: 0.001)
    async with open_server_parts(tmp_path / "proctor.sqlite") as parts:
        await parts.registry.add(push_run(), None, "")
    async with open_server_parts(tmp_path / "proctor.sqlite") as parts:
        right, failed, scored = parts.store.load, 0, asyncio.Event()

        async def load(run_id: str) -> Run | None:
            nonlocal failed
            failed += 1
            if failed <= 3:
                raise StoreFailed("The disk is away.")
            run = await right(run_id)
            scored.set()
            return run

        monkeypatch.setattr(parts.store, "load", load)
        push_driver = make_driver(parts)
        push_driver.open()
        await asyncio.wait_for(scored.wait(), TIMEOUT_S)
        await wait_until_completed(parts)
        await push_driver.close()


async def test_sessions_of_a_played_run_end_with_it(
    monkeypatch: pytest.MonkeyPatch, parts: ServerParts
) -> None:
    """No client repeats a turn of theirs, and their lease is a day."""
    monkeypatch.setitem(PROTOCOLS, "proctor", FaultyPolicy())
    push_driver = make_driver(parts)
    await parts.registry.add(push_run(), None, "")
    run = await wait_until_completed(parts)
    while parts.executor.sessions:  # noqa: ASYNC110 - no event is of that
        await asyncio.sleep(0.01)
    assert run.workers == {}
    assert list(run.ended.values()) == ["detached"]
    await push_driver.close()


# --- keys ---

LONG_KEY = "sk-" + "0123456789" * 4
SLASHED = "ab/cd~ef/gh"


@pytest.fixture
def policy() -> Iterator[ScriptedPolicy]:
    with ScriptedPolicy() as server:
        yield server


def fault_text(
    policy: ScriptedPolicy,
    key: str,
    operation: str = "describe",
    max_bytes: int = 65536,
    max_retries: int = 0,
) -> str:
    """The text that a run's submitter reads when a call of the policy server fails."""

    async def ask() -> Any:
        limits = CallLimits(TIMEOUT_S, 1, max_retries, max_bytes)
        async with HttpCalls(policy.url, EgressPolicy("all"), limits, key) as calls:
            run = push_run()
            asked = ProctorPolicy(run, PolicyServerConfig.from_run(run), calls)
            if operation == "describe":
                return await asked.describe()
            turn = {"session_id": "s", "seq": 0, "episode": {}}
            return await getattr(asked, operation)(turn)

    with pytest.raises(PolicyFault) as caught:
        asyncio.run(ask())
    return str(caught.value)


@pytest.mark.parametrize(
    ("operation", "most"),
    [("describe", ANSWER_BYTES_MAX), ("predict", 4 * ANSWER_BYTES_MAX)],
)
def test_only_actions_may_be_longer_than_other_answers(
    policy: ScriptedPolicy, operation: str, most: int
) -> None:
    as_json = {"Content-Type": "application/json"}

    def answer(size: int) -> str:
        reply = PolicyReply(b"[]" + b" " * (size - 2), 200, as_json)
        for name in ("describe_policy", "predict"):
            policy.on(name, lambda _: reply)
        return fault_text(policy, "key", operation, 4 * ANSWER_BYTES_MAX)

    assert f"answered more than {most} bytes" in answer(most + 1)
    assert "answered more than" not in answer(most)


@pytest.mark.parametrize("words", [1, 100, 700])
@pytest.mark.parametrize("operation", ["describe", "predict"])
@pytest.mark.parametrize("is_refused", [True, False])
def test_both_ends_of_a_reason_survive_its_limit(
    policy: ScriptedPolicy, words: int, operation: str, is_refused: bool
) -> None:
    """What was raised stands at the beginning, and where at the end."""
    raised = f"The policy raised RuntimeError: {'size ' * words}(model.py:7)"
    problem = {"code": "policy_failed", "detail": raised}
    status = 422 if is_refused else 500
    reply = PolicyReply(problem, status, {"Content-Type": PROBLEM_JSON})
    policy.on(
        {"describe": "describe_policy"}.get(operation, operation), lambda _: reply
    )
    text = fault_text(policy, LONG_KEY, operation)
    assert f"status {status} (policy_failed: The policy raised RuntimeError: si" in text
    assert "(model.py:7)) (" in text
    assert len(text) < 900
    problem["detail"] = "x" * 20_000
    assert "too long to be read" in fault_text(policy, LONG_KEY, operation)


@pytest.mark.parametrize(
    ("body", "media_type", "said"),
    [
        (b"CUDA out\n of memory", "text/plain; charset=utf-8", "CUDA out of memory"),
        (b'{"detail": "no weights"}', "application/json", "no weights"),
        (b'{"error": "no weights", "at": 7}', "application/json", "no weights"),
        (b'{"code": 500, "message": "boom"}', "application/json", "boom"),
        (f"for {LONG_KEY}".encode(), "text/plain", "for [API key removed]"),
        (b"<html>boom", "text/html", None),
        (b"{}", "application/json", None),
        (b"[1]", "application/json", None),
        (b"{", "application/json", None),
        (b" ", "text/plain", None),
        (b"x" * 20_000, "text/plain", None),
    ],
)
def test_the_words_of_a_refusal_are_shown(
    policy: ScriptedPolicy, body: bytes, media_type: str, said: str | None
) -> None:
    """As frameworks write an exception that nothing has caught."""
    reply = PolicyReply(body, 500, {"Content-Type": media_type})
    policy.on("reset", lambda _: reply)
    shown = "" if said is None else f' (it says "{said}")'
    assert f"status 500{shown} (reset" in fault_text(policy, LONG_KEY, "reset")


@pytest.mark.parametrize(
    ("replies", "said", "calls"),
    [
        ([503, 503, 503], "status 503 (predict, 3 times)", 3),
        ([503, 429, 504], "status 503, and when called again answered with", 3),
        ([502, 422], "status 502, and when called again answered with status 422", 2),
        ([503, 500], "status 503, and when called again answered with status 500", 2),
        ([500], "status 500 (predict)", 1),
        ([501, 505, 599], "status 501, and when called again answered with", 3),
    ],
)
def test_the_first_cause_of_repeated_calls_is_reported(
    policy: ScriptedPolicy,
    monkeypatch: pytest.MonkeyPatch,
    replies: list[int],
    said: str,
    calls: int,
) -> None:
    """PUSH-021: a 500 is not repeated."""
    monkeypatch.setattr(Backoff, "next_s", lambda _: 0.0)
    left = iter(replies)
    policy.on("predict", lambda _: PolicyReply(b"", next(left)))
    assert said in fault_text(policy, LONG_KEY, "predict", max_retries=2)
    assert len(policy.calls_of("predict")) == calls


@pytest.mark.parametrize(
    ("call", "wait_s", "calls"),
    [
        (("reset", "unavailable"), 60.0, 8),
        (("reset", "unavailable"), 0.0, 3),
        (("reset", "no_capacity"), 60.0, 3),
        (("predict", "unavailable"), 60.0, 3),
        (("describe", "unavailable"), 60.0, 3),
    ],
)
def test_a_busy_policy_server_is_waited_for(
    policy: ScriptedPolicy,
    monkeypatch: pytest.MonkeyPatch,
    call: tuple[str, str],
    wait_s: float,
    calls: int,
) -> None:
    """Seven refusals of a reset, then a status that is final."""
    operation, code = call
    monkeypatch.setattr(Backoff, "next_s", lambda _: 0.0)
    monkeypatch.setattr(calls_with_retries, "BUSY_WAIT_MAX_S", wait_s)
    headers = {"Content-Type": PROBLEM_JSON, "Retry-After": "0"}
    name = "describe_policy" if operation == "describe" else operation
    left = iter([503] * 7 + [422] * 2)
    policy.on(name, lambda _: PolicyReply({"code": code}, next(left), headers))
    text = fault_text(policy, LONG_KEY, operation, max_retries=2)
    assert f"status 503 ({code})" in text
    assert len(policy.calls_of(name)) == calls


@pytest.mark.parametrize("before", [0, 150, 170, 190, 195, 300, 330, 345, 352, 690])
def test_no_part_of_a_key_survives_truncation(
    policy: ScriptedPolicy, before: int
) -> None:
    problem = {"detail": "x" * before + LONG_KEY}
    reply = PolicyReply(problem, 401, {"Content-Type": PROBLEM_JSON})
    policy.on("describe_policy", lambda _: reply)
    text = fault_text(policy, LONG_KEY)
    assert "status 401" in text
    assert LONG_KEY[:4] not in text


def test_a_key_in_a_media_type_is_redacted(policy: ScriptedPolicy) -> None:
    named = {"Content-Type": "text/" + "x" * 40 + LONG_KEY.upper()}
    policy.on("describe_policy", lambda _: PolicyReply(b"", 200, named))
    text = fault_text(policy, LONG_KEY.upper())
    assert "answered with text/xx" in text
    assert LONG_KEY[:4] not in text.lower()


@pytest.mark.parametrize("length", [0, 440, 460, 480])
def test_a_key_in_a_pointer_is_redacted(policy: ScriptedPolicy, length: int) -> None:
    """A JSON pointer writes a slash otherwise, and long lists are cut."""

    def wrong(call: PolicyCall) -> PolicyReply:
        right: dict[str, Any] = dict(policy.final_action_reply(call).body)
        return PolicyReply(right | {"x" * length + SLASHED: 1})

    policy.on("predict", wrong)
    text = fault_text(policy, SLASHED, "predict")
    assert "was refused" in text
    assert "ab~1" not in text
    assert SLASHED[:3] not in text


def test_a_key_in_a_refused_action_name_is_redacted() -> None:
    calls = HttpCalls("http://x", EgressPolicy(), CallLimits(1.0, 1, 0, 1), SLASHED)
    at = "/actions/0/values/ab~1cd~0ef~1gh"
    refused = Refused("invalid_request", "No.", errors=[(at, "is no name")])
    assert str(answer_fault(refused, calls)) == (
        "The policy's answer to predict was refused: "
        "/actions/0/values/[API key removed] is no name."
    )


async def test_a_key_in_the_assumptions_is_redacted(
    monkeypatch: pytest.MonkeyPatch, parts: ServerParts
) -> None:
    class AssumingPolicy(FaultyPolicy):
        async def describe(self) -> Description:
            return Description(1, {"action": {SLASHED: {"size": 1}}})

    monkeypatch.setitem(PROTOCOLS, "proctor", AssumingPolicy())
    key_encryption = KeyEncryption()
    push_driver = make_driver_with(parts, key_encryption)
    run = push_run()
    asked = ORDER | {"sealed_key": key_encryption.encrypt(SLASHED)}
    run.submission = {**run.submission, "policy_server": asked}
    await parts.registry.add(run, None, "")
    with pytest.raises(AssertionError, match=r"/action/\[API key removed\]"):
        await wait_until_completed(parts)
    await push_driver.close()
