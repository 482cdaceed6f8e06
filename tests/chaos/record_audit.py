"""The records of completed runs, and the chain that their statements make, judged.

Who owned a run, and how often that changed, is not seen in its record: it verifies,
and has every result as it was acknowledged.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from pathlib import Path

import msgspec

from reference_record.broken import BrokenRecord
from reference_record.formats.bundle import open_bundle
from reference_record.formats.envelope import read_envelope
from reference_record.formats.names import EPISODES, STATEMENT
from reference_record.statement import read_lines
from reference_record.verification import verify
from tests.attack.attacks.recorded_kills import missing
from tests.attack.raw_client import RawClient
from tests.attack.watcher import History
from tests.chaos.chaos_cluster import ChaosCluster

_LATER = (
    "SELECT number, run_id, statement, sha256 FROM statements WHERE number > {} "
    "ORDER BY number"
)


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
        answer = client.request("GET", f"/v1/runs/{history.run_id}/record")
        if answer.status != 200:
            yield f"{answer.status} {answer.code}"
            return
        path = self._directory / f"{history.run_id}.proctor"
        path.write_bytes(answer.body)
        bundle = open_bundle(path)
        try:
            verify(bundle)
            lines = list(read_lines(bundle.blocks(EPISODES)))
            yield from missing({}, lines, (), history.acknowledged)
        except BrokenRecord as broken:
            yield str(broken)
        self.records += 1
        path.unlink()

    def judge_chain(self) -> Iterator[str]:
        """About what was signed since the last time."""
        for row in self._cluster.execute(_LATER.format(self._number)):
            self._number, run_id, statement, sha256 = row
            payload = read_envelope(STATEMENT, statement).payload
            said = msgspec.json.decode(payload, type=_Statement)
            named = said.predicate.previous_statement_sha256
            if named != self._last:
                yield f"the statement of {run_id} names {named}, not {self._last}"
            self._last = sha256
