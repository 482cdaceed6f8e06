"""Times as texts of RFC 3339, as everywhere in the standard."""

from __future__ import annotations

from datetime import date, timedelta
from functools import lru_cache


def timestamp(at: float) -> str:
    """RFC 3339 in UTC, to the millisecond, of seconds since 1970 (RUN-020)."""
    second, milliseconds = divmod(int(at * 1000), 1000)
    return f"{_format_second(second)}.{milliseconds:03d}Z"


@lru_cache(maxsize=64)
def _format_second(at: int) -> str:
    """Cached: every turn carries a time, mostly one within few seconds."""
    day, second = divmod(at, 86_400)
    minute, second = divmod(second, 60)
    hour, minute = divmod(minute, 60)
    return f"{_format_day(day)}T{hour:02d}:{minute:02d}:{second:02d}"


@lru_cache(maxsize=64)
def _format_day(day: int) -> str:
    """Cached: episodes are listed by the thousand, of few days."""
    return (date(1970, 1, 1) + timedelta(days=day)).isoformat()
