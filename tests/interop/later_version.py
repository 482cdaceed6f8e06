"""Answers as a server of a later minor version could send them.

Every open list of the specification (`x-extensible-enum`) has one value more, every
message one member more. It must not know which of them a client looks at.
"""

from typing import Any

NEW = "of_a_later_version"
VALUES = {
    *("code", "codec", "dtype", "ended_by", "frame", "mode", "out_of_range"),
    *("protocol", "quantity", "relative_to", "rotation", "success_rule", "unit"),
}
LISTS = {"image_codecs", "profiles"}
MAPS = {"action_space", "by_split", "by_task", "generation"}
MAPS |= {"parts", "state", "tensors"}


def extended(value: Any, name: str = "") -> Any:
    """An answer with what today's clients cannot know."""
    if isinstance(value, list):
        added = [NEW] if name in LISTS else []
        return [extended(item) for item in value] + added
    if isinstance(value, dict):
        members = {key: extended(item, key) for key, item in value.items()}
        if _is_map(value, name):
            return members
        if "progress" in value:
            members["mode"] = NEW  # a run; the member may be absent
        return members | {NEW: {"any": [1, None]}}
    return NEW if name in VALUES and isinstance(value, str) else value


def _is_map(value: dict[str, Any], name: str) -> bool:
    """Whether the keys are names of things and not members: a choice has a codec."""
    return name in MAPS or (name == "images" and "codec" not in value)
