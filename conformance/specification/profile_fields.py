"""Which fields and values of requests belong to a profile of Service (levels.md)."""

import functools
from collections.abc import Iterator
from typing import Any

from conformance.specification.ledger import CORE

# operation → JSON pointer → the profile of the field there
FIELDS = {
    "submit_run": {
        "/idle_timeout_s": "sessions",
        "/images": "observations",
        "/options/max_attempts": "sessions",
        "/options/max_faults": "faults",
        "/options/queue_s": "control",
    },
    "attach_worker": {"/takeover": "sessions", "/assumes": "conventions"},
    "predict": {"/observe": "observations"},
}
# operation → header → its profile; a server without it passes the header over
HEADERS = {
    "get_run": {"If-None-Match": "waiting", "Prefer": "waiting"},
    "submit_run": {"Idempotency-Key": "submit_once"},
}
_TASKS = {"echo": "observations", "fault": "faults"}


def profile_of_task(task: str) -> str:
    """The profile that brings a task of calibration."""
    return _TASKS.get(task, CORE)


def profile_of_header(operation_id: str, name: str) -> str:
    """The profile that gives a header of an operation its meaning."""
    return HEADERS.get(operation_id, {}).get(name, CORE)


def profiles_used(operation_id: str, body: dict[str, Any]) -> Iterator[tuple[str, str]]:
    """Give the pointer and the profile of each field or value that is not of Core."""
    for pointer, profile in FIELDS.get(operation_id, {}).items():
        *parents, last = pointer.split("/")[1:]
        if last in functools.reduce(_member, parents, body):
            yield pointer, profile
    if operation_id == "submit_run":
        tasks = _member(body, "options").get("tasks")
        for place, task in enumerate(tasks if isinstance(tasks, list) else []):
            if profile_of_task(str(task)) != CORE:
                yield f"/options/tasks/{place}", profile_of_task(task)
    if operation_id == "stop_run" and body.get("mode") == "drain":
        yield "/mode", "control"


def _member(body: dict[str, Any], name: str) -> dict[str, Any]:
    """The object under a name; an empty one where there is none."""
    value = body.get(name)
    return value if isinstance(value, dict) else {}
