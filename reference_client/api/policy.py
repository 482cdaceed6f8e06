"""The interface of a policy, and the conversion of its actions to the wire format."""

from __future__ import annotations

import contextlib
import math
from collections.abc import Mapping, Sequence
from typing import Any, Protocol, TypeAlias

import numpy as np
import numpy.typing as npt

from reference_client.api.observation import Observation
from reference_client.errors import ProctorError

Vector: TypeAlias = Sequence[float] | npt.NDArray[Any]
Chunk: TypeAlias = Sequence[Mapping[str, Vector]]
WireAction: TypeAlias = dict[str, dict[str, list[float]]]


class Policy(Protocol):
    """Plays episodes one after another; every worker has its own instance."""

    def reset(self, instruction: str) -> None:
        """Called when an episode begins or restarts: discard all earlier state."""

    def act(self, observation: Observation) -> Chunk:
        """The next actions, to be executed in order: 1 to the benchmark's `max_chunk`.

        An action maps every name of the benchmark's action space to its vector of
        finite numbers. Actions after the end of the episode are not executed.
        """


def chunk_of(actions: Chunk) -> list[WireAction]:
    """The return value of `act` as a list of schema Action.

    Raises ProctorError `invalid_request`, with JSON pointers as the server's, for what
    JSON cannot represent. The server checks names, sizes and ranges.
    """
    if isinstance(actions, Mapping) or not isinstance(actions, Sequence):
        raise _invalid_action("/actions", f"is a {type(actions).__name__}, not a list")
    if not actions:
        raise _invalid_action("/actions", "is empty; a chunk holds at least one action")
    return [_action(f"/actions/{i}/values", values) for i, values in enumerate(actions)]


def _action(at: str, values: Mapping[str, Vector]) -> WireAction:
    if not isinstance(values, Mapping):
        raise _invalid_action(
            at, f"is a {type(values).__name__}, not a dict of vectors"
        )
    return {
        "values": {
            name: _numbers(f"{at}/{_escape(name)}", vector)
            for name, vector in values.items()
        }
    }


def _escape(name: str) -> str:
    """As in a JSON pointer, RFC 6901."""
    return name.replace("~", "~0").replace("/", "~1")


def _numbers(at: str, vector: Vector) -> list[float]:
    plain = vector.tolist() if isinstance(vector, np.ndarray) else vector
    if isinstance(plain, list | tuple):
        with contextlib.suppress(TypeError, OverflowError):
            if all(map(math.isfinite, plain)):
                return list(map(float, plain))
    return _inspect_vector(at, vector)


def _inspect_vector(at: str, vector: Vector) -> list[float]:
    """The numbers of any other array-like vector; raises what is wrong with it."""
    try:
        numbers = np.asarray(vector, dtype=np.float64)
    except (TypeError, ValueError) as error:
        raise _invalid_action(
            at, f"holds a value that is no number ({error})"
        ) from error
    if numbers.ndim != 1:
        raise _invalid_action(at, f"has {numbers.ndim} dimensions; a vector has one")
    if not np.isfinite(numbers).all():
        index = int(np.flatnonzero(~np.isfinite(numbers))[0])
        raise _invalid_action(
            f"{at}/{index}", f"is {numbers[index]}, which is not finite"
        )
    values: list[float] = numbers.tolist()
    return values


def _invalid_action(pointer: str, text: str) -> ProctorError:
    return ProctorError(
        "invalid_request",
        "The policy returned actions that cannot be sent. Correct what it returns.",
        errors=[(pointer, text)],
    )
