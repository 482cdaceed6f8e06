"""The benchmark that a question file is: FILE.jsonl as a reference.

The hash of the file is part of the manifest, and a simulator process reads the file
again: it plays the questions of that hash or none. The right answers stand in neither.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from reference_sim.benchmarks.question_answering.benchmark import answer_space
from reference_sim.benchmarks.question_file.question_lines import (
    FileQuestion,
    read_questions,
)
from reference_sim.definition import BenchmarkDefinition, Json, image_sizes
from reference_sim.gymnasium.benchmark_file import legal_id
from reference_sim.gymnasium.own_sources import DeclaredFiles, sha256_of
from reference_sim.interface import (
    Action,
    Observation,
    Simulator,
    StepOutcome,
    TaskUnplayable,
)

ADAPTER = "question_file"
ENDING = ".jsonl"
SPLIT = "test"


def benchmark(reference: str) -> tuple[str, BenchmarkDefinition]:
    """Id and definition of the benchmark of a file. Raises BadBenchmark."""
    path = Path(reference).absolute()
    questions = read_questions(path)
    benchmark_id, sha256 = legal_id(path.stem), sha256_of(path)
    manifest = _manifest(benchmark_id, questions, sha256)

    def describe(_options: Mapping[str, Any], max_chunk: int) -> Json:  # noqa: ARG001 - one action answers
        return manifest

    def settings(images: Mapping[str, Any]) -> Json:
        file = {"path": str(path), "sha256": sha256}
        return {**images, "adapter": ADAPTER, **file}

    file = DeclaredFiles(path.parent, {path.name: sha256})
    return benchmark_id, BenchmarkDefinition(
        describe, settings, make, changed_files=file.changed
    )


def make(settings: Mapping[str, Any]) -> Simulator:
    """The simulator, in the process that runs it."""
    return QuestionFileSimulator(Path(settings["path"]), settings["sha256"])


class QuestionFileSimulator:
    """Asks one question per episode; the seed is its place in the file."""

    def __init__(self, path: Path, sha256: str) -> None:
        self._file = DeclaredFiles(path.parent, {path.name: sha256})
        self._file.require_unchanged()
        self._questions = read_questions(path)
        self._question: FileQuestion | None = None
        self._is_answered = False

    def reset(self, task: str, seed: int, split: str = "") -> str:
        """Raises TaskUnplayable, and ChangedSource."""
        self._file.require_unchanged()
        if not 0 <= seed < len(self._questions):
            raise TaskUnplayable("the file has no question of this seed")
        self._question = self._questions[seed]
        self._is_answered = False
        if self._question.task != task:
            raise TaskUnplayable(f"this question is not of the task {task}")
        return self._question.text

    def step(self, action: Action) -> StepOutcome:
        """The score is 1 for the right answer and nothing beside it, otherwise 0."""
        if self._question is None:
            raise RuntimeError("reset comes before step")
        is_right = self._question.is_right(action)
        self._is_answered = True
        return StepOutcome(success=is_right, score=float(is_right), terminated=True)

    def observe(self) -> Observation:
        """The question is the instruction: nothing else is observed."""
        return Observation(state={})

    def state_bytes(self) -> bytes:
        """The question, and whether it was answered; the seed may be secret."""
        if self._question is None:
            raise RuntimeError("reset comes before state_bytes")
        asked = self._question.task, self._question.text
        return repr((*asked, self._is_answered)).encode()

    def close(self) -> None:
        """No resources to free."""


def _manifest(benchmark_id: str, questions: Any, sha256: str) -> Json:
    tasks = list(dict.fromkeys(question.task for question in questions))
    last = max(question.choices for question in questions) - 1
    return {
        "benchmark_id": benchmark_id,
        "version": "1",
        "title": f"Questions of {benchmark_id}",
        "description": "Questions in words, each with one right answer: a letter or a "
        "number. One action is the answer.",
        "episodes_total": len(questions),
        "episodes": [
            {"task": question.task, "split": SPLIT, "seed": seed}
            for seed, question in enumerate(questions)
        ],
        "tasks": tasks,
        "splits": [SPLIT],
        "control_rate_hz": 1.0,  # nothing moves
        "max_steps": 1,
        "max_chunk": 1,
        "max_attempts": 3,
        "max_faults": 3,
        "success_rule": "any_step",
        "action_space": answer_space(max(last, 1)),
        "observation_space": {"state": {}, "images": {}, "tensors": {}},
        "image_sizes": image_sizes((16, 12)),  # of images that no question has
        "image_codecs": ["png", "jpeg", "raw"],
        "simulator": {
            "name": ADAPTER,
            "version": "1",
            "questions_sha256": sha256,
        },
    }
