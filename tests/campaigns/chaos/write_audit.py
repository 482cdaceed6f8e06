"""What a cluster has written: every write of runs and episodes, and every record.

Triggers in the database note writes. They show what the protocol does not: a result
that was written twice, and a write by a node that was not the owner any more. Who owned
a run, and how often that changed, is not seen in its record: it verifies, and has every
result as it was acknowledged.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import NamedTuple

import msgspec

from reference_record.formats.envelope import read_envelope
from reference_record.formats.names import STATEMENT
from tests.campaigns.chaos.clusters.chaos_cluster import ChaosCluster
from tests.campaigns.players.raw_client import RawClient
from tests.campaigns.players.records import (
    WrongRecord,
    missing_results,
    verified_record,
)
from tests.campaigns.players.run_history import History

_TABLES = (
    """CREATE TABLE audit (id bigserial, number bigint, owner text, fence bigint,
        index bigint, result text, writer text DEFAULT current_user)""",
    """CREATE FUNCTION note_run() RETURNS trigger AS $$ BEGIN
        INSERT INTO audit (number, owner, fence)
        VALUES (NEW.number, NEW.owner, coalesce(NEW.fence, 0));
        RETURN NEW; END $$ LANGUAGE plpgsql""",
    """CREATE FUNCTION note_episode() RETURNS trigger AS $$ BEGIN
        INSERT INTO audit (number, index, result)
        VALUES (NEW.number, NEW.index, NEW.result::text);
        RETURN NEW; END $$ LANGUAGE plpgsql""",
    """CREATE TRIGGER note_run AFTER INSERT OR UPDATE ON runs
        FOR EACH ROW EXECUTE FUNCTION note_run()""",
    """CREATE TRIGGER note_episode AFTER INSERT OR UPDATE ON episodes
        FOR EACH ROW EXECUTE FUNCTION note_episode()""",
    "SELECT 1",
)
# Waits for the transactions that have written: one of them may have an id below others
# that are read already.
_WAIT = "LOCK TABLE audit IN SHARE MODE"
# Those of one run are in the order of their transactions, for each changes its row.
_LATER = (
    "SELECT id, number, owner, fence, index, result, writer FROM audit WHERE id > {} "
    "ORDER BY id"
)

_SIGNED_LATER = (
    "SELECT number, run_id, statement, sha256 FROM statements WHERE number > {} "
    "ORDER BY number"
)


class Owned(NamedTuple):
    owner: str | None
    fence: int


class WriteAudit:
    """Of one cluster, from its first run on. rows, claims: how many it has seen."""

    def __init__(self, cluster: ChaosCluster) -> None:
        self._cluster = cluster
        self._last = 0
        self._owned: dict[int, Owned] = {}
        self._writers: dict[str | None, str] = {}  # by owner
        self._results: dict[tuple[int, int], str] = {}
        self.rows = self.claims = 0
        cluster.execute(*_TABLES)

    def judge(self) -> Iterator[str]:
        """Sentences about what was written since the last time and must not be."""
        for row in self._cluster.execute(_WAIT, _LATER.format(self._last)):
            self.rows += 1
            self._last, number, owner, fence, index, result, writer = row
            if index is None:
                yield from self._judge_owner(number, Owned(owner, fence), writer)
            else:
                yield from self._judge_result((number, index), result)

    def _judge_owner(self, number: int, new: Owned, writer: str) -> Iterator[str]:
        """Who makes a run or claims it writes its owner, and writes alone from then on.

        writer: the user of the database; each node has its own.
        """
        old = self._owned.get(number)
        self._owned[number] = new
        if old != new:
            self._writers[new.owner] = writer
        elif self._writers[new.owner] != writer:
            yield f"run number {number}: {writer} wrote, the owner is {new}"
        if old is None or old == new:
            return
        self.claims += 1
        if new.fence <= old.fence:
            yield f"run number {number}: after {old} was written {new}"

    def _judge_result(self, place: tuple[int, int], new: str | None) -> Iterator[str]:
        old = self._results.get(place)
        if new is not None:
            self._results[place] = new
        if old is not None and new != old:
            yield f"run number, index {place}: {old} was replaced by {new}"


class _Predicate(msgspec.Struct):
    previous_statement_sha256: str | None


class _Statement(msgspec.Struct):
    predicate: _Predicate


class RecordAudit:
    """Of one cluster, from its first run on. records: how many it has verified."""

    def __init__(self, cluster: ChaosCluster, directory: Path) -> None:
        self._cluster, self._directory = cluster, directory
        self._last: str | None = None
        self._number = 0
        self.records = 0

    def judge(self, client: RawClient, histories: Iterable[History]) -> Iterator[str]:
        """Sentences about what is wrong with the records of these runs."""
        for history in histories:
            for found in self._judge_record(client, history):
                yield f"record of {history.run_id}: {found}"
        yield from self.judge_chain()

    def _judge_record(self, client: RawClient, history: History) -> Iterator[str]:
        try:
            with verified_record(client, history.run_id, self._directory) as record:
                self.records += 1
                yield from missing_results(record.lines, history.acknowledged)
        except WrongRecord as wrong:
            yield str(wrong)

    def judge_chain(self) -> Iterator[str]:
        """About what was signed since the last time."""
        for row in self._cluster.execute(_SIGNED_LATER.format(self._number)):
            self._number, run_id, statement, sha256 = row
            payload = read_envelope(STATEMENT, statement).payload
            said = msgspec.json.decode(payload, type=_Statement)
            named = said.predicate.previous_statement_sha256
            if named != self._last:
                yield f"the statement of {run_id} names {named}, not {self._last}"
            self._last = sha256
