"""The operations of the profile `board`; every method raises ProctorError."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

from proctor_client import (
    BoardEntry,
    Checkpoint,
    HistoryLeaf,
    PublishEntry,
    Ranking,
)

from reference_client.protocol.connection import TIMEOUTS_S, Connection
from reference_client.protocol.list_pages import read_pages
from reference_client.protocol.retry_policy import RetryPolicy

PAGE = 1000


class BoardClient:
    """Entries, rankings and the history of one server."""

    def __init__(self, connection: Connection, retry_policy: RetryPolicy) -> None:
        self._control = connection.control
        self._retry_policy, self._call = retry_policy, retry_policy.call

    def publish(self, run_id: str, description: PublishEntry) -> BoardEntry:
        """The entry of the run, new or changed; a repeat changes nothing."""
        return self._call(
            lambda: self._control.publish_entry(
                run_id, description, _request_timeout=TIMEOUTS_S
            )
        )

    def entry(self, entry_id: str) -> BoardEntry:
        return self._call(
            lambda: self._control.get_entry(entry_id, _request_timeout=TIMEOUTS_S)
        )

    def withdraw(self, run_id: str) -> BoardEntry:
        return self._call(
            lambda: self._control.withdraw_entry(run_id, _request_timeout=TIMEOUTS_S)
        )

    def ranking(self, benchmark_id: str, manifest_sha256: str | None) -> Ranking:
        """The whole ranking: the rows of all its pages."""
        pages = read_pages(
            self._retry_policy,
            self._control.get_ranking,
            benchmark_id,
            manifest_sha256=manifest_sha256,
            limit=PAGE,
        )
        whole = next(pages)
        for page in pages:
            whole.rows.extend(page.rows)
        return whole

    def manifests(self, benchmark_id: str) -> Counter[str]:
        """manifest_sha256 → public entries, of the newest entries of a benchmark."""
        page = self._call(
            lambda: self._control.list_entries(
                benchmark_id=benchmark_id, limit=PAGE, _request_timeout=TIMEOUTS_S
            )
        )
        return Counter(
            entry.manifest_sha256 for entry in page.entries if entry.is_public
        )

    def entries(self) -> Iterator[BoardEntry]:
        """Entries that the account sees, the newest first."""
        operation = self._control.list_entries
        for page in read_pages(self._retry_policy, operation, limit=PAGE):
            yield from page.entries

    def leaves(self) -> Iterator[HistoryLeaf]:
        """The history, the oldest leaf first."""
        operation = self._control.list_history
        for page in read_pages(self._retry_policy, operation, limit=PAGE):
            yield from page.leaves

    def checkpoint(self) -> Checkpoint:
        return self._call(
            lambda: self._control.get_checkpoint(_request_timeout=TIMEOUTS_S)
        )

    def consistency(self, old_size: int, new_size: int) -> list[bytes]:
        """The proof between two sizes of the history."""
        proof = self._call(
            lambda: self._control.prove_consistency(
                str(old_size), str(new_size), _request_timeout=TIMEOUTS_S
            )
        )
        return [bytes.fromhex(digest) for digest in proof.hashes]
