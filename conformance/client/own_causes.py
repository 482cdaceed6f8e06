"""Effects that a check itself causes: leases that it lets end, quotas that it uses up.

A server with short leases or small quotas must end them and refuse, so an ended lease
or a refusal proves no violation. It does prove one where the check chose the lease
itself to see it end, or means to use the quota up; but even then a step of its set-up
may have come too late.
"""

import math
import threading
import time
from collections.abc import Mapping
from typing import Any

from conformance.exchanges.answer import Answer
from conformance.verdicts.expect import Inconclusive, SetUpFailed, Violation

# Operations of an account that has no room, and the rules that are about that.
_COUNTED = frozenset({"submit_run", "resume_run"})
_RULES_OF_QUOTAS = ("LIM-007", "LIM-009", "LIM-010")


class OwnCauses:
    """The effects of the requests of one check; safe for several threads."""

    def __init__(self, heartbeat_s_max: float = math.inf) -> None:
        """Begin without effects.

        heartbeat_s_max: the announced limit of this name, in seconds. Repeats and
            heartbeats keep a session no longer than that without a new turn.
        """
        self._lock = threading.Lock()
        self._heartbeat_s_max = heartbeat_s_max
        self.begin()

    def begin(self) -> None:
        """Forget all effects: the check begins, or begins again."""
        with self._lock:
            self._runs: set[str] = set()  # with the lease that the server chose
            self._leases: dict[str, tuple[float, float]] = {}  # their end, length
            self._own_leases: dict[str, tuple[float, float]] = {}  # that it chose
            self._latest_turns: dict[str, tuple[int, float]] = {}  # seq, time
            self._late_for_s: float | None = None  # the lease that was surely over
            self._quota = ""

    def note(
        self, operation_id: str, sent: Any, run_id: str | None, answer: Answer
    ) -> None:
        """Note an answer to a request; bodies that are not objects prove nothing."""
        with self._lock:
            if operation_id in _COUNTED and answer.code == "quota_exceeded":
                self._quota = str(answer.json.get("detail", ""))
            if not isinstance(sent, Mapping) or not isinstance(answer.json, dict):
                return
            if operation_id == "submit_run" and answer.status == 201:
                if "idle_timeout_s" not in sent:
                    self._runs.add(str(answer.json.get("run_id")))
            elif answer.status == 200:
                is_own = run_id not in self._runs
                self._note_lease(
                    sent, answer, self._own_leases if is_own else self._leases
                )
            elif answer.code == "session_ended":
                self._note_refusal(sent, answer)

    def _note_lease(
        self,
        sent: Mapping[str, Any],
        answer: Answer,
        leases: dict[str, tuple[float, float]],
    ) -> None:
        lease = answer.json.get("lease", answer.json)
        length_s = lease.get("idle_timeout_s") if isinstance(lease, dict) else None
        session_id = answer.json.get("session_id", sent.get("session_id"))
        if isinstance(length_s, int | float) and isinstance(session_id, str):
            at_s, seq = answer.started_at, sent.get("seq", 0)
            latest_seq, turn_at_s = self._latest_turns.get(session_id, (-1, at_s))
            if isinstance(seq, int) and seq > latest_seq:
                turn_at_s = at_s
                self._latest_turns[session_id] = (seq, at_s)
            longest_s = max(self._heartbeat_s_max, length_s)
            end_s = min(at_s + length_s, turn_at_s + longest_s)
            leases[session_id] = (end_s, length_s)

    def _note_refusal(self, sent: Mapping[str, Any], answer: Answer) -> None:
        session_id = sent.get("session_id")
        if isinstance(session_id, str) and session_id in self._own_leases:
            end, length_s = self._own_leases[session_id]
            if answer.ended_at > end:
                self._late_for_s = length_s

    def excuse(
        self, rule: str, error: Violation | SetUpFailed
    ) -> SetUpFailed | Inconclusive | None:
        """Give the verdict that replaces the check's own, if that proves nothing."""
        with self._lock:
            is_step = isinstance(error, SetUpFailed) and error.breaks is None
            if is_step and self._late_for_s is not None:
                return Inconclusive(
                    "a request of the kit came too late to be inside a lease of "
                    f"{self._late_for_s:g} s: this machine is too busy"
                )
            if self._quota and rule not in _RULES_OF_QUOTAS:
                return SetUpFailed(
                    "the account of the kit is at a limit of the server: raise it for "
                    f"this account, or judge with a new one. It says: {self._quota}"
                )
            ends = [lease for lease in self._leases.values() if lease[0] < self._now()]
        if not ends or rule.startswith("LEASE-"):
            return None
        return Inconclusive(
            f"a lease of {min(ends)[1]:g} s, which the server chose, could end before "
            "the check sent its next request: announce a longer `idle_timeout_s_max`"
        )

    @staticmethod
    def _now() -> float:
        return time.monotonic()
