"""Draws of seeds: which leaf may follow which, and what a reader can check of them."""

from __future__ import annotations

import hashlib
from collections.abc import Callable
from typing import Any, get_args

import pytest

from reference_record.formats.strict_json import canonical_json
from reference_record.history.drawn_seeds import (
    BrokenDraw,
    SeedsDrawn,
    check_draw,
    seeds_drawn_of,
)
from reference_record.history.merkle_tree import MerkleTree, leaf_hash
from reference_server.rules.board.seed_draws import ORDER, DrawKind, DrawLeaf, next_leaf
from reference_server.rules.runs.lifecycle import Refuse

KEY, DIGEST = b"k" * 32, "sha256:" + "0" * 64
KINDS: tuple[DrawKind, ...] = get_args(DrawKind)


def made(*kinds: DrawKind) -> list[dict[str, Any]]:
    """Leaves of these kinds, each allowed."""
    leaves: list[dict[str, Any]] = []
    for kind in kinds:
        digest = DIGEST if kind == "commit" else ""
        leaf = next_leaf(DrawLeaf(kind, "t/p", digest), leaves, KEY, 1.5)
        assert not isinstance(leaf, Refuse), leaf
        leaves.append(dict(leaf))
    return leaves


@pytest.mark.parametrize("count", range(len(KINDS) + 1))
@pytest.mark.parametrize("kind", KINDS)
def test_a_leaf_follows_by_the_table(kind: DrawKind, count: int) -> None:
    """After the first leaves of a draw. Expect each kind where ORDER has it."""
    earlier = made(*KINDS[:count])
    needed, too_late = ORDER[kind]
    there = set(KINDS[:count])
    leaf = next_leaf(DrawLeaf(kind, "t/p"), earlier, KEY, 1.5)
    is_possible = set(needed) <= there and not set(too_late) & there
    assert isinstance(leaf, Refuse) != is_possible


def test_leaves_have_the_values_of_the_table() -> None:
    seal, commit, draw, opened = made(*KINDS)
    assert seal["key_sha256"] == hashlib.sha256(KEY).hexdigest()
    assert (commit["digest"], opened["key"]) == (DIGEST, KEY.hex())
    assert draw == {"kind": "draw", "at_ms": 1500, "draw_id": "t/p"}
    for digest, is_same in ((DIGEST, True), ("sha256:1", False)):
        assert DrawLeaf("commit", "t/p", digest).is_same(commit) == is_same


Change = Callable[[list[dict[str, Any]]], object]


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (list, ""),
        (lambda leaves: leaves.pop(), ""),  # not opened yet
        (lambda leaves: leaves[2].update(digest="sha256:1"), "commits the host to"),
        (lambda leaves: leaves[0].update(at_ms=7), "root of the first 3"),
        (lambda leaves: leaves.insert(0, leaves.pop(2)), "was not sealed before"),
        (lambda leaves: leaves.insert(3, leaves.pop(2)), "is no `draw`"),
        (lambda leaves: leaves.append(leaves[1]), "is a second `seal`"),
        (lambda leaves: leaves[4].update(key="00"), "not the one that was sealed"),
    ],
)
def test_a_draw_is_checked(change: Change, words: str) -> None:
    """A history is right, or wrong in one way. Expect the reason for each wrong one."""
    leaves = [{"kind": "publish", "entry_id": "entry_1"}, *made(*KINDS)]
    root = MerkleTree(leaf_hash(canonical_json(leaf)) for leaf in leaves[:3]).root()
    drawn = SeedsDrawn("t/p", 3, root.hex())
    change(leaves)
    texts = [canonical_json(leaf).decode() for leaf in leaves]
    if words:
        with pytest.raises(BrokenDraw, match=words):
            check_draw(texts, drawn, DIGEST)
        return
    checked = check_draw(texts, drawn, DIGEST)
    assert (checked.committed_at, checked.drawn_at) == (2, 3)
    assert checked.key == (KEY.hex() if len(leaves) == 5 else None)


def test_a_manifest_of_any_origin_is_read() -> None:
    drawn: dict[str, Any] = {"draw_id": "t/p", "tree_size": 3, "root_sha256": "0" * 64}
    assert seeds_drawn_of({}) is None
    assert seeds_drawn_of({"seeds_drawn": drawn}) == SeedsDrawn(**drawn)
    for wrong in (7, {}, drawn | {"tree_size": -1}, drawn | {"root_sha256": "x"}):
        with pytest.raises(BrokenDraw, match="seeds_drawn"):
            seeds_drawn_of({"seeds_drawn": wrong})
