"""A small part of `make attack`, and the arithmetic by which it judges.

Bounds on latency are not judged here: the machine of a test is busy with others.
"""

from __future__ import annotations

import math
from typing import Any, Self, cast

import pytest

from reference_record.statement import EpisodeLine
from tests.attack import reliability_page
from tests.attack.attack import Attack, Report, Target
from tests.attack.attacks import ATTACKS, recorded_kills
from tests.attack.attacks.recorded_kills import Worker, missing
from tests.attack.invariants import check_histories
from tests.attack.measurement import measure_all
from tests.attack.raw_client import Answer, RawClient
from tests.attack.server_usage import MB, Usage
from tests.attack.verdicts import PROMISES, Latency, Result, judge, percentile
from tests.attack.watcher import History, Sample, Watcher

TIMED = {"latency", "turns", "starts", "ready"}
# In an order in which one server serves several.
GATE = (
    "endless heads",
    "pipelines",
    "long headers",
    "ids of others",
    "colliding keys",
    "wrong values",
    "pickles",
    "fuzz",
    "server kills",
    "recorded kills",
    "simulator kills",
    "torn log",
    "full disk",
    "clock jumps",
    "hostile urls",
)


@pytest.mark.slow("attacks servers")
def test_a_small_part_of_the_attacks_breaks_nothing() -> None:
    chosen = [ATTACKS[name] for name in GATE]
    for result in measure_all(chosen, seed=1, part=0.1):
        assert set(result.broken) <= TIMED, reliability_page.console_line(result)
        assert result.report.sent, reliability_page.console_line(result)


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


# --- what is judged ---


class _FakeClient:
    """Answers what a server could have stored."""

    def __init__(self, episodes: list[dict[str, Any]], score: float) -> None:
        complete = all("result" in one for one in episodes)
        self._episodes = {"episodes": episodes, "next_cursor": None}
        self._score = {"complete": complete, "score": score if complete else None}

    def request(self, _method: str, path: str) -> Answer:
        return _Plain(self._score if path.endswith("score") else self._episodes)


class _Plain(Answer):
    def __init__(self, value: Any) -> None:
        super().__init__(200, b"", b"")
        object.__setattr__(self, "value", value)

    def json(self) -> Any:
        return cast("Any", self).value


def _episode(index: int, score: float | None, **changes: Any) -> dict[str, Any]:
    whole: dict[str, Any] = {"index": index, "attempt": 1, "faults": 0}
    if score is not None:
        whole["result"] = {"index": index, "score": score, "steps": 3}
    return whole | changes


def _history(*scores: float) -> History:
    acknowledged = {n: _episode(n, score)["result"] for n, score in enumerate(scores)}
    expected = {n: (score, 3) for n, score in enumerate(scores)}
    return History("r", 2, acknowledged, expected)


def _findings(history: History, *episodes: dict[str, Any], score: float) -> str:
    client = cast("RawClient", _FakeClient(list(episodes), score))
    return " ".join(check_histories(client, [history]))


def test_what_adds_up_is_right() -> None:
    right = [_episode(0, 0.25), _episode(1, 0.75)]
    assert _findings(_history(0.25, 0.75), *right, score=0.5) == ""
    partly = [_episode(0, 0.25), _episode(1, None)]
    assert _findings(_history(0.25), *partly, score=0.0) == ""


@pytest.mark.parametrize(
    ("second", "score", "about"),
    [
        (_episode(1, 0.5), 0.375, "is scored"),  # rescored
        (_episode(1, None), 0.0, "and is None"),  # lost
        (_episode(2, 0.75), 0.5, "episodes of"),  # doubled, or another
        (_episode(1, 0.75), 0.75, "and not 0.5"),  # wrong sum
        (_episode(1, 0.75, attempt=2), 0.5, "charged an attempt"),
        (_episode(1, 0.75, faults=1), 0.5, "charged 1 faults"),
    ],
)
def test_what_does_not_add_up_is_found(
    second: dict[str, Any], score: float, about: str
) -> None:
    episodes = (_episode(0, 0.25), second)
    assert about in _findings(_history(0.25, 0.75), *episodes, score=score)


def test_a_result_of_no_play_is_found() -> None:
    episodes = (_episode(0, 0.25), _episode(1, 0.75))
    assert "None was played" in _findings(_history(0.25), *episodes, score=0.5)


def test_what_a_record_lacks_is_found() -> None:
    """A turn that is not recorded, or twice, and a result that is another one."""
    line = EpisodeLine("e0", 0, "t", "s", "success", True, 0.5, 3, 1, None, None)
    result = {"outcome": "success", "score": 0.5, "steps": 3, "attempt": 1}
    assert list(missing({1.0: 1}, [line], [1.0], {0: result})) == []
    found = list(missing({1.0: 2}, [line], [1.0, 2.0], {0: result | {"score": 0.25}}))
    assert len(found) == 3
    assert "turn of 1 is recorded 2 times" in found[0]
    assert "turn of 2 is recorded 0 times" in found[1]
    assert "acknowledged as ('success', 0.25" in found[2]


class _Answers:
    """A client that is answered one of these after the other."""

    def __init__(self, *answers: Answer) -> None:
        self._answers = list(answers)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        pass

    def request(self, *_: Any) -> Answer:
        return self._answers.pop(0)


_TARGET = Target("", "", [], seed=1, size=1, seconds=1)


def test_a_wrong_answer_to_a_worker_is_counted(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    wrong = Answer(500, b"", b'{"code": "internal_error"}')
    completed = Answer(200, b"", b'{"state": "completed"}')
    monkeypatch.setattr(Target, "client", lambda *_, **__: _Answers(wrong, completed))
    worker = Worker(_TARGET, "r", 1)
    worker.run()
    assert (worker.report.wrong_5xx, worker.report.violations) == (1, [])


def test_workers_that_end_are_findings_and_end_the_kills(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Each worker is answered wrongly at once. Expect an end, with what was found."""
    wrong = Answer(200, b"", b"{}")
    monkeypatch.setattr(recorded_kills, "_submit", lambda _: "r")
    monkeypatch.setattr(recorded_kills, "_check_record", lambda *_: iter(()))
    monkeypatch.setattr(recorded_kills, "server_of", lambda _: None)
    monkeypatch.setattr(Target, "client", lambda *_, **__: _Answers(wrong))
    report = recorded_kills.kill_recording_server(_TARGET)
    assert report.sent == 0
    assert sum("KeyError" in one for one in report.violations) == recorded_kills.WORKERS


@pytest.mark.parametrize(
    ("values", "expected"),
    [([], math.nan), ([7.0], 7.0), ([float(n) for n in range(1, 201)], 198.0)],
)
def test_percentile(values: list[float], expected: float) -> None:
    assert percentile(values, 0.99) == pytest.approx(expected, nan_ok=True)


def _result(
    *, service_s: float = 0.01, turn_s: float = 0.02, rss: int = 100, back_s: float = 0
) -> Result:
    attack = Attack("one", "it", "all", lambda _: Report())
    calm = Latency.of(Sample(kind, 0.0, 0.02) for kind in ("service", "turn", "start"))
    before, peak = Usage(100 * MB, 20, 5), Usage(rss * MB, 20, 5)
    during = Latency(service_s, turn_s, 0.1)
    result = Result(
        attack, Report(1), Report(), calm, during, before, peak, before, back_s, 1.0
    )
    judge(result)
    return result


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
    verdicts = [line.split()[0] for line in reliability_page.promise_lines([result])]
    assert verdicts.count("broken") == len(broken)
    assert len(verdicts) == len(PROMISES)


@pytest.mark.parametrize(
    ("status", "code", "wrong"),
    [
        (200, "", 0),
        (404, "not_found", 0),
        (503, "unavailable", 0),
        (503, "no_capacity", 0),
        (503, "", 1),
        (500, "internal_error", 1),
    ],
)
def test_errors_of_the_server_are_counted(status: int, code: str, wrong: int) -> None:
    report = Report()
    body = b'{"code": "%s"}' % code.encode() if code else b""
    report.add_answer(Answer(status, b"", body))
    assert (report.sent, report.wrong_5xx) == (1, wrong)
