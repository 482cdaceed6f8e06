"""The platform in this process, and as a program with a mail server."""

from __future__ import annotations

from collections.abc import AsyncIterator, Iterator
from pathlib import Path

import httpx
import pytest

from reference_platform.http.server_calls import ServerRuns
from reference_platform.mail.outbox import MailServer
from reference_platform.parts import Parts
from reference_platform.platform_app import make_application
from tests.support.platform.approved_accounts import Clock, approved, quick_parts
from tests.support.platform.hosted_server import (
    HostedServer,
    MailReceiver,
    mail_receiver,
)


@pytest.fixture
def clock() -> Clock:
    return Clock()


@pytest.fixture
def parts(tmp_path: Path, clock: Clock) -> Iterator[Parts]:
    mail = MailServer("smtp://127.0.0.1:9", "host@example.org")  # sends nothing here
    made = quick_parts(tmp_path / "platform.sqlite", clock=clock, mail_server=mail)
    yield made
    made.database.close()


@pytest.fixture
async def client(parts: Parts) -> AsyncIterator[httpx.AsyncClient]:
    """A browser, or a program, at the platform."""
    app = make_application(parts, ServerRuns("http://127.0.0.1:9"))
    transport = httpx.ASGITransport(app)
    async with httpx.AsyncClient(
        transport=transport, base_url="http://host.example"
    ) as client:
        yield client


@pytest.fixture
async def ada(parts: Parts) -> str:
    """An approved account."""
    return await approved(parts, "ada")


@pytest.fixture(scope="module")
def mail() -> Iterator[MailReceiver]:
    with mail_receiver() as receiver:
        yield receiver


@pytest.fixture(scope="module")
def host(
    tmp_path_factory: pytest.TempPathFactory, mail: MailReceiver
) -> Iterator[HostedServer]:
    """`proctor-host`, for all tests of a module."""
    with HostedServer(tmp_path_factory.mktemp("host"), mail.url) as host:
        yield host
