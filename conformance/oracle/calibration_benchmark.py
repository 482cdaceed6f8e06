"""The benchmark `calibration`, as calibration.md describes it: shape and spaces."""

from typing import Any, NamedTuple

from conformance.specification.tensor_formats import TENSOR_FORMATS

TASKS = ("score", "count", "echo", "delay", "fault")
SHAPE: dict[str, Any] = {
    "version": "1",
    "control_rate_hz": 10,
    "max_steps": 10,
    "max_attempts": 3,
    "max_faults": 3,
    "success_rule": "any_step",
    "episodes_total": 1,
    "splits": ["even", "odd"],
    "simulator": {"name": "calibration", "version": "1"},
}


class Vector(NamedTuple):
    """A vector of numbers; `minimum` and `maximum` are those of each of them."""

    size: int
    minimum: float | None = None
    maximum: float | None = None
    out_of_range: str = "unbounded"


ACTIONS = {
    "score": Vector(1, 0, 1, "refuse"),
    "success": Vector(1, 0, 1, "refuse"),
    "end": Vector(1, 0, 1, "refuse"),
    "delay_s": Vector(1, 0, 5, "refuse"),
    "fault": Vector(1, 0, 2, "refuse"),
    "vector": Vector(8),
    "clipped": Vector(2, -1, 1, "clip"),
}
STATES = {"count": Vector(1), "vector": Vector(8), "clipped": Vector(2)}
# Only the task `echo` has these.
IMAGES = {"pattern": {"channels": 3}}
TENSORS: dict[str, dict[str, Any]] = {
    **{dtype: {"dtype": dtype, "shape": [2, 3]} for dtype in TENSOR_FORMATS},
    "empty": {"dtype": "float64", "shape": [0, 3]},
}


def spaces_of(vectors: dict[str, Vector]) -> dict[str, Any]:
    """Give the schema VectorSpace of each vector, by its name."""
    spaces: dict[str, Any] = {}
    for name, vector in vectors.items():
        quantity, unit = ("time", "s") if name == "delay_s" else ("number", "1")
        part: dict[str, Any] = {"start": 0, "size": vector.size}
        part |= {"quantity": quantity, "unit": unit}
        part |= dict.fromkeys(("frame", "rotation", "relative_to"), "none")
        space = {"size": vector.size, "parts": {"all": part}}
        spaces[name] = space | {"out_of_range": vector.out_of_range}
        if vector.minimum is not None:
            spaces[name]["minimum"] = [vector.minimum] * vector.size
            spaces[name]["maximum"] = [vector.maximum] * vector.size
    return spaces


def action(**values: Any) -> dict[str, Any]:
    """Give an action; omitted names are zero, numbers become vectors."""
    vectors: dict[str, Any] = {n: [0.0] * v.size for n, v in ACTIONS.items()}
    for name, value in values.items():
        vectors[name] = value if isinstance(value, list) else [value]
    return {"values": vectors}
