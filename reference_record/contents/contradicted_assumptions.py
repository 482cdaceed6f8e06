"""Compares the assumptions of a policy with a benchmark: schema Assumptions, Benchmark.

A server refuses by it, and a client looks first, so that a policy that is wrong in one
part leaves no run behind. Pure. A contradiction is a pair of a JSON pointer into the
request and a text for people.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from typing import Any, TypeAlias

from reference_record.contents.declared_parts import DeclaredPart, declared_parts
from reference_record.formats.json_pointer import pointer_step

Contradiction: TypeAlias = tuple[str, str]


def contradictions(
    assumes: Mapping[str, Any], benchmark: Mapping[str, Any]
) -> Iterator[Contradiction]:
    """Assumptions that the benchmark contradicts (ATT-010); none confirms (ATT-011)."""
    rate = assumes.get("control_rate_hz")
    if rate not in (None, benchmark["control_rate_hz"]):
        yield "/assumes/control_rate_hz", _both(rate, benchmark["control_rate_hz"])
    spaces = {
        "action": benchmark["action_space"],
        "state": benchmark["observation_space"]["state"],
    }
    for group, space in spaces.items():
        for name, assumed in (assumes.get(group) or {}).items():
            at = f"/assumes/{group}/{pointer_step(name)}"
            if name in space:
                yield from _of_vector(at, assumed, space[name])
            else:
                yield at, f"the benchmark has no such vector, but {', '.join(space)}"


def _of_vector(
    at: str, assumed: Mapping[str, Any], vector: Mapping[str, Any]
) -> Iterator[Contradiction]:
    """CONV-004, CONV-005: the contradictions in the assumption of one vector."""
    declared = declared_parts(vector)
    for member, value in assumed.items():
        if member == "size" and value != vector["size"]:
            yield f"{at}/size", _both(value, vector["size"])
        elif member not in ("size", "parts"):
            for name, part in declared.items():
                if value != _declared(part, member):
                    text = _both(value, _declared(part, member))
                    yield f"{at}/{member}", f"{text} in the part {name}"
                    break
    for name, members in (assumed.get("parts") or {}).items():
        part_at = f"{at}/parts/{pointer_step(name)}"
        if name not in declared:
            yield part_at, f"the vector has no such part, but {', '.join(declared)}"
            continue
        for member, value in members.items():
            if value != (due := _declared(declared[name], member)):
                text = f"{_both(value, due)} in the part {name}"
                yield f"{part_at}/{member}", text


def _declared(part: DeclaredPart, member: str) -> Any:
    return getattr(part, member, None)


def _both(assumed: Any, declared: Any) -> str:
    """CONV-006: both values, as JSON."""
    values = json.dumps(assumed, ensure_ascii=False), json.dumps(declared)
    return "assumed {}, declared {}".format(*values)
