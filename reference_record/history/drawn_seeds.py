"""Seeds that are drawn after the policies were committed to, and how that is checked.

The history has, for each draw, the leaves `seal` (the SHA-256 of a secret key), one
`commit` for each policy, `draw`, and at last `open` (the key). The seeds follow from
the key and from the root of all leaves in front of `draw`. So the host itself did not
know them before the last policy was committed to, and anyone can check it afterwards.
"""

from __future__ import annotations

import hashlib
import hmac
import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Annotated, Any, Final

import msgspec
from msgspec import Meta

from reference_record.history.merkle_tree import MerkleTree, leaf_hash

KINDS: Final = ("seal", "commit", "draw", "open")
Sha256 = Annotated[str, Meta(pattern="^[0-9a-f]{64}$")]


class SeedsDrawn(msgspec.Struct, frozen=True):
    """`seeds_drawn` of a manifest: the leaf `draw`, and what is in front of it.

    tree_size: the index of that leaf, and how many leaves are in front of it.
    """

    draw_id: Annotated[str, Meta(max_length=200)]
    tree_size: Annotated[int, Meta(ge=0, le=2**53 - 1)]
    root_sha256: Sha256


class BrokenDraw(Exception):
    """The history does not show that the seeds were drawn as it is claimed."""


@dataclass(frozen=True, slots=True)
class CheckedDraw:
    """committed_at: index of the leaf. key: hexadecimal; None before it is opened."""

    draw_id: str
    committed_at: int
    drawn_at: int
    key: str | None


def seeds_drawn_of(manifest: Mapping[str, Any]) -> SeedsDrawn | None:
    """Reads a manifest of any origin. Raises BrokenDraw for another form."""
    drawn = manifest.get("seeds_drawn")
    try:
        return None if drawn is None else msgspec.convert(drawn, SeedsDrawn)
    except msgspec.ValidationError as error:
        raise BrokenDraw(f"`seeds_drawn` of the manifest: {error}") from error


def drawn_secret(key: bytes, root_sha256: str) -> bytes:
    """The secret from which the seeds of one draw follow (HST-032)."""
    return hmac.digest(key, bytes.fromhex(root_sha256), "sha256")


def check_draw(
    leaves: Sequence[str], drawn: SeedsDrawn, digest: str | None
) -> CheckedDraw:
    """Whether these leaves, which a checkpoint covers, show the draw (HST-031).

    digest: of the policy, as the record has it. Raises BrokenDraw.
    """
    of_draw = _leaves_of(leaves, drawn.draw_id)
    places = _places(of_draw)
    drawn_at = places.get("draw")
    if drawn_at != drawn.tree_size:
        raise BrokenDraw(f"leaf {drawn.tree_size} is no `draw` of {drawn.draw_id}")
    committed = (
        index
        for index, leaf in of_draw.items()
        if leaf["kind"] == "commit" and leaf.get("digest") == digest
    )
    committed_at = next(committed, drawn_at)
    if not committed_at < drawn_at:
        raise BrokenDraw(f"no leaf before {drawn_at} commits the host to {digest}")
    if not places.get("seal", drawn_at) < committed_at:
        raise BrokenDraw(f"the key was not sealed before leaf {committed_at}")
    tree = MerkleTree(leaf_hash(leaf.encode()) for leaf in leaves[:drawn_at])
    if tree.root().hex() != drawn.root_sha256:
        raise BrokenDraw(f"the root of the first {drawn_at} leaves is another one")
    key = of_draw[places["open"]].get("key") if "open" in places else None
    if key is not None:
        sealed = of_draw[places["seal"]].get("key_sha256")
        if hashlib.sha256(bytes.fromhex(key)).hexdigest() != sealed:
            raise BrokenDraw("the key that was opened is not the one that was sealed")
    return CheckedDraw(drawn.draw_id, committed_at, drawn_at, key)


def _leaves_of(leaves: Sequence[str], draw_id: str) -> Mapping[int, dict[str, Any]]:
    """Index → leaf, of one draw."""
    read = enumerate(json.loads(text) for text in leaves)
    return {
        index: leaf
        for index, leaf in read
        if leaf.get("draw_id") == draw_id and leaf.get("kind") in KINDS
    }


def _places(of_draw: Mapping[int, dict[str, Any]]) -> Mapping[str, int]:
    """The index of each kind that a draw has once. Raises BrokenDraw."""
    places: dict[str, int] = {}
    for index, leaf in of_draw.items():
        if leaf["kind"] in places and leaf["kind"] != "commit":
            raise BrokenDraw(f"leaf {index} is a second `{leaf['kind']}`")
        places[leaf["kind"]] = index
    return places
