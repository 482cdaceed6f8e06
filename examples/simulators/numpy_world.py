"""A world in NumPy: a point is pushed to a target, and a camera looks from above.

Copy proctor_simulator.py beside this file; then

    proctor-server --simulator "python numpy_world.py"

or, started by yourself and found by the server at a socket:

    python numpy_world.py unix:/tmp/world.sock
    proctor-server --simulator unix:/tmp/world.sock
"""

import sys
from typing import Any, Dict, List

import numpy as np
import proctor_simulator
from proctor_simulator import part, vector

NEAR_M, STEP_M = 0.05, 0.05


class PointWorld(proctor_simulator.Simulator):
    benchmark = {  # noqa: RUF012
        "benchmark_id": "numpy_world",
        "title": "A point in the plane",
        "simulator": {"name": "numpy_world", "version": "1", "numpy": np.__version__},
        "tasks": ["reach"],
        "max_steps": 60,
        "control_rate_hz": 10,
        "action_space": {
            "velocity": vector(2, [-1, -1], [1, 1], description="shares of 5 cm")
        },
        "observation_space": {
            "state": {
                "position": vector({"xy": part(2, "position", "m", "world")}),
                "target": vector({"xy": part(2, "position", "m", "world")}),
            },
            "images": {"top": {"channels": 3, "description": "from above"}},
            "tensors": {},
        },
        "image_sizes": [{"width": 64, "height": 64}, {"width": 640, "height": 480}],
    }

    def reset(self, task: str, seed: int, split: str) -> Dict[str, Any]:
        rng = np.random.default_rng(seed)
        self.position, self.target = rng.uniform(-1, 1, (2, 2))
        return {"instruction": "Reach the red target.", "state": self.state()}

    def step(self, action: Dict[str, List[float]]) -> Dict[str, Any]:
        moved = self.position + STEP_M * np.asarray(action["velocity"])
        self.position = np.clip(moved, -1, 1)
        distance = float(np.linalg.norm(self.position - self.target))
        success = distance < NEAR_M
        return {
            "state": self.state(),
            "success": success,
            "terminated": success,
            "reward": -distance,
        }

    def state(self) -> Dict[str, Any]:
        return {"position": self.position, "target": self.target}

    def draw(self, camera: str, width: int, height: int) -> Any:
        pixels = np.full((height, width, 3), 240, np.uint8)
        for place, colour in (
            (self.target, (200, 30, 30)),
            (self.position, (30, 30, 200)),
        ):
            x, y = ((place + 1) / 2 * (width - 1, height - 1)).astype(int)
            top, left = max(0, height - 1 - y - 2), max(0, x - 2)
            pixels[top : top + 5, left : left + 5] = colour
        return pixels


if __name__ == "__main__":
    proctor_simulator.serve(PointWorld(), *sys.argv[1:])
