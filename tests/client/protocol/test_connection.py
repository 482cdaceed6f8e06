"""Where a connection sends the token."""

import pytest

from reference_client import ProctorError
from reference_client.protocol.connection import Connection

pytestmark = pytest.mark.slow("starts servers or kits")


def test_a_token_is_not_sent_unencrypted() -> None:
    with Connection("https://example.org", "t", requests=1) as connection:
        connection.data("https://other.example.org/")
        with pytest.raises(ProctorError, match="not HTTPS"):
            connection.data("http://example.org")
