"""The rules of conventions.md that a declaration of a vector breaks."""

from collections.abc import Iterator, Mapping
from typing import Any

from conformance.specification.document import load_registry


def declaration_faults(space: Mapping[str, Any]) -> Iterator[tuple[str, str]]:
    """Give each rule that a VectorSpace breaks, and how."""
    parts: Mapping[str, Any] = space.get("parts") or {}
    if fault := _gap_or_overlap(parts, space["size"]):
        yield "CONV-001", fault
    sizes = {entry["name"]: entry.get("size") for entry in load_registry("rotations")}
    for name, part in parts.items():
        numbers = sizes.get(part["rotation"])
        if numbers not in (None, part["size"]):
            text = f"{part['rotation']} has {numbers} numbers, not {part['size']}"
            yield "CONV-002", f"part {name}: {text}"
        ends = part.get("gripper_open"), part.get("gripper_closed")
        if part["quantity"] == "gripper" and (None in ends or ends[0] == ends[1]):
            text = f"gripper_open is {ends[0]}, gripper_closed is {ends[1]}"
            yield "CONV-003", f"part {name}: {text}"


def _gap_or_overlap(parts: Mapping[str, Any], size: int) -> str | None:
    """Say where the parts leave a number out or hold one twice; None if they do not."""
    reached = 0
    for name, part in sorted(parts.items(), key=lambda item: item[1]["start"]):
        if part["start"] != reached:
            return f"part {name} starts at {part['start']}, not at {reached}"
        reached += part["size"]
    return None if reached == size else f"the parts have {reached} numbers, not {size}"
