"""Which episode an attach or a turn may assign: the pending one with the lowest index.

Says something only where no order of the requests explains the answer.
"""

from __future__ import annotations

from collections.abc import Iterator

from conformance.oracle.history.facts.run_knowledge import RunKnowledge
from conformance.oracle.history.facts.seen_exchange import Difference, SeenExchange
from conformance.oracle.history.facts.seen_session import SeenSession

_JUDGED = ("EPI-001", "EPI-002", "EPI-003", "EPI-008", "RES-002")


def judge_assigned(
    facts: RunKnowledge, session: SeenSession, index: int, seen: SeenExchange
) -> Iterator[Difference]:
    """Judge which episode a session got."""
    facts.exercised.update(_JUDGED)
    result = facts.episodes.results.get(index)
    if result is not None and result[1].is_surely_before(seen):
        text = f"another episode than {index}, which has a result"
        rules: tuple[str, ...] = ("EPI-001", "RES-002")
        yield Difference(rules, text, f"episode {index}", seen, result[1])
    for other in facts.sessions.values():
        is_earlier = other.last.observation.is_surely_before(seen)
        if other is session or other.held_index != index or not is_earlier:
            continue
        if facts.is_settled(other, seen) and facts.surely_lives(other, seen):
            text = f"another episode than {index}, which a live session holds"
            rules, witness = ("EPI-008", "EPI-001"), other.last.observation
            yield Difference(rules, text, f"episode {index}", seen, witness)
    if facts.is_partial:
        return
    yield from _attempt(facts, session, index, seen)
    for lower in range(index):
        if _is_surely_pending(facts, lower, session, seen):
            text = f"episode {lower}, the pending one with the lowest index"
            yield Difference(("EPI-001",), text, f"episode {index}", seen)
            return


def _attempt(
    facts: RunKnowledge, session: SeenSession, index: int, seen: SeenExchange
) -> Iterator[Difference]:
    """Judge the number of an attempt by what became of the one before."""
    holders = [
        other
        for other in facts.sessions.values()
        if other is not session and other.held_index == index
    ]
    if facts.views.restarts or facts.may_fail:
        return
    due, rules, witness = 1, ("EPI-002", "EPI-003"), None
    if holders:
        old = max(holders, key=lambda other: other.last.observation.started_at)
        shown, witness = old.last.value["episode"], old.last.observation
        is_closed = facts.reason_of_end(old, seen) is not None
        if not is_closed or not facts.is_settled(old, seen) or facts.ends_for_room(old):
            return
        due = shown["attempt"] + (shown["step"] > 0)
        rules = ("EPI-003", "LEASE-012") if shown["step"] else ("EPI-002", "LEASE-012")
    elif any(not attach.is_success for attach in facts.attaches):
        return  # an attach without an answer may have played it
    elif any(_may_have_held(facts, other, seen) for other in facts.sessions.values()):
        return
    attempt = seen.value["episode"]["attempt"]
    if attempt != due:
        text = f"attempt {due} of episode {index}"
        yield Difference(rules, text, f"attempt {attempt}", seen, witness)


def _may_have_held(
    facts: RunKnowledge, session: SeenSession, seen: SeenExchange
) -> bool:
    """Whether a session may have played an episode that no turn showed."""
    return session.opened is not seen and not facts.is_settled(session, seen)


def judge_nothing_left(
    facts: RunKnowledge, session: SeenSession, seen: SeenExchange
) -> Iterator[Difference]:
    """Judge a turn that is `done`: no episode may have been pending all the while.

    Those behind the first ones that the session wants are none of its own (SUB-005).
    """
    total = facts.episodes_total
    if total is None or facts.is_partial or facts.stops:
        return
    if any(beside.operation == "stop_run" for beside in facts.open.values()):
        return
    wanted = min(session.opened.request.get("first_episodes", total), total)
    for index in range(wanted):
        if _is_surely_pending(facts, index, session, seen):
            rule = "ATT-012" if seen.operation == "attach_worker" else "PRED-009"
            text = f"episode {index}, which is pending"
            rules = (rule, "EPI-001", "ATT-020")
            yield Difference(rules, text, "`done`, no episode", seen)
            return


def _is_surely_pending(
    facts: RunKnowledge, index: int, session: SeenSession, seen: SeenExchange
) -> bool:
    """Whether an episode was neither scored nor held while a request was made."""
    if index in facts.episodes.results or facts.views.restarts or facts.may_fail:
        return False
    is_asked = any(
        beside.operation in ("attach_worker", "predict")
        for beside in facts.open.values()
    )
    # An attach without an answer may hold the episode.
    if is_asked or any(not a.is_success for a in facts.attaches if a is not seen):
        return False
    others = [other for other in facts.sessions.values() if other is not session]
    return not session.is_unknown and all(
        facts.is_settled(other, seen)
        and other.opened.is_surely_before(seen)
        and other.held_index != index  # else it may be held, or abandoned
        for other in others
    )
