"""A small part of `make attack` and `make chaos`; that each invariant can fail.

Bounds on latency are not judged here: the machine of a test is busy with others.
"""

from __future__ import annotations

import json
import math
import threading
from collections.abc import Iterable
from pathlib import Path
from types import SimpleNamespace
from typing import Any, cast

import asyncpg
import pytest

from reference_platform.submissions.interfaces import beginning_of
from reference_record.contents.statement import EpisodeLine
from reference_record.formats.envelope import sign_envelope
from reference_record.keys import make_key
from tests.campaigns.attack import attack_report
from tests.campaigns.attack.attack import Attack
from tests.campaigns.attack.attack_promises import Latency, Result
from tests.campaigns.attack.attacks import ATTACKS
from tests.campaigns.attack.measurement import measure_all
from tests.campaigns.attack.server_usage import MB, Usage
from tests.campaigns.chaos import chaos_report
from tests.campaigns.chaos.chaos_campaign import play_faults
from tests.campaigns.chaos.chaos_faults import FAULTS, FULL_AT, LINKS, RAY, faults_of
from tests.campaigns.chaos.chaos_rounds import Round
from tests.campaigns.chaos.write_audit import RecordAudit, WriteAudit
from tests.campaigns.players.invariants import check_histories
from tests.campaigns.players.raw_client import Answer
from tests.campaigns.players.records import missing_results, missing_turns
from tests.campaigns.players.run_history import History, Report, Sample
from tests.campaigns.players.watcher import Watcher
from tests.campaigns.soak import soak_command, soak_judge
from tests.campaigns.soak.participants import Handed
from tests.campaigns.soak.soak_host import FAULTS as HOST_FAULTS
from tests.support.server.postgresql_server import PostgresqlServer

TIMED = {"latency", "turns", "starts", "ready"}
# In an order in which one server serves several.
ATTACKS_PLAYED = (
    "endless heads",
    "pipelines",
    "long headers",
    "fuzz",
    "server kills",
    "recorded kills",
    "simulator kills",
    "torn log",
    "full disk",
    "clock jumps",
)
# Those that need no time of their own: each ends as soon as all players go on.
FAULTS_PLAYED = ("two nodes killed", "database process killed", "balancer – node cut")
RAY_FAULTS_PLAYED = ("Ray machine killed", "simulators killed")


def _attack(names: Iterable[str], part: float) -> None:
    for result in measure_all([ATTACKS[name] for name in names], seed=1, part=part):
        assert set(result.broken) <= TIMED, attack_report.console_line(result)
        assert result.report.sent, attack_report.console_line(result)


@pytest.mark.slow("attacks servers")
def test_a_small_part_of_the_attacks_breaks_nothing() -> None:
    _attack(ATTACKS_PLAYED, part=0.1)


@pytest.mark.release("all attacks of make attack, and all faults of make chaos")
def test_a_half_of_all_attacks_breaks_nothing() -> None:
    _attack(ATTACKS, part=0.5)


@pytest.mark.slow("breaks a cluster")
def test_a_cluster_goes_on_after_faults_and_loses_nothing() -> None:
    counts = play_faults(FAULTS_PLAYED, seed=1, players=4)
    assert counts.runs >= 4
    seen = counts.claims, counts.compared, counts.writes, counts.records
    assert all(seen), counts  # so there was something to find


@pytest.mark.release("all attacks of make attack, and all faults of make chaos")
@pytest.mark.parametrize("name", faults_of({LINKS}))
def test_a_cluster_goes_on_after_each_fault(name: str) -> None:
    play_faults([name], seed=3, players=3)


@pytest.mark.slow("breaks a cluster whose simulators are on Ray")
def test_a_cluster_on_ray_goes_on_without_a_machine() -> None:
    play_faults(RAY_FAULTS_PLAYED, seed=2, players=3, kinds={RAY})


@pytest.mark.release("all faults of make soak")
def test_submissions_outlast_the_faults_of_their_host() -> None:
    soak = soak_command.play(12, 3, list(HOST_FAULTS), seed=5, pause_s=3.0)
    assert not soak.findings
    assert soak.faults.total() >= 3


# --- each invariant is seen to fail ---


def _episode(index: int, score: float | None, **changes: Any) -> dict[str, Any]:
    whole: dict[str, Any] = {"index": index, "attempt": 1, "faults": 0}
    if score is not None:
        whole["result"] = {"index": index, "score": score, "steps": 3}
    return whole | changes


RIGHT = (_episode(0, 0.25), _episode(1, 0.75))


@pytest.mark.parametrize(
    ("played", "second", "score", "finding"),
    [
        ((0.25, 0.75), RIGHT[1], 0.5, ""),
        ((0.25,), _episode(1, None), 0.0, ""),
        ((0.25, 0.75), _episode(1, 0.5), 0.375, "is scored"),  # rescored
        ((0.25, 0.75), _episode(1, None), 0.0, "and is None"),  # lost
        ((0.25, 0.75), _episode(2, 0.75), 0.5, "episodes of"),  # doubled
        ((0.25, 0.75), RIGHT[1], 0.75, "and not 0.5"),  # wrong sum
        ((0.25, 0.75), _episode(1, 0.75, attempt=2), 0.5, "charged an attempt"),
        ((0.25, 0.75), _episode(1, 0.75, faults=1), 0.5, "charged 1 faults"),
        ((0.25,), RIGHT[1], 0.5, "None was played"),  # the result of no play
    ],
)
def test_a_run_that_does_not_add_up_is_found(
    played: tuple[float, ...], second: dict[str, Any], score: float, finding: str
) -> None:
    results = [_episode(index, score)["result"] for index, score in enumerate(played)]
    expected = {index: (score, 3) for index, score in enumerate(played)}
    history = History("r", 2, dict(enumerate(results)), expected)
    episodes = [RIGHT[0], second]
    is_complete = all("result" in episode for episode in episodes)
    answers = {
        "episodes": {"episodes": episodes, "next_cursor": None},
        "score": {"complete": is_complete, "score": score},
    }

    def request(_: str, path: str) -> Answer:
        value = answers[path.rpartition("/")[2]]
        return Answer(200, b"", json.dumps(value).encode())

    client: Any = SimpleNamespace(request=request)
    findings = " ".join(check_histories(client, [history]))
    assert finding in findings
    assert bool(findings) == bool(finding)


def test_a_record_that_lacks_something_is_found() -> None:
    """A turn that is not recorded, or twice, and a result that is another one."""
    line = EpisodeLine("e0", 0, "t", "s", "success", True, 0.5, 3, 1, None, None)
    result = {"outcome": "success", "score": 0.5, "steps": 3, "attempt": 1}
    assert list(missing_results([line], {0: result})) == []
    assert list(missing_results([line], {0: result | {"score": 0.25}}))
    assert list(missing_turns({1.0: 1}, [1.0])) == []
    assert len(list(missing_turns({1.0: 2}, [1.0, 2.0]))) == 2


class _FailedWatcher(Watcher):
    def step(self) -> None:
        self._begin("turn")
        raise AssertionError("it was answered 418")


def test_a_watcher_that_failed_is_a_finding_and_no_wait() -> None:
    watcher = _FailedWatcher("http://127.0.0.1:9", 1, "player0")
    watcher.start()
    watcher.end()
    assert watcher.waiting() == []
    assert "it was answered 418" in str(watcher.report.violations)


def _result(
    *, service_s: float = 0.01, turn_s: float = 0.02, rss: int = 100, back_s: float = 0
) -> Result:
    attack = Attack("one", "it", "all", lambda _: Report())
    calm = Latency.of(Sample(kind, 0.0, 0.02) for kind in ("service", "turn", "start"))
    before, peak = Usage(100 * MB, 20, 5), Usage(rss * MB, 20, 5)
    during = Latency(service_s, turn_s, 0.1)
    return Result(
        attack, Report(1), Report(), calm, during, before, peak, before, back_s, 1.0
    )


@pytest.mark.parametrize(
    ("changes", "broken"),
    [
        ({}, []),
        ({"service_s": 0.26}, ["latency"]),
        ({"service_s": math.nan}, ["latency"]),
        ({"turn_s": 0.13}, []),
        ({"turn_s": 0.15}, ["turns"]),
        ({"rss": 301}, ["memory"]),
        ({"back_s": math.nan}, ["back"]),
    ],
)
def test_a_bound_that_is_passed_is_a_broken_promise(
    changes: dict[str, Any], broken: list[str]
) -> None:
    result = _result(**changes)
    assert result.broken == broken
    states = [verdict.state for verdict in attack_report.judge_all([result])]
    assert states.count("broken") == len(broken)


def test_a_finding_of_a_round_breaks_the_promise_it_is_about() -> None:
    def broken(*findings: str) -> list[str]:
        waits_s = [0.5, 10.5] if "late" in findings else [0.5]
        played = Round(0, FAULTS["node killed"], waits_s, list(findings), count=1)
        verdicts = chaos_report.judge_all([played])
        return [verdict.text for verdict in verdicts if verdict.state == "broken"]

    assert broken() == []
    assert broken("node 2: Traceback …") == ["The log of no node has a traceback"]
    assert len(broken("a result was lost")) == 6
    assert "All go on" in broken("late")[-1]


@pytest.mark.parametrize(
    ("status", "code", "wrong"),
    [
        (200, "", 0),
        (404, "not_found", 0),
        (503, "unavailable", 0),
        (503, "", 1),
        (500, "internal_error", 1),
    ],
)
def test_errors_of_the_server_are_counted(status: int, code: str, wrong: int) -> None:
    report = Report()
    body = b'{"code": "%s"}' % code.encode() if code else b""
    report.add_answer(Answer(status, b"", body))
    assert (report.sent, report.wrong_5xx) == (1, wrong)


# --- what is written in a database ---


def _owned(owner: str, fence: int, writer: str = "") -> tuple[Any, ...]:
    return (7, owner, fence, None, None, writer or owner)


def _scored(result: str | None) -> tuple[Any, ...]:
    return (7, None, None, 0, result, "a")


@pytest.mark.parametrize(
    ("rows", "finding"),
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
def test_a_wrong_write_is_found(rows: list[tuple[Any, ...]], finding: str) -> None:
    written = [(number, *row) for number, row in enumerate(rows)]
    cluster: Any = SimpleNamespace(
        execute=lambda *statements: written if "FROM audit" in statements[-1] else []
    )
    findings = list(WriteAudit(cluster).judge())
    assert len(findings) == bool(finding)
    assert finding in "".join(findings)


@pytest.mark.parametrize(
    ("previous", "finding"),
    [((None, "sha of 1"), ""), (("other", "sha of 1"), "r1"), ((None, None), "r2")],
)
def test_statements_of_two_chains_are_found(
    tmp_path: Path, previous: tuple[str | None, ...], finding: str
) -> None:
    """As two nodes sign that do not know of each other."""
    key = make_key()
    rows: list[tuple[Any, ...]] = []
    for number, named in enumerate(previous, 1):
        said = {"predicate": {"previous_statement_sha256": named}}
        signed = sign_envelope(json.dumps(said).encode(), key)
        rows.append((number, f"r{number}", signed, f"sha of {number}"))
    cluster: Any = SimpleNamespace(execute=lambda _: rows)
    findings = list(RecordAudit(cluster, tmp_path).judge_chain())
    assert len(findings) == bool(finding)
    assert finding in "".join(findings)


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
        audit = WriteAudit(cast("Any", database))
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
    """Else the fault would be none."""
    with PostgresqlServer() as postgresql:
        database = _Database(postgresql)
        postgresql.limit_files(FULL_AT)
        with pytest.raises((asyncpg.PostgresError, OSError)):
            database.execute("INSERT INTO runs VALUES (1, 'a', 1)", "SELECT 1")
        postgresql.limit_files(None)
        postgresql.kill()
        postgresql.start()
        assert database.execute("SELECT * FROM runs") == []


SHOWN = {
    "state": "completed", "cause": "", "reason": "The score is 1.",
    "started_at": "2026", "run_id": "run_1",
}  # fmt: skip
PRINTED = [f"line {number}" for number in range(soak_judge.STEPS)]
PLATFORM = [
    "The policy listens.", "The sandbox has ended. The evaluation is over.",
    "State completed: The score is 1.",
]  # fmt: skip
KILLED = "The sandbox has ended. The policy was ended by SIGKILL."
THRICE_KILLED = [PLATFORM[0], beginning_of("evaluation"), *[KILLED] * 3, *PLATFORM[1:]]
ABANDONED = {"outcome": "abandoned", "attempt": 3, "steps": 2}


class SeenParticipant:
    """A participant of the soak, as it reads a host. changed: of a right one."""

    name = "player"

    def __init__(self, behaviour: str, **changed: Any) -> None:
        self._used, self._runs = changed.pop("used", 1), changed.pop("runs", {"run_1"})
        self._printed = changed.pop("printed", PRINTED)
        self._platform = changed.pop("platform", PLATFORM)
        self._result: dict[str, Any] = {"outcome": "success"} | changed.pop(
            "result", {}
        )
        self.report = Report(answers=changed.pop("answers", {}))
        is_ended = changed.pop("is_ended", True)
        shown = SHOWN | changed
        self.handed = [Handed("one", behaviour, shown=shown, is_ended=is_ended)]

    def log_of(self, _handed: Handed) -> list[dict[str, Any]]:
        first, *rest = self._platform
        lines = [("platform", first), *(("policy", text) for text in self._printed)]
        lines += [("platform", text) for text in rest]
        return [
            {"number": number, "source": source, "text": text}
            for number, (source, text) in enumerate(lines, 1)
        ]

    def result_of(self, _handed: Handed) -> dict[str, Any]:
        return self._result

    def used(self) -> int:
        return int(self._used)

    def run_ids(self) -> set[str]:
        return set(self._runs)


def _abandoned(printed: list[str], platform: list[str]) -> dict[str, Any]:
    """A participant whose episode used all its attempts up."""
    return {"printed": printed, "platform": platform, "result": ABANDONED}


@pytest.mark.parametrize(
    ("changed", "finding"),
    [
        ({}, ""),
        ({"is_ended": False}, "one: steady"),
        ({"reason": ""}, "ended as"),
        ({"state": "failed", "cause": "policy"}, "ended as"),
        ({"behaviour": "crash"}, "ended as"),
        ({"behaviour": "stopped", "state": "expired"}, "ended as"),
        ({"printed": PRINTED[:3] + PRINTED[4:]}, "line 4 follows 2"),
        ({"printed": PRINTED[:3]}, "of the last sandbox are missing"),
        (_abandoned(PRINTED[:3], THRICE_KILLED), ""),
        (_abandoned(PRINTED[:1], THRICE_KILLED), "of the last sandbox are missing"),
        (_abandoned(PRINTED[:3], PLATFORM), "0 of 3 attempts were lost for a reason"),
        ({"platform": PLATFORM[:2]}, "does not end with its end"),
        ({"platform": [*PLATFORM, PLATFORM[-1]]}, "written twice"),
        ({"platform": [PLATFORM[0], PLATFORM[2]]}, "end of its sandbox is missing"),
        ({"used": 2}, "2 are counted, not 1"),
        ({"runs": {"run_1", "run_2"}}, "runs of no submission"),
        ({"answers": {"500 internal_error": 1}}, "500 internal_error"),
    ],
)
def test_each_promise_of_the_soak_can_be_broken(
    changed: dict[str, Any], finding: str
) -> None:
    soak = soak_judge.Soak()
    seen = SeenParticipant(changed.pop("behaviour", "steady"), **changed)
    soak_judge.judge_participant(soak, cast(Any, seen))
    assert bool(soak.findings) == bool(finding), soak.findings
    assert any(finding in text for text in soak.findings) or not finding
