"""The messages of all contenders: the same observations and the same actions.

An observation is 23 floats and, by scenario, no camera, one of 224 × 224 or four of
480 × 640, `uint8`. Its images are drawn once; a turn only writes its number
into them, so that rendering costs nothing and a stale image is detected. An action is
16 floats. Imports numpy and no protocol.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

Vector = Sequence[float] | NDArray[np.float64]
State = dict[str, NDArray[np.float64]]
Images = dict[str, NDArray[np.uint8]]

STATE_SIZES = {"joint_position": 12, "gripper": 4, "base": 7}
ACTION_SIZES = {"joint_position": 12, "gripper": 4}
CAMERAS = ("head", "front", "left_wrist", "right_wrist")
SEED = 1
_PHASES = np.linspace(0, 6, sum(STATE_SIZES.values()))
FRESH = -2.0  # stands for the action's echo where an episode begins


@dataclass(frozen=True, slots=True)
class Scenario:
    """height, width: of each image, in pixels."""

    cameras: tuple[str, ...]
    height: int = 0
    width: int = 0


SCENARIOS = {
    "state": Scenario(()),
    "camera": Scenario(CAMERAS[:1], 224, 224),
    "cameras": Scenario(CAMERAS, 480, 640),
}


def picture(number: int, height: int, width: int) -> NDArray[np.uint8]:
    """(height, width, 3): a shaded table with boxes on it and a sensor's grain.

    As JPEG of quality 90 it has the size of a frame of `mobile_bimanual`.
    """
    draw = np.random.default_rng([SEED, number])
    row, column = np.mgrid[:height, :width]
    shade = 90 + 80 * row / height + 30 * np.sin(column / width * 3 + number)
    pixels = np.repeat(shade[:, :, None], 3, axis=2)
    for _ in range(24):
        top, left = draw.integers(height * 3 // 4), draw.integers(width * 3 // 4)
        box = pixels[top : top + height // 6, left : left + width // 8]
        slope = np.linspace(0, 30, box.shape[0])[:, None, None]
        box[:] = draw.integers(0, 256, 3) + slope
    pixels += draw.normal(0, 0.6, pixels.shape)
    return pixels.clip(0, 255).astype(np.uint8)


def pictures(scenario: Scenario) -> Images:
    return {
        name: picture(number, scenario.height, scenario.width)
        for number, name in enumerate(scenario.cameras)
    }


def state(step: int, action: Vector) -> State:
    """`base` begins with the number of the step and an echo of the action."""
    # Incompressible digits, like those of measured joints.
    values = np.sin(_PHASES + 0.1 * step)
    joints, grippers = STATE_SIZES["joint_position"], STATE_SIZES["gripper"]
    base = values[joints + grippers :]
    base[:2] = step, action[0]
    return {
        "joint_position": values[:joints],
        "gripper": values[joints : joints + grippers],
        "base": base,
    }


def stamp(image: NDArray[np.uint8], step: int) -> None:
    image[0, 0] = step % 251


class ScenarioPlayer:
    """The peers' servers play it; ours plays the same in its simulator process."""

    def __init__(self, name: str) -> None:
        self._step = 0
        self._images = pictures(SCENARIOS[name])

    def turn(self, action: Vector) -> tuple[State, Images]:
        """The observation after the action. The next turn overwrites its images."""
        self._step += 1
        for image in self._images.values():
            stamp(image, self._step)
        return state(self._step, action), self._images


def action(number: int) -> list[float]:
    """16 floats within [-1, 1], different in every turn."""
    size = sum(ACTION_SIZES.values())
    return [((number * 7 + index * 13) % 199) / 100 - 1 for index in range(size)]


def by_name(action: list[float]) -> dict[str, list[float]]:
    """The action as the spaces of Proctor's benchmark have it."""
    joints = ACTION_SIZES["joint_position"]
    return {"joint_position": action[:joints], "gripper": action[joints:]}


class ObservationChecker:
    """Checks that a client received the right observation. Raises AssertionError."""

    def __init__(self, name: str) -> None:
        self._pictures = pictures(SCENARIOS[name])
        self._last_step = -1

    def check(
        self,
        sent: Sequence[float],
        state: Mapping[str, Vector],
        images: Mapping[str, NDArray[Any]],
        *,
        whole: bool,
        exact: bool = True,
    ) -> None:
        """whole: every pixel is compared. exact: false where they were compressed."""
        sizes = {name: len(values) for name, values in state.items()}
        assert sizes == STATE_SIZES, sizes
        step, echo = int(state["base"][0]), float(state["base"][1])
        assert step != self._last_step, "the same observation came twice"
        assert echo == FRESH or abs(echo - sent[0]) < 1e-6, (echo, sent[0])
        self._last_step = step
        assert images.keys() == self._pictures.keys(), images.keys()
        for name, image in images.items():
            assert image.dtype == np.uint8
            assert image.shape == self._pictures[name].shape, image.shape
            if exact:
                assert int(image[0, 0, 0]) == step % 251, "an old picture"
            if whole:
                far = np.abs(image[1:].astype(int) - self._pictures[name][1:])
                assert far.max() == 0 if exact else far.mean() < 4, far.mean()
