"""Compares the assumptions of a policy with a benchmark, as a server does it.

So a policy that is wrong in one part leaves no run behind. The rules are CONV-004 to
CONV-006 of spec/conventions.md. It sends nothing.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from typing import Any

from reference_client.api.policy import pointer_step
from reference_client.errors import ProctorError
from reference_record.contents.declared_parts import DeclaredPart, declared_parts

Contradiction = tuple[str, str]


def check_assumptions(
    assumes: Mapping[str, Any] | None, benchmark: Mapping[str, Any]
) -> None:
    """assumes: schema Assumptions. benchmark: schema Benchmark.

    Raises ProctorError, with a pointer at each contradiction, if there is any.
    """
    errors = list(contradictions(assumes or {}, benchmark))
    if errors:
        raise ProctorError(
            "convention_mismatch",
            f"The policy assumes other conventions than {benchmark['benchmark_id']} "
            "declares; no run was submitted. Convert as the errors say, or correct "
            "what the policy assumes.",
            errors=errors,
        )


def contradictions(
    assumes: Mapping[str, Any], benchmark: Mapping[str, Any]
) -> Iterator[Contradiction]:
    """Each member, or name of a vector or part, that the benchmark contradicts."""
    rate = assumes.get("control_rate_hz")
    if rate not in (None, benchmark["control_rate_hz"]):
        yield (
            "/assumes/control_rate_hz",
            _both(rate, benchmark["control_rate_hz"]),
        )
    spaces = {
        "action": benchmark["action_space"],
        "state": benchmark["observation_space"]["state"],
    }
    for group, space in spaces.items():
        for name, assumed in assumes.get(group, {}).items():
            at = f"/assumes/{group}/{pointer_step(name)}"
            if name in space:
                yield from _of_vector(at, assumed, space[name])
            else:
                yield at, f"there is no such vector, but {', '.join(space)}"


def _of_vector(
    at: str, assumed: Mapping[str, Any], space: Mapping[str, Any]
) -> Iterator[Contradiction]:
    of_all = dict(assumed)
    named = of_all.pop("parts", {})
    size = of_all.pop("size", space["size"])
    if size != space["size"]:
        yield f"{at}/size", _both(size, space["size"])
    declared = declared_parts(space)
    for member, value in of_all.items():
        for name, part in declared.items():
            if value != _declared(part, member):
                text = _both(value, _declared(part, member))
                yield f"{at}/{member}", f"{text} in the part {name}"
                break
    for name, members in named.items():
        part_at = f"{at}/parts/{pointer_step(name)}"
        if name not in declared:
            yield part_at, f"there is no such part, but {', '.join(declared)}"
            continue
        for member, value in members.items():
            if value != (due := _declared(declared[name], member)):
                text = f"{_both(value, due)} in the part {name}"
                yield f"{part_at}/{member}", text


def _declared(part: DeclaredPart, member: str) -> Any:
    return getattr(part, member, None)


def _both(assumed: Any, declared: Any) -> str:
    return f"assumed {json.dumps(assumed)}, declared {json.dumps(declared)}"
