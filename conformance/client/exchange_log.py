"""What was said on the wire: exchanges with bounded sizes and without tokens.

A journal belongs to one check. It is written by `wire` and read by the reports,
which print it as curl commands.
"""

import threading
from dataclasses import asdict, dataclass, field
from typing import Any

from conformance.verdicts.expect import SetUpFailed

_BODY_BYTES_STORED = 4096
_EXCHANGES_STORED = 120
_EXCHANGES_MAX = 1500


@dataclass
class Exchange:
    """One request and its answer, or the reason why there was none."""

    number: int
    correlation_id: str
    method: str
    url: str
    token_name: str | None
    request_headers: dict[str, str]
    request_body: bytes
    request_size: int | None
    status: int | None = None
    answer_headers: dict[str, str] = field(default_factory=dict)
    answer_body: bytes = b""
    error: str | None = None
    started_at: float = 0.0
    elapsed_s: float = 0.0

    def as_plain(self) -> dict[str, Any]:
        """Give it as JSON-ready data; bytes become text that survives JSON."""
        plain = asdict(self)
        for name in ("request_body", "answer_body"):
            plain[name] = plain[name].decode("latin-1")
        return plain

    @classmethod
    def from_plain(cls, plain: dict[str, Any]) -> "Exchange":
        """Undo `as_plain`."""
        bodies = {
            name: plain[name].encode("latin-1")
            for name in ("request_body", "answer_body")
        }
        return cls(**(plain | bodies))


class ExchangeLog:
    """The exchanges of one check, in order; safe for several threads."""

    def __init__(self, name: str) -> None:
        self.name = name
        self.exchanges: list[Exchange] = []
        self.dropped = 0
        self._lock = threading.Lock()
        self._count = 0

    def next_number(self) -> int:
        """Count one exchange more; too many mean that the check is led in circles."""
        with self._lock:
            self._count += 1
            if self._count > _EXCHANGES_MAX:
                raise SetUpFailed(f"no end in sight after {_EXCHANGES_MAX} requests")
            return self._count

    def add(self, exchange: Exchange) -> None:
        """Keep an exchange; of very many, the first half and the latest."""
        exchange.request_body = exchange.request_body[:_BODY_BYTES_STORED]
        exchange.answer_body = exchange.answer_body[:_BODY_BYTES_STORED]
        with self._lock:
            self.exchanges.append(exchange)
            if len(self.exchanges) > _EXCHANGES_STORED:
                del self.exchanges[_EXCHANGES_STORED // 2]
                self.dropped += 1
