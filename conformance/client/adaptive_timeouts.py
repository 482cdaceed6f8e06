"""Timeouts for a state or for capacity, and pauses between two looks at it."""

import time
from collections import Counter

_TIMEOUT_MIN_S = 0.5


class AdaptiveTimeouts:
    """Timeouts by name, halved after each miss.

    A server that never reaches a state would otherwise cost minutes. A timeout never
    becomes a verdict against the server: it leaves a rule not verified.
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


class GrowingPauses:
    """Pauses between two looks: each is twice the last one, up to the longest."""

    def __init__(self, first_s: float, longest_s: float) -> None:
        self._next_s = first_s
        self._longest_s = longest_s

    def wait(self) -> None:
        """Wait for the next pause."""
        time.sleep(self._next_s)
        self._next_s = min(2 * self._next_s, self._longest_s)
