"""In which protocols a policy is asked: a name of schema PolicyProtocol → its class."""

from __future__ import annotations

from collections.abc import Callable

from reference_server.push.calls import Calls
from reference_server.push.chat import ChatPolicy
from reference_server.push.orders import Order
from reference_server.push.policy import Policy, ProctorPolicy
from reference_server.run_state import Run

PROTOCOLS: dict[str, Callable[[Run, Order, Calls], Policy]] = {
    "proctor": ProctorPolicy,
    "openai_chat": ChatPolicy,
}
