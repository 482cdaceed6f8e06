"""Request bodies, read within their bounds; what the bytes mean is not known here."""

from __future__ import annotations

from collections.abc import AsyncIterator

from starlette.requests import Request

from reference_server.rules.refusal import Refused

# So much of an oversized body is read beyond the limit, so that the refusal reaches a
# client that is still sending.
DRAIN_BYTES = 2**28


async def read_body(
    request: Request, max_bytes: int, *, is_control: bool = False
) -> bytes:
    """The request's body; refused when it is larger than `max_bytes` (ERR-005).

    is_control: the bound is that of every operation but `predict` (LIM-008).
    """
    whole = bytearray()  # a list of parts would hold 40 bytes more for each
    size, more = 0, True
    while more and size <= max_bytes + DRAIN_BYTES:
        message = await request.receive()
        if message["type"] == "http.disconnect":
            raise Refused("malformed_body", "The body ended before its Content-Length.")
        more = message.get("more_body", False)
        part: bytes = message.get("body", b"")
        if not more and not size and len(part) <= max_bytes:
            return part  # uncopied: most bodies arrive at once
        size += len(part)
        if size <= max_bytes:
            whole += part
        else:
            whole = bytearray()
    check_size(size, max_bytes, is_control=is_control)
    return bytes(whole)


def check_size(size: int, max_bytes: int, *, is_control: bool) -> None:
    """Raise Refused where a body of so many bytes is too large; as `read_body`."""
    if size > max_bytes:
        raise Refused(
            "body_too_large",
            f"The body exceeds {max_bytes} bytes"
            + (", see limits.max_control_body_bytes." if is_control else "."),
            requirement="LIM-008" if is_control else "ERR-005",
        )


async def stream_body(request: Request) -> AsyncIterator[bytes]:
    """A long body part by part; refused when it ends too early.

    Its reader stops when it is too long: the connection is drained then.
    """
    more = True
    while more:
        message = await request.receive()
        if message["type"] == "http.disconnect":
            raise Refused("malformed_body", "The body ended before its Content-Length.")
        more = message.get("more_body", False)
        yield message.get("body", b"")
