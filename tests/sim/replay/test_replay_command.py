"""`proctor replay`: exact, the same outcome, diverged with its place; the verdict."""

import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import msgspec
import pytest

from reference_record.formats.bundle import open_bundle
from reference_record.keys import load_or_make
from reference_record.recordings.recording import Turn
from reference_record.verification import verify
from reference_sim import benchmark_registry
from reference_sim.replay.__main__ import main
from tests.support.paths import ROOT
from tests.support.record.played_records import keep, save_calibration_record
from tests.support.record.sample_records import HOST_KEY
from tests.support.sim.calibration_action import calibration_action

VECTORS = ROOT / "spec" / "vectors" / "record"


def replay(path: Path, *words: str) -> int:
    key = path.with_name("key")
    return main([str(path), "--processes", "1", "--signing-key", str(key), *words])


def record_with(tmp_path: Path, change: object = keep) -> Path:
    (tmp_path / "recordings").mkdir()
    path = tmp_path / "run.proctor"
    return save_calibration_record(path, tmp_path / "recordings", change)  # type: ignore[arg-type]


def test_an_honest_record_is_exact_and_says_by_whom(tmp_path: Path) -> None:
    path = record_with(tmp_path)
    assert replay(path) == 0
    trusted = {HOST_KEY.keyid: "H", load_or_make(path.with_name("key")).keyid: "R"}
    report = verify(open_bundle(path), trusted)
    assert report.levels == ["signed by H", "replayed by R (exact, 3 of 3 episodes)"]
    assert report.replayed_by[0][1].replay.episodes == 3
    # Again: the verdict of the same key is replaced.
    assert replay(path, "--name", "later") == 0
    assert [one.name for _, one in verify(open_bundle(path)).replayed_by] == ["later"]


def other_action(index: int, number: int, turn: Turn) -> Turn:
    """The second turn of the episode `count` is recorded with another end."""
    if (index, number) != (1, 2):
        return turn
    actions = [calibration_action(), calibration_action()]
    return msgspec.structs.replace(turn, actions=actions)


def other_digest(index: int, number: int, turn: Turn) -> Turn:
    if (index, number) != (2, 1):
        return turn
    return msgspec.structs.replace(turn, state_digest="0" * 32)


def test_a_lie_is_located(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = record_with(tmp_path, other_action)
    assert replay(path, "--json") == 1
    said = json.loads(capsys.readouterr().out)
    assert (said["result"], said["exact"], said["diverged"]) == ("diverged", 2, 1)
    where = {"episode_index": 1, "attempt": 1, "step": 4}
    assert said["first_divergence"] == where
    (_, verdict), *_ = verify(open_bundle(path)).replayed_by
    assert verdict.replay.result == "diverged"


def test_another_state_with_the_same_result(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = record_with(tmp_path, other_digest)
    before = path.read_bytes()
    assert replay(path, "--no-verdict") == 0
    assert capsys.readouterr().out.startswith("outcome: 2 of 3 episodes exact, 1 with")
    assert path.read_bytes() == before


def test_some_episodes_only(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = record_with(tmp_path, other_action)
    assert replay(path, "--no-verdict", "--episodes", "0,2") == 0
    assert "2 of 2 episodes exact" in capsys.readouterr().out


def test_an_episode_that_is_not_there_leaves_the_record_as_it_is(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = record_with(tmp_path, other_action)
    before = path.read_bytes()
    assert replay(path, "--episodes", "0,99") == 2
    assert "no episode 99" in capsys.readouterr().err
    assert path.read_bytes() == before


@pytest.mark.parametrize(
    ("name", "code", "text"),
    [
        ("recording_changed", 1, "do not trust it: episodes/00000.mcap"),
        ("good", 2, "this machine has no benchmark sample"),
        ("absent", 2, "No such file"),
    ],
)
def test_what_cannot_be_replayed(
    name: str, code: int, text: str, capsys: pytest.CaptureFixture[str]
) -> None:
    path = VECTORS / f"{name}.proctor"
    assert main([str(path), "--no-verdict"]) == code
    assert text in capsys.readouterr().err


def test_another_version_of_the_benchmark_is_not_replayed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    path = record_with(tmp_path)
    resolve = benchmark_registry.resolve

    def resolve_another(*args: Any, **kwargs: Any) -> Any:
        found = resolve(*args, **kwargs)
        return replace(found, manifest=found.manifest | {"version": "later"})

    monkeypatch.setattr(benchmark_registry, "resolve", resolve_another)
    assert replay(path) == 2
    assert "version is later here, 1 in the record" in capsys.readouterr().err


def test_a_benchmark_of_another_name_is_not_said_to_be_missing(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Such as one whose file has another name than that of the record."""
    monkeypatch.setattr(benchmark_registry, "_REFERENCES", {"mine": "lab/mine.toml"})
    assert main([str(VECTORS / "good.proctor"), "--no-verdict"]) == 2
    said = capsys.readouterr().err
    assert "no benchmark sample; lab/mine.toml adds mine: if one is the same" in said
    assert 'write benchmark_id = "sample"' in said


@pytest.mark.parametrize(
    ("known", "text"),
    [
        ({}, "this machine has no benchmark calibration"),
        ({"options": {"tasks": 1}}, "has not the options of the record"),
        ({"reason": "no GL"}, "cannot be simulated here: no GL"),
    ],
)
def test_what_this_machine_cannot_simulate(
    known: dict[str, Any],
    text: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    path = record_with(tmp_path)
    resolve = benchmark_registry.resolve

    def resolve_otherwise(name: str, options: Any, *args: Any, **kwargs: Any) -> Any:
        if not known:
            raise benchmark_registry.UnknownBenchmark(name)
        return resolve(name, known.get("options", options), *args, **kwargs)

    monkeypatch.setattr(benchmark_registry, "resolve", resolve_otherwise)
    reason = known.get("reason")
    monkeypatch.setattr(benchmark_registry, "unavailable_reason", lambda _: reason)
    assert replay(path) == 2
    assert text in capsys.readouterr().err
