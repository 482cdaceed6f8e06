"""How the kit reaches a server: its URL, tokens, proxies and certificates are checked.

All of it before the first request, so that no check fails for one of these.
"""

import os

from conformance.client.connections.transport.copied_text import (
    BadToken,
    read_token,
    token_of,
)
from conformance.client.connections.transport.proxy_route import find_route
from conformance.client.connections.transport.server_address import check_base_url
from conformance.client.connections.transport.tls_trust import client_context


def read_base_url(option: str, text: str) -> str:
    """Read a base URL to which a request can be sent, or raise ValueError."""
    try:
        url = check_base_url(text)
    except ValueError as error:
        raise ValueError(f"{option}: {error}") from error
    find_route(url)
    return url


def read_secret(given: str | None, option: str, variable: str) -> str | None:
    """Read a token, or that of the environment. Raises ValueError, never with it."""
    try:
        return read_token(given or "", option) or token_of(variable)
    except BadToken as error:
        raise ValueError(str(error)) from None


def accept_authorities(path: str | None) -> None:
    """Accept the certificates of a file or folder; raises ValueError without any.

    Also for the processes that judge, which inherit the variable.
    """
    if path:
        os.environ["PROCTOR_CA"] = path
    client_context()
