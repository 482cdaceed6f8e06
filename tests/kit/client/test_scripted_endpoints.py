"""The endpoints of the kit that a server calls, and callers that leave."""

import socket
from urllib.parse import urlsplit

import pytest

from conformance.policy.scripted_chat import ScriptedChat
from conformance.policy.scripted_policy import ScriptedPolicy

HEADERS = b"HTTP/1.1\r\nContent-Length: 99\r\n\r\n{"


def leave_in_a_body(url: str, path: bytes) -> None:
    address = urlsplit(url)
    with socket.create_connection(
        (address.hostname or "", address.port or 0)
    ) as caller:
        caller.sendall(b"POST " + path + b" " + HEADERS)
        caller.shutdown(socket.SHUT_WR)
        assert caller.recv(1) == b""  # closed without a response


def test_callers_that_leave_in_a_body(capfd: pytest.CaptureFixture[str]) -> None:
    with ScriptedChat() as chat, ScriptedPolicy() as policy:
        leave_in_a_body(chat.url, b"/v1/chat/completions")
        leave_in_a_body(policy.url, b"/v1/policy/predict")
        assert (chat.requests, policy.calls) == ([], [])
    assert capfd.readouterr().err == ""
