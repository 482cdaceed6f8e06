"""The body of a request to a server of the kit."""

from http.server import BaseHTTPRequestHandler


def read_body(handler: BaseHTTPRequestHandler) -> bytes:
    """Read a body of the announced length.

    Raises ConnectionAbortedError when the caller leaves before its end, as a stopped
    run does.
    """
    length = int(handler.headers.get("content-length", 0))
    body = handler.rfile.read(length)
    if len(body) < length:
        raise ConnectionAbortedError("the caller left in the middle of a body")
    return body
