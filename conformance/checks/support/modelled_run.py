"""Generated requests of several clients to one run, judged by the model.

A command becomes a request when the client has the ids for it: before its first predict
it attaches. A client knows only the content of its own responses.
"""

import copy
import time
from dataclasses import asdict, dataclass, field, replace
from typing import Any

from hypothesis import strategies as st

from conformance.client.check_context import CheckContext
from conformance.client.run_client import RunClient
from conformance.exchanges.answer import Answer
from conformance.oracle.allowed_answers import Deviation, PossibleRuns, advance
from conformance.oracle.expected_score import expected_score, is_close
from conformance.oracle.linearizability import TimedExchange, split_command
from conformance.oracle.run_model import (
    AnswerSummary,
    Attach,
    Detach,
    EpisodeModel,
    Heartbeat,
    Predict,
    Read,
    ReadEpisodes,
    Request,
    Resume,
    Rules,
    RunModel,
    Step,
    Stop,
)
from conformance.verdicts import expect
from conformance.verdicts.expect import Violation, describe_answer

EPISODES, MAX_STEPS, MAX_ATTEMPTS, MAX_WORKERS = 3, 6, 2, 2
# Sums of these are exact, in whatever order a server adds them.
STEPS = [
    Step(0.25),
    Step(0.125),
    Step(0.375),
    Step(0.5, success=1),
    Step(1.0, success=1, end=1),
    Step(0.75, end=1),
]
# In the middle of these another request arrives; the task `delay` executes them.
SLOW_STEPS = [Step(0.25, delay_s=0.04), Step(1.0, success=1, end=1, delay_s=0.04)]
ATTACH, ATTACH_AGAIN, TAKEOVER = "attach", "attach again", "take over"
NEXT_SEQ, REPEAT, REPEAT_CHANGED, SKIPPED_SEQ, OLD_SEQ = (
    "next",
    "repeat",
    "repeat otherwise",
    "skip",
    "old",
)
RESTART = "abort and resume"
RUN_COMMANDS = ("abort", "drain", "resume", RESTART)
SEQ_OFFSETS = {NEXT_SEQ: 1, REPEAT: 0, REPEAT_CHANGED: 0, SKIPPED_SEQ: 2, OLD_SEQ: -1}


@dataclass(frozen=True)
class ClientCommand:
    """A command of client number `client` for a worker, or for the run."""

    client: int
    kind: str
    worker: str = ""
    steps: tuple[Step, ...] = ()

    def __repr__(self) -> str:
        """Write it as the report shows it."""
        whose = f" {self.worker}" if self.worker else ""
        steps = "".join(
            f" {s.score:g}{'+' * s.success}{'.' * s.end}{'~' * (s.delay_s > 0)}"
            for s in self.steps
        )
        return f"<client {self.client}: {self.kind}{whose}{steps}>"


def commands(
    clients: int, workers: str, kinds: list[str], steps: list[Step] = STEPS
) -> st.SearchStrategy[ClientCommand]:
    """Draw a command; kinds that stand twice are drawn twice as often."""
    chunk = st.lists(st.sampled_from(steps), min_size=1, max_size=3).map(tuple)
    return st.builds(
        lambda client, kind, worker, steps: ClientCommand(
            client,
            kind,
            "" if kind in RUN_COMMANDS else worker,
            steps if kind in (NEXT_SEQ, REPEAT_CHANGED, SKIPPED_SEQ, OLD_SEQ) else (),
        ),
        st.integers(0, clients - 1),
        st.sampled_from(kinds),
        st.sampled_from(workers),
        chunk,
    )


@dataclass
class SessionHandle:
    """The client's knowledge of its session of one worker."""

    session: str
    key: str
    seq: int = 0
    steps: tuple[Step, ...] = ()


def _of_session(command: ClientCommand, handle: SessionHandle) -> Request | None:
    """Give the request of a client that has a session."""
    match command.kind:
        case "attach again":
            return Attach(command.worker, handle.key)
        case "heartbeat":
            return Heartbeat(command.worker, handle.session)
        case "detach":
            return Detach(command.worker, handle.session)
    seq = handle.seq + SEQ_OFFSETS[command.kind]
    steps = handle.steps if command.kind == REPEAT else command.steps
    if seq < 1 or not steps:
        return None
    return Predict(command.worker, handle.session, seq, steps)


@dataclass
class ModelClient:
    """One client with its sessions; `keys` counts the attach keys it made up."""

    number: int
    handles: dict[str, SessionHandle] = field(default_factory=dict)
    keys: int = 0

    def request(self, command: ClientCommand) -> Request | None:
        """Give the request that carries a command out now, if there is one."""
        handle = self.handles.get(command.worker)
        kind = command.kind
        if handle is None and command.worker and kind != TAKEOVER:
            kind = ATTACH
        match kind:
            case "abort" | "drain":
                return Stop(kind)
            case "resume":
                return Resume()
            case "attach" | "take over":
                self.keys += 1
                key = f"client-{self.number}-key-{self.keys}"
                return Attach(command.worker, key, kind == TAKEOVER)
        return None if handle is None else _of_session(command, handle)

    def learn(self, request: Request, answer: Answer) -> None:
        """Store the session and the seq of an answer."""
        if answer.status != 200 or not isinstance(answer.json, dict):
            return
        if isinstance(request, Attach):
            session = str(answer.json.get("session_id"))
            handle = self.handles.get(request.worker)
            if handle is None or handle.session != session:
                self.handles[request.worker] = SessionHandle(session, request.key)
        elif isinstance(request, Predict):
            handle = self.handles[request.worker]
            handle.seq, handle.steps = request.seq, request.steps


class ModelledRun:
    """A new run, its clients, and the states that the model allows so far."""

    def __init__(
        self, context: CheckContext, clients: int, task: str = "score"
    ) -> None:
        workers = context.worker_count(MAX_WORKERS)
        context.coverage.histories += 1
        self.context = context
        self.run = context.submit(
            *[task] * EPISODES,
            max_steps=MAX_STEPS,
            max_attempts=MAX_ATTEMPTS,
            max_workers=workers,
        )
        self.rules = Rules.of(
            context.spec.lifecycle,
            max_workers=workers,
            max_steps=MAX_STEPS,
            max_attempts=MAX_ATTEMPTS,
            scores_success=task != "score",
        )
        self.models: PossibleRuns = frozenset(
            {RunModel("ready", (EpisodeModel(),) * EPISODES)}
        )
        self.clients = [ModelClient(number) for number in range(clients)]

    def send(self, request: Request) -> tuple[Answer, AnswerSummary]:
        """Send a request."""
        answer = send(self.run, request)
        return answer, AnswerSummary(answer.status, answer.code, answer.json)

    def execute(self, command: ClientCommand) -> None:
        """Execute a command and judge the answer."""
        if command.kind == RESTART:
            self.execute(replace(command, kind="abort"))
            self.execute(replace(command, kind="resume"))
            return
        client = self.clients[command.client]
        request = client.request(command)
        if request is None:
            return
        answer, summary = self.send(request)
        self.expect_allowed(request, summary, f"{command}", answer)
        client.learn(request, answer)
        if isinstance(request, Resume) and any(
            m.state == "queued" for m in self.models
        ):
            self.run.until("ready")

    def expect_allowed(
        self,
        request: Request,
        summary: AnswerSummary,
        what: str,
        answer: Answer | None = None,
    ) -> None:
        """Expect an answer that the rules allow."""
        for part in split_command(request, summary):
            try:
                self.models = advance(self.rules, self.models, part, summary)
            except Deviation as deviation:
                observed = (
                    describe_answer(answer)
                    if answer
                    else expect.format_value(summary.body)
                )
                raise Violation(
                    f"{deviation.expected}, as the answer to {what}",
                    observed,
                    answer.exchange if answer else None,
                ) from None

    def expect_state_of_model(self) -> None:
        """Expect the run, its episodes and its score to match the model."""
        for request in (Read(), ReadEpisodes()):
            self.expect_allowed(request, self.read(request), type(request).__name__)
        self.expect_score_of_model()

    def read(self, request: Request) -> AnswerSummary:
        """Read the run or its episodes."""
        if isinstance(request, Read):
            return AnswerSummary(200, None, self.run.get())
        return AnswerSummary(200, None, self.run.episodes())

    def expect_score_of_model(self) -> None:
        """Expect the score of the episodes that the model has (SCORE-…)."""
        score = self.run.score()
        wrong: list[str] = []
        for model in self.models:
            shape = [
                {"task": "", "split": "", "outcome": e.outcome, "score": e.score}
                for e in model.episodes
            ]
            due = expected_score(shape)
            names = ("score", "score_low", "score_high")
            wrong = [n for n in names if not is_close(score[n], due[n])]
            if not wrong and score["complete"] == due["complete"]:
                return
        raise Violation(
            f"the score of its episodes in {wrong}", expect.format_value(score)
        )

    def send_timed(
        self, client: ModelClient, command: ClientCommand
    ) -> TimedExchange | None:
        """Execute a command beside others; they are judged together later."""
        request = client.request(command)
        if request is None:
            return None
        answer, summary = self.send(request)
        client.learn(request, answer)
        return TimedExchange(request, summary, answer.started_at, answer.ended_at)

    def read_timed(self, request: Request) -> TimedExchange:
        """Read the run or its episodes after all other requests."""
        started_at = time.monotonic()
        summary = self.read(request)
        return TimedExchange(request, summary, started_at, time.monotonic())

    def copy_first_client(self, count: int) -> list[ModelClient]:
        """Give each thread its own copy of the first client."""
        return [
            replace(copy.deepcopy(self.clients[0]), number=number)
            for number in range(1, count + 1)
        ]


def send(run: RunClient, request: Request) -> Answer:
    """Send a request of the model."""
    operation, how = _http_request(request)
    if isinstance(request, Attach | Predict | Heartbeat | Detach):
        how["worker_id"] = request.worker
    return run.call(operation, **how)


def _http_request(request: Request) -> tuple[str, dict[str, Any]]:
    match request:
        case Attach():
            takeover = {"takeover": True} if request.takeover else {}
            return "attach_worker", {"json": {"attach_key": request.key, **takeover}}
        case Predict():
            actions = [CheckContext.action(**asdict(step)) for step in request.steps]
            body = {"seq": request.seq, "actions": actions}
            return "predict", {"json": {"session_id": request.session, **body}}
        case Heartbeat():
            return "heartbeat", {"json": {"session_id": request.session}}
        case Detach():
            return "detach_worker", {"params": {"session_id": request.session}}
        case Stop(mode):
            return "stop_run", {"json": {"mode": mode}}
    return "resume_run", {}
