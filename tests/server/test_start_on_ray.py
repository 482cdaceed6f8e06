"""What a server says of the machines of a Ray cluster before it listens."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence

import pytest

from reference_server import __main__ as server
from reference_server.settings import Settings
from reference_sim import benchmark_registry


@pytest.fixture(autouse=True)
def _two_that_declare(monkeypatch: pytest.MonkeyPatch) -> None:
    benchmarks = dict(benchmark_registry._BENCHMARKS)
    for name in ("tabletop", "mobile_bimanual"):
        benchmarks[name] = dataclasses.replace(
            benchmarks[name], ray_resources={"GPU": 0.25, "CPU": 1}
        )
    benchmarks["calibration"] = dataclasses.replace(
        benchmarks["calibration"], ray_resources={"CPU": 0.5}
    )
    monkeypatch.setattr(benchmark_registry, "_BENCHMARKS", benchmarks)


def test_the_lack_of_what_benchmarks_declare_is_said_by_their_names(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Expect: one line for each set of resources that no machine has."""
    requested: list[dict[str, float]] = []

    async def check_cluster(
        _address: str, simulators: Sequence[dict[str, float]]
    ) -> list[int]:
        requested.extend(simulators)
        return [2 if one == {"CPU": 1} else 0 for one in simulators]

    monkeypatch.setattr(server, "check_cluster", check_cluster)
    settings = Settings.model_validate({"simulators": "ray", "recordings": "off"})
    server._check_simulators(settings)
    assert requested == [{"CPU": 1}, {"CPU": 0.5}, {"CPU": 1, "GPU": 0.25}]
    refused = "yet; turns are refused as no_capacity until one joins\n"
    assert capsys.readouterr().err == (
        "proctor: no machine of the Ray cluster has CPU=0.5 for a simulator of "
        f"calibration {refused}"
        "proctor: no machine of the Ray cluster has CPU=1,GPU=0.25 for a simulator of "
        f"mobile_bimanual, tabletop {refused}"
    )
