"""The state of a run after a sequence of requests: the specification as a model. Pure.

`allowed_answers` gives the answers to a request that the rules allow, each with the run
afterwards. Where two rules cover one request, or none does, several answers are
allowed; the model follows the observed one, so it is a set of runs that the server may
be in. Every allowed answer cites its rules. Sessions have the ids, and turns the texts,
that the server gave them.
"""

import json
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, Literal

Status = Literal["live", "superseded", "ended"]


@dataclass(frozen=True, slots=True)
class Rules:
    """The constants of a run; `table` holds (state, event) → (id, state).

    `scores_success`: an episode has the score 1 for a success and else 0, not the last
    commanded one.
    """

    table: Mapping[tuple[str, str], tuple[str, str]]
    max_workers: int
    max_steps: int
    max_attempts: int
    scores_success: bool = False

    @classmethod
    def of(cls, lifecycle: Mapping[str, Any], **limits: Any) -> "Rules":
        """Take the table from `x-lifecycle`."""
        table = {
            (row["from"], row["event"]): (row["id"], row["to"])
            for row in lifecycle["transitions"]
            if row.get("when") != "not_retryable"
        }
        return cls(table, **limits)


@dataclass(frozen=True, slots=True)
class Step:
    """The members of an action that the model uses."""

    score: float = 0.0
    success: int = 0
    end: int = 0
    delay_s: float = 0.0


@dataclass(frozen=True, slots=True)
class Attach:
    """`attach_worker`."""

    worker: str
    key: str
    takeover: bool = False


@dataclass(frozen=True, slots=True)
class Predict:
    """`predict`."""

    worker: str
    session: str
    seq: int
    steps: tuple[Step, ...]


@dataclass(frozen=True, slots=True)
class Heartbeat:
    """`heartbeat`."""

    worker: str
    session: str


@dataclass(frozen=True, slots=True)
class Detach:
    """`detach_worker`."""

    worker: str
    session: str


@dataclass(frozen=True, slots=True)
class Stop:
    """`stop_run`; the run in its answer is judged as a Read."""

    mode: str


@dataclass(frozen=True, slots=True)
class Resume:
    """`resume_run`; the run in its answer is judged as a Read."""


@dataclass(frozen=True, slots=True)
class Read:
    """A run in a response of `get_run`, `stop_run` or `resume_run`."""


@dataclass(frozen=True, slots=True)
class ReadEpisodes:
    """All pages of `list_episodes`, joined."""


Request = Attach | Predict | Heartbeat | Detach | Stop | Resume | Read | ReadEpisodes


@dataclass(frozen=True, slots=True)
class AnswerSummary:
    """An answer: status, problem code, body."""

    status: int
    code: str | None
    body: Any


@dataclass(frozen=True, slots=True)
class EpisodeModel:
    """One episode; `outcome` is None until it is scored."""

    attempt: int = 1
    is_held: bool = False
    outcome: str | None = None
    score: float = 0.0

    @property
    def is_pending(self) -> bool:
        """Whether it can be handed out."""
        return not self.is_held and self.outcome is None


@dataclass(frozen=True, slots=True)
class SessionModel:
    """One session; `steps` and `success` are those of the attempt in play.

    is_interrupted: its latest request got `session_ended`, see linearizability.py.
    """

    id: str
    worker: str
    key: str
    episode: int | None
    is_done: bool
    steps: int = 0
    success: int = 0
    seq: int = 0
    request: tuple[Step, ...] = ()
    turn: str = ""
    status: Status = "live"
    is_interrupted: bool = False


@dataclass(frozen=True, slots=True)
class RunModel:
    """A run that the server may be in."""

    state: str
    episodes: tuple[EpisodeModel, ...]
    sessions: tuple[SessionModel, ...] = ()

    def session(self, session_id: str) -> SessionModel:
        """Find a session by its id."""
        return next(session for session in self.sessions if session.id == session_id)

    def live(self, worker: str | None = None) -> SessionModel | None:
        """Give the live session of a worker."""
        of_worker = (s for s in self.sessions if s.worker == worker)
        return next((s for s in of_worker if s.status == "live"), None)

    @property
    def holders(self) -> list[SessionModel]:
        """Live sessions that hold a slot."""
        return [s for s in self.sessions if s.status == "live" and not s.is_done]

    @property
    def all_scored(self) -> bool:
        """Whether nothing is left to score."""
        return all(episode.outcome is not None for episode in self.episodes)

    def with_session(self, session: SessionModel) -> "RunModel":
        """Replace a session, or add it."""
        is_known = any(s.id == session.id for s in self.sessions)
        if not is_known:
            return replace(self, sessions=(*self.sessions, session))
        sessions = tuple(session if s.id == session.id else s for s in self.sessions)
        return replace(self, sessions=sessions)

    def with_episode(self, index: int, **changes: Any) -> "RunModel":
        """Change an episode."""
        episodes = list(self.episodes)
        episodes[index] = replace(episodes[index], **changes)
        return replace(self, episodes=tuple(episodes))


After = Callable[[AnswerSummary], RunModel]
ABSENT = object()


@dataclass(frozen=True, slots=True)
class AllowedAnswer:
    """An answer that rules allow: status, code, members (path → value), next run.

    `same_turn`: the whole answer except its times, as `turn_text` writes it.
    """

    rules: str
    status: int
    after: After
    code: str | None = None
    members: Mapping[str, Any] = field(default_factory=dict)
    same_turn: str | None = None
    new_among: Sequence[str] | None = None

    def mismatch(self, summary: AnswerSummary) -> str | None:
        """Give the expected text if the answer differs; None if it matches."""
        kind = f" with code `{self.code}`" if self.code else ""
        if summary.status != self.status or (self.code and summary.code != self.code):
            return f"status {self.status}{kind} ({self.rules})"
        if self.same_turn is not None and turn_text(summary.body) != self.same_turn:
            return f"the same turn again ({self.rules})"
        if self.new_among is not None and _at(summary.body, "session_id") in (
            *self.new_among,
            ABSENT,
        ):
            return f"another session_id ({self.rules})"
        wrong = [
            f"{path} {_format_expected(value)}"
            for path, value in self.members.items()
            if not _matches(_at(summary.body, path), value)
        ]
        return f"{', '.join(wrong)} ({self.rules})" if wrong else None


def turn_text(body: Any) -> str:
    """Write a turn without its times, which may differ in a repeated answer."""
    if not isinstance(body, dict):
        return ""
    kept = {k: v for k, v in body.items() if k not in ("lease", "timing")}
    return json.dumps(kept, sort_keys=True)


def _at(body: Any, path: str) -> Any:
    for name in path.split("."):
        if isinstance(body, list) and name.isdigit() and int(name) < len(body):
            body = body[int(name)]
        elif isinstance(body, dict) and name in body:
            body = body[name]
        else:
            return ABSENT
    return body


def _format_expected(value: Any) -> str:
    if value is ABSENT:
        return "absent"
    if isinstance(value, range):
        return " or ".join(map(str, value))
    return json.dumps(value)


def _matches(observed: Any, expected: Any) -> bool:
    if isinstance(expected, range):
        return observed in expected
    if isinstance(expected, bool) or observed is ABSENT or expected is ABSENT:
        return observed is expected
    return bool(observed == expected)


# --- automatic events ---


def closure(rules: Rules, model: RunModel) -> Iterator[RunModel]:
    """Give the run, and the runs it may have become without a request."""
    yield model
    if model.state == "queued":
        yield replace(model, state=rules.table["queued", "capacity"][1])
    # The specification does not say whether a session that is done has ended.
    if model.state in ("running", "stopping") and not model.holders:
        yield _event(rules, model, "last_lease_ends")


def _event(rules: Rules, model: RunModel, event: str) -> RunModel:
    row = rules.table.get((model.state, event))
    return model if row is None else replace(model, state=row[1])


def apply_automatic_events(rules: Rules, model: RunModel) -> RunModel:
    """LIFE-802, LIFE-803, LIFE-804, LIFE-805: what must follow at once."""
    if model.all_scored:
        return _event(rules, model, "all_scored")
    if not any(s.status == "live" for s in model.sessions):
        return _event(rules, model, "last_lease_ends")
    return model


def close_session(rules: Rules, model: RunModel, session: SessionModel) -> RunModel:
    """End a session; its attempt is closed unscored (EPI-002, EPI-003, EPI-004)."""
    index = session.episode
    model = model.with_session(replace(session, status="ended", episode=None))
    if index is None:
        return model
    attempt = model.episodes[index].attempt
    if session.steps == 0:
        return model.with_episode(index, is_held=False)
    if attempt < rules.max_attempts:
        return model.with_episode(index, is_held=False, attempt=attempt + 1)
    return model.with_episode(index, is_held=False, outcome="abandoned", score=0.0)


def hand_out(model: RunModel, session: SessionModel) -> RunModel:
    """EPI-001: give a session the first pending episode; done when there is none."""
    pending = (i for i, episode in enumerate(model.episodes) if episode.is_pending)
    index = None if model.state == "stopping" else next(pending, None)
    session = replace(session, episode=index, is_done=index is None, steps=0, success=0)
    model = model.with_session(session)
    return model if index is None else model.with_episode(index, is_held=True)
