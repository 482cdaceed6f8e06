"""The history of the leaderboard as a tree: its checkpoints and proofs.

The leaves are in the database; the tree of their hashes is kept in memory and grows
with them. It does not know what the leaves say.
"""

from __future__ import annotations

import asyncio
import re

from reference_record.history import checkpoint
from reference_record.history.checkpoint import Checkpoint
from reference_record.history.merkle_tree import MerkleTree
from reference_server.records.run_records import RunRecords
from reference_server.storage.board_store import BoardStore

_NOT_IN_A_NAME = re.compile(r"[\s+]")


class BoardHistory:
    """The tree over all leaves of a store, signed by the key of records."""

    def __init__(self, store: BoardStore, records: RunRecords) -> None:
        self._store, self._records = store, records
        self._tree = MerkleTree()
        self._reading = asyncio.Lock()

    async def tree(self) -> MerkleTree:
        """The tree of all leaves that are stored now."""
        async with self._reading:
            for hashed in await self._store.leaf_hashes(len(self._tree)):
                self._tree.append(hashed)
            return self._tree

    async def sign(self) -> tuple[Checkpoint, str, str]:
        """The checkpoint, its note and the keyid of the key (BRD-014)."""
        tree = await self.tree()
        key = self._records.key
        signed = Checkpoint(self._origin, len(tree), tree.root())
        return signed, checkpoint.sign(signed, key), key.keyid

    @property
    def _origin(self) -> str:
        host = self._records.host_name.partition("://")[2] or self._records.host_name
        return _NOT_IN_A_NAME.sub("_", host.strip("/"))[:180] + "/board"
