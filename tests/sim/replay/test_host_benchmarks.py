"""Benchmarks of a server of this user are found, and those of other users are not."""

import json
from pathlib import Path
from socket import gethostname

import pytest

from reference_sim import benchmark_registry
from reference_sim.replay import host_benchmarks

QUESTIONS = '{"question": "a?", "answer": 1}\n'


@pytest.fixture(autouse=True)
def state(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The folder of the files; benchmarks that a test adds are taken away."""
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    known = {**benchmark_registry._BENCHMARKS}
    monkeypatch.setattr(benchmark_registry, "_BENCHMARKS", known)
    monkeypatch.setattr(benchmark_registry, "_REFERENCES", {})
    return tmp_path / "state" / "proctor" / "benchmarks"


def start_server(folder: Path, monkeypatch: pytest.MonkeyPatch, port: int) -> None:
    """Publish as a server in this folder does, whose reference is relative to it."""
    folder.mkdir(exist_ok=True)
    (folder / "quiz.jsonl").write_text(QUESTIONS)
    monkeypatch.chdir(folder)
    host_benchmarks.publish(port, {"quiz": "quiz.jsonl"})


def test_a_benchmark_is_found_from_any_folder(
    state: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    start_server(tmp_path / "lab", monkeypatch, 1)
    assert (state / f"{gethostname()}-1").stat().st_mode & 0o777 == 0o600
    monkeypatch.chdir(tmp_path)
    lines: list[str] = []
    host_benchmarks.add("quiz", "", lines.append)
    assert "quiz" in benchmark_registry.benchmark_ids()
    assert lines == ["quiz: quiz.jsonl, as a server of yours here offers it"]
    assert Path.cwd() == tmp_path
    assert benchmark_registry.own_references() == {"quiz": "quiz.jsonl"}


def test_named_ones_come_first(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    start_server(tmp_path / "lab", monkeypatch, 1)
    named, lines = tmp_path / "quiz.jsonl", list[str]()
    named.write_text(QUESTIONS)
    host_benchmarks.add("quiz", str(named), lines.append)
    assert (benchmark_registry.own_references(), lines) == ({"quiz": str(named)}, [])


@pytest.mark.parametrize(
    "case", ["another id", "readable by others", "no JSON", "folder gone", "ended"]
)
def test_what_is_no_benchmark_of_this_user_is_not_added(
    state: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, case: str
) -> None:
    start_server(tmp_path / "lab", monkeypatch, 1)
    match case:
        case "readable by others":
            (state / f"{gethostname()}-1").chmod(0o666)
        case "no JSON":
            (state / f"{gethostname()}-1").write_text("{")
        case "folder gone":
            offered = {"folder": str(tmp_path / "gone"), "references": {"quiz": "q"}}
            (state / f"{gethostname()}-1").write_text(json.dumps(offered))
        case "ended":  # another server at that port has none
            host_benchmarks.publish(1, {})
    host_benchmarks.add("riddles" if case == "another id" else "quiz", "", print)
    assert benchmark_registry.own_references() == {}
