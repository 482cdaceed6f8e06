"""How many workers may be live, and how many episodes held, when the run is shown.

Each session counts at least when it was surely live, and at most when it had not surely
ended. Both bounds meet in most histories, so that the numbers are known.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from conformance.oracle.history.facts.run_knowledge import RunKnowledge
from conformance.oracle.history.facts.seen_exchange import Difference, SeenExchange

_PLAYED = ("running", "stopping")


def judge_occupancy(
    facts: RunKnowledge, body: Mapping[str, Any], seen: SeenExchange
) -> Iterator[Difference]:
    """Judge the live workers, the held episodes and the state of a run."""
    sessions = [*facts.sessions.values()]
    is_unknown = any(session.is_unknown for session in sessions)
    if facts.is_partial or facts.views.restarts or is_unknown:
        return
    at_work = [s for s in sessions if _surely_plays(facts, s, seen)]
    alive = [s for s in sessions if facts.reason_of_end(s, seen) is None]
    holding = [s for s in alive if not (s.is_done and facts.is_settled(s, seen))]
    others = sum(
        not attach.is_success
        for attach in (*facts.attaches, *facts.open.values())
        if attach.operation == "attach_worker"
    )
    playing, state = body["progress"]["episodes_in_progress"], body["state"]
    bounds = len(at_work), len(holding) + others
    shown = f"state {state}, {playing} in progress, live_workers {body['live_workers']}"
    ended = _rules_of_ends(facts, seen)
    if not bounds[0] <= playing <= bounds[1]:
        rules = ("RUN-022", *ended) if playing > bounds[1] else ("LEASE-002", "RUN-022")
        yield Difference(rules, _between("episodes in progress", bounds), shown, seen)
    if state in _PLAYED and not bounds[1]:
        rules = ("LIFE-802" if state == "running" else "LIFE-803", *ended)
        yield Difference(rules, "a state that no worker plays", shown, seen)
    if state not in _PLAYED and bounds[0]:
        is_drained = seen.request.get("mode") == "drain"
        rules = ("LEASE-002", "LIFE-301", "LIFE-802")
        rules = ("LIFE-303", "STOP-003", *rules) if is_drained else rules
        yield Difference(rules, "state running or stopping", shown, seen)
    bounds = len(at_work), len(alive) + others
    if not bounds[0] <= body["live_workers"] <= bounds[1]:
        is_many = body["live_workers"] > bounds[1]
        rules = (*ended, "LEASE-006") if is_many else ("LEASE-002", "LEASE-006")
        yield Difference(rules, _between("live workers", bounds), shown, seen)


def _surely_plays(facts: RunKnowledge, session: Any, seen: SeenExchange) -> bool:
    return (
        session.opened.is_surely_before(seen)
        and not session.is_done
        and facts.is_settled(session, seen)
        and facts.surely_lives(session, seen)
    )


def _rules_of_ends(facts: RunKnowledge, seen: SeenExchange) -> tuple[str, ...]:
    """Name the rules by which sessions have surely ended."""
    reasons = [facts.reason_of_end(s, seen) for s in facts.sessions.values()]
    return tuple(dict.fromkeys(reason for reason in reasons if reason is not None))


def _between(what: str, bounds: tuple[int, int]) -> str:
    least, most = bounds
    return f"{least} {what}" if least == most else f"{least} to {most} {what}"
