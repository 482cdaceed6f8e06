"""The catalog: what is offered, and what a user adds to it."""

from __future__ import annotations

from pathlib import Path

import pytest

from reference_sim import catalog
from reference_sim.catalog import World
from reference_sim.gymnasium_adapter import BadBenchmark
from tests.test_layers import of_package, who_imports

EXAMPLES = Path(__file__).resolve().parents[1] / "examples" / "benchmarks"


@pytest.fixture(autouse=True)
def _catalog_of_its_own(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(catalog, "_BENCHMARKS", dict(catalog._BENCHMARKS))


def test_what_is_added_is_offered_beside_ours() -> None:
    ours = catalog.benchmark_ids()
    said: list[str] = []
    catalog.add(f"{EXAMPLES}, gymnasium:Acrobot-v1,", said.append)
    added = {"acrobot_v1", "cartpole", "pendulum"}
    assert set(catalog.benchmark_ids()) == {*ours, *added}
    assert catalog.unavailable_reason("cartpole") is None
    (warning,) = said
    assert warning.startswith("acrobot_v1: no camera: DependencyNotInstalled: pygame")

    resolved = catalog.resolve("cartpole", max_chunk=7)
    assert resolved.manifest["max_chunk"] == 7
    assert len(resolved.episodes) == 2 * (2 + 3)
    assert resolved.world.success_scored_tasks == ["balance", "recover"]
    assert catalog.resolve("pendulum").world.success_scored_tasks == []
    with pytest.raises(BadBenchmark, match="there is a benchmark acrobot_v1 already"):
        catalog.add("gymnasium:Acrobot-v1", said.append)


def test_a_world_is_made_where_nothing_was_added() -> None:
    catalog.add(f"{EXAMPLES}/corridor.py:Corridor", print)
    world = catalog.resolve("corridor").world
    catalog._BENCHMARKS.clear()
    simulator = catalog.make(World("corridor", dict(world.settings)))
    assert simulator.reset("corridor", 1) == "Walk to the mark and stop there."
    assert simulator.observe().state["observation"].shape == (2,)
    simulator.close()
    with pytest.raises(catalog.UnknownBenchmark):
        catalog.resolve("corridor")


def test_meta_world_is_not_in_this_environment_and_the_cure_is_said() -> None:
    with pytest.raises(BadBenchmark) as caught:
        catalog.add("metaworld_mt50", print)
    assert "No module named 'metaworld'" in str(caught.value)
    assert "make serve BENCHMARK=metaworld_mt50" in str(caught.value)


@pytest.mark.parametrize(
    ("module", "owner"),
    [
        ("gymnasium", "reference_sim/gymnasium_adapter/environments.py"),
        ("metaworld", "reference_sim/metaworld_mt50/world.py"),
    ],
)
def test_a_library_of_environments_has_one_owner(module: str, owner: str) -> None:
    house = of_package("reference_sim", "reference_server", "conformance")
    assert who_imports(module, among=house) == [owner]
