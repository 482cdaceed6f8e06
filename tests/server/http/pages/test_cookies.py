"""Cookies of a request: which value is read."""

from __future__ import annotations

import pytest
from starlette.requests import Request

from reference_server.http.connections.connection_limits import HEADER_BYTES
from reference_server.http.pages.cookies import COOKIES_MAX, read_cookie


def read(header: str | None) -> str:
    headers = [] if header is None else [(b"cookie", header.encode("latin-1"))]
    return read_cookie(Request({"type": "http", "headers": headers}), "wanted")


@pytest.mark.parametrize(
    ("header", "value"),
    [
        (None, ""),
        ("", ""),
        ("wanted=a.b-C_9", "a.b-C_9"),
        ("first=1; wanted=a; last=2", "a"),
        ("first=1;wanted=a;last=2", "a"),
        (" wanted = a ", "a"),
        ("wanted=a=b==", "a=b=="),
        ("wanted=", ""),
        ("wanted", ""),
        ("unwanted=a; Wanted=b; wanted2=c", ""),
        ("wanted=a; wanted=b", "b"),
        ("other=x y(z); \xe9=\xe9; ;;=; wanted=a", "a"),
        ('wanted="a\\"b"', '"a\\"b"'),
        ("wanted=a" + ";" * HEADER_BYTES, "a"),
        (";" * COOKIES_MAX + "wanted=a", ""),
    ],
)
def test_value(header: str | None, value: str) -> None:
    assert read(header) == value
