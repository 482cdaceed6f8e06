"""Reads a lock of requirements/: packages, their hashes, and what required them.

A lock is what `uv pip compile` writes: a requirement with `==`, its hashes, and below
it comments that say by which other packages it was required.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from pathlib import Path

from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

_HASH = re.compile(r"--hash=sha256:([0-9a-f]{64})")
_VIA = re.compile(r"    #(?: via|  ) (\S.*)")


@dataclass
class LockedPackage:
    """One package of a lock; `required_by` are names of packages or `-r NAME.in`."""

    name: str
    version: str
    marker: str
    hashes: list[str] = field(default_factory=list)
    required_by: list[str] = field(default_factory=list)


def read_lock(path: Path) -> list[LockedPackage]:
    """Give the packages of a lock in its order. ValueError if a line is not known."""
    packages: list[LockedPackage] = []
    for line in path.read_text(encoding="utf-8").splitlines():
        if line and line[0] not in " #":
            packages.append(_begin(line.removesuffix("\\").strip()))
        elif found := _HASH.search(line):
            packages[-1].hashes.append(found[1])
        elif found := _VIA.fullmatch(line):
            packages[-1].required_by.append(found[1])
        elif line.strip() not in ("", "# via"):
            raise ValueError(f"{path.name}: {line!r} is no line of a lock")
    return packages


def _begin(line: str) -> LockedPackage:
    requirement = Requirement(line)
    (pin,) = requirement.specifier
    if pin.operator != "==":
        raise ValueError(f"{line}: not pinned")
    marker = str(requirement.marker) if requirement.marker else ""
    return LockedPackage(canonicalize_name(requirement.name), pin.version, marker)
