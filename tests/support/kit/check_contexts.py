"""A check's context for a server of one test, without a run of the kit."""

import contextlib
from collections.abc import Iterator
from typing import Protocol

from conformance.client.check_context import CheckContext
from conformance.client.request_context import SharedContext
from conformance.run_settings import Settings
from conformance.specification.ledger import SERVICE


class AnyServer(Protocol):
    """A server of one test."""

    url: str

    def close(self) -> None:
        """Stop listening."""


@contextlib.contextmanager
def open_context(server: AnyServer) -> Iterator[CheckContext]:
    """The context of a check that calls the server; it is closed with the context."""
    settings = Settings(url=server.url, token="secret")
    settings.service = {"profiles": [*SERVICE, "events"], "limits": {}}
    with (
        contextlib.closing(server),
        contextlib.closing(SharedContext.of(settings)) as shared,
    ):
        yield CheckContext(shared, "TEST-001")
