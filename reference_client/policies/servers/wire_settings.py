"""The table `[server]` of a mapping file: how the policy server is spoken to.

Each source of policies reads some of its members and refuses the others.
"""

from __future__ import annotations

import socket
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, fields, replace
from typing import Any, Self

from reference_client.errors import BadPolicy
from reference_client.policies.servers.wire_formats import FORMATS
from reference_record.command_line.spelling import did_you_mean

# A mistyped address is reported before the run is created.
FIRST_CONTACT_S = 3.0
# Between attempts to reach a server: first, and at last.
PAUSE_S, LONGEST_PAUSE_S = 0.2, 2.0
# The first answer may take minutes, while a network is compiled.
ANSWER_S = 600.0
ANSWER_BYTES_MAX = 1 << 28  # a chunk of actions is much smaller
# Probes of TCP keep a connection that a router would forget while a policy computes,
# and end one that it has forgotten. Not every system lets their times be set.
_PROBES = {"TCP_KEEPIDLE": 30, "TCP_KEEPINTVL": 10, "TCP_KEEPCNT": 3}
KEEPALIVE = [
    (socket.SOL_SOCKET, socket.SO_KEEPALIVE, 1),
    *(
        (socket.IPPROTO_TCP, getattr(socket, name), value)
        for name, value in _PROBES.items()
        if hasattr(socket, name)
    ),
]
LIMIT_OF_ANSWERS = "answer_s in [server] of the mapping file is the limit"


@dataclass(frozen=True, slots=True)
class ServerSettings:
    """How a policy server is spoken to.

    format: one of wire_formats.FORMATS. greeting: whether a WebSocket server speaks
    first. ready: members that the greeting has; messages without them are reports of a
    server that still loads. expect: what the greeting must say, by dotted name.
    varying: its members that may differ on each connection, by dotted name.
    envelope: the request is sent as JSON text under this key. reset_path: the path of
    an HTTP server that is posted the message of `[reset]`. new_connection: each episode
    begins with a connection of its own. answer_s: the limit for one answer,
    from its request to its end.
    """

    format: str = "msgpack"
    greeting: bool = True
    ready: Mapping[str, Any] = field(default_factory=dict)
    expect: Mapping[str, Any] = field(default_factory=dict)
    varying: Sequence[str] = ()
    envelope: str | None = None
    reset_path: str | None = None
    new_connection: bool = False
    answer_s: float = ANSWER_S

    @classmethod
    def of(
        cls, table: Mapping[str, Any], kind: str, readable: set[str], **defaults: Any
    ) -> Self:
        """From the table `[server]`; readable: the members that the source reads.

        Raises BadPolicy.
        """
        for name, value in table.items():
            if name not in readable:
                raise BadPolicy(
                    f"{kind} does not read {name} of [server], but "
                    f"{', '.join(sorted(readable))}{did_you_mean(name, readable)}"
                )
            wanted = _TYPES[name]
            if not isinstance(value, wanted) or (
                isinstance(value, bool) and bool not in wanted
            ):
                raise BadPolicy(f"[server]: {name} cannot be {value!r:.60}")
        settings = replace(cls(**defaults), **table)
        if settings.format not in FORMATS:
            raise BadPolicy(
                f"[server]: format is one of {', '.join(FORMATS)}; "
                f"not {settings.format!r:.60}"
            )
        if not all(isinstance(name, str) for name in settings.varying):
            raise BadPolicy("[server]: varying is a list of names")
        if settings.answer_s <= 0:
            raise BadPolicy("[server]: answer_s must be more than 0")
        return settings

    def check_greeting(self, greeting: Any, url: str) -> None:
        """Raises BadPolicy if the server says otherwise than `expect`."""
        for name, wanted in self.expect.items():
            said = greeting
            for part in (name,) if _has(greeting, name) else name.split("."):
                said = said.get(part) if isinstance(said, Mapping) else None
            if as_json(said) != wanted:
                raise BadPolicy(
                    f"The policy server at {url} says {name} = "
                    f"{as_json(said)!r:.200}; the mapping expects {wanted!r:.200} "
                    "(expect in [server])"
                )


_TYPES: Mapping[str, tuple[type, ...]] = {
    "format": (str,),
    "greeting": (bool,),
    "ready": (dict,),
    "expect": (dict,),
    "varying": (list,),
    "envelope": (str,),
    "reset_path": (str,),
    "new_connection": (bool,),
    "answer_s": (int, float),
}
assert set(_TYPES) == {f.name for f in fields(ServerSettings)}


def _has(greeting: Any, name: str) -> bool:
    return isinstance(greeting, Mapping) and name in greeting


def as_json(value: Any) -> Any:
    """Tuples and arrays as lists, to compare with what a TOML file can say."""
    if hasattr(value, "tolist"):
        return value.tolist()
    if isinstance(value, Mapping):
        return {name: as_json(inner) for name, inner in value.items()}
    if isinstance(value, list | tuple):
        return [as_json(item) for item in value]
    return value
