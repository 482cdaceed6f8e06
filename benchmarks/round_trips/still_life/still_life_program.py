"""The world of world.py as a program that speaks the simulator protocol.

It is what this project's own simulators would cost if each were such a program.
`python still_life_program.py state|cameras`, with the library on the path of imports.
"""

import os
import sys
from pathlib import Path
from typing import Any

sys.path[:0] = [str(Path(__file__).parents[3]), os.environ["LIBRARIES"]]

import proctor_simulator  # noqa: E402

from benchmarks.round_trips import observations  # noqa: E402
from benchmarks.round_trips.still_life import world  # noqa: E402

Json = dict[str, Any]


class StillLifeProgram(proctor_simulator.Simulator):
    """Pictures are handed over as they lie; one number in them is that of the step."""

    def __init__(self, scenario: str) -> None:
        described = world._describe(scenario, {}, 1)  # noqa: SLF001 - the same world
        names = ("tasks", "max_steps", "action_space", "observation_space")
        self.benchmark = {name: described[name] for name in names} | {
            "benchmark_id": f"python_{scenario}",
            "simulator": {"name": "still_life", "version": "1"},
            "image_sizes": described["image_sizes"],
            "splits": [{"name": "test", "episodes": 2000, "first_seed": 1}],
            "digest": True,
            "shared_memory": True,
        }
        self._world = world.StillLife(scenario)
        self._pictures = observations.pictures(observations.SCENARIOS[scenario])

    def reset(self, task: str, seed: int, split: str) -> Json:
        instruction = self._world.reset(task, seed)
        return {"instruction": instruction, "state": self.state()}

    def step(self, action: Json) -> Json:
        self._world.step(action)
        return {"state": self.state(), "success": False}

    def state(self) -> Json:
        shown = observations.state(self._world._step, self._world._echo)  # noqa: SLF001
        return {name: vector.tolist() for name, vector in shown.items()}

    def draw(self, camera: str, width: int, height: int) -> Any:
        pixels = self._pictures[camera]
        observations.stamp(pixels, self._world._step)  # noqa: SLF001
        return pixels

    def digest(self) -> bytes:
        return self._world.state_bytes()


if __name__ == "__main__":
    proctor_simulator.serve(StillLifeProgram(sys.argv[1]))
