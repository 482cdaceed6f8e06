"""Policies for the benchmark `calibration` that detect faults of a client."""

import threading

from reference_client import Observation
from tests.support.servers import TIMEOUT_S
from tests.support.sim.calibration_action import calibration_action

Actions = list[dict[str, list[float]]]


class GradedPolicy:
    """Ends every episode after two turns with a score that depends on the episode."""

    def __init__(self) -> None:
        self.resets = 0

    def reset(self, instruction: str) -> None:
        self.resets += 1

    def act(self, observation: Observation) -> Actions:
        score = episode_score(observation.episode_id)
        end = float(observation.step > 0)
        return [calibration_action(score=score, success=1.0, end=end)]


def episode_score(episode_id: str) -> float:
    return int(episode_id[1:]) % 5 / 4


class ExactlyOncePolicy:
    """Expects after each turn that what it has sent was executed exactly once."""

    def reset(self, instruction: str) -> None:
        self.sent = 0

    def act(self, observation: Observation) -> Actions:
        assert observation.state["count"][0] == self.sent
        assert observation.step == self.sent
        self.sent += 2
        return [calibration_action(), calibration_action(success=1.0)]


class BlockingPolicy:
    """Waits in `act` until it is let go; says that it is there."""

    def __init__(self) -> None:
        self.is_acting = threading.Event()
        self.may_continue = threading.Event()
        self.first: Observation | None = None
        self.instructions: list[str] = []

    def reset(self, instruction: str) -> None:
        self.instructions.append(instruction)

    def act(self, observation: Observation) -> Actions:
        self.first = self.first or observation
        self.is_acting.set()
        assert self.may_continue.wait(TIMEOUT_S)
        return [calibration_action(success=1.0, end=1.0)]
