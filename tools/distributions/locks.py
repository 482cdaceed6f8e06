"""Reads a lock that has its hashes: packages, and which packages require them.

Such a lock is what `python tools/locks/complete.py NAME` writes: a requirement with
`==`, its hashes, and below it a comment that names the packages that require it.
"""

import re
from dataclasses import dataclass, field

from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

_HASH = re.compile(r"--hash=sha256:([0-9a-f]{64})")
_VIA = re.compile(r"    # via (\S.*)")


@dataclass
class LockedPackage:
    """One package of a lock; `required_by` are names of packages or `-r NAME.in`."""

    name: str
    version: str
    marker: str
    hashes: list[str] = field(default_factory=list)
    required_by: list[str] = field(default_factory=list)


def parse_lock(text: str) -> list[LockedPackage]:
    """Give the packages of a lock in its order. ValueError if a line is not known."""
    packages: list[LockedPackage] = []
    for line in text.splitlines():
        if line and line[0] not in " #":
            packages.append(_begin(line.removesuffix("\\").strip()))
        elif found := _HASH.search(line):
            packages[-1].hashes.append(found[1])
        elif found := _VIA.fullmatch(line):
            packages[-1].required_by += found[1].split(", ")
        elif line.strip():
            raise ValueError(f"a lock has no line such as {line!r}")
    return packages


def _begin(line: str) -> LockedPackage:
    requirement = Requirement(line)
    (pin,) = requirement.specifier
    if pin.operator != "==":
        raise ValueError(f"{line}: not pinned")
    marker = str(requirement.marker) if requirement.marker else ""
    return LockedPackage(canonicalize_name(requirement.name), pin.version, marker)
