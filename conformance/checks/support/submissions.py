"""Submissions under test: the raw response, and a clean-up of the run."""

from typing import Any

from conformance.client.check_context import CheckContext
from conformance.exchanges.answer import Answer


def submit(context: CheckContext, body: dict[str, Any], **how: Any) -> Answer:
    """Send a body of submit_run unchanged; the run is stopped after the check."""
    answer = context.call("submit_run", json=body, **how)
    if answer.status == 201 and isinstance(answer.json, dict):
        context.adopt(answer.json, how.get("http_client"))
    return answer
