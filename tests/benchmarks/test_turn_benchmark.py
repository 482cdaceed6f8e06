"""The round trips in small: raw TCP and our own server, a few turns of each.

That the peers can be measured too is seen when they are: they live in an environment
that `make test` does not make.
"""

from typing import Any

import numpy as np
import pytest

from benchmarks.round_trips import compared_turns, observations
from benchmarks.round_trips.contender_process import TurnClient
from benchmarks.round_trips.interleaved_rounds import TurnTimes

pytestmark = pytest.mark.slow("measures every contender")

NAMES = ("tcp", "ours msgpack", "ours json")


def test_each_contender_plays_its_turns_and_has_a_row() -> None:
    played = compared_turns.play_scenario("state", NAMES, 3)
    assert set(played) == set(NAMES)
    for times in played.values():
        assert len(times.ns) >= 3
        assert len(times.ns) % 3 == 0  # as many in each round
        assert 0 < times.percentile_ms(50) <= times.percentile_ms(99)
        assert min(times.server_cpu_s, times.client_cpu_s) > 0
    text = compared_turns.table_of(played)
    assert [name for name in NAMES if compared_turns.NAMES[name] not in text] == []


def test_targets_are_computed_from_the_measurements() -> None:
    medians = {"tcp": 1, "ours msgpack": 3, "dm_env_rpc": 6, "ebench": 5}
    cameras = {name: TurnTimes([10**6 * ms] * 2) for name, ms in medians.items()}
    judged = compared_turns.targets({"cameras": cameras})
    assert [(target.measured, target.is_met) for target in judged] == [
        (3.0, False),  # at most twice raw TCP
        (2.0, True),  # gRPC takes at least twice as long
        (pytest.approx(5 / 3), False),
    ]


class FaultyConnections:
    """What may go wrong between a server and a client."""

    def __init__(self) -> None:
        self.world = observations.ScenarioPlayer("camera")

    def correct(self, action: list[float]) -> Any:
        return self.world.turn(action)

    def ignoring_actions(self, _action: list[float]) -> Any:
        return self.world.turn([0.5])

    def stale(self, action: list[float]) -> Any:
        state, images = self.world.turn(action)
        return state, {name: np.roll(image, 1) for name, image in images.items()}

    def without_images(self, action: list[float]) -> Any:
        return self.world.turn(action)[0], {}


@pytest.mark.parametrize("wire", ["ignoring_actions", "stale", "without_images"])
def test_wrong_observations_are_not_measured(wire: str) -> None:
    with pytest.raises(AssertionError):
        TurnClient(getattr(FaultyConnections(), wire), "camera").play(1)
