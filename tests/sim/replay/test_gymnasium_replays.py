"""A Gymnasium environment that draws from its seed alone replays exactly."""

from collections.abc import Iterator
from pathlib import Path

import pytest

from reference_record.contents.replay_verdict import Divergence, ReplaySummary
from reference_record.formats.bundle import open_bundle
from reference_record.recordings.recording import Turn
from reference_record.verification import verify
from reference_sim import benchmark_registry
from reference_sim.episode import Episode
from reference_sim.interface import Simulator
from reference_sim.replay.record_replay import replay_record, resolve
from tests.support.paths import ROOT
from tests.support.record.played_records import Change, Chunk, keep, save_played_record

pytestmark = pytest.mark.slow("starts processes that simulate")

# Its first two episodes have seeds that are shown.
REFERENCE = str(ROOT / "examples" / "benchmarks" / "cartpole.toml")


def play(episode: Episode, simulator: Simulator) -> Iterator[Chunk]:
    """Push against the side to which the pole falls."""
    while not episode.ended:
        state = next(iter(simulator.observe().state.values()))
        yield [{"action": [float(state[2] > 0)]}]


@pytest.fixture(scope="module")
def benchmark_id() -> Iterator[str]:
    """In the registry as long as it is needed."""
    with pytest.MonkeyPatch.context() as patch:
        known = dict(benchmark_registry._BENCHMARKS)
        patch.setattr(benchmark_registry, "_BENCHMARKS", known)
        before = set(benchmark_registry.benchmark_ids())
        benchmark_registry.add(REFERENCE, lambda _line: None)
        (added,) = set(benchmark_registry.benchmark_ids()) - before
        yield added


def replay_of_two(benchmark_id: str, folder: Path, change: Change) -> ReplaySummary:
    """Two episodes are played, recorded as `change` says, and simulated again."""
    found = benchmark_registry.resolve(benchmark_id)
    path = folder / "run.proctor"
    save_played_record(path, folder, found, play, only={0, 1}, change=change)
    bundle = open_bundle(path)
    known = resolve(verify(bundle).evaluation, bundle.read("manifest.json"))
    return replay_record(path, known)


def test_cartpole_replays_exactly(benchmark_id: str, tmp_path: Path) -> None:
    replay = replay_of_two(benchmark_id, tmp_path, keep)
    assert (replay.result, replay.exact) == ("exact", 2)


def test_a_changed_push_is_found_where_it_is(benchmark_id: str, tmp_path: Path) -> None:
    def push_the_other_way(index: int, number: int, turn: Turn) -> Turn:
        if (index, number) == (1, 3):
            turn.actions = [{"action": [1.0 - turn.actions[0]["action"][0]]}]
        return turn

    replay = replay_of_two(benchmark_id, tmp_path, push_the_other_way)
    assert (replay.result, replay.exact, replay.diverged) == ("diverged", 1, 1)
    assert replay.first_divergence == Divergence(1, 1, 3)
