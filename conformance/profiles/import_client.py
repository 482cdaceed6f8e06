"""A record that a check hands in: sent, read, followed to its end, and deleted."""

import time
from typing import Any

from conformance.client.check_context import CheckContext
from conformance.exchanges.answer import Answer
from conformance.verdicts import expect
from conformance.verdicts.expect import Inconclusive

# The replay of few episodes of few steps takes less than a second.
_REPLAY_S = 60.0
_POLL_S = 0.05


def send_record(context: CheckContext, archive: bytes, **how: Any) -> Answer:
    """Hand in an archive; what is made of it is deleted after the check."""
    return context.call("import_record", content=archive, **how)


def accepted(context: CheckContext, archive: bytes) -> dict[str, Any]:
    """Hand in an archive that the rule under test has accepted."""
    body: dict[str, Any] = expect.ok(send_record(context, archive), 202)
    return body


def finished(context: CheckContext, import_id: str) -> dict[str, Any]:
    """Poll until an import is finished."""
    until = time.monotonic() + context.shared.timeouts.of("replay", _REPLAY_S)
    while True:
        body: dict[str, Any] = expect.ok(
            context.call("get_import", import_id=import_id)
        )
        if body["state"] == "finished":
            return body
        if time.monotonic() > until:
            context.shared.timeouts.record_miss("replay")
            raise Inconclusive(f"the import is `{body['state']}` for {_REPLAY_S:g} s")
        time.sleep(_POLL_S)


def listed_ids(context: CheckContext, **how: Any) -> list[str]:
    """Give the ids of `list_imports`, all pages of two."""
    ids: list[str] = []
    cursor = None
    while True:
        params = {"limit": 2} | ({} if cursor is None else {"cursor": cursor})
        page = expect.ok(context.call("list_imports", params=params, **how))
        ids += [one["import_id"] for one in page["imports"]]
        cursor = page["next_cursor"]
        if cursor is None:
            return ids
