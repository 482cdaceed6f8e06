"""A robot cell without a robot: it needs a person, jams, and errs about its state.

An arm takes a block along in the plane. Motion takes time and goes on between two
steps, as that of a robot does; a stop ends it. Copy proctor_simulator.py beside this
file; then

    proctor-server --simulator "python simulated_cell.py"

Options: `--log FILE` writes when the arm began to move and when it stood still, in
monotonic seconds; `--jams SHARE` and `--errs SHARE` of the steps and attempts; behind
them an address, `unix:PATH`.
"""

import argparse
import base64
import math
import random
import struct
import threading
import time
import zlib
from typing import Any

import proctor_simulator
from proctor_simulator import part, vector

WATCHDOG_S, STOP_WITHIN_S = 1.0, 0.25
STEP_S = 0.05
SPEED_M_S = 0.4
NEAR_M = 0.06
SETUPS = {
    "push_left": ("Put the block on the left mark.", (-0.4, 0.0)),
    "push_right": ("Put the block on the right mark.", (0.4, 0.0)),
}


GREY, RED, BLUE, GREEN = (200, 200, 200), (220, 30, 30), (30, 60, 200), (90, 210, 120)


def draw_table(
    width: int, height: int, *squares: tuple[float, float, tuple[int, int, int]]
) -> bytes:
    """The table from above, one metre to each side; squares: x, y and colour.

    The last square is the smallest, so that those below it are seen.
    """
    pixels = bytearray(GREY * (width * height))
    for size, (x, y, colour) in zip((4, 2, 1), squares):  # noqa: B905
        half = max(1, size * width // 64)
        middle = int((x + 1) / 2 * (width - 1)), int((1 - y) / 2 * (height - 1))
        for row in range(max(0, middle[1] - half), min(height, middle[1] + half)):
            for column in range(max(0, middle[0] - half), min(width, middle[0] + half)):
                at = 3 * (row * width + column)
                pixels[at : at + 3] = bytes(colour)
    return bytes(pixels)


def setup_picture(goal: tuple[float, float]) -> str:
    """How things stand before an attempt, as PNG in base64: block blue, mark green."""
    width, height = 320, 240
    pixels = draw_table(width, height, (*goal, GREEN), (0.0, 0.0, BLUE))
    lines = b"".join(
        b"\0" + pixels[at : at + 3 * width] for at in range(0, len(pixels), 3 * width)
    )
    png = b"\x89PNG\r\n\x1a\n"
    size = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    for kind, data in (
        (b"IHDR", size),
        (b"IDAT", zlib.compress(lines)),
        (b"IEND", b""),
    ):
        checked = kind + data
        png += struct.pack(">I", len(data)) + checked
        png += struct.pack(">I", zlib.crc32(checked))
    return base64.b64encode(png).decode()


class Arm:
    """The driver: a thread moves the arm at its speed until it is stopped.

    The stop is latched: no velocity is accepted before the next `enable`.
    """

    def __init__(self, log: str) -> None:
        self.position = [0.0, 0.0]
        self.block = [0.0, 0.0]
        self._velocity = (0.0, 0.0)
        self._lock = threading.Lock()
        self._enabled = False
        self._log = open(log, "a", buffering=1) if log else None  # noqa: PTH123,SIM115
        threading.Thread(target=self._move, daemon=True).start()

    def enable(self) -> None:
        with self._lock:
            self._enabled = True
            self._note("enabled")

    def drive(self, velocity: list[float]) -> None:
        with self._lock:
            if self._enabled:
                self._velocity = (velocity[0], velocity[1])
                self._note("drives")

    def stop(self) -> None:
        with self._lock:
            self._enabled = False
            self._velocity = (0.0, 0.0)
            self._note("stopped")

    def _note(self, event: str) -> None:
        if self._log:
            self._log.write(f"{time.monotonic():.6f} {event}\n")

    def _move(self) -> None:
        while True:
            time.sleep(0.01)
            with self._lock:
                for axis in (0, 1):
                    moved = self.position[axis] + 0.01 * self._velocity[axis]
                    self.position[axis] = min(1.0, max(-1.0, moved))
                if self._enabled and math.dist(self.position, self.block) < NEAR_M:
                    self.block = list(self.position)


class SimulatedCell(proctor_simulator.Robot):
    benchmark = {  # noqa: RUF012
        "benchmark_id": "simulated_cell",
        "title": "A robot cell without a robot",
        "simulator": {"name": "simulated_cell", "version": "1"},
        "tasks": list(SETUPS),
        "splits": [{"name": "test", "episodes": 2, "first_seed": 0}],
        "max_steps": 60,
        "control_rate_hz": 1 / STEP_S,
        "deterministic": False,
        "action_space": {
            "velocity": vector(
                {"xy": part(2, "linear_velocity", "m/s", "base")},
                [-SPEED_M_S] * 2,
                [SPEED_M_S] * 2,
            )
        },
        "observation_space": {
            "state": {"position": vector({"xy": part(2, "position", "m", "base")})},
            "images": {"front": {"channels": 3, "description": "from the front"}},
        },
        "image_sizes": [{"width": 64, "height": 48}],
        "physical": {
            "stop_within_s": STOP_WITHIN_S,
            "watchdog_s": WATCHDOG_S,
            "setups": {
                name: {
                    "instruction": "Put the block, blue in the picture, in the middle."
                    "\n\n"
                    "When you are ready, the policy is asked to do this, with the mark "
                    f"that is green in the picture: {text}",
                    "picture": setup_picture(goal),
                }
                for name, (text, goal) in SETUPS.items()
            },
            "rubric": {
                "success": "The block is on its mark.",
                "criteria": ["The arm touched the block.", "The block moved."],
            },
            "order_seed": 7,
            "second_judge_share": 0.5,
        },
    }

    def __init__(self, arm: Arm, jams: float, errs: float) -> None:
        self._arm, self._jams, self._errs = arm, jams, errs
        self._chance = random.Random()

    def reset(self, task: str, seed: int, split: str) -> dict[str, Any]:
        """Drive home; the person has put the block back."""
        text, self._goal = SETUPS[task]
        self._arm.enable()
        for _ in range(3):
            self._arm.drive([-x / STEP_S for x in self._arm.position])
            time.sleep(STEP_S)
        self._arm.drive([0.0, 0.0])
        self._arm.block = [0.0, 0.0]
        self._is_wrong = self._chance.random() < self._errs
        return {"instruction": text, "state": self._state()}

    def step(self, action: dict[str, list[float]]) -> dict[str, Any]:
        if self._chance.random() < self._jams:
            raise RuntimeError("joint 3 is jammed")
        self._arm.drive(action["velocity"])
        time.sleep(STEP_S)
        near = math.dist(self._arm.block, self._goal) < NEAR_M
        return {"state": self._state(), "success": near != self._is_wrong}

    def stop(self) -> None:
        self._arm.stop()

    def draw(self, camera: str, width: int, height: int) -> bytes:
        mark = (*self._goal, GREEN)
        block = (self._arm.block[0], self._arm.block[1], BLUE)
        arm = (self._arm.position[0], self._arm.position[1], RED)
        return draw_table(width, height, mark, block, arm)

    def _state(self) -> dict[str, list[float]]:
        noise = [self._chance.gauss(0.0, 0.002) for _ in range(2)]
        measured = [x + n for x, n in zip(self._arm.position, noise)]  # noqa: B905
        return {"position": measured}


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("address", nargs="?", default="")
    parser.add_argument("--log", default="")
    parser.add_argument("--jams", type=float, default=0.0)
    parser.add_argument("--errs", type=float, default=0.1)
    given = parser.parse_args()
    cell = SimulatedCell(Arm(given.log), given.jams, given.errs)
    proctor_simulator.serve(cell, given.address)
