"""Environments with one fault each, and one with every kind of space.

`Sound` is right; what is wrong with the others is in their names and docstrings. None
of them looks at the world outside, so that the check is judged and nothing else.
"""

import os
import random
import signal
import time
from typing import Any, ClassVar

import gymnasium
import numpy as np
from gymnasium import spaces

ALL_SPACES = spaces.Dict(
    {
        "arm": spaces.Dict(
            {
                "joints": spaces.Box(-3, 3, (2,), np.float64),
                "gripper": spaces.Discrete(3, start=-1),
            }
        ),
        "front": spaces.Box(0, 255, (12, 16, 3), np.uint8),
        "grey": spaces.Box(0, 255, (12, 16), np.uint8),
        "small": spaces.Box(0, 255, (8, 9, 3), np.uint8),
        "grid": spaces.Box(-1, 1, (2, 3), np.float32),
        "pair": spaces.Tuple((spaces.MultiDiscrete([2, 5]), spaces.MultiBinary(3))),
    }
)


class ValidEnv(gymnasium.Env[Any, Any]):
    """Make the number larger than one."""

    action_space: Any = spaces.Box(-1, 1, (1,))
    observation_space: Any = spaces.Box(-20, 20, (1,))
    max_steps = 20

    def __init__(self, amount: float = 0.0, render_mode: str | None = None) -> None:
        self.amount = amount
        self.render_mode = render_mode

    def reset(self, *, seed: int | None = None, options: Any = None) -> Any:
        super().reset(seed=seed)
        self.number = self.initial_number() + self.amount
        return self.current_observation(), {}

    def initial_number(self) -> float:
        return float(self.np_random.uniform(-1, 1))

    def step(self, action: Any) -> Any:
        self.number += float(action[0])
        seen, info = self.current_observation(), {"success": self.number > 1}
        return seen, self.number, False, False, info

    def current_observation(self) -> Any:
        return np.array([self.number], np.float32)

    def render(self) -> Any:
        # A ramp, so that turning it by half a turn shows.
        ramp = np.arange(6 * 8 * 3, dtype=np.uint8).reshape(6, 8, 3)
        return ramp if self.render_mode == "rgb_array" else None


class TakesAGpu(ValidEnv):
    """Declares what a simulator takes of a Ray cluster, and how often it may fault."""

    ray_resources: ClassVar = {"CPU": 0.5, "GPU": 0.25}
    max_faults = 10


class TakesNothing(ValidEnv):
    """Declares an amount that Ray cannot place."""

    ray_resources: ClassVar = {"CPU": 0}


class FaultsForEver(ValidEnv):
    """Declares a number of faults that is not finite."""

    max_faults = float("inf")


class IgnoresSeed(ValidEnv):
    def initial_number(self) -> float:
        return random.uniform(-1, 1)


class Leaks(ValidEnv):
    """Keeps what happened before."""

    total = 0.0

    def initial_number(self) -> float:
        self.total += 0.125
        return super().initial_number() + self.total


class AlwaysTheSame(ValidEnv):
    def initial_number(self) -> float:
        return 0.5


class ObservationOutOfBounds(ValidEnv):
    observation_space = spaces.Box(-1, 1, (1,))

    def current_observation(self) -> Any:
        return super().current_observation() + 3


class WrongShape(ValidEnv):
    def current_observation(self) -> Any:
        return np.zeros((2,), np.float32)


class WrongDtype(ValidEnv):
    """A picture that is none."""

    observation_space = spaces.Box(0, 255, (12, 16, 3), np.uint8)

    def current_observation(self) -> Any:
        return np.zeros((12, 16, 3), np.float32)


class IsNotFinite(ValidEnv):
    def current_observation(self) -> Any:
        return np.array([np.nan], np.float32)


class RewardIsNotFinite(ValidEnv):
    def step(self, action: Any) -> Any:
        return self.current_observation(), np.inf, False, False, {"success": False}


class Reports(ValidEnv):
    """Reports the values that it is made with."""

    def __init__(
        self,
        success: Any = False,
        reward: Any = 0.0,
        terminated: Any = False,
        truncated: Any = False,
    ) -> None:
        super().__init__()
        self.values = (reward, terminated, truncated, {"success": success})

    def step(self, action: Any) -> Any:
        return self.current_observation(), *self.values


class NoSuccessInfo(ValidEnv):
    """Of success."""

    def step(self, action: Any) -> Any:
        return self.current_observation(), 0.0, False, False, {"distance": 1.0}


class ConstructorRaises(ValidEnv):
    def __init__(self) -> None:
        raise OSError("the robot\nis not plugged in")


class HasText(ValidEnv):
    action_space = spaces.Text(5)


class RendersNone(ValidEnv):
    def __init__(self, render_mode: str | None = None) -> None:
        super().__init__()

    def render(self) -> Any:
        return None


class NoRenderMode(ValidEnv):
    def __init__(self) -> None:
        super().__init__()


class Hangs(ValidEnv):
    def reset(self, *, seed: int | None = None, options: Any = None) -> Any:
        time.sleep(1000)


class Crashes(ValidEnv):
    def reset(self, *, seed: int | None = None, options: Any = None) -> Any:
        os.kill(os.getpid(), signal.SIGSEGV)


class ExitsProcess(ValidEnv):
    def reset(self, *, seed: int | None = None, options: Any = None) -> Any:
        os.write(2, b"no licence found\n")
        os._exit(3)


class ExitsByPython(ValidEnv):
    """As engines do without a license."""

    def step(self, action: Any) -> Any:
        raise SystemExit("no licence found")


class ExitsWhenItDraws(ValidEnv):
    def render(self) -> Any:
        raise SystemExit("no display")


class CountsSteps(ValidEnv):
    """Knows how many steps an episode has had."""

    def reset(self, *, seed: int | None = None, options: Any = None) -> Any:
        self.steps = 0
        return super().reset(seed=seed, options=options)


class RaisesLater(CountsSteps):
    """Longer than a check looks."""

    def step(self, action: Any) -> Any:
        self.steps += 1
        if self.steps > 15:
            raise ValueError("the physics exploded")
        return super().step(action)


class TruncatesItself(CountsSteps):
    """Off, after five steps."""

    def step(self, action: Any) -> Any:
        self.steps += 1
        observation, _, _, _, info = super().step(action)
        return observation, 1.0, False, self.steps == 5, info


class HasAllSpaces(ValidEnv):
    """An action is echoed in the next observation."""

    action_space = ALL_SPACES
    observation_space = ALL_SPACES

    def reset(self, *, seed: int | None = None, options: Any = None) -> Any:
        gymnasium.Env.reset(self, seed=seed)
        self.observation_space.seed(seed)
        return self.observation_space.sample(), {}

    def step(self, action: Any) -> Any:
        assert action in self.action_space
        return action, 0.0, False, False, {"success": False}


def a_share(environment: Any, info: Any) -> Any:
    """A judge of success that gives no truth."""
    return 0.3 if "success" in info else environment


def number_is_large(environment: Any, info: Any) -> bool:
    """A judge of success."""
    return "success" in info and environment.unwrapped.number > 2
