"""How long the kit waits for a state or for capacity: less after each miss."""

from collections import Counter

_TIMEOUT_MIN_S = 0.5


class AdaptiveTimeouts:
    """How long to wait for something: less, the more often it did not come.

    A server that never gets there would otherwise cost minutes. What is lost is never
    a verdict against the server: too little patience leaves a row not verified.
    """

    def __init__(self) -> None:
        self._misses: Counter[str] = Counter()

    def of(self, what: str, wanted_s: float) -> float:
        """Give the time to wait for it, in seconds."""
        share: float = 0.5 ** self._misses[what]
        return max(_TIMEOUT_MIN_S, share * wanted_s)

    def record_miss(self, what: str) -> None:
        """Note that it did not come."""
        self._misses[what] += 1
