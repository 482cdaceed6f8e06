"""The history of a leaderboard: leaves, checkpoints, proofs (BRD), and who reads it.

Other checks publish at the same time, so each looks at the leaves of its own entries
and at sizes that the history has had.
"""

import base64
import json
from typing import Any

import rfc8785

from conformance.checks.support.published_runs import (
    BENCHMARK,
    Board,
    change_entry,
    description_of,
    listed_entries,
    read_leaves,
    require_entry,
)
from conformance.client.check_context import CheckContext
from conformance.profiles.history_tree import (
    consistency_proof,
    inclusion_path,
    read_note,
    tree_root,
)
from conformance.runner.requirement import requirement
from conformance.verdicts import expect
from conformance.verdicts.expect import SetUpFailed

# Proofs are read for these many of the last leaves, and the recursion is of all.
_SIZES = 9
PUBLISHED_MEMBERS = (
    *("run_id", "submitter", "benchmark_id", "benchmark_version", "manifest_sha256"),
    *("policy", "level", "score"),
)


def leaves_of(leaves: list[bytes], entry_id: str) -> list[dict[str, Any]]:
    """Give the leaves of one entry, parsed."""
    parsed = [json.loads(leaf) for leaf in leaves]
    return [leaf for leaf in parsed if leaf.get("entry_id") == entry_id]


def some_history(context: CheckContext) -> list[bytes]:
    """Make a history of a few leaves at least, and read it."""
    run = Board(context).play("10")
    require_entry(run)
    for number in range(1, _SIZES):
        change_entry(run, notes=str(number))
    leaves = read_leaves(context)
    if len(leaves) < _SIZES:
        text = f"{len(leaves)} leaves after {_SIZES} changes"
        raise SetUpFailed(text, breaks="BRD-013")
    return leaves


@requirement("BRD-013")
def test_brd_013_each_change_of_a_public_entry_is_a_leaf(context: CheckContext) -> None:
    """An entry is published, repeated, changed, hidden, changed, shown, withdrawn; its
    failure has a higher score than its successes. Expect a leaf for each change that
    others could see, and earlier ones unchanged."""
    run = Board(context).play("101", scores=(0.5, 1, 0.25))
    hidden = require_entry(Board(context).play("1"), is_public=False)
    before = read_leaves(context)
    entry = require_entry(run, notes="a")
    for members in (
        *({"notes": "a"}, {"notes": "b"}, {"notes": "b", "is_public": False}),
        *({"notes": "c", "is_public": False}, {"notes": "d"}),
    ):
        change_entry(run, **members)
    for _ in range(2):
        expect.ok(run.call("withdraw_entry"))
    after = read_leaves(context, limit=100)
    expect.equal(after[: len(before)], before, "the leaves that were there before")
    expect.equal(leaves_of(after, hidden["entry_id"]), [], "leaves of a private entry")
    leaves = leaves_of(after[len(before) :], entry["entry_id"])
    kinds = [leaf["kind"] for leaf in leaves]
    expected = ["publish", "change", "hide", "publish", "withdraw"]
    expect.equal(kinds, expected, "kinds of its leaves")
    described = [leaf.get("description") for leaf in leaves]
    notes = [description_of(notes=text) for text in "abd"]
    expect.equal(described, [*notes[:2], None, notes[2], None], "descriptions")
    for leaf in (leaves[0], leaves[3]):
        expect.equal(leaf["successes"], "101", "successes")
        for member in PUBLISHED_MEMBERS:
            expect.equal(leaf[member], entry[member], member)
    times = [leaf["at_ms"] for leaf in leaves]
    expect.equal(times, sorted(times), "at_ms, in order")


@requirement("BRD-023")
def test_brd_023_leaves_are_canonical(context: CheckContext) -> None:
    """Entries with whole and other scores, and with texts that JSON may write in
    several ways. Expect leaves that are their canonical text."""
    before = len(read_leaves(context))
    board = Board(context)
    for successes, scores in (("1", None), ("10", None), ("111", (1 / 3, 0.1, 1e-7))):
        board.add(successes, scores, notes='é "<&>"\\ \t\u2028')
    for leaf in read_leaves(context)[before:]:
        canonical = rfc8785.dumps(json.loads(leaf))
        expect.equal(leaf.decode(), canonical.decode(), "a leaf")


@requirement("BRD-014")
def test_brd_014_checkpoints_are_signed(context: CheckContext) -> None:
    """Checkpoints are read before and after an entry is published. Expect notes by the
    key in use, of the leaves that there are, and of one more."""
    keys = expect.ok(context.call("list_keys"))["keys"]
    in_use = {key["keyid"]: key for key in keys if key["retired_at"] is None}
    some_history(context)
    sizes = []
    for _ in range(2):
        there = len(read_leaves(context))
        checkpoint = expect.ok(context.call("get_checkpoint"))
        expect.true(checkpoint["keyid"] in in_use, "the key in use", checkpoint)
        key = base64.b64decode(in_use[checkpoint["keyid"]]["public_key"])
        read = read_note(checkpoint["note"], key)
        expect.equal(checkpoint["tree_size"], read.tree_size, "tree_size")
        expect.equal(checkpoint["root_sha256"], read.root_sha256, "root_sha256")
        expect.true(read.tree_size >= there, f"{there} leaves or more", read.tree_size)
        covered = read_leaves(context)[: read.tree_size]
        expect.equal(len(covered), read.tree_size, "leaves that it covers")
        root = tree_root(covered).hex()
        expect.equal(read.root_sha256, root, "the root of the leaves")
        sizes.append(read.tree_size)
        Board(context).add("1")
    expect.true(sizes[0] < sizes[1], "a size that grows", sizes)


@requirement("BRD-015")
def test_brd_015_inclusion_is_proven(context: CheckContext) -> None:
    """Proofs for leaves in histories of several sizes. Expect the path of each."""
    leaves = some_history(context)
    for size in {1, 2, *range(len(leaves) - _SIZES + 1, len(leaves) + 1)}:
        for index in {0, size // 2, size - 1}:
            params = {"leaf_index": index, "tree_size": size}
            proof = expect.ok(context.call("prove_inclusion", params=params))
            expected = params | {"hashes": inclusion_path(leaves[:size], index)}
            expect.equal({k: proof[k] for k in expected}, expected, "the proof")


@requirement("BRD-016")
def test_brd_016_consistency_is_proven(context: CheckContext) -> None:
    """Proofs between histories of several sizes. Expect that of each pair."""
    leaves = some_history(context)
    for new in {1, *range(len(leaves) - _SIZES + 1, len(leaves) + 1)}:
        for old in {1, (new + 1) // 2, max(1, new - 1), new}:
            params = {"old_size": old, "new_size": new}
            proof = expect.ok(context.call("prove_consistency", params=params))
            expected = params | {"hashes": consistency_proof(leaves[:new], old)}
            expect.equal({k: proof[k] for k in expected}, expected, "the proof")


@requirement("BRD-017")
def test_brd_017_cannot_prove_what_is_not_there(context: CheckContext) -> None:
    """Proofs for sizes and leaves that the history does not have. Expect
    `invalid_request`, and proofs for the right ones beside them."""
    size = len(some_history(context))
    beyond = 10**15 - 1
    inclusion = [(0, beyond), (size, size), (beyond, size), (0, 0)]
    for index, wrong in inclusion:
        params = {"leaf_index": index, "tree_size": wrong}
        answer = context.call("prove_inclusion", params=params)
        expect.refused(answer, "invalid_request")
    params = {"leaf_index": size - 1, "tree_size": size}
    expect.ok(context.call("prove_inclusion", params=params))
    for old, new in ((0, size), (size, size - 1), (1, beyond), (0, 0)):
        params = {"old_size": old, "new_size": new}
        answer = context.call("prove_consistency", params=params)
        expect.refused(answer, "invalid_request")
    params = {"old_size": size - 1, "new_size": size}
    expect.ok(context.call("prove_consistency", params=params))


@requirement("BRD-018")
def test_brd_018_a_public_board_is_read_without_a_token(context: CheckContext) -> None:
    """Every read of the board, without a token and with a wrong one. Expect what is
    public and nothing private, then `unauthenticated`."""
    board = Board(context)
    entry, private = board.add("1"), board.add("1", is_public=False)
    without_token = context.client_with_token(None)
    wrong_token = context.client_with_token("no-such-token")
    size = len(read_leaves(context))
    reads: list[tuple[str, dict[str, Any]]] = [
        ("list_entries", {}),
        ("get_entry", {"entry_id": entry["entry_id"]}),
        ("get_ranking", {"benchmark_id": BENCHMARK}),
        ("list_history", {}),
        ("get_checkpoint", {}),
        ("prove_inclusion", {"params": {"leaf_index": 0, "tree_size": size}}),
        ("prove_consistency", {"params": {"old_size": 1, "new_size": size}}),
    ]
    for operation_id, how in reads:
        expect.ok(context.call(operation_id, http_client=without_token, **how))
        if operation_id == "list_entries":
            both = {entry["entry_id"], private["entry_id"]}
            listed = listed_entries(context, both, without_token, limit=1000)
            expect.equal(listed, [entry["entry_id"]], "the public entry alone")
        refused = context.call(operation_id, http_client=wrong_token, **how)
        expect.refused(refused, "unauthenticated")
    refused = context.call(
        "get_entry", entry_id=private["entry_id"], http_client=without_token
    )
    expect.refused(refused, "not_found")
