"""A policy that solves the mobile bimanual tasks, which proves that they are solvable.

It receives what any policy receives: the observation's state as sent over the wire,
with the poses of the objects. plans.py has a plan for each task, selected by the
instruction. Nothing is read from the simulator being played: the arms' kinematics are a
separate model.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy.typing as npt

from reference_sim.benchmarks.mobile_bimanual.plans import PLANS
from reference_sim.benchmarks.mobile_bimanual.skills import RobotController, Steps


class UnknownInstruction(ValueError):
    """There is no plan for the instruction."""


class MobileBimanualExpert:
    """Executes the plan selected by the instruction until the episode ends."""

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
        self, observation_state: Mapping[str, npt.ArrayLike]
    ) -> dict[str, list[float]]:
        """The next action, with the names of the benchmark's action space."""
        if self._plan is None:
            raise RuntimeError("reset comes before act")
        self._robot.update(observation_state)
        next(self._plan)
        return self._robot.action()


def make_expert() -> MobileBimanualExpert:
    """Make the expert of `mobile_bimanual_state`."""
    return MobileBimanualExpert()
