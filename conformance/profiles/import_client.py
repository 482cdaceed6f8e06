"""A record that a check hands in: sent, read, followed to its end, and deleted."""

import time
from typing import Any

from conformance.client.adaptive_timeouts import GrowingPauses
from conformance.client.check_context import CheckContext
from conformance.exchanges.answer import Answer
from conformance.exchanges.pages import read_pages
from conformance.verdicts import expect
from conformance.verdicts.expect import Inconclusive, SetUpFailed, describe_answer

# The replay of few episodes of few steps takes less than a second.
_REPLAY_S = 60.0
_POLL_S = 0.05
_LONGEST_POLL_S = 0.5
_PAGE_LIMIT = 100


def send_record(context: CheckContext, archive: bytes, **how: Any) -> Answer:
    """Hand in an archive; what is made of it is deleted after the check."""
    return context.call("import_record", content=archive, **how)


def accepted(context: CheckContext, archive: bytes, **how: Any) -> dict[str, Any]:
    """Hand in an archive that the rule under test has accepted.

    A full account proves nothing: it may have imports of others that use it.
    """
    answer = send_record(context, archive, **how)
    if answer.code == "quota_exceeded":
        raise SetUpFailed(f"`import_record`: {describe_answer(answer)}")
    body: dict[str, Any] = expect.ok(answer, 202)
    return body


def finished(context: CheckContext, import_id: str) -> dict[str, Any]:
    """Poll until an import is finished."""
    pauses = GrowingPauses(_POLL_S, _LONGEST_POLL_S)
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
        pauses.wait()


def listed_imports(
    context: CheckContext, limit: int = _PAGE_LIMIT, **how: Any
) -> list[dict[str, Any]]:

    def read(params: dict[str, Any]) -> Any:
        return expect.ok(context.call("list_imports", params=params, **how))

    endless = SetUpFailed("`list_imports` does not end", breaks="REC-120")
    pages = read_pages(read, endless, limit=limit)
    return [record_import for page in pages for record_import in page["imports"]]


def listed_ids(context: CheckContext, **how: Any) -> list[str]:
    """Give the ids of `list_imports`, of all pages."""
    return [listed["import_id"] for listed in listed_imports(context, **how)]
