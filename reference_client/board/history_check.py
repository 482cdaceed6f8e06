"""Whether the history of a leaderboard is whole, and its entries follow from it.

The last checkpoint that was right is kept in a file for each server: what it covers can
neither be changed nor taken out unseen. Pure but for that file: what a server shows is
fetched elsewhere.
"""

from __future__ import annotations

import base64
import json
from collections.abc import Container, Iterable, Mapping, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any, TypeGuard

from reference_record.command_line.replaced_file import replace_file
from reference_record.formats.user_folders import name_of_url, state_folder
from reference_record.history import checkpoint
from reference_record.history.checkpoint import Checkpoint, InvalidCheckpoint
from reference_record.history.merkle_tree import MerkleTree, is_consistent, leaf_hash

DESCRIPTION = (
    *("model_name", "model_type", "organisation", "homepage", "code_url", "notes"),
)


class RewrittenHistory(Exception):
    """The history is not what it was, or not what was signed; the text says how."""


@dataclass(frozen=True, slots=True)
class KeptCheckpoint:
    """The last one that was right. public_key: in base64. root_sha256: hexadecimal."""

    origin: str
    tree_size: int
    root_sha256: str
    public_key: str


def state_file(url: str) -> Path:
    """The file that keeps the checkpoint of a server, unless a flag names another."""
    return state_folder() / "boards" / f"{name_of_url(url)}.json"


def load_kept(path: Path) -> KeptCheckpoint | None:
    """The checkpoint of the last check; None before the first. Raises ValueError."""
    if not path.exists():
        return None
    try:
        return KeptCheckpoint(**json.loads(path.read_bytes()))
    except (ValueError, TypeError) as error:
        raise ValueError(f"{path} holds no checkpoint") from error


def keep(path: Path, signed: Checkpoint, public_key: bytes) -> None:
    """Keep the checkpoint in place of the previous one; the file is replaced whole."""
    path.parent.mkdir(parents=True, exist_ok=True)
    key = base64.b64encode(public_key).decode()
    kept = KeptCheckpoint(signed.origin, signed.tree_size, signed.root.hex(), key)
    replace_file(path, json.dumps(asdict(kept), indent=2) + "\n")


def read_signed(
    note: str,
    public_key: bytes,
    kept: KeptCheckpoint | None,
    retired: Container[str] = (),
) -> Checkpoint:
    """The checkpoint, signed by the key of the one that is kept, if there is one.

    retired: keys in base64 that the host publishes and does not sign with any more
    (REC-101). One of these may be followed by one in use, never the other way.
    Raises RewrittenHistory.
    """
    if has_another_key(kept, public_key) and (
        kept.public_key not in retired
        or base64.b64encode(public_key).decode() in retired
    ):
        raise RewrittenHistory(
            "it is signed by another key than before, and the host does not publish "
            "the old one as retired and this one as in use; if it has announced why, "
            "remove the file that keeps the old one"
        )
    try:
        signed = checkpoint.read(note, public_key)
    except InvalidCheckpoint as error:
        raise RewrittenHistory(f"its checkpoint is not right: {error}") from error
    if kept is not None and signed.tree_size < kept.tree_size:
        raise RewrittenHistory(
            f"it had {kept.tree_size} leaves and has {signed.tree_size}: some were "
            "taken out"
        )
    return signed


def has_another_key(
    kept: KeptCheckpoint | None, public_key: bytes
) -> TypeGuard[KeptCheckpoint]:
    """Whether the checkpoint that is kept was signed by another key."""
    return kept is not None and base64.b64decode(kept.public_key) != public_key


def check_consistency(
    kept: KeptCheckpoint, signed: Checkpoint, proof: Sequence[bytes]
) -> None:
    """Raises RewrittenHistory unless what was kept is the beginning of it."""
    old = bytes.fromhex(kept.root_sha256)
    if not is_consistent(kept.tree_size, old, signed.tree_size, signed.root, proof):
        raise RewrittenHistory(
            f"the first {kept.tree_size} leaves are not those that were kept: some "
            "were changed or taken out"
        )


def check_leaves(signed: Checkpoint, leaves: Sequence[str]) -> None:
    """Raises RewrittenHistory unless these leaves are what was signed."""
    covered = leaves[: signed.tree_size]
    if len(covered) < signed.tree_size:
        raise RewrittenHistory(
            f"{signed.tree_size} leaves were signed, and {len(covered)} are shown"
        )
    tree = MerkleTree(leaf_hash(leaf.encode()) for leaf in covered)
    if tree.root() != signed.root:
        raise RewrittenHistory("the leaves that are shown are not those that it signed")


def entries_of(leaves: Iterable[str]) -> dict[str, dict[str, Any]]:
    """entry_id → the entry by its leaves, for each entry that is public now.

    A flag stays while an entry is private: hiding does not get rid of it. Leaves of a
    kind that this version does not know change nothing.
    """
    entries: dict[str, dict[str, Any]] = {}
    flags: dict[str, str] = {}
    for text in leaves:
        leaf = json.loads(text)
        entry_id, kind = leaf.get("entry_id", ""), leaf["kind"]
        if kind == "publish":
            entries[entry_id] = leaf
        elif kind == "change" and entry_id in entries:
            entries[entry_id]["description"] = leaf["description"]
        elif kind in ("hide", "withdraw"):
            entries.pop(entry_id, None)
        elif kind == "flag":
            flags[entry_id] = leaf["reason"]
        elif kind == "unflag":
            flags.pop(entry_id, None)
    return {
        entry_id: {**leaf, "flag": flags.get(entry_id)}
        for entry_id, leaf in entries.items()
    }


def differences(
    recorded: Mapping[str, Mapping[str, Any]], shown: Iterable[Mapping[str, Any]]
) -> list[str]:
    """One sentence for each way in which the shown entries differ from the history."""
    sentences = []
    left = dict(recorded)
    for entry in shown:
        leaf = left.pop(entry["entry_id"], None)
        if leaf is None:
            sentences.append(f"{entry['entry_id']} is shown, and not in the history")
            continue
        wrong = [
            *(m for m in DESCRIPTION if entry.get(m) != leaf["description"].get(m)),
            *(m for m in ("run_id", "submitter", "level") if entry[m] != leaf[m]),
            *(() if entry["score"] == leaf["score"] else ("score",)),
            *(() if _reason(entry) == leaf["flag"] else ("flag",)),
        ]
        if wrong:
            sentences.append(f"{entry['entry_id']}: {', '.join(wrong)} not as recorded")
    sentences += [f"{entry_id} is in the history, and not shown" for entry_id in left]
    return sentences


def _reason(entry: Mapping[str, Any]) -> str | None:
    reason: str | None = (entry.get("flag") or {}).get("reason")
    return reason
