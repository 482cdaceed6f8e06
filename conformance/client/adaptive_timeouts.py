"""Timeouts for a state or for capacity, which get shorter after each miss."""

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
