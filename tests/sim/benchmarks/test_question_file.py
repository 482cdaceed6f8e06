"""Question files: what a line may say, what is asked, which answers are right."""

import json
from collections import Counter
from pathlib import Path
from typing import Any

import pytest

from reference_sim import benchmark_registry
from reference_sim.benchmarks.question_file import benchmark as question_file
from reference_sim.benchmarks.question_file.question_lines import read_questions
from reference_sim.gymnasium import BadBenchmark
from reference_sim.interface import ChangedSource, Simulator, TaskUnplayable
from tests.support.paths import ROOT

SAMPLE = ROOT / "examples" / "benchmarks" / "small_quiz.jsonl"


def write(folder: Path, *lines: Any, name: str = "My Quiz-1.jsonl") -> Path:
    """A file with these lines; what is no text is written as JSON."""
    texts = [line if isinstance(line, str) else json.dumps(line) for line in lines]
    path = folder / name
    path.write_text("\n".join(texts) + "\n", encoding="utf-8")
    return path


def answer(**given: float) -> dict[str, list[float]]:
    none = {"choice": [-1.0], "number": [-1.0], "point": [-1.0, -1.0]}
    return none | {name: [value] for name, value in given.items()}


def make(path: Path) -> Simulator:
    _, definition = question_file.benchmark(str(path))
    images = {"codec": "png", "width": 16, "height": 12}
    return question_file.make(definition.settings(images))


def test_lines_of_known_sets_are_read(tmp_path: Path) -> None:
    """The members of MMLU and GSM8K, and extra ones. Expect tasks and right answers."""
    choices = ["one", "two", "three", "four"]
    path = write(
        tmp_path,
        {"question": "a?", "subject": "s", "choices": choices, "answer": 1},
        {"question": "b?", "task": "t", "choices": choices, "answer": "d", "id": 7},
        "",
        {"question": "c?", "answer": "so 1000 + 234.\n#### 1,234"},
        {"question": "d?", "answer": 0.5},
    )
    questions = read_questions(path)
    assert [q.task for q in questions] == ["s", "t", "My Quiz-1", "My Quiz-1"]
    assert [q.right for q in questions] == [
        {"choice": [1.0]},
        {"choice": [3.0]},
        {"number": [1234.0]},
        {"number": [0.5]},
    ]
    assert questions[0].text == (
        "a?\nA) one\nB) two\nC) three\nD) four\n\nAnswer with the letter alone."
    )
    assert questions[2].text == "c?\n\nAnswer with the number alone."


@pytest.mark.parametrize(
    ("line", "about"),
    [
        ("{", "line 2: is not JSON"),
        ("[" * 100_000, "line 2: "),
        ("[]", "line 2: the line: "),
        ({"answer": 1}, "line 2: question: Field required"),
        ({"question": "", "answer": 1}, "line 2: question: "),
        ({"question": "a?"}, "line 2: answer: Field required"),
        ({"question": "a?", "answer": True}, "line 2: answer: "),
        ({"question": "a?", "answer": -1}, "line 2: answer: must be a number"),
        ({"question": "a?", "answer": 1_000_000}, "answer: must be a number"),
        ({"question": "a?", "answer": "B"}, "answer: must be a number"),
        ('{"question": "a?", "answer": NaN}', "answer: must be a number"),
        ({"question": "a?", "choices": ["x"], "answer": 0}, "line 2: choices: "),
        ({"question": "a?", "choices": ["x", "y"], "answer": 2}, "from A to B"),
        ({"question": "a?", "choices": ["x", "y"], "answer": "C"}, "from A to B"),
        ({"question": "a?", "choices": ["x", "y"], "answer": 0.0}, "from A to B"),
        ({"question": "a?", "choices": ["x", "y"], "answer": "x"}, "or 0 to 1"),
    ],
)
def test_a_wrong_line_is_named(tmp_path: Path, line: Any, about: str) -> None:
    path = write(tmp_path, {"question": "a?", "answer": 1}, line)
    with pytest.raises(BadBenchmark) as caught:
        read_questions(path)
    assert about in str(caught.value)


def test_a_file_without_questions_is_refused(tmp_path: Path) -> None:
    with pytest.raises(BadBenchmark, match="has no question"):
        read_questions(write(tmp_path, ""))
    with pytest.raises(BadBenchmark, match="No such file"):
        read_questions(tmp_path / "missing.jsonl")
    latin = tmp_path / "latin.jsonl"
    latin.write_bytes(b'{"question": "\xe9?", "answer": 1}')
    with pytest.raises(BadBenchmark, match="line 1 is not UTF-8"):
        read_questions(latin)


def test_the_manifest_has_the_hash_of_the_file_and_no_answer(tmp_path: Path) -> None:
    line = {"question": "a?", "choices": ["x", "y", "z"], "answer": 1}
    manifests = []
    for change in ({}, {"answer": 2}):
        path = write(tmp_path, line | change)
        benchmark_id, definition = question_file.benchmark(str(path))
        manifests.append(definition.describe({}, 64))
        assert benchmark_id == manifests[-1]["benchmark_id"] == "my_quiz_1"
        assert manifests[-1]["action_space"]["choice"]["maximum"] == [2]
        assert '"answer"' not in json.dumps(manifests[-1])
    first, second = manifests
    assert first["simulator"] != second["simulator"]
    assert first | {"simulator": 0} == second | {"simulator": 0}


def test_the_right_answer_alone_scores(tmp_path: Path) -> None:
    simulator = make(
        write(
            tmp_path,
            {"question": "a?", "choices": ["x", "y"], "answer": "B", "task": "t"},
            {"question": "b?", "answer": 72, "task": "t"},
        )
    )
    with pytest.raises(RuntimeError, match="reset comes before"):
        simulator.step(answer())
    cases = [
        (0, answer(choice=1), 1.0),
        (0, answer(choice=0), 0.0),
        (0, answer(number=1), 0.0),
        (0, answer(choice=1, number=72), 0.0),
        (0, answer(), 0.0),
        (1, answer(number=72), 1.0),
        (1, answer(number=71), 0.0),
    ]
    for seed, action, score in cases:
        simulator.reset("t", seed)
        outcome = simulator.step(action)
        assert (outcome.score, outcome.success) == (score, score == 1)
        assert outcome.terminated
    observation = simulator.observe()
    assert (observation.state, observation.images) == ({}, {})
    for task, seed in (("t", 2), ("other", 0)):
        with pytest.raises(TaskUnplayable):
            simulator.reset(task, seed)
    simulator.close()


def test_a_file_that_changed_is_not_played(tmp_path: Path) -> None:
    path = write(tmp_path, {"question": "a?", "answer": 1})
    _, definition = question_file.benchmark(str(path))
    settings = definition.settings({"codec": "png", "width": 16, "height": 12})
    simulator = question_file.make(settings)
    assert not definition.changed_files()
    write(tmp_path, {"question": "a?", "answer": 2})
    assert definition.changed_files() == [path.name]
    for begin in (
        lambda: question_file.make(settings),
        lambda: simulator.reset("t", 0),
    ):
        with pytest.raises(ChangedSource, match="has changed since the server started"):
            begin()


def test_the_sample_has_every_answer_equally_often() -> None:
    questions = read_questions(SAMPLE)
    letters = Counter(q.right["choice"][0] for q in questions if q.choices)
    assert set(letters.values()) == {4}
    assert {q.choices for q in questions} == {0, 4}
    assert {q.task for q in questions} == {"arithmetic", "units", "space"}


def test_a_file_is_a_benchmark_of_the_registry(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    known = dict(benchmark_registry._BENCHMARKS)
    monkeypatch.setattr(benchmark_registry, "_BENCHMARKS", known)
    path = write(tmp_path, {"question": "a?", "answer": 1})
    benchmark_registry.add(str(path), print)
    resolved = benchmark_registry.resolve("my_quiz_1")
    simulator = benchmark_registry.make(resolved.world)
    assert simulator.reset("My Quiz-1", 0).startswith("a?")
    with pytest.raises(BadBenchmark, match="already in use"):
        benchmark_registry.add(str(path), print)
