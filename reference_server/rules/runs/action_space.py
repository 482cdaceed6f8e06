"""Checks of actions against a benchmark's action space.

Called by the guards in `lifecycle.py`. It knows a manifest and vectors, and neither
runs nor sessions. Pure. An error is a pair of a JSON pointer into the request and a
text for people.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from operator import le, ne
from typing import Any, TypeAlias

from reference_record.formats.json_pointer import pointer_step

Values: TypeAlias = Mapping[str, Sequence[float]]
SpaceErrors: TypeAlias = list[tuple[str, str]]


def action_errors(
    actions: Sequence[Values], manifest: Mapping[str, Any]
) -> SpaceErrors:
    """Every breach of the action space, in the order of the chunk; none if it fits.

    A chunk that is too long is not examined further (PRED-015).
    """
    if len(actions) > manifest["max_chunk"]:
        return [("/actions", f"a chunk holds at most {manifest['max_chunk']} actions")]
    space = manifest["action_space"]
    errors: SpaceErrors = []
    for i, values in enumerate(actions):
        if _fits(values, space):
            continue  # nothing is written down of what fits: it is nearly every action
        at = f"/actions/{i}/values"
        errors += [  # PRED-014
            (f"{at}/{pointer_step(name)}", "the action space has no such name")
            for name in values
            if name not in space
        ]
        for name, entry in space.items():
            if name in values:
                errors += _vector_errors(f"{at}/{name}", values[name], entry)
            else:
                errors.append((f"{at}/{name}", "is missing; every name is required"))
    return errors


def clip_actions(
    actions: Sequence[Values], manifest: Mapping[str, Any]
) -> Sequence[Values]:
    """PRED-018: values outside a range declared `clip` become the nearest inside.

    The actions themselves when all values are inside.
    """
    clip: dict[str, tuple[Sequence[float], Sequence[float]]] = {}
    are_inside = True
    for name, entry in manifest["action_space"].items():
        if entry["out_of_range"] == "clip":
            clip[name] = bounds = entry["minimum"], entry["maximum"]
            for values in actions:
                are_inside = are_inside and _is_inside(values[name], *bounds)
    if are_inside:
        return actions
    return [
        {name: _clip(vector, clip.get(name)) for name, vector in values.items()}
        for values in actions
    ]


def count_clipped(
    sent: Sequence[Values], clipped: Sequence[Values], executed: int
) -> int:
    """How many of the first `executed` actions `clip_actions` has changed (ATR-004)."""
    if clipped is sent:
        return 0
    return sum(map(ne, sent[:executed], clipped[:executed]))


def _fits(values: Values, space: Mapping[str, Mapping[str, Any]]) -> bool:
    """Whether an action has nothing to be written down, which is found faster."""
    if values.keys() != space.keys():
        return False
    for name, entry in space.items():
        vector, size = values[name], entry["size"]
        if len(vector) != size:
            return False
        if entry["out_of_range"] != "refuse":
            if not all(map(math.isfinite, vector)):
                return False
        elif size == 1:  # as most are that stand for one thing, such as a gripper
            if not entry["minimum"][0] <= vector[0] <= entry["maximum"][0]:
                return False
        elif not _is_inside(vector, entry["minimum"], entry["maximum"]):
            return False
    return True


def _is_inside(
    vector: Sequence[float], low: Sequence[float], high: Sequence[float]
) -> bool:
    """Bounds are finite, so what is not finite is outside."""
    return all(map(le, low, vector)) and all(map(le, vector, high))


def _vector_errors(
    at: str, vector: Sequence[float], entry: Mapping[str, Any]
) -> SpaceErrors:
    if len(vector) != entry["size"]:  # PRED-013
        return [(at, f"has {len(vector)} numbers, must have {entry['size']}")]
    if not all(map(math.isfinite, vector)):  # PRED-016
        return [(at, "contains a non-finite number")]
    if entry["out_of_range"] != "refuse":  # PRED-017
        return []
    low, high = entry["minimum"], entry["maximum"]
    return [
        (f"{at}/{k}", f"{value} is outside {low[k]} … {high[k]}")
        for k, value in enumerate(vector)
        if not low[k] <= value <= high[k]
    ]


def _clip(
    vector: Sequence[float], bounds: tuple[Sequence[float], Sequence[float]] | None
) -> Sequence[float]:
    if bounds is None or _is_inside(vector, *bounds):
        return vector
    return [
        min(max(v, low), high) for v, low, high in zip(vector, *bounds, strict=True)
    ]
