"""The oracle on histories: right ones have no difference, wrong ones their rule."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Sequence
from typing import Any

import pytest

from conformance.client.request_context import RequestContext
from conformance.oracle.history.facts.seen_exchange import LOST, SeenExchange, read_path
from conformance.run_settings import Settings
from conformance.specification.document import load_spec
from conformance.verdicts.exchange_judge import new_history

DATE = "2026-01-01T00:00:{:09.6f}Z"
NUMBERS = itertools.count(1)


def a_run(state: str = "ready", **changes: Any) -> dict[str, Any]:
    counts = {"total": 3, "scored": 0, "in_progress": 0, "pending": 3}
    counts |= {key: changes.pop(key) for key in [*counts] if key in changes}
    run = {
        "run_id": "r",
        "state": state,
        "reason": None,
        "retryable": None,
        "benchmark_id": "calibration",
        "policy": {"name": "p"},
        "max_workers": 2,
        "idle_timeout_s": 30.0,
        "queue_position": None,
        "live_workers": counts["in_progress"],
        "progress": {f"episodes_{name}": number for name, number in counts.items()},
        "created_at": DATE.format(1),
        "updated_at": DATE.format(1),
    }
    return run | changes


def a_result(index: int = 0, **changes: Any) -> dict[str, Any]:
    result = {
        "episode_id": f"e{index}",
        "index": index,
        "task": "count",
        "split": "even",
        "attempt": 1,
        "faults": 0,
        "outcome": "failure",
        "score": 0.0,
        "steps": 1,
        "terminated": True,
        "truncated": False,
        "finished_at": DATE.format(5),
    }
    return result | changes


def an_item(index: int = 0, **changes: Any) -> dict[str, Any]:
    item = {key: a_result(index)[key] for key in ("episode_id", "index", "task")}
    more = {"split": "even", "attempt": 1, "faults": 0, "status": "pending"}
    return item | more | changes


def scored(index: int = 0, **changes: Any) -> dict[str, Any]:
    return an_item(index, status="scored", result=a_result(index, **changes))


def at_step(step: int = 0, index: int = 0, attempt: int = 1) -> dict[str, Any]:
    shown = {"episode_id": f"e{index}", "index": index, "task": "count"}
    episode = shown | {"attempt": attempt, "step": step, "max_steps": 3}
    states = {"count": [step], "vector": [0.0] * 8, "clipped": [0.0] * 2}
    return {"episode": episode, "observation": {"state": states}}


def a_turn(
    seq: int = 0, rewards: int | None = None, session: str = "s", **changes: Any
) -> dict[str, Any]:
    rewards = min(seq, 1) if rewards is None else rewards
    turn = {
        "session_id": session,
        "seq": seq,
        "executed_steps": rewards,
        "stopped_early": False,
        "rewards": [0.0] * rewards,
        "terminated": False,
        "truncated": False,
        "done": False,
        "lease": {"idle_timeout_s": 30.0, "expires_at": DATE.format(31)},
        "timing": {},
    }
    return turn | changes


def an_action(**values: Any) -> dict[str, Any]:
    return RequestContext.action(**values)


class Story:
    """Exchanges with one service, each after the other unless a time is given."""

    def __init__(self, profiles: Sequence[str] = ("sessions",)) -> None:
        limits = {"wait_s_max": 20, "max_chunk": 4}
        settings = Settings(service={"limits": limits, "profiles": profiles})
        self.history = new_history(load_spec(), settings)
        self.now = 0.0
        self.rules: list[str] = []
        self.begun, self.begun_at = 0, 0.0  # a request that has not ended, its time

    def begin(self, operation: str, at: float) -> Story:
        """Send a request of the session s whose answer comes later."""
        self.begun, self.begun_at = next(NUMBERS), at
        params, body = {"run_id": "r", "worker_id": "w"}, {"session_id": "s", "seq": 1}
        sent = SeenExchange(operation, at, LOST, None, params=params, body=body)
        self.history.begin(self.begun, sent)
        return self

    def say(
        self, operation: str, value: Any, status: int | None = 200, **how: Any
    ) -> None:
        """Send a request and get this answer, one second later."""
        started_at = how.pop("at", self.now + 1)
        ended_at = LOST if status is None else started_at + how.pop("takes", 1)
        params = {"run_id": "r", "worker_id": how.pop("worker", "w")}
        is_begun = self.begun and started_at == self.begun_at
        seen = SeenExchange(
            operation,
            started_at,
            ended_at,
            status,
            value,
            {} if operation in ("submit_run", "list_runs") else params,
            account=how.pop("account", "TOKEN"),
            media_type="application/json",
            **how,
        )
        number = self.begun if is_begun else next(NUMBERS)
        differences = self.history.end(number, seen)
        self.rules += [difference.rules[0] for difference in differences]
        self.now = max(self.now, started_at if status is None else ended_at)

    def resume(self) -> Story:
        """Resume the run."""
        self.say("resume_run", a_run())
        return self

    def submit(
        self, key: str | None = None, run_id: str = "r", **options: Any
    ) -> Story:
        """Submit a run of three episodes, with this Idempotency-Key."""
        names = ("at", "takes")
        how: dict[str, Any] = {n: options.pop(n) for n in names if n in options}
        how |= {"headers": {"idempotency-key": key}} if key else {}
        policy = {"name": "p"}
        options = {"tasks": ["count"] * 3, "max_steps": 3} | options
        body = {"benchmark_id": "calibration", "policy": policy, "options": options}
        self.say("submit_run", a_run(run_id=run_id), 201, body=body, **how)
        return self

    def attach(self, key: str = "k", **how: Any) -> Story:
        """Attach; the answer is turn 0 of episode 0 unless `turn` is given."""
        turn = how.pop("turn", None) or a_turn(**at_step())
        body = {"attach_key": key} | how.pop("body", {})
        self.say("attach_worker", turn, body=body, **how)
        return self

    def predict(self, turn: Any, *actions: Any, seq: int = 1, **how: Any) -> Story:
        """Send a chunk, of one action unless others are given."""
        body = {"session_id": "s", "seq": seq, "actions": [*actions] or [an_action()]}
        self.say("predict", turn, body=body | how.pop("body", {}), **how)
        return self

    def detach(self, **how: Any) -> Story:
        """Detach the session s."""
        self.say("detach_worker", None, 204, query={"session_id": "s"}, **how)
        return self

    def see(self, run: dict[str, Any] | None, **how: Any) -> Story:
        """Read the run."""
        self.say("get_run", run, **how)
        return self

    def listed_run(self, run: dict[str, Any]) -> Story:
        """Read the list of runs."""
        self.say("list_runs", {"runs": [run], "next_cursor": None})
        return self

    def listed(self, *items: dict[str, Any], cursor: str | None = None) -> Story:
        """Read the first page of the episodes."""
        self.say("list_episodes", {"episodes": [*items], "next_cursor": cursor})
        return self

    def refused(self, operation: str, code: str, **how: Any) -> Story:
        """Send a request that is refused."""
        members: dict[str, Any] = {
            name: how.pop(name) for name in ("state", "ended_by") if name in how
        }
        members |= {"expected_seq": how.pop("due")} if "due" in how else {}
        pointer = how.pop("pointer", None)
        members |= {"errors": [{"pointer": pointer}]} if pointer else {}
        body = {"session_id": "s"} | how.pop("body", {})
        self.say(operation, {"code": code} | members, 409, body=body, **how)
        return self

    def refused_at(self, pointer: str, members: dict[str, Any]) -> Story:
        """Send a valid chunk, with more members, that is refused for another part."""
        answer = {"code": "invalid_request", "errors": [{"pointer": pointer}]}
        body = {"session_id": "s", "seq": 1, "actions": [an_action()]} | members
        self.say("predict", answer, 422, body=body)
        return self

    def stop(self, mode: str = "abort", state: str = "stopped", **how: Any) -> Story:
        """Stop the run."""
        self.say("stop_run", a_run(state), body={"mode": mode}, **how)
        return self


def new() -> Story:
    return Story().submit()


def begun() -> Story:
    return new().attach()


def delayed(seq: int = 0) -> dict[str, Any]:
    """A turn of the task `delay`."""
    shown = at_step(seq)
    return a_turn(seq, **shown | {"episode": shown["episode"] | {"task": "delay"}})


def etag(name: str) -> dict[str, str]:
    return {"etag": f'"{name}"'}


END, FIRST = an_action(end=1), at_step()
VALID = {"seq": 1, "actions": [an_action()]}
RUNNING = a_run("running", in_progress=1, pending=2)
STEP, OTHER = a_turn(1, **at_step(1)), a_turn(session="t", **at_step())
SECOND = a_turn(1, terminated=True, episode_result=a_result(), **at_step(0, 1))
THIRD = a_turn(
    2, terminated=True, episode_result=a_result(1, split="odd"), **at_step(0, 2)
)
LAST_OF_DRAIN = a_turn(1, terminated=True, episode_result=a_result(), done=True)
DONE = a_turn(3, terminated=True, episode_result=a_result(2), done=True)
RIGHT: dict[str, Callable[[], Story]] = {
    "a run is played": lambda: (
        begun()
        .predict(SECOND, END)
        .see(a_run("running", scored=1, in_progress=1, pending=1))
    ),
    "a repeat": lambda: begun().predict(SECOND, END).predict(SECOND, END),
    "a concurrent read is older": lambda: begun().see(RUNNING).see(a_run(), at=0.5),
    "a lost stop may come later": lambda: (
        begun().stop(status=None).see(RUNNING).see(a_run("stopped"))
    ),
    "a resume without an answer": lambda: (
        begun().stop().refused("resume_run", "unavailable").see(a_run("ready"))
    ),
    "an old ETag again": lambda: (
        begun()
        .see(RUNNING, answer_headers=etag("1"))
        .detach()
        .see(a_run(), answer_headers=etag("2"))
        .attach("k2", turn=OTHER)
        .see(RUNNING, answer_headers=etag("1"))
    ),
    "a step of unknown actions after a lost turn": lambda: (
        begun()
        .predict(None, seq=1, status=None)
        .attach("k2", turn=a_turn(session="t", **at_step(1)), body={"takeover": True})
    ),
    "an abort beside an attach": lambda: (
        new().stop(at=1.0, takes=3).attach(at=2.0).see(a_run("stopped"), at=5.0)
    ),
    "two attaches beside each other": lambda: (
        new()
        .attach("k2", turn=OTHER, at=2.0)
        .attach(at=1.5, body={"takeover": True})
        .predict(STEP)
    ),
    "a repeat of a long turn is answered first": lambda: (
        Story()
        .submit(tasks=["delay"] * 3)
        .attach(turn=delayed())
        .predict(None, an_action(delay_s=3), at=3.0, status=None)
        .predict(delayed(1), an_action(delay_s=3), at=5.5)
    ),
    "a takeover in the middle of a turn": lambda: (
        begun()
        .begin("predict", at=4.5)
        .attach(
            "k2",
            turn=a_turn(session="t", **at_step(0, 1)),
            body={"takeover": True},
            at=5.0,
        )
        .predict(SECOND, END, at=4.5, takes=3)
    ),
    "a session that was detached is detached again beside its successor": lambda: (
        begun().detach().attach("k2", turn=OTHER).detach()
    ),
    "the answer that makes a session done comes after a refusal of its turn": lambda: (
        begun()
        .begin("predict", at=4.5)
        .stop("drain", "stopping", at=4.6, takes=0.1)
        .see(a_run("stopped", scored=1, pending=2), at=4.8, takes=0.1)
        .refused("predict", "seq_conflict", body=VALID, at=5.0, takes=0.1)
        .predict(LAST_OF_DRAIN, END, at=4.5)
    ),
    "a stop that is answered later has ended the session before its detach": lambda: (
        begun()
        .begin("stop_run", at=4.5)
        .detach(at=5.0)
        .refused("heartbeat", "session_ended", ended_by="run_stopped", at=7.0)
        .stop(at=4.5, takes=9)
    ),
    "a later attempt is listed": lambda: (
        turned(STEP)
        .detach()
        .listed(an_item(attempt=2), an_item(1, split="odd"), an_item(2))
        .attach("k2", turn=a_turn(session="t", **at_step(attempt=2)))
        .listed(
            an_item(attempt=2, status="in_progress"),
            an_item(1, split="odd"),
            an_item(2),
        )
    ),
    "a header, a parameter or another member may be invalid": lambda: (
        begun()
        .refused("predict", "invalid_request", body=VALID, pointer="header:Accept")
        .refused("predict", "invalid_request", body=VALID | {"observe": "last"})
        .refused("predict", "invalid_request", body=VALID | {"actions": [{}]})
    ),
    "a lease that was over": lambda: begun().refused(
        "heartbeat", "session_ended", ended_by="lease_ended", at=99.0
    ),
    "a lease that was over before a detach, which extends none": lambda: (
        begun()
        .detach(at=99.0)
        .refused("heartbeat", "session_ended", ended_by="lease_ended", at=99.5)
    ),
    "a session of more episodes than there are is done after the last": lambda: (
        new()
        .attach(body={"first_episodes": 1_000_000_000})
        .predict(SECOND, END)
        .predict(THIRD, END, seq=2)
        .predict(DONE, END, seq=3)
    ),
    "a wrong header": lambda: begun().refused_at("header:Accept", {}),
    "`observe` is a field of a profile": lambda: begun().refused_at(
        "/observe", {"observe": "last"}
    ),
}


@pytest.mark.parametrize("name", RIGHT)
def test_a_right_history_has_no_difference(name: str) -> None:
    story = RIGHT[name]()
    assert (story.rules, story.history.errors) == ([], [])


def turned(value: Any, *actions: Any, **how: Any) -> Story:
    return begun().predict(value, *actions, **how)


def later(**changes: Any) -> Story:
    return begun().see(a_run("running", in_progress=1, pending=2, **changes))


WRONG: dict[str, tuple[Callable[[], Story], str]] = {
    # Views of the run.
    "a constant changes": (lambda: later(max_workers=3), "RUN-018"),
    "another time of creation": (lambda: later(created_at=DATE.format(0)), "RUN-018"),
    "a place in no queue": (lambda: later(queue_position=1), "RUN-008"),
    "an end that is not complete": (
        lambda: new().attach().see(a_run("completed", scored=2, pending=1)),
        "LIFE-804",
    ),
    "scored and still running": (
        lambda: begun().see(a_run("running", scored=3, pending=0)),
        "LIFE-804",
    ),
    "in progress after a stop": (
        lambda: begun().stop().see(a_run("stopped", in_progress=1, pending=2)),
        "RUN-022",
    ),
    "a stopped run plays": (lambda: begun().stop().see(RUNNING), "LIFE-811"),
    "a stop leaves it running": (lambda: later().stop(state="ready"), "LIFE-302"),
    "one ETag for two runs": (
        lambda: (
            new()
            .see(a_run(), answer_headers=etag("1"))
            .attach()
            .see(RUNNING, answer_headers=etag("1"))
        ),
        "RUN-030",
    ),
    "a stale 304": (
        lambda: (
            new()
            .see(a_run(), answer_headers=etag("1"))
            .attach()
            .see(a_run("running", scored=1, in_progress=1, pending=1))
            .see(None, status=304, headers={"if-none-match": '"1"'})
        ),
        "RUN-011",
    ),
    "a 200 for the current ETag": (
        lambda: new().see(
            a_run(), answer_headers=etag("1"), headers={"if-none-match": '"1"'}
        ),
        "RUN-011",
    ),
    "a wait that is too short": (
        lambda: new().see(
            None, status=304, headers={"prefer": "wait=5", "if-none-match": '"1"'}
        ),
        "RUN-013",
    ),
    "a list that shows another run than reads around it": (
        lambda: new().see(a_run()).listed_run(a_run(reason="x")).see(a_run()),
        "RUN-019",
    ),
    "another policy": (lambda: new().see(a_run(policy={})), "RUN-018"),
    "too few episodes": (
        lambda: Story().submit(tasks=["count"]).see(a_run()),
        "CAL-001",
    ),
    "two live workers shown as one": (
        lambda: (
            begun()
            .attach("k2", turn=a_turn(session="t", **at_step(0, 1)), worker="v")
            .see(RUNNING)
        ),
        "LEASE-002",
    ),
    "a worker that has detached": (lambda: begun().detach().see(RUNNING), "RUN-022"),
    "running without a worker": (
        lambda: begun().detach().see(a_run("running")),
        "LIFE-802",
    ),
    # Episodes and scores.
    "another task": (
        lambda: Story().submit(tasks=["score"] * 3).listed(an_item(), cursor="c"),
        "CAL-001",
    ),
    "another seed": (
        lambda: turned(SECOND | {"episode_result": a_result(seed=1)}, END),
        "SEAL-001",
    ),
    "an attempt that is not counted": (
        lambda: turned(STEP).detach().attach("k2", turn=OTHER),
        "EPI-003",
    ),
    "an attempt goes back": (
        lambda: (
            new()
            .listed(an_item(0, attempt=2), cursor="c")
            .listed(an_item(0), cursor="c")
        ),
        "EPI-003",
    ),
    "two episodes with one id": (
        lambda: new().listed(an_item(0), an_item(1, episode_id="e0")),
        "RUN-024",
    ),
    # Turns.
    "another reward": (lambda: turned(STEP, an_action(score=0.5)), "CAL-008"),
    "nothing left too early": (
        lambda: begun().attach(turn=a_turn(session="t", done=True), worker="v"),
        "ATT-012",
    ),
    # The end of a session.
    "a turn after a stop": (lambda: begun().stop().predict(STEP), "STOP-002"),
    "a turn after the lease": (lambda: begun().predict(STEP, at=99.0), "LEASE-001"),
    "a lease that is too short": (
        lambda: begun().refused("heartbeat", "session_ended", ended_by="lease_ended"),
        "LEASE-002",
    ),
    "detached without a cause": (
        lambda: begun().refused("heartbeat", "session_ended", ended_by="detached"),
        "DET-005",
    ),
    "full without a worker": (
        lambda: new().refused("attach_worker", "worker_limit"),
        "ATT-006",
    ),
    "a ready run refuses a worker": (
        lambda: new().refused("attach_worker", "illegal_transition", state="ready"),
        "LIFE-201",
    ),
    "the stop beside an attach has missed it": (
        lambda: (
            new()
            .stop(at=1.0, takes=3)
            .attach(at=2.0)
            .see(a_run("stopped"), at=5.0)
            .predict(STEP, at=7.0)
        ),
        "STOP-002",
    ),
    "a session that is over cannot be detached again": (
        lambda: begun().detach().refused("detach_worker", "session_ended"),
        "DET-002",
    ),
    "another cause of the end": (
        lambda: (
            begun().detach().stop().refused("heartbeat", "session_ended", ended_by="x")
        ),
        "DET-005",
    ),
    "a stop that was sent after the detach is no cause of the end": (
        lambda: (
            begun()
            .detach(at=5.0)
            .begin("stop_run", at=6.5)
            .refused("heartbeat", "session_ended", ended_by="run_stopped", at=7.0)
        ),
        "DET-005",
    ),
    "a closed attempt is not counted": (
        lambda: turned(STEP).detach().listed(an_item(), an_item(1), an_item(2)),
        "EPI-003",
    ),
    "a session more than there are slots": (
        lambda: (
            begun()
            .see(a_run("running", in_progress=1, pending=2, max_workers=1))
            .attach(turn=a_turn(session="t", **at_step(0, 1)), worker="v")
        ),
        "ATT-006",
    ),
    "a stopped run accepts a worker": (lambda: new().stop().attach(), "LIFE-501"),
    "a failed run is resumed": (
        lambda: (
            Story()
            .submit(tasks=["fault"])
            .see(a_run("failed", retryable=False))
            .resume()
        ),
        "LIFE-605",
    ),
    "a session that is over has a conflict": (
        lambda: (
            begun()
            .predict(SECOND, END)
            .detach()
            .refused("predict", "seq_conflict", body=VALID)
        ),
        "PRED-027",
    ),
    "a session that is done ends when others complete the run": (
        lambda: (
            begun()
            .stop("drain", "stopping")
            .predict(LAST_OF_DRAIN, END)
            .refused(
                "predict",
                "session_ended",
                body=VALID | {"actions": [END]},
                ended_by="run_stopped",
            )
        ),
        "PRED-010",
    ),
    # Accounts and lists.
    "two runs of one key at once": (
        lambda: (
            Story().submit(key="k", at=1.0, takes=3).submit(key="k", at=2.0, run_id="q")
        ),
        "RUN-003",
    ),
    "a run of another account": (
        lambda: begun().see(RUNNING, account="TOKEN_2"),
        "AUTH-003",
    ),
    "a run that was shown is unknown": (
        lambda: begun().refused("get_run", "not_found"),
        "MODEL-001",
    ),
}


@pytest.mark.parametrize("name", WRONG)
def test_a_wrong_history_breaks_its_rule(name: str) -> None:
    make, rule = WRONG[name]
    story = make()
    assert rule in story.rules, (story.rules, story.history.errors)
    assert not story.history.errors


@pytest.mark.parametrize(
    ("max_attempts", "item", "rules"),
    [
        (3, an_item(), []),
        (3, an_item(attempt=2), []),
        (1, an_item(), []),
        (3, an_item(status="in_progress"), ["STOP-001"]),
        (1, scored(outcome="abandoned", score=0, steps=1), ["STOP-001"]),
    ],
)
def test_a_server_without_sessions_may_count_attempts(
    max_attempts: int, item: dict[str, Any], rules: list[str]
) -> None:
    story = Story(profiles=["lists"]).submit(max_attempts=max_attempts).attach()
    story.predict(STEP).stop().listed(item, an_item(1, split="odd"), an_item(2))
    assert (story.rules[:1], story.history.errors) == (rules, [])


def test_unread_requests_explain_a_move() -> None:
    story = new()
    story.history.note_unread("")
    assert story.see(a_run("stopped")).rules == []
    assert new().see(a_run("stopped")).rules == ["LIFE-204"]


def test_a_restart_ends_sessions_and_keeps_results() -> None:
    story = begun().predict(SECOND, END)
    story.see(a_run("running", scored=1, in_progress=1, pending=1))
    story.history.runs["r"].note_restart(story.now + 0.1, LOST)
    story.refused("heartbeat", "session_ended", ended_by="unknown", takes=0)
    story.history.runs["r"].note_restart(story.now + 0.1, story.now + 0.2)
    story.refused("heartbeat", "session_ended", ended_by="unknown")
    assert story.rules == []
    assert story.see(a_run("stopped")).rules == ["CRASH-001"]


def test_an_answer_of_a_wrong_shape_is_left_to_the_schemas() -> None:
    story = begun()
    story.see({"state": "running"})
    assert story.rules == []
    assert len(story.history.errors) == 1


@pytest.mark.parametrize(
    ("url", "params"),
    [
        ("http://h/v1/runs/a", {"run_id": "a"}),
        ("https://h/base/v1/runs/a%2Fb?x=1", {"run_id": "a/b"}),
        ("http://h/v1/v1/runs/a", {"run_id": "a"}),
        ("http://h/v2/runs/a", {}),
    ],
)
def test_the_path_gives_the_run(url: str, params: dict[str, str]) -> None:
    assert read_path("/v1/runs/{run_id}", url) == params
