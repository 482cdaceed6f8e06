"""Push-T by the protocol and in a loop of its own: every episode is the same.

`.venv-own/bin/python -m tools.measurements.play_both_ways`, after `make add
PACKAGE=gym-pusht`. A policy that follows the observation, so that a difference in any
step leads elsewhere, plays the split `practice` of gym_pusht/push_t.toml in
examples/benchmarks twice. Ends with 1 if the steps, the success or the return of one
episode differ.
"""

import subprocess
import sys
import tempfile
import tomllib
from pathlib import Path
from typing import NamedTuple

import gym_pusht  # noqa: F401 - registers the environment
import gymnasium
import numpy as np
import numpy.typing as npt
from proctor_client import EpisodeResult

from reference_client import Observation, evaluate
from reference_client.protocol.connection import Connection

TOKEN = "both"  # noqa: S105 - of a server that lives as long as this does
EXAMPLES = Path(__file__).resolve().parents[2] / "examples" / "benchmarks"
FILE = EXAMPLES / "gym_pusht" / "push_t.toml"


class BothWaysOutcome(NamedTuple):
    """What must agree; the return to the last bit."""

    steps: int
    success: bool
    total_reward: float


def act(state: npt.NDArray[np.float64]) -> npt.NDArray[np.float32]:
    """Go behind the block, as seen from the middle, then push it there."""
    finger, block = state[:2], state[2:4]
    outwards = (block - 256) / (np.linalg.norm(block - 256) + 1e-9)
    beside = finger - block
    along = float(beside @ outwards)
    is_behind = along > 0 and np.linalg.norm(beside - along * outwards) < 25
    goal = finger - 60 * outwards if is_behind else block + 110 * outwards
    inside: npt.NDArray[np.float32] = np.clip(goal, 0, 512).astype(np.float32)
    return inside


class Follower:
    """The same function as a policy of the client."""

    def reset(self, instruction: str) -> None:
        """Nothing is remembered."""

    def act(self, observation: Observation) -> dict[str, npt.NDArray[np.float32]]:
        return {"action": act(np.array(observation.state["observation"]))}


def play_directly(seed: int, max_steps: int) -> BothWaysOutcome:
    """One episode in an environment made for it alone."""
    environment = gymnasium.make("gym_pusht/PushT-v0", obs_type="state")
    state, _ = environment.reset(seed=seed)
    total = 0.0
    try:
        for step in range(1, max_steps + 1):
            state, reward, _, _, info = environment.step(act(state))
            total += float(reward)
            if info["is_success"]:
                return BothWaysOutcome(step, True, total)
        return BothWaysOutcome(max_steps, False, total)
    finally:
        environment.close()


def play_by_protocol() -> dict[int, BothWaysOutcome]:
    """The split `practice`, by seed, on a server of its own with two workers."""
    with tempfile.TemporaryDirectory() as scratch:
        server = subprocess.Popen(
            [
                *(sys.executable, "-m", "reference_server", "--port", "0"),
                *("--database", f"{scratch}/proctor.sqlite"),
                *("--tokens", f"both:read+run:{TOKEN}", "--benchmarks", str(FILE)),
            ],
            stdout=subprocess.PIPE,
            text=True,
        )
        try:
            assert server.stdout is not None
            url = server.stdout.readline().split()[-1]
            score = evaluate(
                Follower,
                url=url,
                token=TOKEN,
                benchmark=FILE.stem,
                splits=["practice"],
                workers=2,
            )
            with Connection(url, TOKEN, requests=1) as connection:
                page = connection.control.list_episodes(score.run_id)
        finally:
            server.terminate()
            server.wait()
    results = [one.result for one in page.episodes if one.result is not None]
    return {one.seed: outcome_of(one) for one in results if one.seed is not None}


def outcome_of(result: EpisodeResult) -> BothWaysOutcome:
    assert result.total_reward is not None
    success = result.outcome.value == "success"
    return BothWaysOutcome(result.steps, success, float(result.total_reward))


def main() -> int:
    content = tomllib.loads(FILE.read_text())
    served = play_by_protocol()
    differing = 0
    for seed in content["splits"][0]["seeds"]:
        direct, by_protocol = play_directly(seed, content["max_steps"]), served[seed]
        differing += direct != by_protocol
        print(f"seed {seed}: {direct}, by protocol {by_protocol}")
    print(f"{len(served)} episodes, {differing} differ")
    return 1 if differing else 0


if __name__ == "__main__":
    sys.exit(main())
