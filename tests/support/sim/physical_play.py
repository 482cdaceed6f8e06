"""Helpers for tests of all physical worlds: to play, and to compare bit for bit."""

import hashlib
from collections.abc import Callable

from reference_sim.interface import Action, Observation, Simulator, StepOutcome

Policy = Callable[[Observation], Action]


def play(sim: Simulator, policy: Policy, steps: int) -> list[StepOutcome]:
    """Plays on until the task ends or the steps are used up."""
    outcomes: list[StepOutcome] = []
    while len(outcomes) < steps and not (outcomes and outcomes[-1].terminated):
        outcomes.append(sim.step(policy(sim.observe())))
    return outcomes


def observation_digest(seen: Observation) -> str:
    digest = hashlib.sha256()
    for name, values in sorted(seen.state.items()):
        digest.update(name.encode() + values.tobytes())
    for name, image in sorted(seen.images.items()):
        digest.update(name.encode() + image.tobytes())
    return digest.hexdigest()
