"""Messages between the server and its launcher (launcher.py). It imports no Ray."""

from __future__ import annotations

import msgspec


class MachineCheck(msgspec.Struct, frozen=True):
    """The conditions that a machine must meet before it may simulate.

    software: as `software()` on the server.
    """

    software: dict[str, str]


# To the launcher


class Connect(msgspec.Struct, tag="connect", frozen=True):
    """Join the cluster; the first message.

    simulators: what one takes of a machine, by Ray's names, for each kind. Every
    machine that has room for one of any kind is looked at before the answer.
    """

    address: str
    machine: MachineCheck
    simulators: list[dict[str, float]] = []


class StartActor(msgspec.Struct, tag="start", frozen=True):
    """number: names the actor in all later messages. resources: what it takes."""

    number: int
    resources: dict[str, float]


class KillActor(msgspec.Struct, tag="kill", frozen=True):
    number: int


class FindRoom(msgspec.Struct, tag="find_room", frozen=True):
    """number: names the question in its answer."""

    number: int
    resources: dict[str, float]


# From the launcher


class Connected(msgspec.Struct, tag="connected", frozen=True):
    """machines: how many could hold a simulator, for each of `Connect.simulators`."""

    machines: list[int]


class Rejected(msgspec.Struct, tag="rejected", frozen=True):
    """The cluster cannot be used; the launcher ends. reason: one sentence."""

    reason: str


class ActorReady(msgspec.Struct, tag="ready", frozen=True):
    """The actor listens there for one connection, which begins with the secret."""

    number: int
    host: str
    port: int
    secret: bytes


class ActorEnded(msgspec.Struct, tag="ended", frozen=True):
    """The actor has ended, or did not start."""

    number: int
    reason: str


class Room(msgspec.Struct, tag="room", frozen=True):
    """lacking: what no machine has, in use or not; empty if one has all of it.

    is_free: nothing uses it, as far as Ray reports: of the cluster as a whole, whose
    machines may have a part of it each. is_known: False if Ray reports nothing.
    """

    number: int
    lacking: dict[str, float]
    is_free: bool
    is_known: bool = True


ToLauncher = Connect | StartActor | KillActor | FindRoom
FromLauncher = Connected | Rejected | ActorReady | ActorEnded | Room

TO_LAUNCHER: msgspec.msgpack.Decoder[ToLauncher] = msgspec.msgpack.Decoder(ToLauncher)
FROM_LAUNCHER: msgspec.msgpack.Decoder[FromLauncher] = msgspec.msgpack.Decoder(
    FromLauncher
)
