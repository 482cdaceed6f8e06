"""All exchanges of a service, judged one by one as they end.

Splits the history into runs, and judges what joins them: accounts, lists, keys of
`submit_run`. Says for each exchange in what it contradicts the rules or an earlier one.
Safe for several threads.
"""

from __future__ import annotations

import threading
import time
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from conformance.oracle.history.expectations.comparisons import judge_comparison
from conformance.oracle.history.facts.run_knowledge import RunKnowledge
from conformance.oracle.history.facts.seen_exchange import (
    LOST,
    UNKNOWN,
    Difference,
    SeenExchange,
)
from conformance.oracle.history.facts.shown_episodes import ShownEpisodes
from conformance.oracle.history.facts.views_of_run import ShownRuns, instant_of
from conformance.oracle.history.run_exchanges import RunExchanges
from conformance.oracle.history.server_clock import ServerClock

# Tokens of one account have one name here; others are of unknown accounts.
_ACCOUNTS = {"TOKEN": "first", "TOKEN_READ": "first", "TOKEN_2": "second"}
# A value that no schema describes so; the rules on schemas judge it.
_UNREADABLE = (KeyError, IndexError, TypeError, ValueError, AttributeError)
_PAGE_ORDER_S = 1.0  # runs of one moment may be in either order


@dataclass
class _Walk:
    """The pages of `list_runs` that were read one after another."""

    begun: SeenExchange
    shown: set[str] = field(default_factory=set)


@dataclass
class ServiceHistory:
    """The history of one service, as the oracle knows it.

    transitions, rules: the lifecycle. limits: those that the service announces.
    has_sessions: whether it announces the profile `sessions`.
    """

    transitions: Mapping[tuple[str, str], tuple[str, ...]]
    rules: Mapping[tuple[str, str], str]
    limits: Mapping[str, Any] = field(default_factory=dict)
    has_sessions: bool = True
    errors: list[str] = field(default_factory=list)
    runs: dict[str, RunExchanges] = field(default_factory=dict)
    _clock: ServerClock = field(default_factory=ServerClock)
    _lock: threading.RLock = field(default_factory=threading.RLock)
    _open: dict[int, SeenExchange] = field(default_factory=dict)
    _unread_checks: set[str] = field(default_factory=set)
    _checks_of: dict[str, set[str]] = field(default_factory=dict)
    _deleted: dict[str, SeenExchange] = field(default_factory=dict)
    _submits: dict[tuple[str, str], tuple[SeenExchange, str]] = field(
        default_factory=dict
    )
    _made: dict[str, tuple[str, SeenExchange]] = field(default_factory=dict)
    _exercised: Counter[str] = field(default_factory=Counter)
    _kept: set[str] = field(default_factory=set)
    _walks: dict[tuple[str | None, str], _Walk] = field(default_factory=dict)

    # --- what happens ---

    def begin(self, number: int, sent: SeenExchange) -> None:
        """Note that a request is sent; `number` names it until it ends."""
        with self._lock:
            self._open[number] = sent
            run = self.runs.get(sent.params.get("run_id", ""))
            if run is not None:
                run.facts.open[number] = sent

    def sent(self, number: int) -> SeenExchange | None:
        """Give a request that was sent and has not ended."""
        with self._lock:
            return self._open.get(number)

    def end(self, number: int, seen: SeenExchange) -> list[Difference]:
        """Judge an exchange that has ended, or whose answer was lost."""
        with self._lock:
            self._open.pop(number, None)
            run = self.runs.get(seen.params.get("run_id", ""))
            if run is not None:
                run.facts.open.pop(number, None)
            return [*self._judge_safely(seen)]

    def judge_event(self, seen: SeenExchange) -> list[Difference]:
        """Judge the body of an event: a run, or an episode with its result."""
        with self._lock:
            run = self.runs.get(seen.params["run_id"])
            if run is None:
                return []
            try:
                if "progress" in seen.value:
                    return [*run.judge_view(seen.value, seen)]
                return [*run.facts.episodes.judge_listed(seen.value, seen)]
            except _UNREADABLE:
                return []  # EVT-001 judges what it is

    def take_exercised(self) -> Counter[str]:
        """Give how often rules were judged since this was asked last."""
        with self._lock:
            exercised = self._exercised.copy()
            self._exercised.clear()
            return exercised

    def keep(self, run_id: str) -> None:
        """Keep a run that several checks use."""
        with self._lock:
            self._kept.add(run_id)

    def begin_restart(self) -> float:
        """Note that the server is being killed, before it is; give the time."""
        with self._lock:
            began_at = time.monotonic()
            for run in self.runs.values():
                run.note_restart(began_at, LOST)
            return began_at

    def end_restart(self, began_at: float) -> None:
        """Note that the server has started again after it was killed."""
        with self._lock:
            for run in self.runs.values():
                run.note_restart(began_at, time.monotonic())

    def note_unread(self, check: str) -> None:
        """Note that a check sends requests which the oracle cannot read."""
        with self._lock:
            self._unread_checks.add(check)
            for run_id, checks in self._checks_of.items():
                if check in checks and run_id in self.runs:
                    _note_unread_play(self.runs[run_id].facts)

    def forget(self, check: str) -> None:
        """Drop what only one check needed, which has ended: its runs."""
        with self._lock:
            for run_id, checks in [*self._checks_of.items()]:
                if checks == {check} and run_id not in self._kept:
                    self.runs.pop(run_id, None)
                    del self._checks_of[run_id]

    # --- the judgement ---

    def _judge_safely(self, seen: SeenExchange) -> Iterator[Difference]:
        try:
            yield from self._judge(seen)
        except _UNREADABLE as error:
            self.errors.append(f"{seen.operation} of {seen.check}: {error!r}")

    def _judge(self, seen: SeenExchange) -> Iterator[Difference]:
        if seen.operation == "describe_service" and seen.is_success:
            self._clock.note(seen)
        if seen.operation == "submit_run":
            yield from self._submit(seen)
            return
        if seen.operation == "list_runs" and seen.is_success:
            yield from self._page(seen)
        if seen.operation == "compare_runs" and seen.is_success:
            known = {run_id: run.facts for run_id, run in self.runs.items()}
            yield from judge_comparison(known, seen)
        run = self._run_of(seen)
        if run is None:
            return
        account = _ACCOUNTS.get(seen.account or "")
        is_foreign = account is not None and run.facts.account not in (None, account)
        if is_foreign and seen.is_success and seen.operation in _PRIVATE:
            witness = self._made.get(run.facts.run_id)
            text = "`not_found` for a run of another account"
            yield Difference(
                ("AUTH-003",),
                text,
                f"status {seen.status}",
                seen,
                witness[1] if witness else None,
            )
            return
        if seen.operation == "delete_run" and seen.may_have_effect:
            self._deleted[run.facts.run_id] = seen
        yield from self._missing(run, seen)
        yield from run.judge(seen)
        if seen.is_success and seen.operation in ("attach_worker", "predict"):
            yield from self._times_of_turn(run, seen)
        if seen.is_success and seen.operation == "heartbeat":
            yield from self._times_of_heartbeat(run, seen)

    def _times_of_turn(
        self, run: RunExchanges, seen: SeenExchange
    ) -> Iterator[Difference]:
        """Judge the times of a turn, unless it is a repeat."""
        session, length_s = (
            run.facts.sessions.get(seen.value["session_id"]),
            run.facts.idle_timeout_s,
        )
        if session is None or length_s is None or session.is_unknown:
            return
        turn = session.turns.get(seen.value["seq"])
        # A turn that was sent before has the times of then.
        first_at = run.facts.first_sent_at(session, seen.value["seq"], seen)
        is_first = first_at == seen.started_at
        if turn is not None and turn.observation is seen and is_first:
            self._exercised["LEASE-009"] += 1
            yield from self._clock.judge_lease(seen, length_s, LOST)
            yield from self._clock.judge_finished(seen)

    def _times_of_heartbeat(
        self, run: RunExchanges, seen: SeenExchange
    ) -> Iterator[Difference]:
        session = run.facts.sessions.get(str(seen.request.get("session_id")))
        if session is None or run.facts.idle_timeout_s is None:
            return
        longest_s = self.limits.get("heartbeat_s_max", LOST)
        until = session.last_new_turn_at() + longest_s
        yield from self._clock.judge_lease(seen, run.facts.idle_timeout_s, until)

    def _run_of(self, seen: SeenExchange) -> RunExchanges | None:
        """Find the run of an exchange; one that was shown is known from then on."""
        run_id = seen.params.get("run_id")
        if run_id is None:
            return None
        self._checks_of.setdefault(run_id, set()).add(seen.check)
        if run_id not in self.runs and seen.operation == "get_run" and seen.is_success:
            account = _ACCOUNTS.get(seen.account or "")
            self._add(run_id, account, None, seen)
        return self.runs.get(run_id)

    def _add(
        self,
        run_id: str,
        account: str | None,
        submission: Mapping[str, Any] | None,
        seen: SeenExchange,
    ) -> RunExchanges:
        is_calibration = (submission or {}).get("benchmark_id") == "calibration"
        options = (submission or {}).get("options") or {}
        views = ShownRuns(self.transitions, self.rules)
        is_push = (submission or {}).get("mode") == "push"
        views.is_played_by_others = submission is None or is_push
        attempts = int(options.get("max_attempts", 3)) if is_calibration else None
        episodes = ShownEpisodes(
            views.rules_of_loss, is_calibration, attempts, self.has_sessions
        )
        run = RunExchanges(
            RunKnowledge(run_id, account, views, episodes, self.limits, submission)
        )
        if seen.check in self._unread_checks:
            _note_unread_play(run.facts)
        run.facts.exercised = self._exercised
        run.facts.open |= {
            number: sent
            for number, sent in self._open.items()
            if sent.params.get("run_id") == run_id
        }
        self.runs[run_id] = run
        self._checks_of.setdefault(run_id, set()).add(seen.check)
        return run

    # --- submit ---

    def _submit(self, seen: SeenExchange) -> Iterator[Difference]:
        if seen.status != 201 or not isinstance(seen.value, dict):
            return
        run_id = seen.value["run_id"]
        account = _ACCOUNTS.get(seen.account or "")
        key = seen.headers.get("idempotency-key")
        earlier = self._made.get(run_id)
        if earlier is not None:
            yield from self._same_run(run_id, key, account, earlier, seen)
        else:
            yield from self._new_run(run_id, key, account, seen)
        run = self.runs.get(run_id)
        if run is None:
            submission = None if seen.body is UNKNOWN else seen.request
            is_new = earlier is None
            run = self._add(run_id, account, submission if is_new else None, seen)
        yield from run.judge_view(seen.value, seen)
        if earlier is None:
            yield from self._clock.judge_created(seen)

    def _new_run(
        self, run_id: str, key: str | None, account: str | None, seen: SeenExchange
    ) -> Iterator[Difference]:
        if key is not None and account is not None:
            fact = self._submits.setdefault((account, key), (seen, run_id))
            if fact[1] != run_id:
                text = f"the run {fact[1]} of this Idempotency-Key, or a refusal"
                rules = ("RUN-003", "RUN-004", "MODEL-002")
                yield Difference(rules, text, f"run {run_id}", seen, fact[0])
        self._made[run_id] = (account or "", seen)

    def _same_run(
        self,
        run_id: str,
        key: str | None,
        account: str | None,
        earlier: tuple[str, SeenExchange],
        seen: SeenExchange,
    ) -> Iterator[Difference]:
        """Judge a submit that returns a run which was made before."""
        first = earlier[1]
        first_key = first.headers.get("idempotency-key")
        if (earlier[0], first_key) == (account or "", key) and key is not None:
            return
        rule = "RUN-029" if key is None else "RUN-026"
        if earlier[0] != (account or ""):
            rule = "RUN-005"
        text = "a run of its own"
        observed = f"run {run_id} of Idempotency-Key {first_key!r}"
        yield Difference((rule, "RUN-003"), text, observed, seen, first)

    # --- lists and accounts ---

    def _page(self, seen: SeenExchange) -> Iterator[Difference]:
        items, cursor = seen.value["runs"], seen.query.get("cursor")
        account = _ACCOUNTS.get(seen.account or "")
        self._exercised["RUN-025"] += 1
        limit = int(seen.query.get("limit", 100))
        if len(items) > limit:
            text = f"at most {limit} runs"
            yield Difference(("RUN-025",), text, f"{len(items)} runs", seen)
        walk = (
            _Walk(seen) if cursor is None else self._walks.pop((account, cursor), None)
        )
        times = [instant_of(item["created_at"]) for item in items]
        for place in range(1, len(times)):
            if times[place] > times[place - 1] + _PAGE_ORDER_S:
                text = "runs in the order of `created_at`, newest first"
                observed = f"{items[place - 1]['created_at']}, then "
                observed += items[place]["created_at"]
                yield Difference(("RUN-009",), text, observed, seen)
                break
        ids = [str(item["run_id"]) for item in items]
        for run_id in ids:
            made = self._made.get(run_id)
            if made is not None and account and made[0] not in ("", account):
                text = "no run of another account"
                yield Difference(("AUTH-004",), text, f"run {run_id}", seen, made[1])
        if walk is not None:
            yield from self._walk(walk, ids, account, seen)
        for item in items:
            run = self.runs.get(item["run_id"])
            if run is not None:
                yield from run.judge_view(item, seen)

    def _walk(
        self, walk: _Walk, ids: Sequence[str], account: str | None, seen: SeenExchange
    ) -> Iterator[Difference]:
        """Judge a page that follows others, or is the first one."""
        twice = [
            i for place, i in enumerate(ids) if i in walk.shown or i in ids[:place]
        ]
        if twice:
            text = "each run once"
            yield Difference(("RUN-009",), text, f"{twice[0]} again", seen, walk.begun)
        walk.shown |= set(ids)
        following = seen.value["next_cursor"]
        if following is not None:
            self._walks[account, following] = walk
            return
        for run_id, (owner, made) in self._made.items():
            is_due = owner == account and made.is_surely_before(walk.begun)
            is_due = is_due and not self._is_asked(run_id, "delete_run")
            if is_due and run_id not in walk.shown and run_id not in self._deleted:
                text = f"the run {run_id} on one of the pages"
                observed = f"{len(walk.shown)} other runs"
                yield Difference(("RUN-009", "AUTH-004"), text, observed, seen, made)
                return

    def _is_asked(self, run_id: str, operation: str) -> bool:
        """Whether such a request is still carried out."""
        return any(
            sent.operation == operation and sent.params.get("run_id") == run_id
            for sent in self._open.values()
        )

    def _missing(self, run: RunExchanges, seen: SeenExchange) -> Iterator[Difference]:
        """Judge `not_found` for a run that was shown to the account."""
        account = _ACCOUNTS.get(seen.account or "")
        is_own = account is not None and run.facts.account == account
        deleted = self._deleted.get(run.facts.run_id)
        if seen.operation not in _OF_WHOLE_RUN:
            return
        if seen.code == "not_found" and is_own and deleted is None:
            witness = self._made.get(run.facts.run_id)
            if witness is None or not witness[1].is_surely_before(seen):
                return
            rules = (
                ("CRASH-003",) if run.facts.views.restarts else ("MODEL-001", "RUN-019")
            )
            text = f"the run {run.facts.run_id}, which was shown before"
            yield Difference(rules, text, "`not_found`", seen, witness[1])
        is_gone = deleted is not None and deleted.status == 204
        if is_gone and deleted and seen.is_success and deleted.is_surely_before(seen):
            text = "`not_found` for a deleted run"
            rules = ("DEL-004",)
            yield Difference(rules, text, f"status {seen.status}", seen, deleted)


_OF_WHOLE_RUN = ("get_run", "get_score", "list_episodes", "stop_run", "resume_run")
_PRIVATE = (
    *_OF_WHOLE_RUN,
    *("attach_worker", "predict", "heartbeat", "detach_worker", "stream_events"),
)


def _note_unread_play(facts: RunKnowledge) -> None:
    """Note that other interfaces play a run; each may have its own `max_attempts`."""
    facts.views.is_played_by_others = True
    facts.episodes.max_attempts = None
