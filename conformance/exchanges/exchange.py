"""One HTTP request with its response, as logged: bounded in size, without tokens.

Plain data. The HTTP client writes it; the verdicts and the reports read it.
"""

from dataclasses import asdict, dataclass, field
from typing import Any


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
    leave_after_s: float | None = None  # the client did not wait longer for an answer
    is_judged: bool = False  # its answer, or the lack of one, decided the verdict

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
