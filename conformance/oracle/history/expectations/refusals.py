"""Refusals that nothing explains: no request was sent that could be their reason.

A refusal may have several reasons, so each is judged only by what it claims itself.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from conformance.oracle.history.expectations.expected_turn import is_valid_chunk
from conformance.oracle.history.facts.run_knowledge import RunKnowledge
from conformance.oracle.history.facts.seen_exchange import (
    Difference,
    SeenExchange,
    is_same,
)
from conformance.oracle.history.facts.seen_session import (
    LEASE_TOLERANCE_S,
    SeenSession,
    comparable,
)

_OF_SEQS: dict[str, tuple[str, ...]] = {
    "seq_conflict": ("PRED-003",),
    "seq_out_of_order": ("PRED-004",),
    "no_episode": ("PRED-011",),
}
# The rules that a refusal shows to be judged, whatever the judgement.
_SHOWN_BY: dict[str, tuple[str, ...]] = {
    **{code: (*rules, "PRED-024", "PRED-027") for code, rules in _OF_SEQS.items()},
    "session_superseded": ("ATT-005", "PRED-027"),
    "session_ended": ("DET-001", "DET-005", "STOP-002", "PRED-027"),
    "worker_busy": ("ATT-003", "ATT-008", "ATT-018"),
    "worker_limit": ("ATT-006", "ATT-007"),
}
_ACCEPTED = {
    "attach_worker": ("ready", "running"),
    "resume_run": ("queued", "ready", "running", "stopped"),
    "stop_run": ("queued", "ready", "running", "stopping", "stopped"),
}
_CAUSES = {"detached": "detach_worker", "run_stopped": "stop_run"}
_ENDED_BY = {"DET-001": "detached", "STOP-002": "run_stopped"}


def judge_refusal(facts: RunKnowledge, seen: SeenExchange) -> Iterator[Difference]:
    """Judge a refusal by the state, the worker or the session that it speaks of."""
    if seen.code == "illegal_transition" and not facts.is_played_by_server:
        yield from _state(facts, seen)
    if facts.is_partial or facts.views.restarts:
        return
    facts.exercised.update(_SHOWN_BY.get(str(seen.code), ()))
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
    is_retryable = facts.views.latest().get("retryable") is True
    is_accepted = state in _ACCEPTED.get(seen.operation, ())
    if is_accepted or (command, state, is_retryable) == ("resume_run", "failed", True):
        rule = facts.views.rules.get((state, command), "MODEL-001")
        rule = "LIFE-604" if state == "failed" else rule
        text = f"no `illegal_transition` of {command} in state {state}"
        yield Difference((rule,), text, f"state {state}", seen)


def _attach(facts: RunKnowledge, seen: SeenExchange) -> Iterator[Difference]:
    """A worker is busy, or the run is full, only by sessions that may be live."""
    worker, key = seen.params.get("worker_id"), seen.request.get("attach_key")
    holding = [
        (session.worker, session.key)
        for session in facts.sessions.values()
        if facts.reason_of_end(session, seen) is None
        and not (session.is_done and facts.is_settled(session, seen))
    ]
    done = [(s.worker, s.key) for s in facts.sessions.values() if s.is_done]
    lost = [
        (attach.params.get("worker_id"), attach.request.get("attach_key"))
        for attach in (*facts.attaches, *facts.open.values())
        if attach.operation == "attach_worker"
        and not attach.is_success
        and attach.may_be_before(seen)
    ]
    keys = {k for w, k in (*holding, *done, *lost) if w == worker}
    if seen.code == "worker_busy" and not keys - {key}:
        text = "no `worker_busy` without a live session with another key"
        rules = ("ATT-003", "ATT-002") if keys else ("ATT-003", "DET-001")
        yield Difference(rules, text, "`worker_busy`", seen)
    limit = facts.views.latest().get("max_workers")
    workers = {w for w, _ in (*holding, *lost)} - {worker}
    if seen.code == "worker_limit" and limit is not None and len(workers) < limit:
        text = f"no `worker_limit` before {limit} other workers hold a slot"
        observed = f"`worker_limit` beside {len(workers)} others"
        yield Difference(("ATT-006", "ATT-014"), text, observed, seen)


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
        case "session_ended" if seen.operation == "detach_worker":
            text = "204: a session that is over may be detached again"
            yield Difference(("DET-002",), text, "`session_ended`", seen)
        case "session_ended":
            yield from _ended(facts, session, seen)
        case "seq_conflict" | "seq_out_of_order" | "no_episode":
            yield from _of_seq(facts, session, seen)
        case "invalid_request" | "illegal_transition" if (
            seen.operation == "predict"
            and facts.is_calibration
            and not _points_elsewhere(seen)
            and is_valid_chunk(seen.request, int(facts.limits.get("max_chunk", 1)))
        ):
            yield from _of_seq(facts, session, seen)


def _points_elsewhere(seen: SeenExchange) -> bool:
    """Whether a refusal points at a header, at a query parameter, or at `observe`.

    A server without the profile `observations` does not know that field.
    """
    pointers = [str(error.get("pointer")) for error in seen.value.get("errors") or []]
    return any(at == "/observe" or not at.startswith("/") for at in pointers)


def _of_seq(
    facts: RunKnowledge, session: SeenSession, seen: SeenExchange
) -> Iterator[Difference]:
    """Judge a refusal for the seq: where nothing is uncertain, one answer is due."""
    seq, observed = seen.request.get("seq"), f"`{seen.code}` for seq"
    witness = session.last.observation
    reason = facts.reason_of_end(session, seen)
    is_over = seq != session.last_seq and _is_ended_by_request(session, seen)
    # An answer that is still on its way may be the turn that made the session `done`.
    is_known = not facts.is_asked_by(session.worker)
    if reason is not None and is_known and (is_over or not session.is_done):
        text = "a refusal of the session, which is over"
        over = ("PRED-027", reason)
        yield Difference(over, text, f"{observed} {seq}", seen, witness)
    elif facts.is_settled(session, seen) and isinstance(seq, int) and seq > 0:
        due, rule = _due(session, seq, seen)
        if due != seen.code:
            text = f"`{due}` for seq {seq}" if due else f"a turn for seq {seq}"
            others = _OF_SEQS.get(str(seen.code), ())
            rules = (rule, *others, "PRED-024", "PRED-025", "PRED-027", "PRED-018")
            yield Difference(rules, text, f"{observed} {seq}", seen, witness)
    if seen.code == "seq_out_of_order":
        yield from _expected_seq(facts, session, seen)


def _is_ended_by_request(session: SeenSession, seen: SeenExchange) -> bool:
    """Whether an abort or a detach had ended a session, be it `done` or not.

    Its latest turn may be answered again all the same (OPT-022).
    """
    return any(
        end.operation in ("stop_run", "detach_worker")
        and end.request.get("mode") != "drain"
        and end.is_success
        and session.opened.is_surely_before(end)
        and end.is_surely_before(seen)
        for end, _ in session.ends
    )


def _due(session: SeenSession, seq: int, seen: SeenExchange) -> tuple[str | None, str]:
    """Name the refusal that a seq gets, if any, and the rule."""
    last = session.last_seq
    if seq == last:
        stored = comparable(session.turns[seq].request)
        is_repeat = is_same(stored, comparable(seen.request))
        return (None, "PRED-002") if is_repeat else ("seq_conflict", "PRED-003")
    if seq != last + 1:
        return "seq_out_of_order", "PRED-004"
    return ("no_episode", "PRED-011") if session.is_done else (None, "PRED-024")


def _ended(
    facts: RunKnowledge, session: SeenSession, seen: SeenExchange
) -> Iterator[Difference]:
    """The cause that `ended_by` names was there, and the lease was surely over."""
    cause = seen.value.get("ended_by")
    yield from _still_lives(facts, session, seen)
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


def _still_lives(
    facts: RunKnowledge, session: SeenSession, seen: SeenExchange
) -> Iterator[Difference]:
    """Judge that a session has ended, and by what, where nothing is uncertain."""
    cause, observed = seen.value.get("ended_by"), "`session_ended`"
    is_lost = any(not a.is_success for a in facts.attaches_of(session.worker))
    later = replace(seen, ended_at=seen.ended_at + LEASE_TOLERANCE_S / 5)
    if not is_lost and facts.surely_lives(session, later):
        text = "no end of a session that nothing ended"
        of_done = ("PRED-010",) if session.is_done else ()
        rules = (*of_done, "LEASE-002", "LEASE-003", "LEASE-010", "DET-005", "DET-004")
        yield Difference(rules, text, observed, seen, session.last.observation)
        return
    successors = [
        other
        for other in facts.sessions.values()
        if other.worker == session.worker
        and session.opened.is_surely_before(other.opened)
        and other.opened.is_surely_before(seen)
    ]
    ends = sorted(session.ends, key=lambda pair: pair[0].started_at)
    length_s, bounds = facts.idle_timeout_s, ("unused_s_max", "heartbeat_s_max")
    is_bounded = any(facts.limits.get(name) for name in bounds)
    if not ends or length_s is None or facts.may_fail or is_bounded:
        return
    first, rule = ends[0]
    beside = [*(end for end, _ in ends[1:]), *facts.open_ends_of(session)]
    is_alone = session.opened.is_surely_before(first) and not any(
        end.may_be_before(first) for end in beside
    )
    is_sure = is_alone and first.is_success and first.is_surely_before(seen)
    if not is_sure or first.ended_at >= session.least_end(length_s):
        return
    if rule == "ATT-005":
        successor = facts.sessions[first.value["session_id"]]
        is_held = not (successor.is_done or session.is_done)
        if is_held and facts.surely_lives(successor, seen):
            text = "`session_superseded`: its worker has another live session"
            yield Difference(("ATT-005",), text, observed, seen, first)
    elif cause not in (None, due := _ENDED_BY.get(rule)) and due and not successors:
        yield Difference(
            ("DET-005",), f"ended_by {due}", f"ended_by {cause}", seen, first
        )


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
    if not isinstance(due, int) or not least <= due <= most:
        text = f"expected_seq {least}" + (f" to {most}" if most > least else "")
        witness = session.last.observation
        yield Difference(("PRED-004",), text, f"expected_seq {due}", seen, witness)
