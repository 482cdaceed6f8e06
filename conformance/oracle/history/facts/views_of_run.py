"""The run as answers show it: what never changes, what only grows, which states follow.

A view is a run in an answer of `get_run`, `submit_run`, `stop_run`, `resume_run` or
`list_runs`, or in an event; an answer 304 shows the run that its ETag named before.
"""

from __future__ import annotations

import functools
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from datetime import datetime
from typing import Any

from conformance.oracle.history.facts.seen_exchange import (
    LOST,
    Difference,
    SeenExchange,
    is_same,
    name_of_difference,
)

# Members that no request and no event changes, with the rules that say so.
CONSTANTS = {
    "benchmark_id": ("RUN-018",),
    "benchmark_version": ("RUN-018",),
    "policy": ("RUN-018",),
    "max_workers": ("RUN-018",),
    "idle_timeout_s": ("RUN-018",),
    "images": ("RUN-018",),
    "created_at": ("RUN-018",),
    "manifest_sha256": ("BEN-005", "RUN-018"),
    "any_policy": ("ATR-005",),
    "select": ("SUB-003",),
    "attempts_by_submitter": ("REC-110",),
    "mode": ("RUN-019",),
}
_OTHER_CONSTANTS = {"episodes_total": ("RUN-014",), "runs_played_before": ("DEL-006",)}
COMMANDS = {
    "attach_worker": ("attach_worker",),
    "stop_run": ("stop_abort", "stop_drain"),
    "resume_run": ("resume_run",),
}
_FINAL = ("stopped", "completed", "failed")
_STATES = ("queued", "ready", "running", "stopping", *_FINAL)
_IDLE = ("queued", "ready", *_FINAL)
# Members that may change and change back without a request.
_LIVE = ("queue_position", "live_workers", "endpoint")
_TIMER_S = 0.05  # so early a timer may end
_VIEWS_KEPT = 10
# The states in which a run may be when its command was just carried out.
_AFTER_COMMAND = {
    "abort": ("stopped", "completed"),
    "drain": ("stopping", "stopped", "completed", "failed"),
    "resume": ("queued", "ready", "running", "completed", "failed"),
}


@dataclass(frozen=True, slots=True)
class RunCommand:
    """A request that may have moved the run, or that a restart did."""

    events: tuple[str, ...]
    started_at: float
    ended_at: float


@dataclass(frozen=True, slots=True)
class ShownRun:
    """A run as one answer shows it."""

    body: Mapping[str, Any]
    observation: SeenExchange

    @property
    def state(self) -> str:
        """The state that it shows."""
        return str(self.body["state"])

    @property
    def scored(self) -> int:
        """How many episodes it shows as scored."""
        return int(self.body["progress"]["episodes_scored"])


def _events_of(seen: SeenExchange) -> tuple[str, ...]:
    """Name the events that a command may be."""
    mode = seen.request.get("mode")
    is_known = seen.operation == "stop_run" and mode in ("abort", "drain")
    return (f"stop_{mode}",) if is_known else COMMANDS[seen.operation]


@functools.lru_cache(maxsize=4096)
def instant_of(text: str) -> float:
    """Give a time of an answer in seconds."""
    return datetime.fromisoformat(text).timestamp()


@dataclass
class ShownRuns:
    """All views of one run so far.

    transitions: the lifecycle, (state, event) → states; rules: the ids of its rows.
    is_played_by_others: whether requests may have reached the run that the oracle has
    not seen.
    """

    transitions: Mapping[tuple[str, str], tuple[str, ...]]
    rules: Mapping[tuple[str, str], str] = field(default_factory=dict)
    is_played_by_others: bool = False
    commands: list[RunCommand] = field(default_factory=list)
    restarts: list[tuple[float, float]] = field(default_factory=list)
    _first: dict[str, tuple[Any, SeenExchange]] = field(default_factory=dict)
    _views: list[ShownRun] = field(default_factory=list)
    _by_etag: dict[str, ShownRun] = field(default_factory=dict)

    def note_command(self, seen: SeenExchange) -> None:
        """Note a request that may move the run."""
        if not seen.may_have_effect:
            return
        events = _events_of(seen)
        ended_at = LOST if seen.status is None else seen.ended_at
        self.commands.append(RunCommand(events, seen.started_at, ended_at))

    def latest(self) -> Mapping[str, Any]:
        """Give the run as it was shown last; empty where it never was."""
        return self._views[-1].body if self._views else {}

    # --- a view ---

    def judge(self, body: Any, seen: SeenExchange) -> Iterator[Difference]:
        """Judge a view, and store it."""
        view = ShownRun(body, seen)
        yield from self._constants(view)
        yield from _faults_inside(view)
        if seen.operation != "stream_events":
            yield from self._growth(view)
            yield from self._moves(view)
            yield from self._effect_of_command(view)
            yield from self._between(view)
            self._views = [*self._views[-_VIEWS_KEPT:], view]

    def judge_etag(self, seen: SeenExchange, wait_s_max: float) -> Iterator[Difference]:
        """Judge an answer of `get_run` beside earlier ones with its ETag."""
        etag = seen.answer_headers.get("etag", "").removeprefix("W/")
        sent = seen.headers.get("if-none-match", "")
        named = [name.strip().removeprefix("W/") for name in sent.split(",")]
        wait = seen.headers.get("prefer", "").removeprefix("wait=")
        is_current = bool(etag) and (etag in named or named == ["*"])
        if seen.status == 200 and is_current and not wait:
            text, observed = "304 for the current ETag", f"200 with ETag {etag}"
            yield Difference(("RUN-011",), text, observed, seen)
        if seen.status == 304:
            due_s = min(float(wait), wait_s_max) if wait.isdigit() else 0.0
            if seen.ended_at - seen.started_at < due_s - _TIMER_S:
                text = f"304 after {due_s:g} s"
                observed = f"after {seen.ended_at - seen.started_at:.2f} s"
                yield Difference(("RUN-013",), text, observed, seen)
            shown = self._by_etag.get(named[0]) if len(named) == 1 else None
            if shown is not None:
                yield from self._growth(ShownRun(shown.body, seen), shown.observation)
                yield from self._moves(ShownRun(shown.body, seen), shown.observation)
            return
        if seen.status != 200 or not etag or not isinstance(seen.value, dict):
            return
        earlier = self._by_etag.setdefault(etag, ShownRun(seen.value, seen))
        if not is_same(earlier.body, seen.value):
            name = name_of_difference(earlier.body, seen.value)
            yield Difference(
                ("RUN-030",),
                f"another ETag than {etag}, or `{name}` {earlier.body.get(name)!r}",
                f"ETag {etag} with `{name}` {seen.value.get(name)!r}",
                seen,
                earlier.observation,
            )

    def _constants(self, view: ShownRun) -> Iterator[Difference]:
        values = {name: view.body.get(name) for name in CONSTANTS}
        values["created_at"] = instant_of(view.body["created_at"])
        values["episodes_total"] = view.body["progress"]["episodes_total"]
        if (played := view.body.get("runs_played_before")) is not None:
            values["runs_played_before"] = played
        for name, value in values.items():
            first, witness = self._first.setdefault(name, (value, view.observation))
            if not is_same(first, value):
                rules = CONSTANTS.get(name, _OTHER_CONSTANTS.get(name, ()))
                text, observed = f"`{name}` {first!r} as before", f"`{name}` {value!r}"
                yield Difference(rules, text, observed, view.observation, witness)

    def _growth(
        self, view: ShownRun, shown_by: SeenExchange | None = None
    ) -> Iterator[Difference]:
        """Judge what only grows; `shown_by`: where a 304 takes the run from."""
        stale = ("RUN-011",) if shown_by else ()
        for earlier in self._views:
            if not earlier.observation.is_surely_before(view.observation):
                continue
            if earlier.scored > view.scored:
                rules = self._rules_of_loss(earlier.observation)
                text = f"episodes_scored of at least {earlier.scored}"
                observed = f"episodes_scored {view.scored}"
                seen, witness = view.observation, earlier.observation
                yield Difference((*stale, *rules), text, observed, seen, witness)
                return
            times = [instant_of(v.body["updated_at"]) for v in (earlier, view)]
            if times[0] > times[1]:
                yield Difference(
                    (*stale, "RUN-021"),
                    f"updated_at not before {earlier.body['updated_at']}",
                    f"updated_at {view.body['updated_at']}",
                    view.observation,
                    earlier.observation,
                )
                return

    def _between(self, view: ShownRun) -> Iterator[Difference]:
        """Judge the views between two equal ones: the run did not change meanwhile."""
        after = view.observation
        equal = [
            earlier.observation
            for earlier in self._views
            if earlier.observation.operation == after.operation == "get_run"
            and earlier.observation.is_surely_before(after)
            and is_same(earlier.body, view.body)
        ]
        if not equal or self.is_played_by_others:
            return
        before, *_ = equal
        is_moved = any(
            command.started_at < after.ended_at and command.ended_at > before.started_at
            for command in self.commands
        )
        for middle in self._views if not is_moved else ():
            seen = middle.observation
            is_between = before.is_surely_before(seen) and seen.is_surely_before(after)
            for name in middle.body if is_between else ():
                shown, due = middle.body[name], view.body.get(name)
                if name not in _LIVE and not is_same(shown, due):
                    text = f"`{name}` {due!r} as `get_run` before and after"
                    yield Difference(
                        ("RUN-019",), text, f"`{name}` {shown!r}", seen, after
                    )
                    return

    def _rules_of_loss(self, since: SeenExchange) -> tuple[str, ...]:
        """Name the rules that keep results, by what happened since they were shown."""
        if any(ended > since.started_at for _, ended in self.restarts):
            return ("CRASH-001", "CRASH-003")
        events = {
            event
            for command in self.commands
            if command.ended_at > since.started_at
            for event in command.events
        }
        if "resume_run" in events:
            return ("RES-001", "STOP-005", "EPI-005", "FAULT-003", "RES-003")
        return ("STOP-005", "EPI-005") if "stop_abort" in events else ("EPI-005",)

    def rules_of_loss(self, since: SeenExchange) -> tuple[str, ...]:
        """Name the rules that keep a result which an observation showed."""
        return self._rules_of_loss(since)

    # --- the lifecycle ---

    def judge_state(self, state: str, seen: SeenExchange) -> Iterator[Difference]:
        """Judge the state that a score or a refusal shows."""
        if self._views:
            body = {**self._views[-1].body, "state": state}
            yield from self._moves(ShownRun(body, seen))

    def judge_accepted(self, seen: SeenExchange) -> Iterator[Difference]:
        """Judge a command that was carried out: some state before accepts it."""
        earlier, events = self._latest_before(seen), _events_of(seen)
        if earlier is None or len(events) > 1:
            return
        event = events[0]
        states = self._reachable(earlier, seen)
        is_final = event == "resume_run" and earlier.body.get("retryable") is False
        if states == {"failed"} and is_final:
            rule = "LIFE-605"
        elif any((state, event) in self.transitions for state in states):
            return
        else:
            rule = self.rules.get((earlier.state, event), "MODEL-001")
        text = f"`illegal_transition` in state {earlier.state}"
        yield Difference((rule,), text, "success", seen, earlier.observation)

    def _latest_before(self, seen: SeenExchange) -> ShownRun | None:
        """Give the view that was answered last before a request."""
        before = [v for v in self._views if v.observation.is_surely_before(seen)]
        return max(before, key=lambda v: v.observation.ended_at, default=None)

    def _moves(
        self, view: ShownRun, shown_by: SeenExchange | None = None
    ) -> Iterator[Difference]:
        """Judge whether the state follows from the one shown last."""
        earlier = self._latest_before(view.observation)
        if earlier is None:
            return
        states = self._reachable(earlier, view.observation)
        if view.state in states:
            return
        rules = _rules_of_move(earlier.state, view.state)
        yield Difference(
            ("RUN-011", *rules) if shown_by else rules,
            f"state {' or '.join(sorted(states))} after state {earlier.state}",
            f"state {view.state}",
            view.observation,
            earlier.observation,
        )

    def _reachable(self, earlier: ShownRun, seen: SeenExchange) -> set[str]:
        since = earlier.observation.started_at
        is_restarted = any(
            begun < seen.ended_at and ended > since for begun, ended in self.restarts
        )
        if is_restarted and earlier.state not in _FINAL:
            return set(_STATES)
        events = {"capacity", "last_lease_ends", "all_scored", "fault"}
        if self.is_played_by_others:
            events |= {name for names in COMMANDS.values() for name in names}
        for command in self.commands:
            if command.started_at < seen.ended_at and command.ended_at > since:
                events |= set(command.events)
        reached, new = {earlier.state}, [earlier.state]
        while new:
            state = new.pop()
            for event in events:
                for to in self.transitions.get((state, event), ()):
                    if to not in reached:
                        reached.add(to)
                        new.append(to)
        return reached

    def _effect_of_command(self, view: ShownRun) -> Iterator[Difference]:
        """Judge the state in the answer to a command that no other one accompanies."""
        seen = view.observation
        if seen.operation not in ("stop_run", "resume_run") or self.is_played_by_others:
            return
        beside = [
            command
            for command in self.commands
            if command.started_at < seen.ended_at
            and command.ended_at > seen.started_at
            and command.started_at != seen.started_at
        ]
        name = str(seen.request.get("mode")) if seen.operation == "stop_run" else ""
        allowed = _AFTER_COMMAND.get(name or "resume")
        if beside or allowed is None or view.state in allowed:
            return
        event = f"stop_{name}" if name else "resume_run"
        earlier = self._views[-1].state if self._views else "ready"
        rules = (self.rules.get((earlier, event), "MODEL-001"),)
        text = f"state {' or '.join(allowed)}"
        yield Difference(rules, text, f"state {view.state}", seen)


def _rules_of_move(from_state: str, to_state: str) -> tuple[str, ...]:
    if to_state == "completed":
        return ("LIFE-804", "LIFE-805", "MODEL-001")
    return {
        "completed": ("LIFE-702", "LIFE-704"),
        "failed": ("LIFE-602", "LIFE-605"),
        "stopped": ("LIFE-811", "LIFE-502"),
        "stopping": ("LIFE-404", "LIFE-403"),
        "queued": ("LIFE-801", "LIFE-104"),
        "ready": ("LIFE-204", "LIFE-201"),
    }.get(from_state, ("LIFE-304", "MODEL-001"))


def _faults_inside(view: ShownRun) -> Iterator[Difference]:
    """Give the contradictions inside of one view."""
    body, seen = view.body, view.observation
    progress, state = body["progress"], view.state
    total, playing = progress["episodes_total"], progress["episodes_in_progress"]
    pending = progress["episodes_pending"]
    counts = (total, view.scored, playing, pending)
    shown = f"state {state}, progress {dict(progress)}"
    if view.scored + playing + pending != total or min(counts) < 0:
        yield Difference(("RUN-014",), "counts that add up to the total", shown, seen)
    if (body["queue_position"] is None) == (state == "queued"):
        position = f"state {state} with queue_position {body['queue_position']}"
        text = "queue_position null exactly outside of `queued`"
        yield Difference(("RUN-008",), text, position, seen)
    if (body["retryable"] is None) == (state == "failed"):
        retryable = f"state {state} with retryable {body['retryable']}"
        text = "retryable null exactly outside of `failed`"
        yield Difference(("RUN-023",), text, retryable, seen)
    if state == "failed" and not body["reason"]:
        yield Difference(("FAULT-002",), "a reason", f"reason {body['reason']}", seen)
    if state == "completed" and view.scored < total:
        rules = ("LIFE-804", "LIFE-805")
        yield Difference(rules, "a completed run with all scored", shown, seen)
    if state in ("running", "stopping") and view.scored == total:
        rule = "LIFE-804" if state == "running" else "LIFE-805"
        yield Difference((rule,), "state completed with all scored", shown, seen)
    if state in _IDLE and playing:
        text = f"no episode in progress in state {state}"
        yield Difference(("RUN-022", "STOP-001"), text, shown, seen)
    if playing > body["live_workers"] or playing > body["max_workers"]:
        text = "at most as many episodes in progress as live workers and max_workers"
        observed = f"{shown}, live_workers {body['live_workers']}"
        yield Difference(("ATT-006", "RUN-022"), text, observed, seen)
    if instant_of(body["updated_at"]) < instant_of(body["created_at"]):
        text = f"updated_at not before created_at {body['created_at']}"
        observed = f"updated_at {body['updated_at']}"
        yield Difference(("RUN-021",), text, observed, seen)
