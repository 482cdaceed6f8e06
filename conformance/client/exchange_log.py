"""The exchanges of one check, in order, with bounded sizes.

The HTTP client adds to the log; the reports print it as curl commands.
"""

import threading

from conformance.client.connections.way_faults import WayFaults
from conformance.exchanges.exchange import Exchange
from conformance.verdicts.expect import SetUpFailed

BODY_BYTES_STORED = 4096
_EXCHANGES_STORED = 120
_EXCHANGES_MAX = 1500
_NUMBERS_PER_ROUND = 100_000


class ExchangeLog:
    """The exchanges of one check, in order; safe for several threads."""

    def __init__(self, name: str, round_number: int = 0) -> None:
        """Begin without exchanges; each round has other numbers for them."""
        self.name = name
        self.exchanges: list[Exchange] = []
        self.dropped = 0
        self.way_faults = WayFaults()
        self._lock = threading.Lock()
        self._count = round_number * _NUMBERS_PER_ROUND
        self.allow_more()

    def next_number(self) -> int:
        """Count one more exchange; too many mean that the check does not terminate."""
        with self._lock:
            self._count += 1
            if self._count > self._limit:
                raise SetUpFailed(
                    f"request limit of the check reached ({_EXCHANGES_MAX})"
                )
            return self._count

    def allow_more(self) -> None:
        """Count from here: what begins now is another of many examples."""
        with self._lock:
            self._limit = self._count + _EXCHANGES_MAX

    def add(self, exchange: Exchange) -> None:
        """Store an exchange; beyond the limit, the first half and the latest remain."""
        exchange.request_body = exchange.request_body[:BODY_BYTES_STORED]
        exchange.answer_body = exchange.answer_body[:BODY_BYTES_STORED]
        with self._lock:
            self.exchanges.append(exchange)
            if len(self.exchanges) > _EXCHANGES_STORED:
                del self.exchanges[_EXCHANGES_STORED // 2]
                self.dropped += 1

    def adopt(self, exchanges: list[Exchange], of: int) -> None:
        """Take up how another check made what this one reads, as evidence.

        of: how many exchanges there were; the others count as left out.
        """
        with self._lock:
            if all(exchange not in self.exchanges for exchange in exchanges):
                self.exchanges[:0] = exchanges
                self.dropped += max(of - len(exchanges), 0)
