"""Everything known of one run: views, episodes, sessions, and requests in flight."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any

from conformance.oracle.history.expectations.expected_turn import PlayedActions
from conformance.oracle.history.facts.seen_exchange import LOST, SeenExchange
from conformance.oracle.history.facts.seen_session import LEASE_TOLERANCE_S, SeenSession
from conformance.oracle.history.facts.shown_episodes import ShownEpisodes
from conformance.oracle.history.facts.views_of_run import ShownRuns


@dataclass
class Attempts:
    """The actions that attempts executed since step 0, as far as turns showed them.

    An attempt is (index of its episode, its number). It is tainted when a request may
    have executed actions of it that no turn showed.
    """

    tainted: set[tuple[int, int]] = field(default_factory=set)
    _played: dict[tuple[int, int], list[PlayedActions]] = field(default_factory=dict)

    @staticmethod
    def of(episode: Mapping[str, Any]) -> tuple[int, int]:
        """Give the attempt that a turn shows."""
        return int(episode["index"]), int(episode["attempt"])

    def taint(self, episode: Mapping[str, Any] | None) -> None:
        """Note that unknown actions may have been executed; of all with None."""
        if episode is not None:
            self.tainted.add(self.of(episode))
        else:
            self.tainted |= self._played.keys()

    def at(self, episode: Mapping[str, Any]) -> PlayedActions | None:
        """Give the actions of an attempt up to the step that a turn shows."""
        attempt = self.of(episode)
        if attempt in self.tainted:
            return None
        if episode["step"] == 0:
            self._played.pop(attempt, None)
            return PlayedActions()
        played = reversed(self._played.get(attempt, []))
        return next((p for p in played if p.steps == episode["step"]), None)

    def add(self, episode: Mapping[str, Any], played: PlayedActions) -> None:
        """Note the actions of an attempt that goes on."""
        attempt = self.of(episode)
        self._played[attempt] = [*self._played.get(attempt, [])[-3:], played]


@dataclass
class RunKnowledge:
    """One run. `limits` are those that the server announces.

    submission: the body of its `submit_run`; None where the oracle has not seen it.
    open: the requests about it that have not ended, by their number.
    """

    run_id: str
    account: str | None
    views: ShownRuns
    episodes: ShownEpisodes
    limits: Mapping[str, Any]
    submission: Mapping[str, Any] | None = None
    sessions: dict[str, SeenSession] = field(default_factory=dict)
    attempts: Attempts = field(default_factory=Attempts)
    open: dict[int, SeenExchange] = field(default_factory=dict)
    attaches: list[SeenExchange] = field(default_factory=list)
    stops: list[SeenExchange] = field(default_factory=list)
    exercised: Counter[str] = field(default_factory=Counter)  # rules that were judged

    @property
    def is_partial(self) -> bool:
        """Whether requests may have reached the run that the oracle has not seen."""
        return self.submission is None or self.views.is_played_by_others

    @property
    def is_played_by_server(self) -> bool:
        """Whether it may have the mode `push`, in which no client attaches."""
        return str(self.views.latest().get("mode", "pull")) != "pull"

    @property
    def is_calibration(self) -> bool:
        """Whether its episodes are those of calibration.md."""
        return self.episodes.is_calibration

    @property
    def options(self) -> Mapping[str, Any]:
        """The options of calibration with which it was submitted."""
        return (self.submission or {}).get("options") or {}

    @property
    def tasks(self) -> list[str]:
        """The tasks of its episodes; empty where they are not known."""
        submission = self.submission
        if submission is None or not self.is_calibration or "select" in submission:
            return []
        return list(self.options.get("tasks") or ["score"])

    @property
    def success_rule(self) -> str | None:
        """The success rule; None where it is not known."""
        if self.submission is None or not self.is_calibration:
            return None
        return str(self.options.get("success_rule", "any_step"))

    @property
    def idle_timeout_s(self) -> float | None:
        """The lease of its sessions; None before the run was shown."""
        length_s = self.views.latest().get("idle_timeout_s")
        return None if length_s is None else float(length_s)

    @property
    def episodes_total(self) -> int | None:
        """How many episodes it has; None before the run was shown."""
        total = self.views.latest().get("progress", {}).get("episodes_total")
        return None if total is None else int(total)

    @property
    def may_fail(self) -> bool:
        """Whether faults may fail the run, which ends all sessions."""
        return not self.is_calibration or "fault" in self.options.get("tasks", [])

    def attaches_of(self, worker: str) -> Iterator[SeenExchange]:
        """Give the attaches of a worker that may have had an effect, and the open."""
        for attach in [*self.attaches, *self.open.values()]:
            is_attach = attach.operation == "attach_worker"
            if is_attach and attach.params.get("worker_id") == worker:
                yield attach

    @property
    def aborts(self) -> list[SeenExchange]:
        """The stops that may have ended sessions."""
        return [stop for stop in self.stops if stop.request.get("mode") != "drain"]

    @staticmethod
    def perhaps_after(
        opened: SeenExchange, ends: Iterable[SeenExchange], rule: str
    ) -> list[tuple[SeenExchange, str]]:
        """Give what may have ended a session that an attach opened meanwhile."""
        return [(end, rule) for end in ends if not end.is_surely_before(opened)]

    def first_sent_at(
        self, session: SeenSession, seq: int, seen: SeenExchange
    ) -> float:
        """Give when a seq was sent first: later requests get the same turn.

        For seq 0, when the attach was sent first that opened the session.
        """
        if seq:
            sent = [t.started_at for t in session.traces if t.seq == seq]
            open_ = [
                beside.started_at
                for beside in self.open.values()
                if beside.request.get("session_id") == session.id
                and beside.request.get("seq") == seq
            ]
            return min((seen.started_at, *sent, *open_))
        attaches = self.attaches_of(session.worker)
        same = [
            a.started_at
            for a in attaches
            if a.request.get("attach_key") == (session.key)
        ]
        return min((seen.started_at, *same))

    def is_settled(self, session: SeenSession, seen: SeenExchange) -> bool:
        """Whether the state of a session was surely that of its latest turn."""
        is_lost = session.highest_seq_sent(seen.ended_at) > session.last_seq
        is_asked = session.is_asked_beside(seen, self.open.values())
        return not (is_lost or is_asked or session.is_unknown)

    def ends_for_room(self, session: SeenSession) -> bool:
        """Whether a session may end without counting its attempt, to make room."""
        unused_s = float(self.limits.get("unused_s_max", LOST))
        if session.ends:
            first = min(end.ended_at for end, _ in session.ends)
            return first > session.last_new_turn_at() + unused_s
        return unused_s != LOST

    def reason_of_end(self, session: SeenSession, seen: SeenExchange) -> str | None:
        """Name the rule by which a session had surely ended before a request."""
        for end, rule in session.ends:
            is_older = session.opened.is_surely_before(end)
            if end.is_success and is_older and end.is_surely_before(seen):
                return {"STOP-002": "STOP-001"}.get(rule, rule)
        length_s = self.idle_timeout_s
        is_extended = any(
            attach.status is None for attach in self.attaches_of(session.worker)
        )
        if length_s is None or is_extended or self.is_asked_by(session.worker):
            return None
        end_at = session.latest_end(length_s, seen.started_at)
        is_over = seen.started_at > end_at + 2 * LEASE_TOLERANCE_S
        return "LEASE-011" if is_over else None

    def is_asked_by(self, worker: str) -> bool:
        """Whether a request of a worker is still carried out."""
        return any(
            beside.params.get("worker_id") == worker for beside in self.open.values()
        )

    def open_ends_of(self, session: SeenSession) -> list[SeenExchange]:
        """Give the requests in flight that end a session, or may have ended it."""
        return [
            beside
            for beside in self.open.values()
            if beside.operation == "stop_run"
            or beside.params.get("session_id") == session.id
            or beside.params.get("worker_id") == session.worker
        ]

    def surely_lives(self, session: SeenSession, seen: SeenExchange) -> bool:
        """Whether a session was live until an answer came, whatever the order."""
        length_s = self.idle_timeout_s
        if session.is_unknown or length_s is None or self.is_partial or self.may_fail:
            return False
        # A takeover ends the session itself, but only once it has its effect.
        ends = [e for e, rule in session.ends if e is not seen or rule != "ATT-005"]
        ends += self.open_ends_of(session)
        if any(end.may_be_before(seen) for end in ends):
            return False
        bounds = [self.limits.get(n, LOST) for n in ("unused_s_max", "heartbeat_s_max")]
        return seen.ended_at < session.least_end(
            length_s
        ) and seen.ended_at < session.last_new_turn_at() + min(bounds)
