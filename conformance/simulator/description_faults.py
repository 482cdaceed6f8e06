"""How a description lacks what a benchmark needs (SIM-008)."""

from collections.abc import Iterator, Mapping
from typing import Any

from conformance.oracle.vector_declarations import declaration_faults
from conformance.specification.document import load_spec, schema_faults

_NAMES = {"type": "array", "minItems": 1, "items": {"type": "string"}}
_FLAGS = ("graded", "deterministic", "digest", "shared_memory")
_SCHEMA: Mapping[str, Any] = {
    "type": "object",
    "required": [
        *("simulator", "tasks", "action_space", "observation_space", "max_steps")
    ],
    "properties": {
        "simulator": {
            "type": "object",
            "required": ["name", "version"],
            "properties": {"name": {"type": "string"}, "version": {"type": "string"}},
        },
        "tasks": {**_NAMES, "uniqueItems": True},
        "action_space": {"type": "object", "minProperties": 1},
        "observation_space": {"type": "object"},
        "max_steps": {"type": "integer", "minimum": 1},
        "benchmark_id": {"type": "string", "pattern": "^[a-z][a-z0-9_]{0,63}$"},
        **{name: {"type": "string"} for name in ("title", "description", "version")},
        "control_rate_hz": {"type": "number", "exclusiveMinimum": 0},
        "success_rule": {"enum": ["any_step", "last_step"]},
        **{name: {"type": "boolean"} for name in _FLAGS},
        "splits": {"type": "array", "items": {"type": "object", "required": ["name"]}},
        "image_sizes": {"type": "array"},
        "sources": {
            "type": "object",
            "additionalProperties": {"type": "string", "pattern": "^[0-9a-f]{64}$"},
        },
    },
}
# The members that a server knows; `image_codecs` is one of its own files.
MEMBERS = {**_SCHEMA["properties"], "physical": {}, "image_codecs": {}}
OBSERVED = {"state": "VectorSpace", "images": "ImageSpace", "tensors": "TensorSpace"}


def description_faults(benchmark: Any) -> list[str]:
    """List the faults; empty if there is none."""
    faults = schema_faults(_SCHEMA, benchmark)
    return faults or list(_space_faults(benchmark))


def _space_faults(benchmark: Mapping[str, Any]) -> Iterator[str]:
    yield from _faults_of("action_space", "VectorSpace", benchmark["action_space"])
    for group, schema in OBSERVED.items():
        spaces = benchmark["observation_space"].get(group, {})
        yield from _faults_of(f"observation_space.{group}", schema, spaces)
    sizes = benchmark.get("image_sizes", [])
    yield from _faults_of("image_sizes", "ImageSize", dict(enumerate(sizes)))
    if benchmark["observation_space"].get("images") and not sizes:
        yield "images, and no image_sizes"


def _faults_of(where: str, name: str, spaces: Any) -> Iterator[str]:
    if not isinstance(spaces, dict):
        yield f"{where} is not a map"
        return
    schema = load_spec().schema(name)
    for key, space in spaces.items():
        faults = schema_faults(schema, space)
        size = space.get("size") if isinstance(space, dict) else None
        for bound in ("minimum", "maximum"):
            if not faults and len(space.get(bound, [0] * (size or 0))) != (size or 0):
                faults.append(f"{bound} has another size than {size}")
        if name == "VectorSpace" and not faults:
            faults += [f"{rule}: {text}" for rule, text in declaration_faults(space)]
        yield from (f"{where}.{key}: {fault}" for fault in faults)
