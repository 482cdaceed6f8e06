"""The cookies of a request, read in a time that grows with their length alone.

`http.cookies` reads a quoted value in a time that grows with the square of its length
(CVE-2024-7592, in Python before 3.11.10 and 3.12.6), and anyone can send such a value:
one header of 32 kB would stop the event loop for seconds. Starlette's `Request.cookies`
unquotes with the same function. So nothing else here reads cookies.
"""

from __future__ import annotations

from starlette.requests import Request

# Browsers keep at most a few hundred cookies of a site. Further ones are not read.
COOKIES_MAX = 1000


def read_cookie(request: Request, name: str) -> str:
    """The value of a cookie as it was sent; empty if the request has none of the name.

    The last of several counts. A value in quotes is not unquoted: this server sets none
    that needs them.
    """
    header = request.headers.get("cookie", "")
    for pair in reversed(header.split(";", COOKIES_MAX)[:COOKIES_MAX]):
        sent_name, separator, value = pair.partition("=")
        if separator and sent_name.strip(" \t") == name:
            return value.strip(" \t")
    return ""
