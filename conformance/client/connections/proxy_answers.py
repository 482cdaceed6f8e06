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


_NGINX = re.compile(r"\b(nginx|openresty|tengine)\b", re.IGNORECASE)


def find_nginx(headers: Mapping[str, str]) -> str | None:
    """Give the name of nginx, or of what is built on it, if it passed an answer on.

    It writes its name into the header Server. Unless it is set otherwise, it drops
    headers with an underscore, and keeps event streams until they end.
    """
    match = _NGINX.search(headers.get("server", ""))
    return None if match is None else match[1]
