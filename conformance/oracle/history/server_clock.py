"""The clock of the server beside that of the client, as an interval.

`server_time` of `describe_service` was read between sending and answering. So the
difference of the clocks lies in an interval, and so does each time that an answer has.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from conformance.oracle.history.facts.seen_exchange import Difference, SeenExchange
from conformance.oracle.history.facts.views_of_run import instant_of

_ACCURACY_S = 1.0  # of RUN-020 and LEASE-009
# The clocks of two machines part by less than that in a run of the kit.
_DRIFT_S = 0.1


@dataclass
class ServerClock:
    """Server time minus client time: at least `least_s`, at most `most_s`."""

    least_s: float | None = None
    most_s: float = 0.0

    def note(self, seen: SeenExchange) -> None:
        """Take the server's time from an answer."""
        now = instant_of(seen.value["server_time"])
        least_s, most_s = now - seen.ended_at, now - seen.started_at
        if self.least_s is not None:
            narrow = max(self.least_s, least_s), min(self.most_s, most_s)
            if narrow[0] <= narrow[1]:
                least_s, most_s = narrow
        self.least_s, self.most_s = least_s, most_s

    def _is_outside(self, instant: float, seen: SeenExchange) -> bool:
        if self.least_s is None:
            return False
        least = seen.started_at + self.least_s - _ACCURACY_S - _DRIFT_S
        most = seen.ended_at + self.most_s + _ACCURACY_S + _DRIFT_S
        return not least <= instant <= most

    def judge_created(self, seen: SeenExchange) -> Iterator[Difference]:
        """Judge `created_at` in the answer that made the run."""
        text = seen.value["created_at"]
        if self._is_outside(instant_of(text), seen):
            due = "created_at within 1 s of the submit, by the clock of `server_time`"
            yield Difference(("RUN-020",), due, f"created_at {text}", seen)

    def judge_lease(
        self, seen: SeenExchange, idle_timeout_s: float, lives_until: float
    ) -> Iterator[Difference]:
        """Judge a lease in an answer, which may not be a repeat.

        lives_until: the time at which LIM-006 ends the session at the latest.
        """
        lease: Any = seen.value.get("lease", seen.value)
        if lease["idle_timeout_s"] != idle_timeout_s:
            text = f"idle_timeout_s {idle_timeout_s:g} as the run has it"
            observed = f"idle_timeout_s {lease['idle_timeout_s']}"
            yield Difference(("LEASE-009",), text, observed, seen)
        began = instant_of(lease["expires_at"]) - idle_timeout_s
        if lives_until < seen.ended_at + idle_timeout_s + _ACCURACY_S:
            return
        if self._is_outside(began, seen):
            text = "expires_at within 1 s of the response plus idle_timeout_s"
            observed = f"expires_at {lease['expires_at']}"
            yield Difference(("LEASE-009",), text, observed, seen)

    def judge_finished(self, seen: SeenExchange) -> Iterator[Difference]:
        """Judge `finished_at` in the turn that ended an episode."""
        result = seen.value.get("episode_result")
        if result is None:
            return
        text = result["finished_at"]
        if self._is_outside(instant_of(text), seen):
            due = "finished_at within 1 s of the result, by the clock of `server_time`"
            yield Difference(("RUN-020",), due, f"finished_at {text}", seen)
