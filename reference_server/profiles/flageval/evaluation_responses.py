"""The responses to FlagEval's client: status letters, datasets, differences.

A dataset is a task of the benchmark, an accuracy the mean score of its episodes, and
`diff` and `release` are computed by `rules/comparison.py`. Views of runs as plain data;
must not read requests.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal, NotRequired, TypedDict

import msgspec
from starlette.responses import Response

from reference_record.generated.answers import ComputedComparison, GroupScore
from reference_server.http.codec import JSON
from reference_server.rules import comparison
from reference_server.rules.refusal import Refused
from reference_server.rules.runs.run import Episode, RunHead
from reference_server.rules.scoring import ScoredEpisode, score_of
from reference_server.views import run_views

Status = Literal["S", "F", "C", "OOR", "R"]
BASELINE = "-nvidia-origin"
TOLERANCE = comparison.TOLERANCE
BASELINE_OF_NOTHING = (
    "The baseline has scored nothing, which is no measure of another model: nothing is "
    "released. See whether the baseline's model answers as its questions ask."
)
# The status of several evaluations together: the first of these that one has.
_STATUS_PRIORITY: tuple[Status, ...] = ("R", "F", "OOR", "C", "S")


class Gate(TypedDict):
    """Whether a model is released, and texts that only some answers have.

    warning: why the baseline measures nothing. reason: why an evaluation has failed.
    """

    release: bool
    warning: NotRequired[str]
    reason: NotRequired[str | None]
    request_id: NotRequired[str]


class DatasetResult(TypedDict):
    """The result of one dataset; None while it, or the baseline's, has none."""

    dataset: str
    status: Status
    accuracy: float | None
    diff: float | None


class EvalResult(Gate):
    """The result of one evaluation."""

    status: Status
    details: list[DatasetResult]


class DatasetDiff(TypedDict):
    """One dataset of a model beside the same of another model."""

    dataset: str
    base_acc: float | None
    accuracy: float | None
    diff: float | None


class EvalDiff(Gate):
    """All datasets of a model beside those of another model."""

    details: list[DatasetDiff]


class RequestProgress(TypedDict):
    """How far the evaluations of a request are."""

    finished: bool
    status: Status
    datasets_progress: str
    running_dataset: str
    running_progress: str


def success_response(text: str = "success", /, **members: Any) -> Response:
    """Success; the message has both names that FlagEval's documents give it."""
    envelope = {"err_code": 0, "err_msg": text, "err_message": text}
    return Response(msgspec.json.encode(envelope | members), media_type=JSON)


def refusal_response(refused: Refused) -> Response:
    """FLE-002: always status 200, with `err_code` 1 and the reason under both names."""
    faults = "; ".join(f"{at or 'the body'} {text}" for at, text in refused.errors)
    parts = [refused.detail, faults and f"{faults}.", refused.act]
    text = " ".join(filter(None, parts))
    envelope = {"err_code": 1, "err_msg": text, "err_message": text}
    return Response(msgspec.json.encode(envelope), media_type=JSON)


@dataclass(frozen=True, slots=True)
class EvaluationView:
    """One evaluation: a run in FlagEval's terms."""

    run_id: str
    eval_model: str
    base_model_name: str
    status: Status
    manifest_sha256: str
    episodes: Sequence[ScoredEpisode]
    reason: str | None = None

    @classmethod
    def from_run(cls, run: RunHead, episodes: Sequence[Episode]) -> EvaluationView:
        return cls(
            run.run_id,
            run.submission["policy"]["name"],
            run.submission.get("labels", {}).get("base_model_name", ""),
            status_of(run, episodes),
            run.manifest_sha256,
            run_views.scored_episodes(episodes),
            run.reason,
        )

    @property
    def is_baseline(self) -> bool:
        return self.eval_model.endswith(BASELINE)

    @property
    def has_failed(self) -> bool:
        return self.status in ("F", "OOR")

    @property
    def datasets(self) -> Mapping[str, GroupScore]:
        """Task → counts and mean, in the order of the manifest."""
        return score_of(self.episodes)["by_task"]

    def compare_with(self, base: EvaluationView | None) -> ComputedComparison | None:
        """The comparison with a baseline (FLE-010, FLE-011); None without one."""
        if base is None or base.manifest_sha256 != self.manifest_sha256:
            return None
        return comparison.compare(base.episodes, self.episodes, TOLERANCE)

    def result(self, base: EvaluationView | None) -> EvalResult:
        """EvalResult, for evaldiffs (FLE-007, FLE-010, FLE-011)."""
        compared = self.compare_with(base)
        details: list[DatasetResult] = [
            {
                "dataset": task,
                "status": self.status if group["counts"]["unscored"] else "S",
                "accuracy": group["mean"],
                "diff": None
                if compared is None
                else compared["by_task"][task]["difference"],
            }
            for task, group in self.datasets.items()
        ]
        result: EvalResult = {
            "status": self.status,
            "details": details,
            **_gate(compared),
        }
        if self.has_failed:
            result["reason"] = self.reason
        return result

    def diff(self, base: EvaluationView) -> EvalDiff:
        """The differences to a base, for evaluation_diffs (FLE-015). Raises Refused."""
        compared = self.compare_with(base)
        if compared is None:
            raise Refused("not_comparable", f"{self.eval_model}: the datasets differ.")
        details: list[DatasetDiff] = [
            {
                "dataset": task,
                "base_acc": group["baseline_mean"],
                "accuracy": group["mean"],
                "diff": group["difference"],
            }
            for task, group in compared["by_task"].items()
        ]
        return {"details": details, **_gate(compared)}


def _gate(compared: ComputedComparison | None) -> Gate:
    """FLE-011, FLE-021: `release`, and a warning if the baseline says nothing."""
    if compared is None:
        return {"release": False}
    if compared["baseline_mean"] == 0:
        return {"release": False, "warning": BASELINE_OF_NOTHING}
    return {"release": compared["release"]}


def failures_of(evaluations: Sequence[EvaluationView]) -> str:
    """FLE-020: why evaluations have failed; `success` if none has."""
    failed = [evaluation for evaluation in evaluations if evaluation.has_failed]
    texts = [
        f"{evaluation.eval_model}: {evaluation.status}: {evaluation.reason}"
        for evaluation in failed
    ]
    return " ".join(texts) or "success"


def status_of(run: RunHead, episodes: Sequence[Episode]) -> Status:
    """FLE-009: success, failed, cancelled, out of retries, or running."""
    if run.state == "completed":
        return "S"
    if run.state in ("stopped", "stopping"):
        return "C"
    if run.state != "failed":
        return "R"
    most = run.manifest["max_faults"]
    is_ours = any(e.faults - e.faults_forgiven >= most for e in episodes)
    return "OOR" if run.retryable and not is_ours else "F"


def progress(evaluations: Sequence[EvaluationView]) -> RequestProgress:
    """FLE-014: the progress of all evaluations of a request together."""
    statuses = {evaluation.status for evaluation in evaluations}
    status = next(letter for letter in _STATUS_PRIORITY if letter in statuses)
    open_, done, total = [], 0, 0
    for evaluation in evaluations:
        for task, group in evaluation.datasets.items():
            counts = group["counts"]
            total += 1
            done += counts["unscored"] == 0
            if counts["unscored"] and evaluation.status == "R":
                scored = counts["total"] - counts["unscored"]
                open_.append((task, f"{scored}/{counts['total']}"))
    dataset, running = open_[0] if open_ else ("", "")
    return {
        "finished": status != "R",
        "status": status,
        "datasets_progress": f"{done}/{total}",
        "running_dataset": dataset,
        "running_progress": running,
    }
