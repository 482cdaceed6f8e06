"""Answers that a proxy in front of the server gives in its place.

ERR-001 and VER-001 apply to requests that reached the server. A proxy is known by the
error pages that it writes, never by a status or a media type alone: that the framework
of a server answers 413 in HTML is a violation.
"""

import re
from collections.abc import Mapping

_LONGEST_PAGE = 4096
_PAGES = {
    # nginx and what is built on it; padding for old browsers may follow the page.
    "nginx": re.compile(
        rb"<html>\s*<head><title>[45][0-9]{2} .*<hr><center>"
        rb"(nginx|openresty|Tengine)[^<]*</center>\s*</body>\s*</html>",
        re.DOTALL,
    ),
    "HAProxy": re.compile(
        rb"\s*<html><body><h1>[45][0-9]{2} [A-Za-z -]+</h1>\n[^<]+\n</body></html>\s*"
    ),
}


def find_proxy(status: int, headers: Mapping[str, str], body: bytes) -> str | None:
    """Give the name of the proxy that wrote an answer; None if the server did."""
    if status < 400 or "proctor-version" in headers or len(body) > _LONGEST_PAGE:
        return None
    for name, page in _PAGES.items():
        if page.match(body):
            return name
    return None


# These drop a header whose name has an underscore, unless they are set otherwise.
_DROPS_UNDERSCORES = re.compile(r"\b(nginx|openresty|tengine)\b", re.IGNORECASE)


def find_dropping_proxy(headers: Mapping[str, str]) -> str | None:
    """Give the proxy that passed an answer on and drops headers with an underscore.

    It writes its name into the header Server of what it passes on.
    """
    match = _DROPS_UNDERSCORES.search(headers.get("server", ""))
    return None if match is None else match[1]
