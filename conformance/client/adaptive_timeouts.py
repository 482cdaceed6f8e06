"""Timeouts for a state or for capacity, and pauses between two looks at it."""

import time
from collections import Counter

_TIMEOUT_MIN_S = 0.5
# So often an answer is awaited in full; then for this share of the time before.
_WAITS_IN_FULL, _LATER_SHARE = 2, 0.25


class AdaptiveTimeouts:
    """Timeouts by name, halved after each miss.

    A server that never reaches a state, or an operation that never answers, would
    otherwise cost minutes. A shorter timeout never becomes a verdict against the
    server: it leaves a rule not verified.
    """

    def __init__(self) -> None:
        self._misses: Counter[str] = Counter()

    def of(self, what: str, wanted_s: float) -> float:
        """Give the time to wait for it, in seconds."""
        share: float = 0.5 ** self._misses[what]
        return max(_TIMEOUT_MIN_S, share * wanted_s)

    def record_miss(self, what: str) -> None:
        """Note that the wait was in vain."""
        self._misses[what] += 1

    def of_answer(self, operation_id: str, wanted_s: float) -> float:
        """Give the time to wait for an answer: little after two waits in vain."""
        more = self._misses[operation_id] - _WAITS_IN_FULL
        if more < 0:
            return wanted_s
        return min(wanted_s, max(_TIMEOUT_MIN_S, _LATER_SHARE ** (more + 1) * wanted_s))

    def record_answer(self, operation_id: str) -> None:
        """Note that an operation has answered: its next one is awaited in full."""
        self._misses.pop(operation_id, None)


class GrowingPauses:
    """Pauses between two looks: each is twice the last one, up to the longest."""

    def __init__(self, first_s: float, longest_s: float) -> None:
        self._next_s = first_s
        self._longest_s = longest_s

    def wait(self) -> None:
        """Wait for the next pause."""
        time.sleep(self._next_s)
        self._next_s = min(2 * self._next_s, self._longest_s)
