"""A policy that solves the mobile bimanual tasks, to prove that they can be solved.

The expert sees what any policy sees: the observation's state, as it comes over the
wire, with the poses of the things. For each task there is a script in scripts.py; the
instruction says which. Nothing is read from the simulator being played: the arms'
kinematics are a model apart.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from reference_sim.benchmarks.mobile_bimanual.plans import PLANS
from reference_sim.benchmarks.mobile_bimanual.skills import RobotController, Steps


class UnknownInstruction(ValueError):
    """No script is known for what was asked."""


class MobileBimanualExpert:
    """Plays the script that the instruction asks for until the episode ends."""

    def __init__(self, control: str = "joint_position") -> None:
        """control: a key of ACTION_CHANNELS."""
        self._control = control
        self._robot = RobotController(control)
        self._plan: Steps | None = None

    def reset(self, instruction: str) -> None:
        """Begins an episode. Raises UnknownInstruction."""
        if instruction not in PLANS:
            raise UnknownInstruction(instruction)
        self._robot.reset()
        self._plan = PLANS[instruction](self._robot)

    def act(
        self, observation_state: Mapping[str, Sequence[float]]
    ) -> dict[str, list[float]]:
        """The next action, with the names of the benchmark's action space."""
        if self._plan is None:
            raise RuntimeError("reset comes before act")
        self._robot.update(observation_state)
        next(self._plan)
        return self._robot.action()


def make_expert() -> MobileBimanualExpert:
    """For `mobile_bimanual_state`."""
    return MobileBimanualExpert()
