"""The cookies of browsers: how they are set, and read in a bounded time.

Over TLS their names begin with `__Host-`: a browser takes such a cookie from this host
alone, over TLS and for all its paths. So neither another host of the same domain nor a
connection without TLS can plant one.

`http.cookies` reads a quoted value in a time that grows with the square of its length
(CVE-2024-7592, in Python before 3.11.10 and 3.12.6), and anyone can send such a value:
one header of 32 kB would stop the event loop for seconds. Starlette's `Request.cookies`
unquotes with the same function. So nothing else here reads cookies.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, Literal

from starlette.requests import Request
from starlette.responses import Response

# Browsers keep at most a few hundred cookies of a site. Further ones are not read.
COOKIES_MAX = 1000
_OVER_TLS: Final = "__Host-"


@dataclass(frozen=True, slots=True)
class Cookie:
    """A cookie that no script reads. name: without TLS.

    same_site: `strict` sends it with no request that another site began.
    """

    name: str
    same_site: Literal["strict", "lax"] = "strict"

    def read(self, request: Request, *, is_secure: bool) -> str:
        """Its value; empty if it was not sent.

        is_secure: whether the browser is connected over TLS. Then a cookie without the
        prefix was not set here. Without TLS no browser accepts one with the prefix.
        """
        value = read_cookie(request, _OVER_TLS + self.name)
        return value or ("" if is_secure else read_cookie(request, self.name))

    def set(
        self,
        response: Response,
        value: str,
        *,
        seconds: int,
        is_secure: bool,
        path: str | None = None,
    ) -> None:
        """seconds: 0 deletes it.

        path: without TLS, the paths that it is sent to. None is the folder of the
        request as the browser knows it: also where a proxy serves the pages under a
        path of its own.
        """
        response.set_cookie(
            _OVER_TLS * is_secure + self.name,
            value,
            max_age=seconds,
            path="/" if is_secure else path,
            httponly=True,
            samesite=self.same_site,
            secure=is_secure,
        )

    def forget(self, response: Response, *, is_secure: bool) -> None:
        self.set(response, "", seconds=0, is_secure=is_secure)


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
