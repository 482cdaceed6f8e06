"""The reference server without the profiles that ONLY_PROFILES does not name.

`ONLY_PROFILES=core,lists python -m tests.support.kit.server_of_profiles`. Operations,
fields, values and headers of other profiles are unknown to it, as levels.md has it. Its
description of `calibration` is that of the whole benchmark. UP_TO_STAGE=3 makes
not_found of the operations that later stages add.
"""

import dataclasses
import functools
import json
import os
import sys
from collections.abc import Awaitable, Callable
from typing import Any

from starlette.responses import Response

from conformance.specification.document import load_spec
from conformance.specification.profile_fields import profiles_used
from conformance.specification.stages import LAST, stage_of_operation
from reference_server.__main__ import main
from reference_server.http.codec import JSON
from reference_server.http.dispatch import Operation, OperationCall
from reference_server.http.handlers import Handlers
from reference_server.rules.refusal import Refused
from tests.mutants import put

Handler = Callable[[OperationCall], Awaitable[Response]]
STAGE = int(os.environ.get("UP_TO_STAGE", LAST))
ANNOUNCED = {"core", *os.environ.get("ONLY_PROFILES", "").split(",")} - {""}
# operation → fields of profiles that build on Service
FIELDS = {
    "submit_run": {
        "select": "subsets",
        "any_policy": "attribution",
        "mode": "push",
        "policy_server": "push",
    },
    "attach_worker": {"player": "attribution", "first_episodes": "subsets"},
    "heartbeat": {"reason": "reasons"},
    "stop_run": {"reason": "reasons"},
}
HEADERS = {
    "if-none-match": "waiting",
    "prefer": "waiting",
    "idempotency-key": "submit_once",
    "last-event-id": "events",
}


def require_known(name: str, body: Any) -> None:
    """Raise Refused if a body has a field or a value of a profile that is missing."""
    own = FIELDS.get(name, {})
    used = [*profiles_used(name, body), *((f"/{k}", own[k]) for k in own if k in body)]
    if "sealed" in (body.get("options") or {}):
        used.append(("/options/sealed", "sealed_seeds"))
    for pointer, profile in used:
        if profile not in ANNOUNCED:
            errors = [(pointer, "unknown")]
            raise Refused("invalid_request", "Unknown.", errors=errors)


def announced(response: Response) -> Response:
    """Give the description of a service of these profiles."""
    service = json.loads(bytes(response.body)) | {"profiles": sorted(ANNOUNCED)}
    headers = {k: v for k, v in response.headers.items() if k != "content-length"}
    return Response(json.dumps(service), response.status_code, headers)


def stripped(name: str, handler: Handler) -> Handler:
    @functools.wraps(handler)
    async def handle(call: OperationCall) -> Response:
        if stage_of_operation(name) > STAGE:
            raise Refused("not_found", "Not written yet.")
        if call.raw[:1] == b"{":
            require_known(name, json.loads(call.raw))
        response = await handler(call)
        if "waiting" not in ANNOUNCED and "etag" in response.headers:
            del response.headers["etag"]
        return announced(response) if name == "describe_service" else response

    return handle


def stripped_operation(operation: Operation) -> Operation:
    headers = tuple(
        name for name in operation.headers if HEADERS.get(name, "core") in ANNOUNCED
    )
    handler = stripped(operation.handler.__name__, operation.handler)
    operation = dataclasses.replace(operation, handler=handler, headers=headers)
    if JSON in operation.reads and "msgpack" not in ANNOUNCED:
        operation = dataclasses.replace(operation, reads=(JSON,))
    if JSON in operation.writes and "msgpack" not in ANNOUNCED:
        operation = dataclasses.replace(operation, writes=(JSON,))
    return operation


def stripped_table(handlers: Handlers) -> dict[str, dict[str, Operation]]:
    table: dict[str, dict[str, Operation]] = {}
    for path, operations in whole_table(handlers).items():
        for method, operation in operations.items():
            name = operation.handler.__name__
            if load_spec().operations[name].profile in ANNOUNCED:
                table.setdefault(path, {})[method] = stripped_operation(operation)
    return table


whole_table = Handlers.table

if __name__ == "__main__":
    put(Handlers, "table", stripped_table)
    sys.exit(main())
