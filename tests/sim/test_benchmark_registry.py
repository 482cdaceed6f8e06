"""The catalog: what is offered, and what a user adds to it."""

from pathlib import Path

import pytest

from reference_record.contents.benchmark_manifest import manifest_sha256
from reference_sim import benchmark_registry
from reference_sim.benchmark_registry import SimulatorConfig
from reference_sim.gymnasium import BadBenchmark
from tests.support.paths import ROOT
from tests.support.repository.imports import files_of_package, importers_of

EXAMPLES = ROOT / "examples" / "benchmarks"


@pytest.fixture(autouse=True)
def _catalog_of_its_own(monkeypatch: pytest.MonkeyPatch) -> None:
    known = dict(benchmark_registry._BENCHMARKS)
    monkeypatch.setattr(benchmark_registry, "_BENCHMARKS", known)


@pytest.mark.slow("plays an episode of each benchmark")
def test_added_benchmarks_are_offered() -> None:
    built_in = benchmark_registry.benchmark_ids()
    warnings: list[str] = []
    benchmark_registry.add(f"{EXAMPLES}, gymnasium:Acrobot-v1,", warnings.append)
    added = {"acrobot_v1", "cartpole", "pendulum"}
    assert set(benchmark_registry.benchmark_ids()) == {*built_in, *added}
    assert benchmark_registry.unavailable_reason("cartpole") is None
    # A slow machine adds lines of progress.
    (warning,) = (line for line in warnings if ": checking, " not in line)
    assert warning.startswith("acrobot_v1: no camera: DependencyNotInstalled: pygame")

    resolved = benchmark_registry.resolve("cartpole", max_chunk=7)
    assert resolved.manifest["max_chunk"] == 7
    assert len(resolved.episodes) == 2 * (2 + 3)
    assert resolved.world.success_scored_tasks == ["balance", "recover"]
    assert benchmark_registry.resolve("pendulum").world.success_scored_tasks == []
    with pytest.raises(BadBenchmark, match="acrobot_v1 is already in use"):
        benchmark_registry.add("gymnasium:Acrobot-v1", warnings.append)


def test_a_simulator_is_built_without_the_registration() -> None:
    benchmark_registry.add(f"{EXAMPLES}/corridor.py:Corridor", print)
    world = benchmark_registry.resolve("corridor").world
    benchmark_registry._BENCHMARKS.clear()
    config = SimulatorConfig("corridor", dict(world.settings))
    simulator = benchmark_registry.make(config)
    assert simulator.reset("corridor", 1) == "Walk to the mark and stop there."
    assert simulator.observe().state["observation"].shape == (2,)
    simulator.close()
    with pytest.raises(benchmark_registry.UnknownBenchmark):
        benchmark_registry.resolve("corridor")


def test_declared_resources_come_with_the_simulator_and_change_no_manifest(
    tmp_path: Path,
) -> None:
    text = (EXAMPLES / "cartpole.toml").read_text()
    declared = 'benchmark_id = "cartpole"\nray_resources = { CPU = 0.5, GPU = 1 }\n'
    (tmp_path / "cartpole.toml").write_text(declared + text)
    benchmark_registry.add(f"{EXAMPLES}/cartpole.toml", print)
    without = benchmark_registry.resolve("cartpole")
    del benchmark_registry._BENCHMARKS["cartpole"]
    benchmark_registry.add(f"{tmp_path}/cartpole.toml", print)
    having = benchmark_registry.resolve("cartpole")
    assert manifest_sha256(having.manifest) == manifest_sha256(without.manifest)
    assert without.world.ray_resources == {}
    assert having.world.ray_resources == {"CPU": 0.5, "GPU": 1}
    assert benchmark_registry.ray_resources("cartpole") == {"CPU": 0.5, "GPU": 1}


def test_missing_meta_world_is_reported_with_the_command_to_install_it() -> None:
    with pytest.raises(BadBenchmark) as caught:
        benchmark_registry.add("metaworld_mt50", print)
    assert "No module named 'metaworld'" in str(caught.value)
    assert "make serve BENCHMARK=metaworld_mt50" in str(caught.value)


@pytest.mark.parametrize(
    ("module", "owner"),
    [
        ("gymnasium", "reference_sim/gymnasium/environments.py"),
        ("metaworld", "reference_sim/benchmarks/metaworld/world.py"),
    ],
)
def test_a_library_of_environments_has_one_owner(module: str, owner: str) -> None:
    packages = files_of_package("reference_sim", "reference_server", "conformance")
    assert importers_of(module, among=packages) == [owner]
