"""Messages between a platform and a machine that runs one of its sandboxes.

The first connection to the machine controls the sandbox: the platform sends Start, then
Acknowledged and Close; the machine Started, then Line and Ended. Each other one leads
to the policy. A connection begins with a secret and one byte that says which it is.
"""

from __future__ import annotations

from pathlib import Path

import msgspec

from reference_platform.sandbox.sandbox_interface import (
    Limits,
    SandboxEnd,
    SandboxSpec,
    Source,
)

SECRET_BYTES = 32
CONTROL, POLICY = b"C", b"P"
# Answers to a connection to the policy.
LISTENS, SILENT = b"1", b"0"


class Start(msgspec.Struct, tag="start", frozen=True):
    """A SandboxSpec, with paths as texts. They are those of the machine."""

    command: list[str]
    root: str
    binds: dict[str, str]
    environment: dict[str, str]
    directory: str
    limits: Limits

    @classmethod
    def of(cls, spec: SandboxSpec) -> Start:
        return cls(
            list(spec.command),
            "" if spec.root is None else str(spec.root),
            {place: str(path) for place, path in spec.binds.items()},
            dict(spec.environment),
            spec.directory,
            spec.limits,
        )

    def spec(self) -> SandboxSpec:
        return SandboxSpec(
            self.command,
            Path(self.root) if self.root else None,
            {place: Path(path) for place, path in self.binds.items()},
            self.environment,
            self.directory,
            self.limits,
        )


class Close(msgspec.Struct, tag="close", frozen=True):
    reason: str


class Acknowledged(msgspec.Struct, tag="acknowledged", frozen=True):
    """One line is durable; lines are acknowledged in their order."""


class Started(msgspec.Struct, tag="started", frozen=True):
    pass


class Unavailable(msgspec.Struct, tag="unavailable", frozen=True):
    """The machine makes no sandbox."""

    reason: str


class Line(msgspec.Struct, tag="line", frozen=True):
    source: Source
    text: str


class Ended(msgspec.Struct, tag="ended", frozen=True):
    end: SandboxEnd


ToNode = Start | Close | Acknowledged
FromNode = Started | Unavailable | Line | Ended
TO_NODE = msgspec.msgpack.Decoder(ToNode)
FROM_NODE = msgspec.msgpack.Decoder(FromNode)
