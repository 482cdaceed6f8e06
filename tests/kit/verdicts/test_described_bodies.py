"""A body that is no JSON object, described for the writer of the server."""

import httpx
import pytest

from conformance.exchanges.answer import Answer, describe_body

JSON = "application/json"


@pytest.mark.parametrize(
    ("media_type", "body", "says"),
    [
        ("text/plain; charset=utf-8", b"{}", "Content-Type is text/plain, not"),
        (None, b"{}", "Content-Type is absent, not application/json"),
        (JSON, b"", "body is empty"),
        (JSON, b"\xef\xbb\xbf{}", "begins with a byte order mark"),
        (JSON, b'{"a": "\xfc"}', "is not UTF-8: byte 7 is invalid"),
        (JSON, b'{"a": ', "is no JSON: Input data was truncated"),
        (
            JSON,
            b'{"a": NaN}',
            "is no JSON: JSON is malformed: invalid character (byte 6)",
        ),
        (JSON, b"[]", "is JSON, but not an object"),
    ],
)
def test_a_body_that_cannot_be_read_is_described(
    media_type: str | None, body: bytes, says: str
) -> None:
    headers = httpx.Headers({} if media_type is None else {"Content-Type": media_type})
    assert says in describe_body(Answer(200, headers, body, 0.0, 0.0, None, 1))
