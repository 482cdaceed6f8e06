"""A short form of `make chaos`, and what it finds where something is wrong."""

from __future__ import annotations

import json
import threading
import time
from pathlib import Path
from random import Random
from types import SimpleNamespace
from typing import Any, cast

import asyncpg
import pytest

from reference_record.formats.envelope import sign_envelope
from reference_record.keys import make_key
from tests.attack.raw_client import Answer
from tests.attack.watcher import History
from tests.chaos import chaos_cluster, chaos_page
from tests.chaos.chaos_campaign import Campaign
from tests.chaos.chaos_cluster import ChaosCluster, ChaosNode
from tests.chaos.chaos_faults import FAULTS, FULL_AT, NODES_KILLED, PROMISED
from tests.chaos.chaos_rounds import (
    ROUNDS_MIN,
    Counts,
    KeptRounds,
    Round,
    broken_so_far,
    faults_to_play,
)
from tests.chaos.push_player import PushPlayer
from tests.chaos.write_audit import RecordAudit, WriteAudit
from tests.support.server.postgresql_server import LIBFAKETIME, PostgresqlServer
from tests.support.servers import NotStarted, ReferenceServer
from tools import built_pages

# Those that need no time of their own: each ends as soon as all players go on.
GATE = ("two nodes killed", "database process killed", "balancer – node cut")


@pytest.mark.slow("breaks a cluster")
def test_a_cluster_goes_on_after_faults_and_loses_nothing() -> None:
    with Campaign.open(seed=1, players=4, lease_s=1.0) as campaign:
        rounds = [
            campaign.play_fault(number, FAULTS[name], Random(number))
            for number, name in enumerate(GATE)
        ]
        counts = campaign.counts()
    assert [one.findings for one in rounds] == [[] for _ in GATE]
    assert counts.runs >= 4
    seen = counts.claims, counts.compared, counts.writes, counts.records
    assert all(seen), counts  # so there was something to find


@pytest.mark.slow("breaks a cluster whose simulators are on Ray")
def test_a_cluster_on_ray_goes_on_without_a_machine() -> None:
    names = ("Ray machine killed", "simulators killed")
    with Campaign.open(seed=2, players=3, lease_s=1.0, ray=True) as campaign:
        rounds = [
            campaign.play_fault(number, FAULTS[name], Random(number))
            for number, name in enumerate(names)
        ]
    assert [one.findings for one in rounds] == [[] for _ in names]
    assert all(one.waits_s for one in rounds)


def test_a_node_whose_database_does_not_answer_is_started_again(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    starts: list[int] = []

    def start(_: ReferenceServer) -> None:
        starts.append(len(starts))
        if len(starts) < 3:
            raise NotStarted("the database does not answer in time")

    monkeypatch.setattr(ReferenceServer, "start", start)
    monkeypatch.setattr(ReferenceServer, "end", lambda *_: None)
    ChaosNode(tmp_path, {})
    assert len(starts) == 3
    monkeypatch.setattr(chaos_cluster, "STARTS_MAX", 2)
    starts.clear()
    with pytest.raises(NotStarted):
        ChaosNode(tmp_path, {})
    assert len(starts) == 2


# --- what is judged ---


class _Written:
    """A database that has noted these writes."""

    def __init__(self, *rows: tuple[Any, ...]) -> None:
        self._rows = [(number, *row) for number, row in enumerate(rows)]

    def execute(self, *statements: str) -> list[tuple[Any, ...]]:
        return self._rows if "FROM audit" in statements[-1] else []


def _owned(owner: str, fence: int, writer: str = "") -> tuple[Any, ...]:
    return (7, owner, fence, None, None, writer or owner)


def _scored(result: str | None) -> tuple[Any, ...]:
    return (7, None, None, 0, result, "a")


@pytest.mark.parametrize(
    ("rows", "found"),
    [
        ([_owned("a", 1), _owned("a", 1), _owned("b", 2)], ""),
        ([_owned("a", 1), _owned("b", 1)], "was written"),
        ([_owned("a", 2), _owned("a", 1)], "was written"),
        ([_owned("a", 1), _owned("b", 2), _owned("a", 1)], "was written"),
        ([_owned("a", 1), _owned("b", 2), _owned("b", 2, "a")], "a wrote"),
        ([_scored(None), _scored("1"), _scored("1")], ""),
        ([_scored("1"), _scored("2")], "was replaced"),
        ([_scored("1"), _scored(None)], "was replaced"),
    ],
)
def test_a_wrong_write_is_found(rows: list[tuple[Any, ...]], found: str) -> None:
    audit = WriteAudit(cast("ChaosCluster", _Written(*rows)))
    sentences = list(audit.judge())
    assert len(sentences) == bool(found)
    assert found in "".join(sentences)


@pytest.mark.parametrize(
    ("previous", "found"),
    [((None, "sha of 1"), ""), (("other", "sha of 1"), "r1"), ((None, None), "r2")],
)
def test_statements_of_two_chains_are_found(
    tmp_path: Path, previous: tuple[str | None, ...], found: str
) -> None:
    """As two nodes sign that do not know of each other."""
    key = make_key()
    rows: list[tuple[Any, ...]] = []
    for number, named in enumerate(previous, 1):
        said = {"predicate": {"previous_statement_sha256": named}}
        signed = sign_envelope(json.dumps(said).encode(), key)
        rows.append((number, f"r{number}", signed, f"sha of {number}"))
    cluster: Any = SimpleNamespace(execute=lambda _: rows)
    sentences = list(RecordAudit(cluster, tmp_path).judge_chain())
    assert len(sentences) == bool(found)
    assert found in "".join(sentences)


class _Database:
    """A database without nodes, which has what the triggers need."""

    def __init__(self, postgresql: PostgresqlServer) -> None:
        self._postgresql = postgresql
        self._name = postgresql.create().partition("@/")[2].partition("?")[0]
        self.execute(
            "CREATE TABLE runs (number bigint, owner text, fence bigint)",
            "CREATE TABLE episodes (number bigint, index bigint, result text)",
            "SELECT 1",
        )

    def execute(self, *statements: str) -> list[tuple[Any, ...]]:
        return self._postgresql.execute(self._name, *statements)


@pytest.mark.slow("starts PostgreSQL")
def test_a_write_that_is_committed_late_is_judged() -> None:
    """It has the lower id of two, and is still open when the other one is stored."""
    with PostgresqlServer() as postgresql:
        database = _Database(postgresql)
        audit = WriteAudit(cast("ChaosCluster", database))
        late = ("INSERT INTO runs VALUES (1, 'a', 1)", "SELECT pg_sleep(1)")
        thread = threading.Thread(target=database.execute, args=late)
        thread.start()
        held = "SELECT 1 FROM pg_locks WHERE relation = 'audit'::regclass"
        while not database.execute(held):
            pass
        database.execute("INSERT INTO runs VALUES (2, 'a', 1)", "SELECT 1")
        assert list(audit.judge()) == []
        thread.join()
        assert list(audit.judge()) == []
    assert audit.rows == 2


@pytest.mark.slow("starts PostgreSQL")
def test_a_full_disk_ends_a_write() -> None:
    with PostgresqlServer() as postgresql:
        database = _Database(postgresql)
        postgresql.limit_files(FULL_AT)
        with pytest.raises((asyncpg.PostgresError, OSError)):
            database.execute("INSERT INTO runs VALUES (1, 'a', 1)", "SELECT 1")
        postgresql.limit_files(None)
        postgresql.kill()
        postgresql.start()
        assert database.execute("SELECT * FROM runs") == []


@pytest.mark.slow("starts PostgreSQL")
@pytest.mark.skipif(LIBFAKETIME is None, reason="needs the package libfaketime")
def test_the_clock_of_a_database_jumps() -> None:
    ask = "SELECT extract(epoch FROM clock_timestamp())::float8"
    with PostgresqlServer(has_clock=True) as postgresql:
        for shift_s in (3600.0, -3600.0):
            postgresql.shift_clock(shift_s)
            [[now]] = postgresql.execute("postgres", ask)
            assert now - time.time() == pytest.approx(shift_s, abs=60)


def test_reading_a_push_run_is_no_progress(monkeypatch: pytest.MonkeyPatch) -> None:
    """It is read four times and changes once."""
    player = PushPlayer("http://127.0.0.1:1", 1, "p", 1.0)
    states = [("running", 0), ("running", 0), ("running", 1), ("completed", 1)]
    answers = (
        Answer(200, b"", json.dumps({"state": state, "progress": done}).encode())
        for state, done in states
    )
    monkeypatch.setattr(player, "_until_answered", lambda *_: next(answers))
    player._watch(history := History("r", 1))
    assert history.is_done
    assert [sample.kind for sample in player.samples] == ["progress"]


def test_the_page_shows_promises_and_faults(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(built_pages, "BUILD", tmp_path)
    played = Round(0, FAULTS["node killed"], [0.5, 6.0], ["a result was lost"])
    played.count = 1
    assert "BROKEN" in chaos_page.round_line(played)
    chaos_page.write([played], chaos_page.Conditions([1, 2], 2, 5.0, 0.5))
    text = (tmp_path / "chaos.md").read_text()
    assert "| 1,000 nodes killed: no result lost, doubled, rescored | 1 | **b" in text
    assert "at most 10 s | 6.0 s | kept |" in text
    assert "| The log of no node has a traceback | 0 | kept |" in text
    assert "| node killed | SIGKILL, started when all go on | 1 | 0.5 |" in text
    assert text.endswith("| 6.0 | 1 |\n")


def test_a_traceback_is_no_lost_result(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(built_pages, "BUILD", tmp_path)
    found = ["node 2: Traceback (most recent call last): …"]
    played = Round(0, FAULTS["node killed"], [0.5], found, count=1000)
    chaos_page.write([played], chaos_page.Conditions([1], 2, 5.0, 0.5))
    text = (tmp_path / "chaos.md").read_text()
    assert (
        "| 1,000 nodes killed: no result lost, doubled, rescored | 1,000 | kept" in text
    )
    assert "| The log of no node has a traceback | 1 | **broken** |" in text


# --- a long campaign ---


def _played(name: str, count: int, number: int = 0) -> Round:
    return Round(number, FAULTS[name], [0.5], [], count, Counts(1, 2, 3, 4, 5))


def test_a_long_campaign_ends_when_all_was_tried() -> None:
    rarely = [_played(name, 1) for name in FAULTS for _ in range(ROUNDS_MIN)]
    left = faults_to_play(rarely)
    assert {FAULTS[name].promise for name in left} == set(PROMISED)
    missing = PROMISED[NODES_KILLED] - broken_so_far(rarely)[NODES_KILLED]
    assert "node killed" in faults_to_play(
        [*rarely, _played("node killed", missing - 1)]
    )
    enough = [*rarely, _played("node killed", missing)]
    assert not {"node killed", "two nodes killed"} & set(faults_to_play(enough))
    most = [_played(left_over, 1000) for left_over in left]
    assert faults_to_play([*rarely, *most]) == []
    assert faults_to_play([*rarely[:-1], *most]) == [rarely[-1].fault.name]


def test_a_long_campaign_goes_on_where_it_ended(tmp_path: Path) -> None:
    file = tmp_path / "var" / "chaos.jsonl"
    kept = KeptRounds({"commit": "a"}, file)
    kept.add(_played("node killed", 1, number=7), 2.5)
    KeptRounds({"commit": "b"}, file).add(_played("node ended", 1), 0.0)
    again = KeptRounds({"commit": "a"}, file)
    assert again.rounds == kept.rounds
    assert again.loads == [2.5]
    assert KeptRounds({"commit": "a"}, None).rounds == []


def test_clusters_that_are_broken_at_once_share_what_they_played(
    tmp_path: Path,
) -> None:
    """Each reads what the others have added, once, and no half of a line."""
    file = tmp_path / "var" / "chaos.jsonl"
    one, other = (KeptRounds({"commit": "a"}, file) for _ in range(2))
    one.add(_played("node killed", 1), 1.0)
    other.add(_played("node ended", 1), 1.0)
    other.rounds[-1].seed = 2
    with file.open("a") as writer:
        writer.write('{"under": {"comm')
        writer.flush()
        one.refresh()
        one.refresh()
        assert [kept.fault.name for kept in one.rounds] == ["node killed", "node ended"]
        writer.write('it": "b"}}\n')
    one.refresh()
    assert len(one.rounds) == 2
    assert [other.played_with(seed) for seed in (0, 2, 3)] == [1, 1, 0]
