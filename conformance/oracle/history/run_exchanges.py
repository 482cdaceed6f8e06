"""Everything that the exchanges say of one run, and how each new one fits.

Joins the views of the run, its episodes, its score and its sessions. Where requests may
have had their effects in either order, each order is allowed.
"""

from __future__ import annotations

import contextlib
from collections.abc import Iterator
from typing import Any

from conformance.oracle.history.expectations.closed_attempts import judge_closed
from conformance.oracle.history.expectations.occupancy import judge_occupancy
from conformance.oracle.history.expectations.refusals import judge_refusal
from conformance.oracle.history.expectations.score_views import judge_score
from conformance.oracle.history.expectations.submitted import (
    judge_episode,
    judge_submitted,
)
from conformance.oracle.history.facts.run_knowledge import RunKnowledge
from conformance.oracle.history.facts.seen_exchange import Difference, SeenExchange
from conformance.oracle.history.facts.views_of_run import COMMANDS, ShownRuns
from conformance.oracle.history.session_requests import SessionRequests

_SHOW_RUN = ("get_run", "stop_run", "resume_run")
_OF_SESSION = ("predict", "heartbeat", "detach_worker")
_EPISODES_OF_PAGE = 100  # without `limit`


class RunExchanges:
    """One run and the requests about it."""

    def __init__(self, facts: RunKnowledge) -> None:
        self.facts = facts
        self._requests = SessionRequests(facts)
        self._next_index: dict[str, int] = {}  # the index with which a page begins

    def note_restart(self, began_at: float, ended_at: float) -> None:
        """Note that the server was killed; again when it has started again."""
        facts = self.facts
        restarts = facts.views.restarts
        restarts[:] = [r for r in restarts if r[0] != began_at]
        restarts.append((began_at, ended_at))
        facts.attempts.taint(None)
        for session in facts.sessions.values():
            session.is_unknown = True

    def judge(self, seen: SeenExchange) -> Iterator[Difference]:
        """Judge an exchange about the run, and store what it says."""
        operation = seen.operation
        if seen.code is not None:
            yield from judge_refusal(self.facts, seen)
            if seen.code == "illegal_transition" and "state" in seen.value:
                yield from self._state(seen.value["state"], seen)
        if operation in COMMANDS:
            if seen.is_success and self._is_decided_by_state(seen):
                with self._open_commands() as views:
                    yield from views.judge_accepted(seen)
            self.facts.views.note_command(seen)
        if operation == "stop_run" and seen.may_have_effect:
            self._note_stop(seen)
        if operation == "get_run":
            wait_s_max = float(self.facts.limits.get("wait_s_max", 0))
            yield from self.facts.views.judge_etag(seen, wait_s_max)
        if operation == "attach_worker":
            yield from self._requests.judge_attach(seen)
        if operation in _OF_SESSION:
            yield from self._requests.judge(seen)
        if seen.is_success:
            yield from self._judge_success(seen)

    @contextlib.contextmanager
    def _open_commands(self) -> Iterator[ShownRuns]:
        """Give the views while open commands count: they may have had their effect."""
        views = self.facts.views
        noted = len(views.commands)
        for beside in self.facts.open.values():
            if beside.operation in COMMANDS:
                views.note_command(beside)
        yield views
        del views.commands[noted:]

    def _state(self, state: str, seen: SeenExchange) -> Iterator[Difference]:
        """Judge a state that an answer shows without the run."""
        with self._open_commands() as views:
            yield from views.judge_state(state, seen)

    def judge_view(self, body: Any, seen: SeenExchange) -> Iterator[Difference]:
        """Judge the run as an answer shows it."""
        with self._open_commands() as views:
            yield from views.judge(body, seen)
        self.facts.exercised.update(("RUN-014", "RUN-021", "RUN-023"))
        yield from judge_submitted(self.facts, body, seen)
        if seen.operation != "stream_events":
            yield from judge_occupancy(self.facts, body, seen)
        if body["state"] == "stopped" and not self.facts.is_partial:
            for session in self.facts.sessions.values():
                if session.opened.is_surely_before(seen):
                    session.ends.append((seen, "STOP-002"))

    def _judge_success(self, seen: SeenExchange) -> Iterator[Difference]:
        if self.facts.aborts:
            self.facts.exercised.update(("STOP-001", "STOP-005", "RES-001"))
        if seen.operation in _SHOW_RUN:
            yield from self.judge_view(seen.value, seen)
        elif seen.operation == "list_episodes":
            yield from self._page(seen)
        elif seen.operation == "get_score":
            yield from judge_score(self.facts, seen)
            yield from self._state(seen.value["state"], seen)

    def _is_decided_by_state(self, seen: SeenExchange) -> bool:
        """Whether only the state of the run decides whether a command is accepted."""
        facts = self.facts
        if seen.operation != "attach_worker":
            return True
        is_again = seen.value["session_id"] in facts.sessions
        is_held = any(
            session.worker == seen.params.get("worker_id")
            and facts.reason_of_end(session, seen) is None
            for session in facts.sessions.values()
        )
        lost = any(not attach.is_success for attach in facts.attaches)
        return not (is_again or is_held or lost or facts.is_partial)

    def _note_stop(self, seen: SeenExchange) -> None:
        self.facts.stops.append(seen)
        if seen.request.get("mode") == "drain":
            return
        for session in self.facts.sessions.values():
            session.ends.append((seen, "STOP-002"))

    def _page(self, seen: SeenExchange) -> Iterator[Difference]:
        """Judge a page of the episodes."""
        items, cursor = seen.value["episodes"], seen.query.get("cursor")
        following, total = seen.value["next_cursor"], self.facts.episodes_total
        self.facts.exercised.update(("RUN-025", "EPI-006"))
        limit = int(seen.query.get("limit", _EPISODES_OF_PAGE))
        if len(items) > limit:
            text = f"at most {limit} episodes"
            yield Difference(("RUN-025",), text, f"{len(items)} episodes", seen)
        indices = [item["index"] for item in items]
        first = 0 if cursor is None else self._next_index.get(cursor)
        if first is None and indices:
            first = indices[0]
        if first is not None:
            after = first + len(items)
            if indices != [*range(first, after)]:
                text = f"the episodes from {first} to {after - 1} in order"
                yield Difference(("EPI-006",), text, f"{indices}", seen)
            elif following is not None:
                self._next_index[following] = after
            elif total is not None and after != total:
                text = f"all {total} episodes before `next_cursor` null"
                yield Difference(("EPI-006",), text, f"the first {after}", seen)
        for item in items:
            yield from judge_closed(self.facts, item, seen)
            yield from self.facts.episodes.judge_listed(item, seen)
            yield from judge_episode(self.facts, item, seen)
            self.facts.exercised["FAULT-009"] += item.get("faults", 0)
