"""The interface of a simulator.

A simulator plays one episode at a time. It knows tasks, seeds, actions and
observations; it does not know runs, sessions, attempts, step limits or encodings
(`episode.py` counts and truncates, `process/simulator_main.py` communicates).

The shape follows Gymnasium's `reset(seed)` / `step(action)` with two differences that
the protocol needs: observing is apart from stepping, so that a chunk of actions
renders its last frame only; and the goal condition is reported as such, never hidden
in a reward.
"""

from __future__ import annotations

import math
import reprlib
from collections.abc import Iterable, Mapping, Sequence
from numbers import Real
from typing import Any, Protocol

import msgspec
import numpy as np
from numpy.typing import NDArray

Action = Mapping[str, Sequence[float]]


class Observation(msgspec.Struct, frozen=True):
    """The observation that a policy receives after a step.

    state: name → float64 array of shape (n,), units as the benchmark's spaces declare.
    images: name → uint8 array of shape (height, width, channels), RGB, row 0 on top.
    tensors: name → C-contiguous little-endian array of any shape.
    """

    state: Mapping[str, NDArray[np.float64]]
    images: Mapping[str, NDArray[np.uint8]] = msgspec.field(default_factory=dict)
    tensors: Mapping[str, NDArray[np.generic]] = msgspec.field(default_factory=dict)


class StepOutcome(msgspec.Struct, frozen=True):
    """The outcome of one executed action.

    success: the goal condition holds now.
    score: progress so far in [0, 1]; 1 exactly when the task is fully done.
    terminated: the task ends here by itself (step limits are not the simulator's).
    reward: for the record only; no score is computed from it.
    stopped: why a robot was stopped before or while it executed the action, which then
        does not count as executed; empty if it was not.
    """

    success: bool
    score: float
    terminated: bool
    reward: float = 0.0
    stopped: str = ""


def truth_of(value: Any, name: str) -> bool:
    """The truth that a simulator reports as `name`; its libraries decide alike.

    True and False, the numbers 0 and 1, and scalars and arrays without an axis of NumPy
    and others that are one of these. Raises WrongReport for everything else: the truth
    of any other object, such as a text, would decide a score by chance.
    """
    if isinstance(value, bool):  # most are
        return value
    plain = _without_axes(value)
    if isinstance(plain, Real) and plain in (0, 1):
        return bool(plain)
    raise WrongReport(f"{_shown(value, name)} true or false, or 0 or 1")


def number_of(value: Any, name: str) -> float:
    """The finite number that a simulator reports as `name`, in the forms of truth_of.

    Raises WrongReport for everything else.
    """
    if type(value) is float and math.isfinite(value):  # most are
        return value
    plain = _without_axes(value)
    if isinstance(plain, Real) and math.isfinite(plain):
        return float(plain)
    raise WrongReport(f"{_shown(value, name)} a finite number")


def _without_axes(value: Any) -> Any:
    has_none = getattr(value, "shape", None) == () and hasattr(value, "item")
    return value.item() if has_none else value


def _shown(value: Any, name: str) -> str:
    text = " ".join(reprlib.repr(value).split())
    return f"{name} is {text} ({type(value).__name__}), and must be"


class WrongReport(ValueError):
    """The simulator reports what no episode may have; the text says what."""


class ProgramFault(Exception):
    """A program had a fault, broke its protocol or ended; the text says what."""


class TaskUnplayable(Exception):
    """The task can never be played: a broken asset, for example (FAULT-005)."""


class ChangedSource(Exception):
    """The files differ from those of the manifest; the text has the cure."""

    @classmethod
    def of(cls, names: Iterable[str]) -> ChangedSource:
        """The exception of files that are not those of the manifest."""
        return cls(
            f"{', '.join(names)} has changed since the server started, and this run "
            "needs it as it was: undo the change, or restart the server to offer the "
            "changed benchmark to new runs"
        )


class SimulatorAway(Exception):
    """The simulator is a program that does not listen, or was not started by this
    machine; the text says why. No simulator is the cause."""


class Simulator(Protocol):
    """Used by one process, playing episodes one after another."""

    def reset(self, task: str, seed: int, split: str = "") -> str:
        """Begin an episode; the same arguments give the same state, bit for bit.

        split: one of the manifest's; a simulator without variations ignores it.
        Returns the instruction in natural language.
        """

    def step(self, action: Action) -> StepOutcome:
        """Execute one action. Values are finite, complete and of declared length."""

    def observe(self) -> Observation:
        """The observation of the current state; may be called repeatedly."""

    def state_bytes(self) -> bytes:
        """The state that decides the rest of the episode; equal bytes are equal states.

        A simulator that cannot read its state returns the observed part of it.
        """

    def close(self) -> None:
        """Free what the end of the process does not free."""


def stages_of(simulator: Simulator) -> Sequence[str]:
    """The stages that the score of the episode counts, in order; most have none.

    A simulator that has an attribute `stages` promises after its `reset`: the score is
    k / (n + 1) once the first k of the n stages were reached, and 1 at the goal, which
    is not one of them. Raises WrongReport for names that cannot be so (SIM-004).
    """
    stages = tuple(getattr(simulator, "stages", ()))
    if len({"", "goal", *stages}) < len(stages) + 2:
        raise WrongReport(
            f"the stages {list(stages)} must have different names, none of them empty "
            "or `goal`: the goal comes last by itself"
        )
    return stages
