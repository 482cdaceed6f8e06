"""A session asks an older server for nothing that it does not know."""

import threading
from types import SimpleNamespace
from typing import Any

import pytest

from reference_client.errors import ProctorError
from reference_client.protocol.retry_policy import RetryPolicy
from reference_client.protocol.worker_session import Session, WorkerSlot
from tests.support.client.api_exceptions import api_exception

RUN: Any = SimpleNamespace(run_id="run_1", endpoint="http://a/v1", idle_timeout_s=1.0)
TURN = SimpleNamespace(lease=SimpleNamespace(expires_at="later"))


def attach(unknown: str) -> list[int | None]:
    """The values of `first_episodes` that a server is sent which refuses a member."""
    sent: list[int | None] = []

    def answer(_run_id: str, _worker_id: str, request: Any) -> Any:
        sent.append(request.first_episodes)
        if getattr(request, unknown) is None:
            return TURN
        fault = f"/{unknown}", "Extra inputs are not permitted"
        raise api_exception("invalid_request", 422, retryable=False, fault=fault)

    data: Any = SimpleNamespace(attach_worker=answer, limit_silence=lambda *_: None)
    slot = WorkerSlot(data, RUN, "w0", first_episodes=2)
    waits = RetryPolicy("http://127.0.0.1:1", 1.0, threading.Event(), lambda _: None)
    Session.attach(slot, waits, takeover=True)
    return sent


def test_an_older_server_begins_an_episode_that_is_not_wanted() -> None:
    """It plays the run, which is there already, without the bound."""
    assert attach("first_episodes") == [2, None]


def test_a_member_that_decides_is_never_left_out() -> None:
    with pytest.raises(ProctorError, match="/takeover: this server does not know it"):
        attach("takeover")
