"""Experiment trackers: the calls that they receive, and evaluations without them.

The libraries here note their calls; with the real ones it was played by hand.
"""

from __future__ import annotations

import importlib.util
import sys
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from proctor_client import Run

from reference_client import evaluate
from reference_client.view.trackers import tracking
from reference_client.view.trackers.tracker_libraries import make_tracker
from tests.support.client.command import Proctor, options
from tests.support.client.evaluations import calibration_evaluation
from tests.support.client.policies import GradedPolicy
from tests.support.paths import ROOT
from tests.support.servers import ReferenceServer

PAGE = (ROOT / "docs" / "evaluate" / "trackers.md").read_text()
TASKS = ["score"] * 4


class Recorder:
    """A tracker of one's own; `broken` names the method that raises."""

    def __init__(self, broken: str = "") -> None:
        self.calls: list[tuple[str, Any]] = []
        self._broken = broken

    def _note(self, name: str, value: Any) -> None:
        self.calls.append((name, value))
        if name == self._broken:
            raise RuntimeError("no\nnetwork")

    def begin(self, run: Run, link: str, config: Mapping[str, Any]) -> None:
        self._note("begin", (run.run_id, link, config))

    def log(self, step: int, numbers: Mapping[str, float]) -> None:
        self._note("log", (step, numbers))

    def finish(
        self,
        numbers: Mapping[str, float],
        episodes: Sequence[Mapping[str, Any]],
        videos: Sequence[Path],
    ) -> None:
        self._note("finish", (numbers, episodes, [path.name for path in videos]))

    def fail(self, reason: str) -> None:
        self._note("fail", reason)

    @property
    def names(self) -> list[str]:
        return [name for name, _ in self.calls]


def play(server: ReferenceServer, log: Any, **more: Any) -> Any:
    given = calibration_evaluation(*TASKS) | more
    return evaluate(GradedPolicy, url=server.url, log=log, **given)


def test_a_tracker_receives_the_whole_evaluation(
    server: ReferenceServer, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Expect the link first, growing steps, then intervals, episodes and videos."""
    monkeypatch.setattr(
        "reference_client.evaluation.evaluate.draw_videos",
        lambda _fetch, _episodes, count, folder: [folder / f"{count}.mp4"],
    )
    recorder = Recorder()
    score = play(server, recorder, log_videos=2)
    assert set(recorder.names) == {"begin", "log", "finish"}
    run_id, link, config = recorder.calls[0][1]
    assert link == f"{server.url}/pages/runs/{run_id}"
    assert (config["benchmark"], config["workers"]) == ("calibration", 1)
    steps = [value[0] for name, value in recorder.calls if name == "log"]
    assert steps == sorted(set(steps))
    assert steps[-1] == len(TASKS)
    numbers, episodes, videos = recorder.calls[-1][1]
    assert numbers["mean"] == score.mean
    assert numbers["mean_ci95_low"] == score.mean_interval.low
    assert numbers["success_ci95_high"] == score.success_interval.high
    assert numbers["task/score/mean"] == score.mean
    assert [row["score"] for row in episodes] == [0.0, 0.25, 0.5, 0.75]
    assert {*episodes[0]} == {*tracking.COLUMNS}
    assert videos == ["2.mp4"]


@pytest.mark.parametrize("broken", ["begin", "log", "finish"])
def test_a_tracker_that_fails_does_not_end_the_evaluation(
    server: ReferenceServer, caplog: pytest.LogCaptureFixture, broken: str
) -> None:
    recorder = Recorder(broken)
    assert play(server, recorder).complete
    assert recorder.names.count(broken) == 1
    assert recorder.names[-1] == broken
    said = "Recorder failed and receives no more: RuntimeError: no network"
    assert said in caplog.text


def test_videos_that_cannot_be_drawn_are_reported(
    server: ReferenceServer, caplog: pytest.LogCaptureFixture
) -> None:
    """The benchmark calibration has no camera. Expect the reason, and the score."""
    recorder = Recorder()
    play(server, recorder, log_videos=1)
    assert recorder.calls[-1][1][2] == []
    assert "no videos: " in caplog.text


def test_the_end_without_a_score_is_reported(server: ReferenceServer) -> None:
    class Raises(GradedPolicy):
        def act(self, observation: Any) -> Any:
            raise ValueError("out of memory")

    recorder = Recorder()
    given = calibration_evaluation("score") | {"dry_turn": False}
    with pytest.raises(ValueError, match="memory"):
        evaluate(Raises, url=server.url, log=recorder, **given)
    assert recorder.calls[-1] == ("fail", "out of memory")


@pytest.mark.parametrize(
    ("log", "said"),
    [
        ("wandbb:x", "log is wandb:PROJECT, .* not 'wandbb:x'; did you mean wandb"),
        ("wandb:", "log is wandb:PROJECT"),
        ("wandb", "log is wandb:PROJECT"),
        ("wandb:x", "wandb is not installed in .*: pip install wandb"),
        ("mlflow:x", "mlflow is not installed in .*: pip install mlflow"),
        ("tensorboard:x", "tensorboard is not installed .*: pip install tensorboard"),
    ],
)
def test_a_tracker_that_is_not_there_is_refused_before_a_run(
    proctor: Proctor, monkeypatch: pytest.MonkeyPatch, log: str, said: str
) -> None:
    monkeypatch.setattr(importlib.util, "find_spec", lambda _name: None)
    with pytest.raises(ValueError, match=said):
        make_tracker(log)
    before = proctor.json("status")
    flags = ["--policy", "policies:Graded", "--log", log]
    answer = proctor.json("run", *flags, *options("score"))
    assert proctor.code == 2
    assert "log" in answer["error"]["detail"]
    assert proctor.json("status") == before


class Noted:
    """A library that notes each call of each of its functions and objects."""

    def __init__(self, calls: list[tuple[str, Any]], name: str = "") -> None:
        self._calls, self._name = calls, name

    def __getattr__(self, name: str) -> Noted:
        return Noted(self._calls, f"{self._name}.{name}".strip("."))

    def __call__(self, *given: Any, **named: Any) -> Noted:
        self._calls.append((self._name, (given, named)))
        return Noted(self._calls, f"{self._name}()")


WANDB_CALLS = """init init().log Table Video init().log init().summary.update
    init().finish"""
TENSORBOARD_CALLS = """Writer Writer().add_scalar Writer().flush Writer().add_scalar
    Writer().flush Writer().close"""
MLFLOW_CALLS = """set_experiment start_run log_params log_metrics log_metrics log_dict
    log_artifact end_run"""


@pytest.mark.parametrize(
    ("log", "module", "expected"),
    [
        ("wandb:p", "wandb", WANDB_CALLS),
        ("tensorboard:f", "tensorboard.summary", TENSORBOARD_CALLS),
        ("mlflow:e", "mlflow", MLFLOW_CALLS),
    ],
)
def test_each_library_is_called_in_its_words(
    monkeypatch: pytest.MonkeyPatch, log: str, module: str, expected: str
) -> None:
    calls: list[tuple[str, Any]] = []
    monkeypatch.setitem(sys.modules, module.partition(".")[0], Noted(calls))
    monkeypatch.setitem(sys.modules, module, Noted(calls))
    monkeypatch.setattr(importlib.util, "find_spec", lambda _name: True)
    policy = SimpleNamespace(name="p")
    run: Any = SimpleNamespace(run_id="run_1", benchmark_id="b", policy=policy)
    tracker = make_tracker(log)
    tracker.begin(run, "http://h/pages/runs/run_1", {"workers": 1})
    tracker.log(1, {"mean": 0.5})
    tracker.finish({"mean": 0.5}, [{"episode_id": "e"}], [Path("0.mp4")])
    assert [name for name, _ in calls] == expected.split()
    ends: list[Callable[[str], None]] = [tracker.fail, make_tracker(log).fail]
    for end in ends:  # also of an evaluation that never began
        end("stopped")


def test_the_page_has_what_is_sent_and_its_program_is_a_tracker(
    server: ReferenceServer, capsys: pytest.CaptureFixture[str]
) -> None:
    recorder = Recorder()
    play(server, recorder)
    for name in recorder.calls[-1][1][0]:
        assert f"`{name.replace('/score/', '/TASK/')}`" in PAGE
    names: dict[str, Any] = {}
    exec(PAGE.rpartition("```python\n")[2].partition("```")[0], names)  # noqa: S102
    play(server, names["Printed"]())
    assert "calibration" in capsys.readouterr().out
