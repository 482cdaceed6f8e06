"""uvicorn's HTTP/1.1 connection, as far as this server builds on it.

uvicorn offers no way to bound what a connection may send, so `bounded_connection.py` is
a subclass of the class that reads and answers requests. uvicorn does not promise that
class to anyone: this file owns the dependency. Everything that is used of it is listed
here, and is looked for when the server starts; `tests/server/http/connections/` plays
against the rest of its behaviour, so run these before another release is allowed.

Used of `HttpToolsProtocol`
    its constructor (config, server_state, app_state, _loop);
    overridden and called: connection_made, connection_lost, on_message_begin,
    on_headers_complete, on_body, on_message_complete, pause_writing, resume_writing;
    overridden and not called: data_received, on_header, on_response_complete,
    _unsupported_upgrade_warning;
    called by uvicorn on it, and left as it is: shutdown, on_url;
    read: loop, transport, flow, client, parser, url, headers, cycle, server_state;
    set: url, expect_100_continue.

Used of its `cycle`, one request and its answer
    read: response_started, response_complete, keep_alive;
    set: transport, body, keep_alive, disconnected; called: message_event.set.

Used of its `flow`
    pause_reading, resume_reading, read_paused, write_paused.

Used besides
    STATUS_LINE: status → the first line of an answer. ServerState.total_requests.
"""

from __future__ import annotations

import inspect
from collections.abc import Iterable

import uvicorn
from uvicorn.protocols.http import flow_control, httptools_impl
from uvicorn.protocols.http.httptools_impl import STATUS_LINE, HttpToolsProtocol
from uvicorn.server import ServerState

__all__ = ["STATUS_LINE", "HttpToolsProtocol", "ServerState"]

# The releases (major, minor) whose behaviour the tests have seen.
TESTED_RELEASES = ("0.54",)

_METHODS = (
    *("connection_made", "connection_lost", "data_received", "shutdown"),
    *("on_message_begin", "on_url", "on_header", "on_headers_complete", "on_body"),
    *("on_message_complete", "on_response_complete", "pause_writing"),
    *("resume_writing", "_unsupported_upgrade_warning"),
)
# Each class with the names that its constructor sets, or that the class has.
_MEMBERS: dict[str, tuple[type, Iterable[str]]] = {
    "HttpToolsProtocol": (
        HttpToolsProtocol,
        (
            *_METHODS,
            *("loop", "transport", "flow", "client", "parser", "headers", "cycle"),
            *("server_state", "expect_100_continue"),
        ),
    ),
    "RequestResponseCycle": (
        httptools_impl.RequestResponseCycle,
        (
            *("response_started", "response_complete", "keep_alive", "transport"),
            *("body", "disconnected", "message_event"),
        ),
    ),
    "FlowControl": (
        flow_control.FlowControl,
        ("pause_reading", "resume_reading", "read_paused", "write_paused"),
    ),
}
_ARGUMENTS = ["self", "config", "server_state", "app_state", "_loop"]


class WrongUvicorn(ImportError):
    """The installed uvicorn is not one that this server can build on."""


def check_uvicorn(version: str = uvicorn.__version__) -> None:
    """Raise WrongUvicorn unless the release is a tested one with all of these names."""
    if ".".join(version.split(".")[:2]) not in TESTED_RELEASES:
        raise WrongUvicorn(
            f"uvicorn {version} is installed, and this server builds on names of its "
            f"HTTP connection that are tested with {', '.join(TESTED_RELEASES)} alone: "
            f"install uvicorn=={TESTED_RELEASES[-1]}.*"
        )
    missing = [
        f"{of}.{name}"
        for of, (owner, names) in _MEMBERS.items()
        for name in names
        if not (
            hasattr(owner, name) or name in vars(owner)["__init__"].__code__.co_names
        )
    ]
    if list(inspect.signature(HttpToolsProtocol.__init__).parameters) != _ARGUMENTS:
        missing.append(f"HttpToolsProtocol({', '.join(_ARGUMENTS)})")
    if missing:
        raise WrongUvicorn(
            f"uvicorn {version} has no {', '.join(missing)}: this server builds on "
            "them (reference_server/http/connections/uvicorn_protocol.py)"
        )


check_uvicorn()
