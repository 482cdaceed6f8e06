"""Texts of policy servers in every charset, and greetings in every spelling."""

import encodings
import pkgutil
from math import nan
from typing import Any

import numpy as np
import pytest

from reference_client.errors import ProctorError
from reference_client.policies.servers.first_greeting import FirstGreeting
from reference_client.policies.servers.server_faults import text_of
from reference_client.policies.servers.server_transport import route_to

CHARSETS = sorted(module.name for module in pkgutil.iter_modules(encodings.__path__))
BODIES = [b"", b"no model caf\xc3\xa9", b"\xff\xfe\x00", b"xn--a.b..c"]


@pytest.mark.parametrize(
    ("charset", "text"),
    [
        ("utf-8", "läuft"),
        ("latin-1", "lÃ¤uft"),
        *((charset, "läuft") for charset in ("no-such", "rot13", "base64", "a\0b")),
        *((charset, "läuft") for charset in ("idna", "punycode", "undefined", "")),
    ],
)
def test_a_text_is_shown_in_its_charset_or_in_utf_8(charset: str, text: str) -> None:
    assert text_of("läuft".encode(), f"text/plain; charset={charset}") == text


def test_no_charset_of_python_raises() -> None:
    assert {"idna", "undefined", "utf_7"} < set(CHARSETS)
    for charset in CHARSETS:
        for body in BODIES:
            shown = text_of(body, f"text/plain; charset={charset}")
            assert shown or not body.strip(b"\xff\xfe\0"), charset


@pytest.mark.parametrize(
    ("before", "now"),
    [
        ({"p": 1, "q": 2}, {"q": 2, "p": 1}),
        ([{"p": 1, "q": [2, {}]}], [{"q": [2, {}], "p": 1}]),
        ([1, -0.0, 2**53], [1.0, 0, 2.0**53]),
        ([nan, {"low": nan}], [nan, {"low": float("nan")}]),
        ([{"low": np.zeros(2)}], [{"low": (0, 0)}]),
        (np.float32(0.5), 0.5),
    ],
)
def test_a_greeting_in_another_spelling_is_the_first_one_again(
    before: Any, now: Any
) -> None:
    first = FirstGreeting()
    first.check("ws://h", {"assumes": before})
    first.check("ws://h", {"assumes": now})


@pytest.mark.parametrize(
    ("before", "now"),
    [
        ([{"p": 1}], [{"p": 2}]),
        ([{"p": 1}], [{"p": 1, "q": 1}]),
        ([{"p": None}], [{"q": None}]),
        ([1, 2], [2, 1]),
        ([1, 2], [1, 2, 3]),
        (1, True),
        ([False], [0.0]),
        (1, "1"),
        (nan, None),
        ([], [None]),
        (2**53, 2**53 + 1),
        ([{"low": np.zeros(2)}], [{"low": np.ones(2)}]),
    ],
)
def test_a_greeting_with_another_value_is_not(before: Any, now: Any) -> None:
    for one, other in ((before, now), (now, before)):
        first = FirstGreeting()
        first.check("ws://h", {"assumes": one})
        with pytest.raises(ProctorError, match=r"assumes = .* no score is made of two"):
            first.check("ws://h", {"assumes": other})


@pytest.mark.parametrize("scheme", ["ws", "wss", "http", "https"])
@pytest.mark.parametrize("port", ["99999", "-1", "port"])
def test_a_mistyped_port_is_a_fault_of_the_address(scheme: str, port: str) -> None:
    with pytest.raises(ProctorError, match="has an invalid port: it is a number"):
        route_to(f"{scheme}://host:{port}/act")
