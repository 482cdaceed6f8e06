"""Benchmarks of the server: what is looked up once."""

import asyncio
from pathlib import Path
from typing import Any

import pytest

from reference_server.files.seed_secret import SeedSecret
from reference_server.runs import benchmarks
from reference_server.runs.benchmarks import Benchmarks, SimulatorConfigs
from reference_sim import benchmark_registry
from tests.support.server.server_parts import ServerParts, calibration_run, run_scenario


def test_a_simulator_configuration_is_resolved_once_per_choice(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    one, same, other = (calibration_run(t) for t in ("count", "count", "echo"))
    resolved: list[str] = []
    right = benchmark_registry.resolve

    def resolve(benchmark_id: str, *rest: Any, **named: Any) -> Any:
        resolved.append(benchmark_id)
        return right(benchmark_id, *rest, **named)

    monkeypatch.setattr(benchmark_registry, "resolve", resolve)
    configs = SimulatorConfigs(SeedSecret())
    assert configs.find(one) == configs.find(same) == configs.find(one)
    assert len(resolved) == 1
    configs.find(other)
    assert len(resolved) == 2


def test_runs_that_cannot_go_on_are_logged_at_the_start(
    tmp_path: Path, caplog: pytest.LogCaptureFixture
) -> None:
    """Two of them were submitted to a benchmark that has changed since."""
    changed = {"manifest_sha256": "0" * 64, "state": "ready"}
    runs = [
        calibration_run(run_id="run_1", state="ready"),
        calibration_run(run_id="run_2", **changed),
        calibration_run(run_id="run_3", **changed),
        calibration_run(run_id="run_4", **changed | {"state": "completed"}),
    ]

    async def story(parts: ServerParts) -> None:
        for run in runs:
            await parts.store.insert(run, None, "")
        why_unplayable = SimulatorConfigs(SeedSecret()).why_unplayable
        await benchmarks.log_unplayable(parts.store, why_unplayable)

    run_scenario(tmp_path, story)
    (record,) = [r for r in caplog.records if r.name == "proctor.runs"]
    said = "2 open runs of calibration cannot go on: the benchmark has changed since, "
    assert record.getMessage().startswith(said)


def test_runs_of_one_manifest_share_it(monkeypatch: pytest.MonkeyPatch) -> None:
    """A thousand finished runs took twenty megabytes."""
    monkeypatch.setattr(benchmarks, "SHARED_MANIFESTS_MAX", 2)
    found = Benchmarks(64, SeedSecret())

    def manifest(task: str) -> Any:
        submission: Any = {"benchmark_id": "calibration", "options": {"tasks": [task]}}
        return asyncio.run(found.resolve(submission)).manifest

    assert manifest("count") is manifest("count")
    assert manifest("count") is not manifest("echo")
    manifest("score")
    assert len(found._manifests) <= 2


def test_a_choice_is_sealed_and_hashed_once(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(benchmarks, "SHARED_MANIFESTS_MAX", 2)
    sealed: list[str] = []
    right = benchmarks._sealed_manifest

    def seal(found: Any, *seeds: Any) -> Any:
        sealed.append(found.manifest["benchmark_id"])
        return right(found, *seeds)

    monkeypatch.setattr(benchmarks, "_sealed_manifest", seal)
    found = Benchmarks(64, SeedSecret())

    def resolve(**choices: Any) -> Any:
        submission: Any = {"benchmark_id": "calibration", **choices}
        return asyncio.run(found.resolve(submission))

    assert resolve() is resolve()
    assert asyncio.run(found.view("calibration"))["splits"] == ["even", "odd"]
    assert len(sealed) == 1
    part = resolve(options={"tasks": ["score"] * 2}, select={"splits": ["odd"]})
    assert part.manifest["episodes_total"] == 1
    assert len(sealed) == 2
    found._seed_secret.value = b"another secret"
    resolve()
    assert len(sealed) == 3
    assert len(found._resolved_runs) <= 2
