"""A benchmark of one's own is one class.

make serve BENCHMARK=examples/benchmarks/corridor.py:Corridor
"""

from typing import Any

import gymnasium
import numpy as np
from gymnasium.spaces import Box
from numpy.typing import NDArray

Floats = NDArray[np.float32]


class Corridor(gymnasium.Env[Floats, Floats]):
    """Walk to the mark and stop there."""

    action_space = Box(-1, 1, (1,))  # how far to walk, in metres
    observation_space = Box(0, 10, (2,))  # where the robot and the mark are
    max_steps = 40

    def reset(self, *, seed: int | None = None, options: Any = None) -> Any:
        super().reset(seed=seed)
        self.robot, self.mark = 0.0, self.np_random.uniform(5, 9)
        return self.look(), {}

    def step(self, action: Floats) -> Any:
        self.robot = min(10.0, max(0.0, self.robot + float(action[0])))
        success = abs(self.robot - self.mark) < 0.2 and abs(action[0]) < 0.1
        return self.look(), 0.0, False, False, {"success": success}

    def look(self) -> Floats:
        return np.array([self.robot, self.mark], np.float32)
