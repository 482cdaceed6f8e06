"""Benchmarks of the server: what is looked up once."""

from typing import Any

import pytest

from reference_server.runs.benchmarks import SimulatorConfigs
from reference_server.runs.seed_secret import SeedSecret
from reference_sim import benchmark_registry
from tests.support.server.server_parts import calibration_run


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
