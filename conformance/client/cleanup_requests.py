"""Requests that take back what a check leaves on a server, for others to see or store.

A public entry would stay in the ranking; an import would count against the account, and
so would a run that stays open.
"""

from collections.abc import Mapping
from typing import Any

from conformance.exchanges.answer import Answer

Request = tuple[str, dict[str, Any]]


def cleanup_after(
    operation_id: str, answer: Answer, path_params: Mapping[str, str]
) -> Request | None:
    """Give the operation that deletes what an answer says was made, with its path.

    If the check has undone it already, the operation is refused, which does no harm.
    """
    if operation_id == "publish_entry" and answer.status == 201:
        return "withdraw_entry", dict(path_params)
    if operation_id == "submit_run" and answer.status == 201:
        body = answer.json
        run_id = body.get("run_id") if isinstance(body, dict) else None
        if isinstance(run_id, str):
            return "stop_run", {"run_id": run_id, "json": {"mode": "abort"}}
    if operation_id == "import_record" and answer.status == 202:
        body = answer.json
        import_id = body.get("import_id") if isinstance(body, dict) else None
        if isinstance(import_id, str):
            return "delete_import", {"import_id": import_id}
    return None
