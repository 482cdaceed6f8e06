"""The cause of a failed connection and its cure, as far as the error itself shows them.

Sentences for errors.py; nothing here is sent or decided.
"""

from __future__ import annotations

import contextlib
import errno
import http.client
from collections.abc import Iterator

from proctor_client import ApiException, ProxyFault
from proctor_client.transport.server_address import place_of_redirection
from urllib3.exceptions import (
    ConnectTimeoutError,
    NewConnectionError,
    ProtocolError,
    ReadTimeoutError,
)


def causes_of(error: BaseException) -> Iterator[BaseException]:
    """The error, and those that it was raised from, the outermost first."""
    inner: BaseException | None = error
    while inner is not None:
        yield inner
        inner = inner.__cause__ or inner.__context__


def is_of_first_hop(error: Exception) -> bool:
    """Whether no connection was made: to the server, or to the proxy before it."""
    kinds = (NewConnectionError, ConnectTimeoutError)
    return any(isinstance(cause, kinds) for cause in causes_of(error))


def is_late_answer(error: Exception) -> bool:
    """Whether a connection was made, and no answer came on it in time."""
    kinds = (ReadTimeoutError, TimeoutError)
    is_timeout = any(isinstance(cause, kinds) for cause in causes_of(error))
    return is_timeout and not is_of_first_hop(error)


def was_cut(error: Exception) -> bool:
    """Whether a connection was made, and ended before the answer was complete."""
    ends = (ConnectionAbortedError, ConnectionResetError, BrokenPipeError)
    kinds = (ProtocolError, *ends)
    is_cut = any(isinstance(cause, kinds) for cause in causes_of(error))
    return is_cut and not is_of_first_hop(error)


def out_of_files(error: Exception) -> str | None:
    """The sentence for a program or a machine that may open no more files."""
    numbers = {getattr(cause, "errno", None) for cause in causes_of(error)}
    if not numbers & {errno.EMFILE, errno.ENFILE}:
        return None
    most = ""
    with contextlib.suppress(ImportError):  # on Windows
        import resource

        most = f" ({resource.getrlimit(resource.RLIMIT_NOFILE)[0]} are its limit)"
    return (
        f"this program can open no more files{most}. Raise the limit, for example "
        "with `ulimit -n 4096` before the command, or take fewer --workers"
    )


def fault_of_proxy(error: Exception) -> ProxyFault | None:
    """The error of the proxy on the way, which no request has passed."""
    faults = (cause for cause in causes_of(error) if isinstance(cause, ProxyFault))
    return next(faults, None)


def line_of_http2(error: Exception) -> str:
    """The bytes that a library took for the first line of an answer, or a text."""
    lines = (
        str(cause)
        for cause in causes_of(error)
        if isinstance(cause, http.client.BadStatusLine)
    )
    return next(lines, "")


def scheme_hint(error: Exception, url: str) -> str:
    """The question whether a server that hangs up on a request speaks TLS."""
    silent = (http.client.BadStatusLine, ConnectionResetError)
    hung_up = any(isinstance(cause, silent) for cause in causes_of(error))
    return " (https:// if it speaks TLS)" if hung_up and url[:5] == "http:" else ""


def speaks_tls(error: ApiException, url: str) -> bool:
    """Whether an answer says that the port is one for TLS, as nginx and Go do."""
    said = f"{error.reason} {error.body}".lower()
    is_refusal = error.status in (400, 497)
    return (
        url[:5] == "http:" and is_refusal and "http request" in said and "https" in said
    )


def where_it_moved(error: ApiException, url: str) -> str | None:
    """The sentence that names the new place of a server, if the answer redirects."""
    if error.location is None:
        return None
    place, is_base = place_of_redirection(url, error.location)
    if is_base:
        return f"The server is at {place} now: use that URL"
    return f"It points to {place}; check that the URL is that of a Proctor server"
