"""One session: its turns in order, its repeats, and until when it surely lives."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any

from conformance.oracle.history.expectations.expected_turn import PlayedActions
from conformance.oracle.history.facts.seen_exchange import (
    LOST,
    UNKNOWN,
    Difference,
    SeenExchange,
    is_same,
    name_of_difference,
)

# A lease may be judged only that much after its end: timers are not exact.
LEASE_TOLERANCE_S = 1.0
_TURNS_KEPT = 3


@dataclass(frozen=True, slots=True)
class SentRequest:
    """A request of a session that ended, without its bodies."""

    operation: str
    seq: int
    started_at: float
    ended_at: float
    is_success: bool


@dataclass(frozen=True, slots=True)
class SeenTurn:
    """A turn with the request that it answered, as it was answered first.

    played: the attempt that goes on after it; None where it is not known.
    """

    request: Mapping[str, Any]
    observation: SeenExchange
    played: PlayedActions | None = None

    @property
    def value(self) -> Any:
        """The turn."""
        return self.observation.value


@dataclass
class SeenSession:
    """One session, as its exchanges showed it."""

    id: str
    worker: str
    key: str
    opened: SeenExchange
    turns: dict[int, SeenTurn] = field(default_factory=dict)
    traces: list[SentRequest] = field(default_factory=list)
    is_unknown: bool = False  # requests were sent that the oracle cannot read
    # When something surely, or perhaps, ended it: the answers, and the rule.
    ends: list[tuple[SeenExchange, str]] = field(default_factory=list)

    @property
    def last_seq(self) -> int:
        """The highest seq that was answered with a turn."""
        return max(self.turns, default=0)

    @property
    def last(self) -> SeenTurn:
        """The latest turn that was answered."""
        return self.turns[self.last_seq]

    @property
    def held_index(self) -> int | None:
        """The episode that its latest turn shows; None where there is none."""
        episode = self.last.value.get("episode")
        return None if episode is None else int(episode["index"])

    @property
    def is_done(self) -> bool:
        """Whether the latest turn is `done`."""
        return bool(self.last.value["done"])

    def add(self, seq: int, turn: SeenTurn) -> None:
        """Store a turn; old ones are dropped, for only the last is repeated."""
        self.turns[seq] = turn
        while len(self.turns) > _TURNS_KEPT:
            del self.turns[min(self.turns)]

    def note(self, seen: SeenExchange, seq: int) -> None:
        """Note a request of the session."""
        ended_at = LOST if seen.status is None else seen.ended_at
        is_success = seen.is_success
        self.traces.append(
            SentRequest(seen.operation, seq, seen.started_at, ended_at, is_success)
        )

    def is_asked_beside(
        self, seen: SeenExchange, opened: Iterable[SeenExchange]
    ) -> bool:
        """Whether another request of the session may have its effect meanwhile."""
        return any(
            trace.ended_at > seen.started_at and trace.started_at < seen.ended_at
            for trace in self.traces
        ) or any(
            beside.request.get("session_id") == self.id
            or beside.params.get("worker_id") == self.worker
            for beside in opened
        )

    def highest_seq_sent(self, before: float) -> int:
        """Give the highest seq that was sent by then, whatever became of it."""
        sent = (t.seq for t in self.traces if t.started_at < before)
        return max((self.last_seq, *sent))

    def least_end(self, idle_timeout_s: float) -> float:
        """Give the earliest time at which the lease may end.

        A detach does not extend it, and is answered alike when it is over (DET-002).
        """
        good = [
            trace.started_at
            for trace in self.traces
            if trace.is_success and trace.operation != "detach_worker"
        ]
        return max((self.opened.started_at, *good)) + idle_timeout_s

    def latest_end(self, idle_timeout_s: float, now: float) -> float:
        """Give the latest time at which the lease has ended; LOST if it is open."""
        good = [
            trace.ended_at
            for trace in self.traces
            if trace.is_success or trace.ended_at >= now
        ]
        return max((self.opened.ended_at, *good)) + idle_timeout_s

    def last_new_turn_at(self) -> float:
        """Give the earliest time at which its latest turn was answered."""
        return self.last.observation.started_at

    def judge_repeat(self, seq: int, seen: SeenExchange) -> Iterator[Difference]:
        """Judge an answer to a seq that was answered before."""
        stored = self.turns[seq]
        if seen.body is UNKNOWN or stored.observation.body is UNKNOWN:
            return
        witness = stored.observation
        if not is_same(comparable(seen.request), comparable(stored.request)):
            text = f"`seq_conflict` for another body of seq {seq}"
            yield Difference(("PRED-003",), text, "status 200", seen, witness)
        elif seen.media_type == witness.media_type and not is_same(
            seen.value, stored.value
        ):
            name = name_of_difference(stored.value, seen.value)
            rules: tuple[str, ...] = ("PRED-002", "PRED-025")
            rules = ("PRED-010", *rules) if stored.value["done"] else rules
            rules = ("FAULT-011", *rules) if "fault" in stored.value else rules
            text = f"the stored turn {seq}, with `{name}` {stored.value.get(name)!r}"
            observed = f"`{name}` {seen.value.get(name)!r}"
            yield Difference(rules, text, observed, seen, witness)


def comparable(request: Mapping[str, Any]) -> dict[str, Any]:
    """Give a body of `predict` without what a server may fill in."""
    return {
        name: value
        for name, value in request.items()
        if not (name == "observe" and value == "last")
    }
