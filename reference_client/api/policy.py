"""The interface of a policy, and the conversion of its actions to the wire format."""

from __future__ import annotations

import inspect
import math
from collections.abc import Mapping, Sequence
from typing import Any, Protocol, SupportsFloat, TypeAlias

import numpy as np
import numpy.typing as npt

from reference_client.api.action_layout import ActionLayout
from reference_client.api.foreign_arrays import (
    UnreadableNumbers,
    as_numpy,
    kind_of_answer,
)
from reference_client.api.observation import Observation
from reference_client.errors import ProctorError
from reference_record.command_line.spelling import did_you_mean
from reference_record.formats.json_pointer import pointer_step
from reference_record.generated import answers


class Array(Protocol):
    """An array of numpy, torch, jax or another library."""

    def __array__(self) -> npt.NDArray[Any]: ...


Vector: TypeAlias = Sequence[SupportsFloat] | Array
Action: TypeAlias = Mapping[str, Vector] | Vector
Chunk: TypeAlias = Sequence[Mapping[str, Sequence[float] | npt.NDArray[Any]]]
Actions: TypeAlias = Action | Sequence[Action]
WireAction: TypeAlias = answers.Action

_NOT_NUMBERS = (str, bytes, Mapping, list, tuple)


class Policy(Protocol):
    """Plays episodes one after another; every worker has its own instance."""

    def reset(self, instruction: str, /) -> None:
        """Called when an episode begins or restarts: discard all earlier state."""

    def act(self, observation: Observation, /) -> Actions:
        """The next actions, to be executed in order: 1 to the benchmark's `max_chunk`.

        An action maps every name of the benchmark's action space to its vector of
        finite numbers, or is an array of all numbers (n,) in the order of the action
        space. Several are a list of actions or an array (actions, n). Actions after
        the end of the episode are not executed.
        """


def chunk_of(actions: Actions, layout: ActionLayout | None = None) -> list[WireAction]:
    """The return value of `act` as a list of schema Action.

    One action is a dict of vectors or a row of all numbers, a chunk is a list of such
    or an array (actions, numbers). layout: the action space, needed for rows and to
    check names and sizes. Raises ProctorError `invalid_request`, with JSON pointers as
    the server's. The server checks ranges.
    """
    given = _plain(actions, layout)
    if isinstance(given, Mapping) or (layout is not None and _is_row(given)):
        given = [given]
    if inspect.iscoroutine(given):
        given.close()  # Python would warn that it was not awaited
        what = "is a coroutine, which nothing awaits: act must not be async"
        raise _invalid_action("/actions", what, layout)
    if not isinstance(given, Sequence) or isinstance(given, str | bytes):
        what = f"is a {type(given).__name__}, not an action or a list of actions"
        raise _invalid_action("/actions", what, layout)
    if not given:
        what = "is empty; a chunk holds at least one action"
        raise _invalid_action("/actions", what, layout)
    return [
        _action(f"/actions/{i}/values", action, layout)
        for i, action in enumerate(given)
    ]


def check_length(
    chunk: Sequence[WireAction], max_chunk: int, layout: ActionLayout | None = None
) -> None:
    """Raises ProctorError `invalid_request` for more than `max_chunk` actions."""
    if len(chunk) > max_chunk:
        what = f"has {len(chunk)} actions; a chunk holds at most {max_chunk}"
        raise _invalid_action("/actions", what, layout)


def _plain(given: Any, layout: ActionLayout | None, at: str = "/actions") -> Any:
    """Arrays of any library as lists; other values unchanged.

    A batch of one chunk, (1, actions, numbers), is the chunk.
    """
    if isinstance(given, str | bytes | Mapping | list | tuple):
        return given
    if not hasattr(given, "__array__"):
        return given
    try:
        array = np.atleast_1d(as_numpy(given))
    except UnreadableNumbers as error:
        raise _invalid_action(at, str(error), layout) from error
    while array.ndim > 2 and len(array) == 1:
        array = array[0]
    return array.tolist()


def _is_row(given: Any) -> bool:
    """Whether it is one action as numbers, not a list of actions."""
    return (
        isinstance(given, list | tuple)
        and len(given) > 0
        and not any(isinstance(number, _NOT_NUMBERS) for number in given)
        and all(np.ndim(number) == 0 for number in given)
    )


def _action(at: str, given: Any, layout: ActionLayout | None) -> WireAction:
    if not isinstance(given, Mapping):
        given = _row(at, _plain(given, layout, at), layout)
    values = {
        name: _plain_numbers(vector)
        or _inspect_vector(f"{at}/{pointer_step(str(name))}", vector, layout)
        for name, vector in given.items()
    }
    if layout is not None and set(given) != layout.names:
        raise _invalid_action(at, _name_difference(given, layout), layout)
    for vector in () if layout is None else layout.vectors:
        size = len(values[vector.name])
        if size != vector.size:
            where = f"{at}/{pointer_step(vector.name)}"
            what = f"has {size} numbers; {vector.name} has {vector.size}"
            raise _invalid_action(where, what, layout)
    return {"values": values}


def _row(at: str, given: Any, layout: ActionLayout | None) -> dict[str, list[float]]:
    """The named vectors of a row of numbers."""
    if isinstance(given, str | bytes):
        what = f"holds {kind_of_answer(given)}; numbers are expected"
        raise _invalid_action(at, what, layout)
    if layout is None or not isinstance(given, Sequence):
        what = f"is a {type(given).__name__}, not a dict of vectors"
        raise _invalid_action(at, what, layout)
    row = _plain_numbers(given) or _inspect_vector(at, given, layout)
    if len(row) != layout.size:
        raise _invalid_action(at, f"is an array of {len(row)}", layout)
    return layout.split(row)


def _name_difference(given: Mapping[Any, Any], layout: ActionLayout) -> str:
    parts = []
    if missing := sorted(layout.names - set(given)):
        parts.append(f"lacks {', '.join(missing)}")
    parts += [
        f"has {name}, which is no name{did_you_mean(name, layout.names)}"
        for name in sorted(set(map(str, given)) - layout.names)
    ]
    return "; ".join(parts)


def _plain_numbers(vector: Vector) -> list[float] | None:
    """The numbers of a list, tuple or array of finite ones; else None."""
    plain = vector.tolist() if isinstance(vector, np.ndarray) else vector
    if not isinstance(plain, list | tuple):
        return None
    try:
        return list(map(float, plain)) if all(map(math.isfinite, plain)) else None
    except (TypeError, OverflowError):
        return None


def _inspect_vector(
    at: str, vector: Vector, layout: ActionLayout | None
) -> list[float]:
    """The numbers of any other array-like vector; raises an error for a bad one."""
    try:
        numbers = as_numpy(vector)
    except UnreadableNumbers as error:
        raise _invalid_action(at, str(error), layout) from error
    if numbers.shape[:-1] != (1,) * (numbers.ndim - 1):
        what = (
            f"has shape {numbers.shape}; a vector has one dimension, and a chunk is a "
            "list of actions"
        )
        raise _invalid_action(at, what, layout)
    numbers = numbers.reshape(-1)  # without a batch of one; a single number is a vector
    if not np.isfinite(numbers).all():
        index = int(np.flatnonzero(~np.isfinite(numbers))[0])
        what = f"is {numbers[index]}, which is not finite"
        raise _invalid_action(f"{at}/{index}", what, layout)
    values: list[float] = numbers.tolist()
    return values


def _invalid_action(
    pointer: str, text: str, layout: ActionLayout | None
) -> ProctorError:
    shape = "" if layout is None else f" {expected_action(layout)}"
    return ProctorError(
        "invalid_request",
        "The policy returned actions that cannot be sent. Correct what it returns."
        + shape,
        errors=[(pointer, text)],
    )


def expected_action(layout: ActionLayout) -> str:
    """The shape of an action by name, for every refusal of one."""
    return f"An action of {layout.benchmark_id} is: {layout.describe()}."
