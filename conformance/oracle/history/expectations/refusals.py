"""Refusals that nothing explains: no request was sent that could be their reason.

A refusal may have several reasons, so each is judged only by what it claims itself.
"""

from __future__ import annotations

from collections.abc import Iterator

from conformance.oracle.history.facts.run_knowledge import RunKnowledge
from conformance.oracle.history.facts.seen_exchange import Difference, SeenExchange
from conformance.oracle.history.facts.seen_session import (
    LEASE_TOLERANCE_S,
    SeenSession,
    comparable,
)

_ACCEPTED = {
    "attach_worker": ("ready", "running"),
    "resume_run": ("queued", "ready", "running", "stopped"),
    "stop_run": ("queued", "ready", "running", "stopping", "stopped"),
}
_CAUSES = {"detached": "detach_worker", "run_stopped": "stop_run"}


def judge_refusal(facts: RunKnowledge, seen: SeenExchange) -> Iterator[Difference]:
    """Judge a refusal by the state, the worker or the session that it speaks of."""
    if seen.code == "illegal_transition" and not facts.is_played_by_server:
        yield from _state(facts, seen)
    if facts.is_partial or facts.views.restarts:
        return
    if seen.operation == "attach_worker":
        yield from _attach(facts, seen)
    name = seen.request.get("session_id", seen.query.get("session_id"))
    session = facts.sessions.get(str(name))
    is_own = session is not None and session.worker == seen.params.get("worker_id")
    if session is not None and is_own and not session.is_unknown:
        yield from _of_session(facts, session, seen)


def _state(facts: RunKnowledge, seen: SeenExchange) -> Iterator[Difference]:
    """A state that accepts the command refuses nothing."""
    state, command = str(seen.value.get("state")), seen.operation
    if command == "stop_run":
        command = f"stop_{seen.request.get('mode')}"
    if state in _ACCEPTED.get(seen.operation, ()):
        rule = facts.views.rules.get((state, command), "MODEL-001")
        text = f"no `illegal_transition` of {command} in state {state}"
        yield Difference((rule,), text, f"state {state}", seen)


def _attach(facts: RunKnowledge, seen: SeenExchange) -> Iterator[Difference]:
    """A worker is busy, or the run is full, only by other attaches."""
    worker, key = seen.params.get("worker_id"), seen.request.get("attach_key")
    others = [
        attach
        for attach in (*facts.attaches, *facts.open.values())
        if attach.operation == "attach_worker" and attach.may_be_before(seen)
    ]
    if seen.code == "worker_busy" and not any(
        attach.params.get("worker_id") == worker
        and attach.request.get("attach_key") != key
        for attach in others
    ):
        text = "no `worker_busy` without an attach with another key"
        yield Difference(("ATT-003",), text, "`worker_busy`", seen)
    limit = facts.views.latest().get("max_workers")
    workers = {attach.params.get("worker_id") for attach in others} - {worker}
    if seen.code == "worker_limit" and limit is not None and len(workers) < limit:
        text = f"no `worker_limit` before {limit} other workers attach"
        observed = f"`worker_limit` after {len(workers)} others"
        yield Difference(("ATT-006",), text, observed, seen)


def _of_session(
    facts: RunKnowledge, session: SeenSession, seen: SeenExchange
) -> Iterator[Difference]:
    match seen.code:
        case "session_superseded":
            is_taken = any(
                attach is not session.opened and attach.may_be_before(seen)
                for attach in facts.attaches_of(session.worker)
            )
            if not is_taken:
                text = "no `session_superseded` without another attach"
                yield Difference(("ATT-005",), text, "that code", seen)
        case "session_ended":
            yield from _ended(facts, session, seen)
        case "seq_conflict":
            yield from _conflict(facts, session, seen)
        case "seq_out_of_order":
            yield from _expected_seq(facts, session, seen)
        case "no_episode" if facts.is_settled(session, seen) and not session.is_done:
            text, witness = "a turn: the latest one is not `done`", session.last
            rules = ("PRED-011",)
            yield Difference(rules, text, "`no_episode`", seen, witness.observation)


def _ended(
    facts: RunKnowledge, session: SeenSession, seen: SeenExchange
) -> Iterator[Difference]:
    """The cause that `ended_by` names was there, and the lease was surely over."""
    cause = seen.value.get("ended_by")
    requests = [end for end, _ in session.ends] + [*facts.open.values(), *facts.stops]
    wanted = _CAUSES.get(str(cause))
    if wanted is not None and not any(
        request.operation == wanted and request.may_be_before(seen)
        for request in requests
    ):
        text = f"another `ended_by`: no {wanted} was sent"
        yield Difference(("DET-005",), text, f"ended_by {cause}", seen)
    length_s = facts.idle_timeout_s
    bounds = [facts.limits.get(n) for n in ("unused_s_max", "heartbeat_s_max")]
    known = [bound for bound in bounds if bound is not None]
    if cause != "lease_ended" or length_s is None:
        return
    ends_at = session.least_end(length_s)
    if known:
        ends_at = min(ends_at, session.last_new_turn_at() + min(known))
    if seen.ended_at < ends_at - LEASE_TOLERANCE_S / 5:
        text = f"a lease of {length_s:g} s since the last successful response"
        early_s = ends_at - seen.ended_at
        observed = f"ended_by lease_ended, {early_s:.2f} s too early"
        yield Difference(("LEASE-002", "LEASE-003", "LEASE-010"), text, observed, seen)


def _conflict(
    facts: RunKnowledge, session: SeenSession, seen: SeenExchange
) -> Iterator[Difference]:
    """A seq conflicts only with another body that was sent under it."""
    seq, stored = (
        seen.request.get("seq"),
        session.turns.get(seen.request.get("seq", -1)),
    )
    if not facts.is_settled(session, seen):
        return
    if stored is None and seq == session.last_seq + 1:
        text = f"a turn for seq {seq}, the next one"
        yield Difference(("PRED-003", "PRED-024"), text, "`seq_conflict`", seen)
    elif (
        stored is not None
        and 0 < session.last_seq == seq
        and comparable(stored.request) == comparable(seen.request)
    ):
        text, witness = "the stored turn for the same body", stored.observation
        rules = ("PRED-002", "PRED-025")
        yield Difference(rules, text, "`seq_conflict`", seen, witness)


def _expected_seq(
    facts: RunKnowledge, session: SeenSession, seen: SeenExchange
) -> Iterator[Difference]:
    """`expected_seq` follows the last turn, or is that of a turn in execution."""
    due = seen.value.get("expected_seq")
    least = 1 + max(
        (n for n, t in session.turns.items() if t.observation.is_surely_before(seen)),
        default=0,
    )
    beside = [o.request.get("seq") for o in facts.open.values()]
    numbers = [n for n in beside if isinstance(n, int)]
    sent = max([session.highest_seq_sent(seen.ended_at), *numbers])
    most = max(sent, session.last_seq) + 1
    if facts.is_settled(session, seen):
        most = session.last_seq + 1
        if seen.request.get("seq") in (session.last_seq, most) and not session.is_done:
            text = f"no `seq_out_of_order` of seq {seen.request.get('seq')}"
            witness = session.last.observation
            yield Difference(("PRED-004",), text, f"expected {due}", seen, witness)
    if not isinstance(due, int) or not least <= due <= most:
        text = f"expected_seq {least}" + (f" to {most}" if most > least else "")
        witness = session.last.observation
        yield Difference(("PRED-004",), text, f"expected_seq {due}", seen, witness)
