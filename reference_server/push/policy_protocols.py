"""In which protocols a policy is asked: a name of schema PolicyProtocol → its class."""

from __future__ import annotations

from collections.abc import Callable

from reference_server.push.chat_calls import ChatPolicy
from reference_server.push.http_calls import Calls
from reference_server.push.policy_calls import Policy, ProctorPolicy
from reference_server.push.policy_server_config import Order
from reference_server.rules.run import Run

PROTOCOLS: dict[str, Callable[[Run, Order, Calls], Policy]] = {
    "proctor": ProctorPolicy,
    "openai_chat": ChatPolicy,
}
