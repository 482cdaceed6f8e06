"""Texts of policy servers, in whatever charset they say that they are."""

import encodings
import pkgutil

import pytest

from reference_client.policies.servers.server_faults import text_of

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
