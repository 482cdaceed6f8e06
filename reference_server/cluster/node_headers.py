"""The headers of what nodes send each other, and what they prove.

A node shows with the secret of another one that it is a node; what it says of a client
is believed then. Headers of one connection stay at it.
"""

from __future__ import annotations

import hmac

from starlette.types import Scope

from reference_server.cluster.membership import Membership
from reference_server.outgoing.streamed_exchange import (
    HOP_BY_HOP,
    Headers,
    headers_without,
)
from reference_server.rules.refusal import Refused
from reference_server.storage.node_store import Node
from reference_server.telemetry.log_output import REQUEST_ID
from reference_server.telemetry.spans import traceparent

SECRET_HEADER, CLIENT_HEADER = b"proctor-node-secret", b"proctor-node-client"
# Headers that this node adds to every answer itself.
_ADDED_ANEW = {b"date", b"proctor-version", b"x-request-id"}
_OURS = {SECRET_HEADER, CLIENT_HEADER, b"x-request-id"}
# The other node trusts these headers, so those of clients are not forwarded.
_OF_TRACES = {b"traceparent", b"tracestate"}
_NOT_PASSED_ON = HOP_BY_HOP | _OURS | _OF_TRACES
NOT_SENT_BACK = HOP_BY_HOP | _ADDED_ANEW


def is_from_node(scope: Scope, membership: Membership) -> bool:
    """Whether a node forwarded it; then its header gives the address of the client.

    The headers of any other sender about this are removed. Raises Refused for a request
    that was sent to another node: forwarded again, it might come back without end.
    """
    headers: Headers = scope["headers"]
    sent = {name: value for name, value in headers if name in _OURS}
    if SECRET_HEADER not in sent and CLIENT_HEADER not in sent:
        return False
    kept = (SECRET_HEADER, CLIENT_HEADER)
    scope["headers"] = [pair for pair in headers if pair[0] not in kept]
    secret = sent.get(SECRET_HEADER, b"")
    is_node = hmac.compare_digest(secret, membership.secret.encode())
    if not is_node and membership.is_secret_of_other(secret):
        text = "The request was sent to another node: its node_url leads to this one."
        raise Refused("unavailable", text)
    if is_node:
        scope["client"] = (sent.get(CLIENT_HEADER, b"-").decode("latin-1"), 0)
    return is_node


def has_secret_of(membership: Membership, scope: Scope) -> bool:
    """Whether a node passed it on to this one. Unlike `is_from_node` it only looks."""
    secret = membership.secret.encode()
    return any(
        name == SECRET_HEADER and hmac.compare_digest(value, secret)
        for name, value in scope["headers"]
    )


def request_headers(scope: Scope, node: Node) -> Headers:
    """The headers to send to the other node."""
    client = (scope.get("client") or ("-",))[0]
    return [
        *headers_without(scope, _NOT_PASSED_ON),
        (SECRET_HEADER, node.secret.encode()),
        (CLIENT_HEADER, str(client).encode("latin-1", "replace")),
        (b"x-request-id", (REQUEST_ID.get() or "").encode()),
        *trace_headers(),
    ]


def trace_headers() -> Headers:
    """Headers by which the other node continues the trace of this request."""
    sent = traceparent()
    return [] if sent is None else [(b"traceparent", sent.encode())]
