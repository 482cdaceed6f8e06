"""Weights & Biases, TensorBoard and MLflow, each imported only when it is chosen.

None of them is a dependency of the client.
"""

from __future__ import annotations

import importlib
import importlib.util
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

from proctor_client import Run

from reference_client.view.trackers.tracking import COLUMNS, Tracker
from reference_record.command_line.spelling import did_you_mean

FORMS = "wandb:PROJECT, tensorboard:FOLDER or mlflow:EXPERIMENT"


def make_trackers(log: str | Tracker | Sequence[str] | None) -> list[Tracker]:
    """The trackers of texts, or one that the caller has. Raises as `make_tracker`."""
    match log:
        case None:
            return []
        case str():
            return [make_tracker(log)]
        case Sequence():
            return [make_tracker(text) for text in log]
    return [log]


def make_tracker(text: str) -> Tracker:
    """The tracker of one of FORMS. Raises ValueError if it is none, or not installed.

    So a mistake is reported before there is a run.
    """
    kind, _, place = text.partition(":")
    if kind not in _TRACKERS or not place:
        meant = did_you_mean(kind, _TRACKERS)
        raise ValueError(f"log is {FORMS}, not {text!r}{meant}")
    module, make = _TRACKERS[kind]
    if importlib.util.find_spec(kind) is None:
        raise ValueError(
            f"log {text}: {kind} is not installed in the environment of this client: "
            f"pip install {kind}"
        )
    return make(importlib.import_module(module), place)


class WandbTracker:
    """A run of Weights & Biases with the id of the run, so that it is continued."""

    def __init__(self, library: Any, project: str) -> None:
        self._wandb = library
        self._project = project
        self._run: Any = None

    def begin(self, run: Run, link: str, config: Mapping[str, Any]) -> None:
        self._run = self._wandb.init(
            project=self._project,
            id=run.run_id,
            name=f"{run.policy.name} on {run.benchmark_id}",
            resume="allow",
            notes=link,
            config=dict(config),
        )

    def log(self, step: int, numbers: Mapping[str, float]) -> None:
        self._run.log(dict(numbers), step=step)

    def finish(
        self,
        numbers: Mapping[str, float],
        episodes: Sequence[Mapping[str, Any]],
        videos: Sequence[Path],
    ) -> None:
        table = self._wandb.Table(
            columns=list(COLUMNS), data=[list(row.values()) for row in episodes]
        )
        shown = {
            f"video/{path.stem}": self._wandb.Video(str(path), format="mp4")
            for path in videos
        }
        self._run.log({"episodes": table, **shown})
        self._run.summary.update(dict(numbers))
        self._run.finish()

    def fail(self, reason: str) -> None:
        if self._run is not None:
            self._run.summary.update({"ended": reason})
            self._run.finish(exit_code=1)


class TensorboardTracker:
    """Scalars in FOLDER/RUN; the link is in their description. It takes no videos."""

    def __init__(self, library: Any, folder: str) -> None:
        self._library = library
        self._folder = Path(folder)
        self._link = ""
        self._step = 0
        self._writer: Any = None

    def begin(self, run: Run, link: str, config: Mapping[str, Any]) -> None:
        self._link = f"[{run.policy.name} on {run.benchmark_id}]({link})"
        self._writer = self._library.Writer(str(self._folder / run.run_id))

    def log(self, step: int, numbers: Mapping[str, float]) -> None:
        self._step = step
        for name, number in numbers.items():
            self._writer.add_scalar(name, number, step, description=self._link)
        self._writer.flush()

    def finish(
        self,
        numbers: Mapping[str, float],
        episodes: Sequence[Mapping[str, Any]],
        videos: Sequence[Path],
    ) -> None:
        self.log(self._step, {f"final/{name}": n for name, n in numbers.items()})
        self._writer.close()

    def fail(self, reason: str) -> None:
        if self._writer is not None:
            self._writer.close()


class MlflowTracker:
    """A run of an MLflow experiment; where it is, MLFLOW_TRACKING_URI says."""

    def __init__(self, library: Any, experiment: str) -> None:
        self._mlflow = library
        self._experiment = experiment
        self._is_begun = False

    def begin(self, run: Run, link: str, config: Mapping[str, Any]) -> None:
        self._mlflow.set_experiment(self._experiment)
        name = f"{run.policy.name} on {run.benchmark_id}"
        self._mlflow.start_run(run_name=name, tags={"proctor.link": link})
        self._is_begun = True
        self._mlflow.log_params(dict(config))

    def log(self, step: int, numbers: Mapping[str, float]) -> None:
        self._mlflow.log_metrics(dict(numbers), step=step)

    def finish(
        self,
        numbers: Mapping[str, float],
        episodes: Sequence[Mapping[str, Any]],
        videos: Sequence[Path],
    ) -> None:
        # A slash groups names there, too; numbers of tasks keep theirs.
        self._mlflow.log_metrics(dict(numbers))
        self._mlflow.log_dict({"episodes": list(episodes)}, "episodes.json")
        for path in videos:
            self._mlflow.log_artifact(str(path), "videos")
        self._mlflow.end_run()

    def fail(self, reason: str) -> None:
        if self._is_begun:
            self._mlflow.set_tag("proctor.ended", reason)
            self._mlflow.end_run("FAILED")


# Kind → the module that is imported, and the class.
_TRACKERS: Mapping[str, tuple[str, Callable[[Any, str], Tracker]]] = {
    "wandb": ("wandb", WandbTracker),
    "tensorboard": ("tensorboard.summary", TensorboardTracker),
    "mlflow": ("mlflow", MlflowTracker),
}
