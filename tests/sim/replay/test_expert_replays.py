"""Records of experts on every task of the MuJoCo benchmarks replay exactly."""

from collections.abc import Iterator
from pathlib import Path

import pytest

from reference_record.formats.bundle import open_bundle
from reference_record.verification import verify
from reference_sim import benchmark_registry
from reference_sim.episode import Episode
from reference_sim.interface import Simulator
from reference_sim.replay.record_replay import replay_record, resolve
from tests.support.record.played_records import Chunk, save_played_record
from tools import experts

pytestmark = pytest.mark.slow("plays whole episodes")


@pytest.mark.parametrize("benchmark", experts.benchmark_names())
@pytest.mark.parametrize("processes", [1, 2])
def test_experts_replay_exactly(benchmark: str, processes: int, tmp_path: Path) -> None:
    found = benchmark_registry.resolve(f"{benchmark}_state")
    tasks = [plan.task for plan in found.episodes]
    only = {tasks.index(task) for task in found.manifest["tasks"]}

    def play(episode: Episode, simulator: Simulator) -> Iterator[Chunk]:
        policy = experts.expert(benchmark)
        policy.reset(episode.instruction)
        while not episode.ended and not episode.success:
            state = simulator.observe().state
            action = policy.act({name: v.tolist() for name, v in state.items()})
            yield [{name: [*map(float, values)] for name, values in action.items()}]

    path = tmp_path / "run.proctor"
    (tmp_path / "recordings").mkdir()
    save_played_record(path, tmp_path / "recordings", found, play, only=only)
    bundle = open_bundle(path)
    evaluation = verify(bundle).evaluation
    known = resolve(evaluation, bundle.read("manifest.json"))
    replay = replay_record(path, known, processes=processes)
    assert (replay.result, replay.exact) == ("exact", len(only))
