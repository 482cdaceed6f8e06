"""Finds the rows of numbers in the answer of a policy."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from reference_client.api.foreign_arrays import (
    UnreadableNumbers,
    as_numpy,
    kind_of_answer,
)
from reference_client.policies.mapping.members import Array, shown
from reference_record.texts.counted_text import counted


class InvalidPolicyAnswer(ValueError):
    """The policy's answer does not fit the mapping."""


class NoNumbers(InvalidPolicyAnswer):
    """The answer has none where the mapping expects them."""


def rows_of(answer: Any, source: str | None, leading: int, name: str) -> Array:
    """The rows (actions, numbers) that the answer has at `source`.

    leading: how many dimensions of size 1 in front are dropped. name: of the mapping,
    for messages. Raises InvalidPolicyAnswer.
    """
    values, is_list = answer, False
    if source is not None:
        # Some policies return a list of actions instead of an action of lists.
        values, is_list = _at(answer, source, source, name)
    place = _place(source)
    try:
        rows = as_numpy(values)
    except UnreadableNumbers as error:
        raise NoNumbers(
            f"The policy answered {kind_of_answer(values)} in {place}, where "
            f"{name} expects numbers"
        ) from error
    if rows.size == 0:
        raise InvalidPolicyAnswer(f"The policy answered no action: {place} is empty")
    if is_list and rows.ndim == 1:
        rows = rows[:, np.newaxis]  # one number for each action
    in_front = rows.shape[:leading] if rows.ndim > leading else ()
    is_batch_of_one = set(in_front) <= {1}
    if is_batch_of_one:
        rows = rows.reshape(rows.shape[len(in_front) :])
    if rows.ndim < 2:
        rows = np.atleast_2d(rows)
    elif rows.ndim > 2 or not is_batch_of_one:
        raise InvalidPolicyAnswer(
            f"The policy answered the shape {np.shape(values)} in {place}; "
            f"{name} expects a chunk (actions, numbers){_cure(np.shape(values))}"
        )
    return rows


def _place(source: str | None) -> str:
    return f"`{source}`" if source else "its answer"


def _cure(shape: tuple[int, ...]) -> str:
    """Names `leading`, where it makes the shape a chunk."""
    extra = len(shape) - 2
    if extra < 1 or set(shape[:extra]) != {1}:
        return "; `leading` in [action] drops dimensions of size 1 alone"
    which = "the first" if extra == 1 else f"the first {extra}"
    return f"; `leading = {extra}` in [action] drops {which}, of size 1"


def common_length(rows_by_place: Mapping[str | None, Array], name: str) -> int:
    """How many actions the answer has; 1 without any place.

    Raises InvalidPolicyAnswer where the places have different numbers of rows: cut to
    the shortest, a chunk would be another one than the policy's.
    """
    lengths = {source: len(rows) for source, rows in rows_by_place.items()}
    if len(set(lengths.values())) > 1:
        listed = ", ".join(
            f"{counted(length, 'row')} in {_place(source)}"
            for source, length in lengths.items()
        )
        raise InvalidPolicyAnswer(
            f"The policy answered {listed}, where {name} expects a row of each for "
            "every action"
        )
    return next(iter(lengths.values()), 1)


def _at(answer: Any, path: str, source: str, mapping: str) -> tuple[Any, bool]:
    """The part of the answer at a dotted path, and whether it is a list of actions.

    A number in the path is an index; any other name is looked up in each item of a
    list. Names may contain dots: the longest that the answer has is taken.
    """
    if not path:
        return answer, False
    parts = path.split(".")
    if isinstance(answer, Mapping):
        for count in range(len(parts), 0, -1):
            name, rest = ".".join(parts[:count]), ".".join(parts[count:])
            for key in (name, name.encode()):
                if key in answer:
                    return _at(answer[key], rest, source, mapping)
    elif parts[0].isdigit() and isinstance(answer, list | tuple | np.ndarray):
        if int(parts[0]) < len(answer):
            return _at(answer[int(parts[0])], ".".join(parts[1:]), source, mapping)
    elif isinstance(answer, list):
        return [_at(item, path, source, mapping)[0] for item in answer], True
    where = source.removesuffix(path).rstrip(".")
    inside = f" in {where}" if where else ""
    if isinstance(answer, Mapping):
        raise NoNumbers(
            f"{mapping}: the policy's answer has no {path}{inside}, but "
            f"{_listed(answer)}"
        )
    raise NoNumbers(
        f"The policy answered {kind_of_answer(answer)}{inside}, where {mapping} "
        f"expects an object with `{path}`"
    )


def _listed(answer: Mapping[Any, Any]) -> str:
    """The names in it, with the values that are a text, a number or null."""
    if not answer:
        return "is an empty object"
    return ", ".join(
        f"{name} = {shown(value)}"
        if value is None or isinstance(value, str | int | float)
        else f"{name}"
        for name, value in sorted(answer.items(), key=lambda item: str(item[0]))
    )
