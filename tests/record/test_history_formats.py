"""The tree of a history and its checkpoints: the vectors, and what each reader says."""

import base64
import json
from typing import Any

import pytest

from reference_record.history.checkpoint import (
    Checkpoint,
    InvalidCheckpoint,
    read,
    sign,
)
from reference_record.history.merkle_tree import (
    EMPTY_ROOT,
    MerkleTree,
    is_consistent,
    is_included,
    leaf_hash,
)
from reference_record.keys import SigningKey
from tests.support.paths import SPEC

VECTORS = SPEC / "vectors" / "history"
TREE = json.loads((VECTORS / "tree.json").read_text())
NOTES = json.loads((VECTORS / "checkpoints.json").read_text())
LEAVES = [bytes.fromhex(leaf) for leaf in TREE["leaves"]]
ROOTS = [bytes.fromhex(root) for root in TREE["roots"]]
# The roots that Certificate Transparency publishes for these leaves, of 1, 7 and 8.
PUBLISHED_ROOTS = {
    1: "6e340b9cffb37a989ca544e6bb780a2c78901d3fb33738768511a30617afa01d",
    7: "ddb89be403809e325750d3d263cd78929c2942b7942a34b77e122c9594a74c8c",
    8: "5dc9da79a70659a9ad559cb701ded9a2ab9d823aad2f4960cfe370eff4604328",
}
KEY = base64.b64decode(NOTES["public_key"])


def hashes(row: dict[str, Any]) -> list[bytes]:
    return [bytes.fromhex(one) for one in row["hashes"]]


def test_roots_are_the_published_ones() -> None:
    assert ROOTS[0] == EMPTY_ROOT == MerkleTree().root()
    for size, root in PUBLISHED_ROOTS.items():
        assert ROOTS[size].hex() == root


def test_the_tree_gives_the_vectors() -> None:
    tree = MerkleTree()
    for size, root in enumerate(ROOTS):
        assert (len(tree), tree.root()) == (size, root)
        if size < len(LEAVES):
            tree.append(leaf_hash(LEAVES[size]))
    assert [tree.root(size) for size in range(9)] == ROOTS
    for row in TREE["inclusion"]:
        assert tree.inclusion(row["leaf_index"], row["tree_size"]) == hashes(row)
    for row in TREE["consistency"]:
        assert tree.consistency(row["old_size"], row["new_size"]) == hashes(row)


def test_right_proofs_are_accepted_and_others_refused() -> None:
    for row in TREE["inclusion"]:
        index, size, proof = row["leaf_index"], row["tree_size"], hashes(row)
        leaf, root = LEAVES[index], ROOTS[size]
        assert is_included(leaf, index, size, proof, root)
        assert not is_included(leaf + b"x", index, size, proof, root)
        assert not is_included(leaf, index, size, [*proof, root], root)
        assert not is_included(leaf, size, size, proof, root)
        assert not is_included(leaf, index, size, proof, ROOTS[size - 1])
        if proof:
            assert not is_included(leaf, index, size, proof[:-1], root)
    for row in TREE["consistency"]:
        old, new, proof = row["old_size"], row["new_size"], hashes(row)
        assert is_consistent(old, ROOTS[old], new, ROOTS[new], proof)
        assert not is_consistent(old, ROOTS[old - 1], new, ROOTS[new], proof)
        assert not is_consistent(old, ROOTS[old], new, ROOTS[new - 1], proof)
        assert not is_consistent(old, ROOTS[old], new, ROOTS[new], [*proof, KEY])
        if proof:
            assert not is_consistent(old, ROOTS[old], new, ROOTS[new], proof[:-1])
            assert not is_consistent(old, ROOTS[old], new, ROOTS[new], [])


def test_what_follows_an_empty_history_is_consistent_with_it() -> None:
    assert is_consistent(0, EMPTY_ROOT, 5, ROOTS[5], [])
    assert not is_consistent(0, ROOTS[1], 5, ROOTS[5], [])
    assert not is_consistent(5, ROOTS[5], 3, ROOTS[3], [])


@pytest.mark.parametrize("row", NOTES["notes"], ids=lambda row: row["description"])
def test_notes_are_judged_as_the_vectors_say(row: dict[str, Any]) -> None:
    if row["is_right"]:
        found = read(row["note"], KEY)
        assert found.root == ROOTS[found.tree_size]
        return
    with pytest.raises(InvalidCheckpoint):
        read(row["note"], KEY)


def test_a_signed_note_is_that_of_the_vectors() -> None:
    key = SigningKey(bytes(range(32)))
    assert key.public_key == KEY
    note = sign(Checkpoint("eval.example.org/board", 5, ROOTS[5]), key)
    assert note == NOTES["notes"][0]["note"]
