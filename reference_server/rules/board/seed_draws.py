"""Which leaf of a draw of seeds may follow which. Pure.

A host seals a key, is committed to the policies of a phase, draws the seeds, and opens
the key when all of them were played (HST-031).
"""

from __future__ import annotations

import hashlib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Final, Literal

from reference_server.rules.runs.lifecycle import Refuse

DrawKind = Literal["seal", "commit", "draw", "open"]
# kind → the kinds that must be there before it, and those that must not.
ORDER: Final[Mapping[DrawKind, tuple[Sequence[DrawKind], Sequence[DrawKind]]]] = {
    "seal": ((), ()),
    "commit": (("seal",), ("draw", "open")),
    "draw": (("seal", "commit"), ("open",)),
    "open": (("draw",), ()),
}


@dataclass(frozen=True, slots=True)
class DrawLeaf:
    """A leaf that is to be appended. digest: of a policy, for `commit` alone."""

    kind: DrawKind
    draw_id: str
    digest: str = ""

    def is_same(self, leaf: Mapping[str, Any]) -> bool:
        """Whether the leaf is this one: a repeat appends nothing."""
        names = ("kind", "draw_id", "digest")
        return [leaf.get(name, "") for name in names] == [
            *(self.kind, self.draw_id, self.digest)
        ]


def next_leaf(
    asked: DrawLeaf, earlier: Sequence[Mapping[str, Any]], key: bytes, at_wall: float
) -> Mapping[str, Any] | Refuse:
    """The new leaf. earlier: those of the same draw, oldest first."""
    kinds = {leaf["kind"] for leaf in earlier}
    needed, too_late = ORDER[asked.kind]
    if not kinds.issuperset(needed) or kinds.intersection(too_late):
        there = ", ".join(sorted(kinds)) or "none"
        detail = f"`{asked.kind}` is not possible: {asked.draw_id} has {there}."
        return Refuse("illegal_transition", detail, "HST-031")
    leaf: dict[str, Any] = {
        "kind": asked.kind,
        "at_ms": int(at_wall * 1000),
        "draw_id": asked.draw_id,
    }
    if asked.kind == "seal":
        leaf["key_sha256"] = hashlib.sha256(key).hexdigest()
    if asked.kind == "commit":
        leaf["digest"] = asked.digest
    if asked.kind == "open":
        leaf["key"] = key.hex()
    return leaf
