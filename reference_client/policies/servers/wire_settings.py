"""The table `[server]` of a mapping file: how the policy server is spoken to.

Each source of policies reads some of its members and refuses the others.
"""

from __future__ import annotations

import socket
from collections.abc import Mapping
from typing import Annotated, Any, Self, TypeAlias

import msgspec
from msgspec import Meta

from reference_client.errors import BadPolicy
from reference_client.policies.mapping import PolicyMapping
from reference_client.policies.mapping.members import Flag, Table, Text, read_members
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
_FORMATS = f"one of {', '.join(FORMATS)}"

Format: TypeAlias = Annotated[
    str, Meta(pattern=f"^({'|'.join(FORMATS)})$", description=_FORMATS)
]
Names: TypeAlias = Annotated[tuple[str, ...], Meta(description="a list of names")]
# A longer wait would not end in practice. The bounds refuse nan and infinity, too.
Seconds: TypeAlias = Annotated[
    float, Meta(gt=0, le=1e9, description="a number of seconds above 0, at most 1e9")
]
LIMIT_OF_ANSWERS = "answer_s in [server] of the mapping file is the limit"


class ServerSettings(msgspec.Struct, frozen=True, kw_only=True):
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

    format: Format = "msgpack"
    greeting: Flag = True
    ready: Table = {}
    expect: Table = {}
    varying: Names = ()
    envelope: Text | None = None
    reset_path: Text | None = None
    new_connection: Flag = False
    answer_s: Seconds = ANSWER_S

    @classmethod
    def of(
        cls, mapping: PolicyMapping, kind: str, readable: set[str], **defaults: Any
    ) -> Self:
        """From the table `[server]`; readable: the members that the source reads.

        Raises BadPolicy and BadMapping.
        """
        for name in mapping.server:
            if name not in readable:
                raise BadPolicy(
                    f"{mapping.name}: {kind} does not read {name} of [server], but "
                    f"{', '.join(sorted(readable))}{did_you_mean(name, readable)}"
                )
        given = read_members(cls, f"{mapping.name}: server", mapping.server)
        left_open = {
            name: value
            for name, value in defaults.items()
            if name not in mapping.server
        }
        return msgspec.structs.replace(given, **left_open)

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
