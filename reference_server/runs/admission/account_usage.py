"""Counts for each account all that its quota bounds; decides and stores nothing.

A run counts from the moment at which it is submitted or resumed, so that requests at
the same time count each other.
"""

from __future__ import annotations

from collections.abc import Mapping

from reference_server.rules.capacity import (
    Quota,
    below_quota,
    below_storage_quota,
)
from reference_server.rules.refusal import Refused
from reference_server.rules.runs.lifecycle import OPEN_STATES, Refuse
from reference_server.rules.runs.run import Run, State
from reference_server.runs.admission.disk_bound import DiskBound
from reference_server.runs.memory.run_events import Departure, RunFollower
from reference_server.storage.runs.rows import RUN_BYTES, stored_bytes


class AccountUsage(RunFollower):
    """Open runs, Idempotency-Keys and stored bytes of each account.

    disk_bound: of all accounts together.
    """

    def __init__(self, quota: Quota, disk_bound: DiskBound | None = None) -> None:
        self.quota, self._disk_bound = quota, disk_bound or DiskBound()
        self._open: dict[str, set[str]] = {}  # ids of open runs
        self._keys: dict[str, int] = {}
        self._bytes: dict[str, int] = {}

    def load_stored(self, keys: Mapping[str, int], size: Mapping[str, int]) -> None:
        """Begin with what the database has of each account."""
        self._keys, self._bytes = dict(keys), dict(size)

    def loaded(self, run: Run, stored: State) -> None:
        self.changed(run)

    def changed(self, run: Run) -> None:
        self.note_open(run.account, run.run_id, is_open=run.state in OPEN_STATES)

    def left(self, run: Run, why: Departure) -> None:
        if why == "unstored":  # it is counted until it is known what the store has
            return
        self.note_open(run.account, run.run_id, is_open=False)
        if why == "deleted":
            self._note_deleted(run)

    def note_submitted(self, run: Run, key: str | None) -> None:
        """Count at once: what is submitted at the same time counts it, too."""
        self.note_open(run.account, run.run_id, is_open=True)
        self._note_size(run, key, 1)

    def note_not_stored(self, run: Run, key: str | None) -> None:
        """The submitted run could not be stored: take it from the counts again."""
        self.note_open(run.account, run.run_id, is_open=False)
        self._note_size(run, key, -1)

    def note_open(self, account: str, run_id: str, *, is_open: bool) -> None:
        ids = self._open.setdefault(account, set())
        if is_open:
            ids.add(run_id)
        else:
            ids.discard(run_id)

    def count_open(self) -> int:
        """The number of open runs of all accounts."""
        return sum(map(len, self._open.values()))

    def forget_open(self) -> None:
        """Other servers have the runs now."""
        self._open.clear()

    def _note_size(self, run: Run, key: str | None, sign: int) -> None:
        size = self._bytes.get(run.account, 0) + sign * stored_bytes(run)
        self._bytes[run.account] = size
        if key is not None:
            self._keys[run.account] = self._keys.get(run.account, 0) + sign

    def _note_deleted(self, run: Run) -> None:
        """DEL-005, DEL-006: its key and its row are kept."""
        left = self._bytes.get(run.account, 0) - stored_bytes(run) + RUN_BYTES
        self._bytes[run.account] = left

    def note_kept(self, account: str, size_bytes: int) -> None:
        """Count what the history of the leaderboard keeps for good."""
        self._bytes[account] = self._bytes.get(account, 0) + size_bytes

    def check_kept(self, has: Quota) -> None:
        """Refuse if no more may be kept for an account that has so much."""
        _raise_if(below_storage_quota(has, self.quota, has_key=False))

    def check_open(self, account: str) -> None:
        """Refuse if the account has as many open runs as it may have."""
        self.check_open_runs(len(self._open.get(account, ())))

    def check_open_runs(self, open_runs: int) -> None:
        """Refuse if that is as many as an account may have open."""
        _raise_if(below_quota(open_runs, self.quota.open_runs))

    def check_opened(self, has: Quota) -> None:
        """Refuse if an account that has so much may not have another run open."""
        self.check_open_runs(has.open_runs)

    def check_stored(self, has_key: bool, has: Quota) -> None:
        """Refuse if an account that has so much may not have another run."""
        self._disk_bound.check()
        self.check_open_runs(has.open_runs)
        _raise_if(below_storage_quota(has, self.quota, has_key=has_key))

    def check_new(self, account: str, *, has_key: bool) -> None:
        """Refuse if the account may not have another run."""
        self._disk_bound.check()
        self.check_open(account)
        has = Quota(
            keys=self._keys.get(account, 0), stored_bytes=self._bytes.get(account, 0)
        )
        _raise_if(below_storage_quota(has, self.quota, has_key=has_key))


def _raise_if(refused: Refuse | None) -> None:
    if refused is not None:
        raise Refused.from_verdict(refused)
