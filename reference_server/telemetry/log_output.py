"""How log lines look: text for people, JSON objects for programs.

Every line that belongs to a request names it: a request keeps the id that it came
with in `X-Request-Id`, or gets one, and everything that it causes is logged under it.
No value breaks a line. It must not know what is logged.
"""

from __future__ import annotations

import json
import logging
import random
import re
from contextvars import ContextVar
from typing import Any, Literal

from uvicorn.config import LOG_LEVELS

from reference_record.texts.timestamps import timestamp

REQUEST_ID: ContextVar[str | None] = ContextVar("request_id", default=None)
ACCESS_LOG = "proctor.access"
_REQUEST_ID = re.compile(rb"[A-Za-z0-9._-]{1,64}")
_PLAIN = re.compile(r"[!#-<>-~]+")


def request_id_of(header: bytes | None) -> str:
    """The id that a request came with, if it is fit for a log line; else a new one.

    A new one names a request in the log, and protects nothing.
    """
    if header is not None and _REQUEST_ID.fullmatch(header):
        return header.decode()
    return f"{random.getrandbits(64):016x}"


def log_event(
    log: logging.Logger, text: str, level: int = logging.INFO, **members: Any
) -> None:
    """Log an event with its members; None are left out."""
    if log.isEnabledFor(level):
        given = {name: value for name, value in members.items() if value is not None}
        log.log(level, text, extra={"members": given})


def log_config(
    level: str, form: Literal["text", "json"], *, access: bool
) -> dict[str, Any]:
    """The argument of `logging.config.dictConfig`: all goes to the standard error."""
    number = LOG_LEVELS[level]
    loggers: dict[str, Any] = {
        name: {"level": number, "handlers": ["stderr"], "propagate": False}
        for name in ("uvicorn", "proctor")
    }
    access_level = logging.INFO if access else logging.CRITICAL
    loggers[ACCESS_LOG] = {"level": access_level}
    loggers["uvicorn.asgi"] = {"filters": ["without_query"]}
    formatter = JsonFormatter if form == "json" else TextFormatter
    return {
        "version": 1,
        "disable_existing_loggers": False,
        "filters": {"without_query": {"()": QueryRemover}},
        "formatters": {"chosen": {"()": formatter}},
        "handlers": {
            "stderr": {
                "class": "logging.StreamHandler",
                "formatter": "chosen",
                "stream": "ext://sys.stderr",
            }
        },
        "loggers": loggers,
        # Others log elsewhere: asyncio what nothing caught, the pool of simulators.
        "root": {"level": max(number, logging.WARNING), "handlers": ["stderr"]},
    }


class QueryRemover(logging.Filter):
    """Removes queries from uvicorn's log, because they contain the ids of sessions."""

    def filter(self, record: logging.LogRecord) -> bool:
        if isinstance(record.args, tuple):
            record.args = tuple(map(_without_query, record.args))
        return True


def _without_query(logged: object) -> object:
    if isinstance(logged, dict) and "query_string" in logged:
        return logged | {"query_string": "<...>"}
    return logged


class TextFormatter(logging.Formatter):
    """`TIME LEVEL LOGGER: MESSAGE name=value …`, and a traceback below."""

    def format(self, record: logging.LogRecord) -> str:
        words = [f"{timestamp(record.created)} {record.levelname:<7} {record.name}:"]
        words.append(_one_line(record.getMessage()))
        words += [f"{name}={_value(value)}" for name, value in _members(record).items()]
        line = " ".join(words)
        if record.exc_info:
            line += f"\n{self.formatException(record.exc_info)}"
        return line


class JsonFormatter(logging.Formatter):
    """Formats a record as one JSON object on one line."""

    def format(self, record: logging.LogRecord) -> str:
        line = {
            "time": timestamp(record.created),
            "level": record.levelname.lower(),
            "logger": record.name,
            "message": record.getMessage(),
            **_members(record),
        }
        if record.exc_info:
            line["traceback"] = self.formatException(record.exc_info)
        return json.dumps(line, default=str)


def _members(record: logging.LogRecord) -> dict[str, Any]:
    members = dict(getattr(record, "members", {}))
    request_id = REQUEST_ID.get()
    if request_id is not None:
        members["request_id"] = request_id
    return members


def _one_line(text: str) -> str:
    return text if text.isprintable() else json.dumps(text)[1:-1]


def _value(value: Any) -> str:
    text = str(value)
    return text if _PLAIN.fullmatch(text) else json.dumps(text)
