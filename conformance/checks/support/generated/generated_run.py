"""Generated requests of several clients to one run, which the oracle judges.

A command becomes a request when the client has the ids for it: before its first predict
it attaches. A client knows only the content of its own responses.
"""

import contextlib
import copy
import uuid
from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from typing import Any

from hypothesis import strategies as st

from conformance.checks.support.generated.spelled_requests import (
    RULES_OF_HEADERS,
    spell_request,
)
from conformance.client.check_context import CheckContext
from conformance.client.http_client import LeftUnanswered
from conformance.client.run_client import RunClient
from conformance.exchanges.answer import Answer
from conformance.verdicts import expect
from conformance.verdicts.expect import SetUpFailed, Violation

Request = tuple[str, dict[str, Any]]
EPISODES, MAX_STEPS, MAX_ATTEMPTS, MAX_WORKERS = 3, 6, 2, 2
ATTACH, ATTACH_AGAIN, TAKEOVER = "attach", "attach again", "take over"
NEXT_SEQ, REPEAT, REPEAT_CHANGED, SKIPPED_SEQ, OLD_SEQ = (
    *("next", "repeat", "repeat otherwise", "skip", "old"),
)
RESTART, RUN_COMMANDS = "abort and resume", ("abort", "drain", "resume")
READS = READ_RUN, READ_EPISODES, READ_SCORE = (
    *("read run", "read episodes", "read score"),
)
WAIT, SUBMIT_AGAIN, READ_LIST = "wait", "submit again", "list runs"
INVALID, FOREIGN = "invalid action", "session of another worker"
SEQ_OFFSETS = {
    NEXT_SEQ: 1,
    REPEAT: 0,
    REPEAT_CHANGED: 0,
    SKIPPED_SEQ: 2,
    OLD_SEQ: -1,
    INVALID: 1,
    FOREIGN: 1,
}
# The kinds that need another profile than Core.
_PROFILES = {
    **dict.fromkeys((TAKEOVER, "heartbeat", "detach"), "sessions"),
    **dict.fromkeys(("drain", "resume", RESTART), "control"),
    **dict.fromkeys((READ_EPISODES, READ_LIST), "lists"),
    SUBMIT_AGAIN: "submit_once",
}
_REFUSED = (INVALID, FOREIGN)
_OF_WRONG_REQUESTS = (
    *("malformed_body", "invalid_request", "invalid_action", "not_acceptable"),
    *("unsupported_media_type", "not_found", "method_not_allowed", "body_too_large"),
    *("unsupported_version", "unauthenticated", "forbidden"),
)
_OF_RUN = (*RUN_COMMANDS, RESTART, *READS, WAIT, SUBMIT_AGAIN, READ_LIST)
_WITH_STEPS = SEQ_OFFSETS.keys() - {REPEAT}
# Their second request finds the effect of the first, or makes it.
_LEFT = (NEXT_SEQ, REPEAT, ATTACH, TAKEOVER, "heartbeat", "detach", "abort", "drain")
MSGPACK, OBSERVE_ALL = "msgpack", "observe all"
# Each id is the beginning of the next one: with the rest, all read alike.
WORKERS = ("w", "wo", "wor")


@dataclass(frozen=True)
class Step:
    """The values of an action that a history draws."""

    score: float = 0.0
    success: int = 0
    end: int = 0
    delay_s: float = 0.0
    fault: int = 0
    clipped: float = 0.0

    def action(self) -> dict[str, Any]:
        """Give the action that has these values."""
        return CheckContext.action(
            score=self.score,
            success=self.success,
            end=self.end,
            delay_s=self.delay_s,
            fault=self.fault,
            clipped=[self.clipped, 0.0],
        )


# Sums of these are exact, in whatever order a server adds them.
STEPS = [
    *(Step(0.25), Step(0.125), Step(0.375), Step(0.5, success=1)),
    *(Step(1.0, success=1, end=1), Step(0.75, end=1)),
]
# In the middle of these another request arrives; the task `delay` executes them.
SLOW_STEPS = [Step(0.25, delay_s=0.04), Step(1.0, success=1, end=1, delay_s=0.04)]


@dataclass(frozen=True)
class ClientCommand:
    """A command of client number `client` for a worker, or for the run."""

    client: int
    kind: str
    worker: str = ""
    steps: tuple[Step, ...] = ()
    spelling: tuple[str, ...] = ()  # of `predict`, with MSGPACK and OBSERVE_ALL
    form: int = 0  # the seed of another legal spelling of the request
    # The client closes the connection after this time, and sends the request again.
    leave_after_s: float | None = None


_PLAIN = st.just(0)


def commands_of_core(kinds: list[str]) -> list[str]:
    """Give the kinds of commands that a server of Core has."""
    return [kind for kind in kinds if kind not in _PROFILES]


def offered(context: CheckContext, kinds: list[str]) -> list[str]:
    """Give the kinds of commands that need no profile which the server lacks."""
    return [k for k in kinds if context.offers(_PROFILES.get(k, "core"))]


def commands(
    clients: int,
    kinds: list[str],
    steps: list[Step] = STEPS,
    *,
    longest: int = 3,
    spellings: Sequence[tuple[str, ...]] = ((),),
    forms: st.SearchStrategy[int] = _PLAIN,
    leaves: Sequence[float | None] = (None,),
) -> st.SearchStrategy[ClientCommand]:
    """Draw a command; kinds that stand twice are drawn twice as often.

    longest: the most actions of a chunk.
    """
    chunk = st.lists(st.sampled_from(steps), min_size=1, max_size=longest).map(tuple)
    first, second, third = WORKERS
    return st.builds(
        lambda client, kind, worker, steps, spelling, form, leave: ClientCommand(
            client,
            kind,
            "" if kind in _OF_RUN else worker,
            steps if kind in (*_WITH_STEPS, READ_EPISODES) else (),
            spelling if kind in (*SEQ_OFFSETS, ATTACH, ATTACH_AGAIN) else (),
            form,
            leave if kind in _LEFT else None,
        ),
        st.integers(0, clients - 1),
        st.sampled_from(kinds),
        st.sampled_from([first, first, first, second, second, third]),
        chunk,
        st.sampled_from(spellings),
        forms,
        st.sampled_from(leaves),
    )


@dataclass
class SessionHandle:
    """The client's knowledge of its session of one worker."""

    session: str
    key: str
    seq: int = 0
    steps: tuple[Step, ...] = ()
    observe: str | None = None

    def request(self, command: ClientCommand) -> Request | None:
        """Give the request of a command, if there is one."""
        session, how = {"session_id": self.session}, {"worker_id": command.worker}
        match command.kind:
            case "attach again":
                return "attach_worker", how | {"json": {"attach_key": self.key}}
            case "heartbeat":
                return "heartbeat", how | {"json": session}
            case "detach":
                return "detach_worker", how | {"params": session}
        seq = self.seq + SEQ_OFFSETS[command.kind]
        steps = self.steps if command.kind == REPEAT else command.steps
        if seq < 1 or not steps:
            return None
        body: dict[str, Any] = {"seq": seq, "actions": [s.action() for s in steps]}
        is_all = OBSERVE_ALL in command.spelling
        observe = self.observe if command.kind == REPEAT else "all" if is_all else None
        if observe is not None:
            body["observe"] = observe
        if command.kind == INVALID:  # the last one: none of the chunk is executed
            body["actions"][-1]["values"]["vector"].append(0.0)
        return "predict", how | {"json": session | body}


@dataclass
class GeneratedClient:
    """One client with its sessions; `keys` counts the attach keys of each worker."""

    number: int
    handles: dict[str, SessionHandle] = field(default_factory=dict)
    keys: Counter[str] = field(default_factory=Counter)
    etag: str = ""

    def request(self, command: ClientCommand) -> Request | None:
        """Give the request that carries a command out now, if there is one."""
        worker, kind = command.worker, command.kind
        handle = self.handles.get(worker)
        if kind in ("abort", "drain"):
            return "stop_run", {"json": {"mode": kind}}
        if kind == "resume":
            return "resume_run", {}
        if kind in READS:
            return self._read(command)
        if kind == FOREIGN:
            handle = next((self.handles[w] for w in self.handles if w != worker), None)
        if kind in _REFUSED and handle is None:
            return None
        if kind not in (ATTACH, TAKEOVER) and handle is not None:
            return handle.request(command)
        self.keys[worker] += 1
        rest = WORKERS[-1].removeprefix(worker)
        body: dict[str, Any] = {
            "attach_key": f"{rest}-{self.number}-{self.keys[worker]}"
        }
        if kind == TAKEOVER:
            body["takeover"] = True
        return "attach_worker", {"worker_id": worker, "json": body}

    def _read(self, command: ClientCommand) -> Request:
        """Give a request that reads; a page is as long as the command is."""
        match command.kind:
            case "read run":
                known = {"If-None-Match": self.etag} if self.etag else None
                return "get_run", {"headers": known}
            case "read episodes":
                return "list_episodes", {"params": {"limit": len(command.steps)}}
        return "get_score", {}

    def learn(self, command: ClientCommand, request: Request, answer: Answer) -> None:
        """Store the session and the seq of an answer."""
        operation, how = request
        if operation == "get_run":
            self.etag = answer.headers.get("etag", self.etag)
        if answer.status != 200 or not isinstance(answer.json, dict):
            return
        if operation == "attach_worker":
            session = str(answer.json.get("session_id"))
            handle = self.handles.get(command.worker)
            if handle is None or handle.session != session:
                key = how["json"]["attach_key"]
                self.handles[command.worker] = SessionHandle(session, key)
        elif operation == "predict":
            handle = self.handles[command.worker]
            handle.seq = how["json"]["seq"]
            if command.kind != REPEAT:
                handle.steps = command.steps
                handle.observe = how["json"].get("observe")


@dataclass(frozen=True)
class RunPlan:
    """The values with which a run is submitted; `options` has the other ones."""

    tasks: tuple[str, ...] = ("score",) * EPISODES
    max_steps: int = MAX_STEPS
    max_attempts: int = MAX_ATTEMPTS
    max_workers: int = MAX_WORKERS
    idle_timeout_s: float | None = None
    form: int = 0
    options: tuple[tuple[str, Any], ...] = ()


def _spelled(how: dict[str, Any], form: int) -> dict[str, Any]:
    """Give the same request in another legal spelling."""
    content, headers = spell_request(form, how.get("json"), how.get("headers"))
    return {**how, "json": None, "content": content, "headers": headers}


def _expect_accepted(operation: str, how: dict[str, Any], answer: Answer) -> None:
    """Expect no refusal as that of a wrong request.

    Where it is for a header, the rule on this header explains it.
    """
    if answer.code not in _OF_WRONG_REQUESTS:
        return
    observed = expect.describe_answer(answer)
    rule, name = RULES_OF_HEADERS.get(answer.code or "", ("", ""))
    value = (how.get("headers") or {}).get(name)
    if value is not None:
        text = f"{operation} with the right {name}: {value}: {observed}"
        raise SetUpFailed(text, breaks=rule, exchange=answer.exchange)
    text = f"no refusal of {operation}, whose request is right"
    raise Violation(text, observed, answer.exchange)


class GeneratedRun:
    """A new run and its clients."""

    def __init__(
        self,
        context: CheckContext,
        clients: int,
        plan: RunPlan | None = None,
        acts: Mapping[str, Callable[["GeneratedRun", ClientCommand], None]]
        | None = None,
    ) -> None:
        """Submit the run.

        acts: how kinds of commands that are not of one run are carried out.
        """
        context.coverage.histories += 1
        self.context = context
        self._acts: dict[str, Act] = {
            SUBMIT_AGAIN: GeneratedRun._submit_again,
            READ_LIST: GeneratedRun._read_list,
        }
        self._acts |= acts or {}
        self._submission: dict[str, Any] = {}
        self._differences = context.tally.differences
        self.run = self._submit_at_once(clients, plan or RunPlan())
        self.clients = [GeneratedClient(number) for number in range(clients)]

    def _submit_at_once(self, clients: int, plan: RunPlan) -> RunClient:
        """Submit a run, several times at once where keys are offered."""
        context = self.context
        options: dict[str, Any] = {"max_steps": plan.max_steps, **dict(plan.options)}
        if context.offers("sessions"):
            options["max_attempts"] = plan.max_attempts
        workers = min(plan.max_workers, context.limits["max_workers"])
        body = context.submit_body(
            max_workers=workers,
            idle_timeout_s=plan.idle_timeout_s,
            options=options | {"tasks": list(plan.tasks)},
        )
        body["policy"]["name"] += " é漢😀"
        has_keys = context.offers("submit_once")
        key = {"Idempotency-Key": uuid.uuid4().hex} if has_keys else {}
        self._submission = {"json": body, "headers": key}
        spelled = self._submission
        if plan.form:
            spelled = _spelled(self._submission, plan.form)
        submit = partial(context.call, "submit_run", **spelled)
        at_once = clients + 1 if has_keys else 1
        answers = context.call_concurrently(*[submit] * at_once)
        bodies = {a.json["run_id"]: a.json for a in answers if a.status == 201}
        if not bodies:
            _expect_accepted("submit_run", spelled, answers[0])
            expect.require(answers[0], 201, "submit_run")
        runs = [context.adopt(body) for body in bodies.values()]
        self.expect_no_difference("submits at once")
        runs[0].until("ready")
        return runs[0]

    def _submit_again(self, _command: ClientCommand) -> None:
        self.context.call("submit_run", **self._submission)

    def _read_list(self, _command: ClientCommand) -> None:
        self.context.call("list_runs", params={"limit": 3})

    def execute(self, command: ClientCommand) -> None:
        """Execute a command, and expect nothing that the oracle does not allow."""
        if command.kind == RESTART:
            self.execute(replace(command, kind="abort"))
            self.execute(replace(command, kind="resume"))
            return
        if command.kind in self._acts:
            self._acts[command.kind](self, command)
            self.expect_no_difference(command.kind)
            return
        self.send(self.clients[command.client], command)
        self.expect_no_difference(command.kind)
        if command.kind == "resume" and self.run.get()["state"] == "queued":
            self.run.until("ready")

    def send(self, client: GeneratedClient, command: ClientCommand) -> None:
        """Send the request of a command, if there is one."""
        request = client.request(command)
        if request is not None:
            operation, how = request
            if MSGPACK in command.spelling:
                how = how | {"msgpack": True}
            elif command.form:
                how = _spelled(how, command.form)
            if command.leave_after_s is not None:
                with contextlib.suppress(LeftUnanswered):
                    self.run.call(operation, leave_after_s=command.leave_after_s, **how)
            answer = self.run.call(operation, **how)
            if command.kind not in _REFUSED:
                _expect_accepted(operation, how, answer)
            elif answer.status < 400:
                observed = expect.describe_answer(answer)
                raise Violation("a refusal", observed, answer.exchange)
            client.learn(command, request, answer)

    def expect_no_difference(self, what: str) -> None:
        """Expect no difference that the oracle has found since the run was made."""
        tally = self.context.tally
        if tally.differences > self._differences and tally.latest is not None:
            breach, rules = tally.latest, ", ".join(tally.latest.rules)
            text = f"{breach.expected} ({rules}), after {what}"
            raise Violation(text, breach.observed)

    def read_all(self) -> None:
        """Read the run, its episodes and its score."""
        self.run.get()
        if self.context.offers("lists"):
            self.run.episodes()
        self.run.score()
        self.expect_no_difference("reading the run")

    def copy_first_client(self, count: int) -> list[GeneratedClient]:
        """Give each thread its own copy of the first client."""
        return [
            replace(copy.deepcopy(self.clients[0]), number=number)
            for number in range(1, count + 1)
        ]


Act = Callable[[GeneratedRun, ClientCommand], None]
