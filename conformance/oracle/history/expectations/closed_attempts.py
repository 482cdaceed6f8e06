"""The list of episodes, after an attempt was closed without a result.

Judged where no result was shown before, so that the last holder is known.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from conformance.oracle.history.facts.run_knowledge import RunKnowledge
from conformance.oracle.history.facts.seen_exchange import Difference, SeenExchange

_OF_ABANDONED = {"outcome": "abandoned", "score": 0, "terminated": False}


def judge_closed(
    facts: RunKnowledge, item: Mapping[str, Any], seen: SeenExchange
) -> Iterator[Difference]:
    """Judge an episode whose last attempt has surely been closed, or surely goes on."""
    most, sessions = facts.episodes.max_attempts, [*facts.sessions.values()]
    holders = [s for s in sessions if s.held_index == item["index"]]
    is_unsure = (
        facts.is_partial
        or item["index"] in facts.episodes.results  # an attempt was played to its end
        or facts.may_fail
        or facts.views.restarts
        or any(not attach.is_success for attach in facts.attaches)
        or any(o.operation in ("attach_worker", "predict") for o in facts.open.values())
        or not all(facts.is_settled(session, seen) for session in sessions)
    )
    if is_unsure or not holders or most is None:
        return
    last = max(holders, key=lambda session: session.last.observation.started_at)
    others = [session for session in holders if session is not last]
    if not all(o.last.observation.is_surely_before(last.opened) for o in others):
        return  # which of them holds it is open
    reason, played = facts.reason_of_end(last, seen), last.last.value["episode"]
    attempt, witness = played["attempt"], last.last.observation
    due: dict[str, Any] = {"attempt": attempt}
    rules: tuple[str, ...] = ("EPI-002", "LEASE-012")
    if facts.surely_lives(last, seen):
        due |= {"status": "in_progress"}
        rules = ("EPI-006", "LEASE-002")
    elif reason in (None, "ATT-005") or facts.ends_for_room(last):
        return
    elif not facts.episodes.counts_attempts:
        due, rules = {"status": "pending"}, ("STOP-001",)  # by OPT-082
    elif played["step"] == 0:
        due |= {"status": "pending"}
    elif attempt < most:
        due = {"status": "pending", "attempt": attempt + 1}
        rules = ("EPI-003", "STOP-001", "LEASE-012", "DET-003")
    else:
        due |= {"status": "scored", "steps": played["step"], **_OF_ABANDONED}
        rules = ("EPI-004", "EPI-010", "EPI-009", "LEASE-012")
    facts.exercised.update(rules)
    shown = {**item.get("result", {}), **item}
    for name, value in due.items():
        if shown.get(name) != value:
            text = f"`{name}` {value!r} of episode {item['index']}"
            observed = f"`{name}` {shown.get(name)!r}"
            yield Difference(rules, text, observed, seen, witness)
            return
