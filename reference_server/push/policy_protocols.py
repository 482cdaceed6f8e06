"""In which protocols a policy is asked: a name of schema PolicyProtocol → its class."""

from __future__ import annotations

from collections.abc import Callable

from reference_server.push.chat_calls import ChatPolicy
from reference_server.push.http_calls import HttpCalls
from reference_server.push.policy_calls import PolicyAdapter, ProctorPolicy
from reference_server.rules.policy_server import PolicyServerConfig
from reference_server.rules.run import Run

PROTOCOLS: dict[str, Callable[[Run, PolicyServerConfig, HttpCalls], PolicyAdapter]] = {
    "proctor": ProctorPolicy,
    "openai_chat": ChatPolicy,
}
