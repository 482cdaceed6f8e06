"""A reader of a leaderboard finds the faults of histories that a host made up."""

import base64
import json
from pathlib import Path
from typing import Any

import pytest

from reference_client.board import history_check
from reference_client.board.history_check import KeptCheckpoint, RewrittenHistory
from reference_record.history import checkpoint
from reference_record.history.checkpoint import Checkpoint
from reference_record.history.merkle_tree import MerkleTree, leaf_hash
from reference_record.keys import SigningKey

KEY, OTHER = SigningKey(bytes(32)), SigningKey(bytes([1] * 32))
LEAVES = [f"leaf {number}" for number in range(7)]


def tree_of(leaves: list[str]) -> MerkleTree:
    return MerkleTree(leaf_hash(leaf.encode()) for leaf in leaves)


def signed(leaves: list[str], key: SigningKey = KEY) -> str:
    tree = tree_of(leaves)
    return checkpoint.sign(Checkpoint("host/board", len(tree), tree.root()), key)


def keep_and_load(path: Path, leaves: list[str]) -> KeptCheckpoint:
    found = history_check.read_signed(signed(leaves), KEY.public_key, None)
    history_check.keep(path, found, KEY.public_key)
    kept = history_check.load_kept(path)
    assert kept is not None
    return kept


def test_a_history_may_only_grow(tmp_path: Path) -> None:
    kept = keep_and_load(tmp_path / "deep" / "kept.json", LEAVES[:5])
    found = history_check.read_signed(signed(LEAVES), KEY.public_key, kept)
    proof = tree_of(LEAVES).consistency(5, 7)
    history_check.check_consistency(kept, found, proof)
    with pytest.raises(RewrittenHistory, match="5 leaves and has 4"):
        history_check.read_signed(signed(LEAVES[:4]), KEY.public_key, kept)
    rewritten = ["other", *LEAVES[1:]]
    found = history_check.read_signed(signed(rewritten), KEY.public_key, kept)
    proof = tree_of(rewritten).consistency(5, 7)
    with pytest.raises(RewrittenHistory, match="not those that were kept"):
        history_check.check_consistency(kept, found, proof)


def test_the_key_is_that_of_the_first_time(tmp_path: Path) -> None:
    kept = keep_and_load(tmp_path / "kept.json", LEAVES)
    with pytest.raises(RewrittenHistory, match="another key"):
        history_check.read_signed(signed(LEAVES, OTHER), OTHER.public_key, kept)
    with pytest.raises(RewrittenHistory, match="not signed by this key"):
        history_check.read_signed(signed(LEAVES, OTHER), KEY.public_key, kept)


def test_a_key_retired_and_published_may_be_followed_by_another(tmp_path: Path) -> None:
    """Then the history is still one that only grew."""
    kept = keep_and_load(tmp_path / "kept.json", LEAVES[:5])
    retired = [base64.b64encode(KEY.public_key).decode()]
    note = signed(LEAVES, OTHER)
    found = history_check.read_signed(note, OTHER.public_key, kept, retired)
    proof = tree_of(LEAVES).consistency(5, 7)
    history_check.check_consistency(kept, found, proof)
    rewritten = signed(LEAVES[:4], OTHER)
    with pytest.raises(RewrittenHistory, match="5 leaves and has 4"):
        history_check.read_signed(rewritten, OTHER.public_key, kept, retired)


def test_a_key_in_use_is_not_followed_by_a_retired_one(tmp_path: Path) -> None:
    """A copy of a retired key cannot take over from the one that followed it."""
    kept = keep_and_load(tmp_path / "kept.json", LEAVES[:5])
    old, other = (base64.b64encode(key.public_key).decode() for key in (KEY, OTHER))
    note = signed(LEAVES, OTHER)
    for retired in ([], [other], [old, other]):
        with pytest.raises(RewrittenHistory, match="another key"):
            history_check.read_signed(note, OTHER.public_key, kept, retired)


def test_leaves_are_those_that_were_signed() -> None:
    found = history_check.read_signed(signed(LEAVES[:5]), KEY.public_key, None)
    history_check.check_leaves(found, LEAVES)  # it may have grown since
    with pytest.raises(RewrittenHistory, match="5 leaves were signed, and 4"):
        history_check.check_leaves(found, LEAVES[:4])
    with pytest.raises(RewrittenHistory, match="not those that it signed"):
        history_check.check_leaves(found, LEAVES[::-1])


def test_a_file_that_is_no_checkpoint_is_said_to_be_none(tmp_path: Path) -> None:
    path = tmp_path / "kept.json"
    assert history_check.load_kept(path) is None
    for text in ("", "[]", '{"origin": 1}'):
        path.write_text(text)
        with pytest.raises(ValueError, match="holds no checkpoint"):
            history_check.load_kept(path)


def leaf(kind: str, entry_id: str = "a", **members: Any) -> str:
    published = {"run_id": "r", "submitter": "s", "level": "signed", "score": {"n": 1}}
    described = {"description": {"model_name": "m"}}
    said = {"publish": published | described}.get(kind, {})
    return json.dumps({"kind": kind, "entry_id": entry_id, **said, **members})


def shown(entry_id: str = "a", **members: Any) -> dict[str, Any]:
    entry = {"run_id": "r", "submitter": "s", "level": "signed", "score": {"n": 1}}
    return {"entry_id": entry_id, "model_name": "m", **entry, **members}


ODD, PUBLISHED = {"reason": "odd"}, leaf("publish")
FLAGGED, UNFLAGGED = leaf("flag", **ODD), leaf("unflag", reason="p")
RENAMED = leaf("change", description={"model_name": "n"})


@pytest.mark.parametrize(
    ("leaves", "entries", "found"),
    [
        ([], [], []),
        ([leaf("publish")], [shown()], []),
        ([leaf("publish")], [], ["a is in the history, and not shown"]),
        ([], [shown()], ["a is shown, and not in the history"]),
        ([leaf("publish"), leaf("withdraw")], [], []),
        ([leaf("publish"), leaf("hide")], [], []),
        ([leaf("publish"), leaf("hide"), leaf("publish")], [shown()], []),
        ([leaf("publish")], [shown(score={"n": 2})], ["a: score not as recorded"]),
        ([leaf("publish")], [shown(notes="n")], ["a: notes not as recorded"]),
        ([leaf("publish"), RENAMED], [shown(model_name="n")], []),
        ([leaf("publish"), FLAGGED], [shown(flag=ODD)], []),
        ([leaf("publish"), FLAGGED], [shown()], ["a: flag"]),
        ([leaf("publish"), FLAGGED, UNFLAGGED], [shown()], []),
        ([PUBLISHED, FLAGGED, leaf("hide"), PUBLISHED], [shown(flag=ODD)], []),
        ([PUBLISHED, FLAGGED, leaf("hide"), UNFLAGGED, PUBLISHED], [shown()], []),
        ([leaf("publish"), leaf("a_later_kind")], [shown()], []),
    ],
)
def test_entries_follow_from_the_leaves(
    leaves: list[str], entries: list[dict[str, Any]], found: list[str]
) -> None:
    recorded = history_check.entries_of(leaves)
    said = history_check.differences(recorded, entries)
    assert [text.removesuffix(" not as recorded") for text in said] == [
        text.removesuffix(" not as recorded") for text in found
    ]
