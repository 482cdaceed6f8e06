"""The requests of workers: attaches, turns and heartbeats, judged as they are answered.

A turn is compared with the one that the turn before and its actions lead to.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from conformance.oracle.history.expectations.assignments import (
    judge_assigned,
    judge_nothing_left,
)
from conformance.oracle.history.expectations.expected_turn import (
    ABSENT,
    Expectation,
    PlayedActions,
    PlayedChunk,
    execute,
    expectations,
    expected_observations,
    expected_states,
    result_differences,
    value_at,
)
from conformance.oracle.history.expectations.submitted import judge_episode
from conformance.oracle.history.facts.run_knowledge import RunKnowledge
from conformance.oracle.history.facts.seen_exchange import (
    UNKNOWN,
    Difference,
    SeenExchange,
    is_same,
    name_of_difference,
)
from conformance.oracle.history.facts.seen_session import (
    LEASE_TOLERANCE_S,
    SeenSession,
    SeenTurn,
)

_TIMER_S = 0.002  # so early a timer may end
_ROUNDING_S = 5e-6
_PARTS = ("queue_s", "simulate_s", "render_s", "encode_s")
_OF_TURN_0: list[Expectation] = [
    ("seq", 0, ("ATT-001", "ATT-019", "ATT-022")),
    ("executed_steps", 0, ("ATT-022", "ATT-001")),
    ("rewards", [], ("ATT-022", "ATT-001")),
    ("terminated", False, ("ATT-022",)),
    ("truncated", False, ("ATT-022",)),
    ("observations", ABSENT, ("ATT-022",)),
    ("episode_result", ABSENT, ("ATT-022",)),
]


class SessionRequests:
    """Judges the requests of the sessions of one run."""

    def __init__(self, facts: RunKnowledge) -> None:
        self._facts = facts

    # --- attach ---

    def judge_attach(self, seen: SeenExchange) -> Iterator[Difference]:
        """Judge an attach, and store the session that it opened."""
        facts = self._facts
        if seen.may_have_effect:
            facts.attaches.append(seen)
        if not seen.is_success:
            return
        turn = seen.value
        session = facts.sessions.get(turn["session_id"])
        if session is not None:
            yield from self._attach_again(session, seen)
            return
        worker, key = seen.params.get("worker_id", ""), seen.request.get("attach_key")
        session = SeenSession(turn["session_id"], worker, str(key), seen)
        session.is_unknown = seen.body is UNKNOWN or turn["seq"] != 0
        old = self._surely_taken_over(worker, seen)
        yield from self._not_beside(session, seen)
        for earlier in facts.sessions.values():
            if earlier.worker == worker:
                earlier.ends.append((seen, "ATT-005"))
                session.ends += facts.perhaps_after(seen, [earlier.opened], "ATT-005")
        session.ends += facts.perhaps_after(seen, facts.aborts, "STOP-002")
        if seen.body is not UNKNOWN:
            yield from self._compare(_OF_TURN_0, seen)
        played = None
        if "episode" in turn and facts.is_calibration:
            played = facts.attempts.at(turn["episode"])
        session.add(turn["seq"], SeenTurn({}, seen, played))
        facts.sessions[session.id] = session
        if "episode" in turn:
            yield from self._first_episode(session, seen, old, played)
        elif turn["done"]:
            yield from judge_nothing_left(facts, session, seen)
        else:
            rules, text = ("ATT-012", "PRED-009"), "`done` in a turn without `episode`"
            yield Difference(rules, text, "`done` false", seen)

    def _attach_again(
        self, session: SeenSession, seen: SeenExchange
    ) -> Iterator[Difference]:
        """Judge an attach that returns a session which was opened before."""
        worker, key = seen.params.get("worker_id"), seen.request.get("attach_key")
        if seen.body is UNKNOWN:
            return
        if (worker, key) != (session.worker, session.key):
            text = f"a session of worker {worker!r} with attach_key {key!r}"
            observed = f"that of {session.worker!r} with {session.key!r}"
            rules, witness = ("ATT-018", "ATT-020", "ATT-004"), session.opened
            yield Difference(rules, text, observed, seen, witness)
            return
        yield from self._after_end(session, seen)
        is_settled = self._facts.is_settled(session, seen)
        session.note(seen, -1)
        latest = session.last.observation
        self._facts.exercised.update(("ATT-002", "ATT-018"))
        if not is_settled or seen.media_type != latest.media_type:
            return
        stored, again = _without_times(latest.value), _without_times(seen.value)
        if not is_same(stored, again):
            name = name_of_difference(stored, again)
            text = f"the latest turn again, with `{name}` {stored.get(name)!r}"
            observed = f"`{name}` {again.get(name)!r}"
            yield Difference(("ATT-002", "ATT-016"), text, observed, seen, latest)

    def _not_beside(self, new: SeenSession, seen: SeenExchange) -> Iterator[Difference]:
        """Judge a new session by the others that surely live."""
        facts = self._facts
        alive = [
            session
            for session in facts.sessions.values()
            if not session.is_done
            and facts.is_settled(session, seen)
            and facts.surely_lives(session, seen)
        ]
        for old in alive:
            if old.worker != new.worker:
                continue
            is_first, is_same = old.opened.is_surely_before(seen), old.key == new.key
            is_taken = any(a.request.get("takeover") for a in (seen, old.opened))
            is_taken &= not (is_first and (is_same or not seen.request.get("takeover")))
            if not is_taken:
                same = ("ATT-002", "ATT-016", "ATT-018")
                other = ("ATT-003", "ATT-008", "ATT-018", "ATT-002")
                text = "no second session of a worker that is live"
                wrong = same if is_same else other
                yield Difference(wrong, text, "another session", seen, old.opened)
        others = [session for session in alive if session.worker != new.worker]
        limit = facts.views.latest().get("max_workers")
        if limit is not None and len(others) >= limit and not seen.value["done"]:
            text = f"`worker_limit`: {len(others)} other workers hold all slots"
            rules, witness = ("ATT-006", "ATT-007"), others[-1].opened
            yield Difference(rules, text, "a session", seen, witness)

    def _surely_taken_over(self, worker: str, seen: SeenExchange) -> SeenSession | None:
        """Give the session that an attach with `takeover` surely continues."""
        facts = self._facts
        of_worker = [s for s in facts.sessions.values() if s.worker == worker]
        if seen.request.get("takeover") is not True or not of_worker:
            return None
        old = max(of_worker, key=lambda session: session.opened.started_at)
        is_alone = all(
            attach is seen or (attach.status and attach.is_surely_before(seen))
            for attach in facts.attaches_of(worker)
        )
        is_last = all(
            session is old or session.opened.is_surely_before(old.opened)
            for session in of_worker
        )
        if not (is_alone and is_last) or old.is_done:
            return None
        is_sure = facts.is_settled(old, seen) and facts.surely_lives(old, seen)
        return old if is_sure else None

    def _first_episode(
        self,
        session: SeenSession,
        seen: SeenExchange,
        old: SeenSession | None,
        played: PlayedActions | None,
    ) -> Iterator[Difference]:
        """Judge the episode of turn 0, which `old` played if it is not None."""
        facts, episode = self._facts, seen.value["episode"]
        yield from self._shown(seen)
        due: list[Expectation] = []
        facts.exercised.update(("ATT-007", "ATT-008", "ATT-020"))
        if facts.is_calibration:
            due += expected_states("observation", played, episode["step"])
        witness = None
        if old is not None:
            rules: tuple[str, ...] = ("ATT-004", "ATT-019", "ATT-020")
            witness = old.last.observation
            shown = old.last.value["episode"]
            names = ("index", "attempt", "step", "episode_id")
            due += [(f"episode.{name}", shown[name], rules) for name in names]
        is_new = seen.body is not UNKNOWN and not seen.request.get("takeover")
        if is_new:
            due.append(("episode.step", 0, ("ATT-001",)))
            yield from judge_assigned(facts, session, episode["index"], seen)
        yield from self._compare(due, seen, witness)

    # --- requests with a session id ---

    def judge(self, seen: SeenExchange) -> Iterator[Difference]:
        """Judge a turn, a heartbeat or a detach."""
        facts, worker = self._facts, seen.params.get("worker_id")
        name = seen.request.get("session_id", seen.query.get("session_id"))
        session = facts.sessions.get(str(name))
        if session is None or session.worker != worker:
            if seen.body is UNKNOWN:
                for other in facts.sessions.values():
                    other.is_unknown |= other.worker == worker
            return
        seq = seen.request.get("seq", -1)
        seq = int(seq) if isinstance(seq, int | float) else -1
        if seen.operation == "predict":
            yield from self._predict(session, seq, seen)
        elif seen.is_success and seen.operation == "heartbeat":
            yield from self._after_end(session, seen)
        elif seen.is_success:
            yield from self._detached_by_another(session, seen)
        # A refused request uses up no seq (PRED-024), nor does one after the session.
        if seen.is_success or (
            seen.may_have_effect and facts.reason_of_end(session, seen) is None
        ):
            session.note(seen, seq)
        if seen.operation == "detach_worker" and seen.may_have_effect:
            session.ends.append((seen, "DET-001"))

    def _detached_by_another(
        self, session: SeenSession, seen: SeenExchange
    ) -> Iterator[Difference]:
        """Judge the detach of a session that another live one has superseded."""
        first = min(session.ends, key=lambda e: e[0].started_at, default=None)
        if first is None or first[1] != "ATT-005":
            return
        if session.is_done or first[0].request.get("takeover") is not True:
            return
        length_s = self._facts.idle_timeout_s or 0.0
        is_first = session.opened.is_surely_before(first[0])
        is_first &= first[0].is_surely_before(seen)
        is_first &= first[0].ended_at < session.least_end(length_s)
        is_held = any(
            other.worker == session.worker
            and not (other is session or other.is_done)
            and self._facts.surely_lives(other, seen)
            for other in self._facts.sessions.values()
        )
        if is_first and is_held:
            text = "`session_superseded`: its worker has another live session"
            yield Difference(("ATT-005",), text, "204", seen, first[0])

    def _predict(
        self, session: SeenSession, seq: int, seen: SeenExchange
    ) -> Iterator[Difference]:
        if not seen.is_success:
            is_over = self._facts.reason_of_end(session, seen) is not None
            if seen.may_have_effect and not is_over:
                episode = session.last.value.get("episode")
                self._facts.attempts.taint(episode)
            return
        due = [("session_id", session.id, ("PRED-001",)), ("seq", seq, ("PRED-001",))]
        yield from self._compare(due, seen)
        yield from self._after_end(session, seen)
        if seq in session.turns:
            stored, shown = session.turns[seq].value, ["PRED-002", "PRED-025"]
            shown += ["PRED-010"] * stored["done"] + ["FAULT-011"] * ("fault" in stored)
            self._facts.exercised.update(shown)
            yield from session.judge_repeat(seq, seen)
        elif seq > session.last_seq:
            yield from self._new_turn(session, seq, seen)
        elif session.last.observation.is_surely_before(seen):
            yield _out_of_order(session, seq, seen)

    def _new_turn(
        self, session: SeenSession, seq: int, seen: SeenExchange
    ) -> Iterator[Difference]:
        before = session.turns.get(seq - 1)
        if before is None:
            sent = session.highest_seq_sent(seen.ended_at)
            beside = [o.request.get("seq") for o in self._facts.open.values()]
            if sent < seq - 1 not in beside and not session.is_unknown:
                yield _out_of_order(session, seq, seen)
            session.add(seq, SeenTurn(seen.request, seen))
            yield from self._shown(seen)
        elif before.value["done"]:
            text, witness = "`no_episode` after a `done` turn", before.observation
            yield Difference(("PRED-011",), text, "status 200", seen, witness)
        elif self._is_predictable(before, seen):
            yield from self._next_turn(session, seq, before, seen)
        else:
            self._facts.attempts.taint(before.value["episode"])
            session.add(seq, SeenTurn(seen.request, seen))
            yield from self._shown(seen)
            yield from self._own_fault(before, seen)

    def _is_predictable(self, before: SeenTurn, seen: SeenExchange) -> bool:
        """Whether the actions decide the turn: none with a fault of its own."""
        actions = seen.request.get("actions")
        if not self._facts.is_calibration or not isinstance(actions, list):
            return False
        is_of_fault = before.value["episode"]["task"] == "fault"
        return "fault" not in seen.value or (is_of_fault and _commands_fault(actions))

    def _own_fault(self, before: SeenTurn, seen: SeenExchange) -> Iterator[Difference]:
        """Judge a fault in a task whose actions cause none."""
        task, actions = before.value["episode"]["task"], seen.request.get("actions")
        if not self._facts.is_calibration or not isinstance(actions, list):
            return
        if "fault" in seen.value and task != "fault" and _commands_fault(actions):
            text = f"no fault in the task {task}"
            yield Difference(("CAL-010",), text, "a turn with `fault`", seen)

    def _next_turn(
        self, session: SeenSession, seq: int, before: SeenTurn, seen: SeenExchange
    ) -> Iterator[Difference]:
        """Judge a turn that follows a known one."""
        facts, turn, episode = self._facts, seen.value, before.value["episode"]
        chunk = execute(before.played, episode, seen.request["actions"])
        due = [*expectations(chunk, episode, facts.success_rule, turn)]
        if seen.request.get("observe") == "all":
            due += expected_observations(chunk)
        if chunk.is_end and chunk.after is not None and "episode_result" in turn:
            due += result_differences(turn["episode_result"], chunk.after)
        played = PlayedActions() if chunk.is_end else chunk.after
        if not chunk.is_end and played is not None and not chunk.is_fault:
            facts.attempts.add(episode, played)
        if "episode" in turn and turn["episode"]["step"] == 0:
            facts.attempts.at(turn["episode"])
        session.add(seq, SeenTurn(seen.request, seen, played))
        yield from self._compare(due, seen, before.observation)
        yield from self._times(chunk, episode, seen)
        yield from self._shown(seen)
        yield from self._after_episode(session, chunk, seen)

    def _after_episode(
        self, session: SeenSession, chunk: PlayedChunk, seen: SeenExchange
    ) -> Iterator[Difference]:
        """Judge what a turn assigns when an episode has ended."""
        turn = seen.value
        if chunk.is_end and "episode" in turn:
            index = turn["episode"]["index"]
            yield from judge_assigned(self._facts, session, index, seen)
        elif chunk.is_end and turn["done"]:
            yield from judge_nothing_left(self._facts, session, seen)
        if turn["done"] and ("episode" in turn or "observation" in turn):
            text = "a `done` turn without `episode` and `observation`"
            yield Difference(("PRED-008",), text, f"members {sorted(turn)}", seen)

    def _shown(self, seen: SeenExchange) -> Iterator[Difference]:
        """Judge the episodes that a turn shows, whatever led to it."""
        turn, episodes = seen.value, self._facts.episodes
        if "episode" in turn:
            yield from episodes.judge_shown(turn["episode"], seen)
            yield from judge_episode(self._facts, turn["episode"], seen)
        if "episode_result" in turn:
            self._facts.exercised["EPI-005"] += 1
            yield from episodes.judge_result(turn["episode_result"], seen)
            yield from judge_episode(self._facts, turn["episode_result"], seen)
        shown = {**turn, **turn.get("episode", {})}
        if "seed" in shown:
            text = "no seed of an episode without a result"
            yield Difference(("EPI-007",), text, f"seed {shown['seed']}", seen)

    def _times(
        self, chunk: PlayedChunk, episode: Mapping[str, Any], seen: SeenExchange
    ) -> Iterator[Difference]:
        """Judge how long a turn took, and how it says that it spent the time."""
        delays = [values["delay_s"][0] for values in chunk.executed]
        seq, session = seen.value["seq"], self._facts.sessions[seen.value["session_id"]]
        took_s = seen.ended_at - self._facts.first_sent_at(session, seq, seen)
        self._facts.exercised["CAL-004"] += episode["task"] == "delay"
        if episode["task"] == "delay" and took_s < sum(delays) - _TIMER_S:
            text, observed = f"a turn of {sum(delays):.3f} s or more", f"{took_s:.3f} s"
            yield Difference(("CAL-004",), text, observed, seen)
        timing = seen.value["timing"]
        parts = sum(timing.get(name, 0.0) for name in _PARTS)
        self._facts.exercised["PRED-023"] += 1
        if parts > timing.get("total_s", parts) + _ROUNDING_S:
            text = f"parts of at most total_s {timing['total_s']}"
            yield Difference(("PRED-023",), text, f"parts of {parts}", seen)

    def _compare(
        self,
        due: Iterable[Expectation],
        seen: SeenExchange,
        witness: SeenExchange | None = None,
    ) -> Iterator[Difference]:
        """Compare an answer with what it has to have; give one difference a rule."""
        broken = set[str]()
        for path, expected, rules in due:
            observed = value_at(seen.value, path)
            self._facts.exercised.update(rules)
            if rules[0] not in broken and not is_same(observed, expected):
                broken.add(rules[0])
                text = f"`{path}` {expected!r}"
                yield Difference(rules, text, f"`{path}` {observed!r}", seen, witness)

    # --- the end of a session ---

    def _after_end(
        self, session: SeenSession, seen: SeenExchange
    ) -> Iterator[Difference]:
        """Judge a success of a session that had surely ended, or was superseded."""
        if session.is_unknown:
            return
        for end, rule in session.ends:
            is_other = end.is_success and end.is_surely_before(seen)
            is_kept = session.is_done and rule != "DET-001"
            is_kept |= not session.opened.is_surely_before(end)
            if is_other and not is_kept:
                text = "a refusal of a session that has ended or was taken over"
                yield Difference((rule,), text, "status 200", seen, end)
                return
        yield from self._after_lease(session, seen)

    def _after_lease(
        self, session: SeenSession, seen: SeenExchange
    ) -> Iterator[Difference]:
        facts = self._facts
        is_extended = any(
            attach.status is None for attach in facts.attaches_of(session.worker)
        )
        is_asked = any(
            beside.params.get("worker_id") == session.worker
            for beside in facts.open.values()
        )
        length_s = facts.idle_timeout_s
        if length_s is None or is_extended or is_asked:
            return
        end_at = session.latest_end(length_s, seen.started_at)
        if seen.started_at > end_at + LEASE_TOLERANCE_S:
            text = f"`session_ended`: nothing was answered for {length_s:g} s"
            late_s = seen.started_at - end_at + length_s
            observed = f"status 200 after {late_s:.2f} s"
            yield Difference(("LEASE-001", "LEASE-008"), text, observed, seen)


def _out_of_order(session: SeenSession, seq: int, seen: SeenExchange) -> Difference:
    text = f"`seq_out_of_order` for seq {seq} after {session.last_seq}"
    witness = session.last.observation
    return Difference(("PRED-004",), text, "status 200", seen, witness)


def _commands_fault(actions: list[Any]) -> bool:
    return any(action["values"]["fault"][0] >= 1 for action in actions)


def _without_times(turn: Mapping[str, Any]) -> dict[str, Any]:
    return {k: v for k, v in turn.items() if k not in ("lease", "timing")}
