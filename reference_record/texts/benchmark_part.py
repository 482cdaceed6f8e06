"""The part of a benchmark that a run selects, as text."""

from __future__ import annotations

from collections.abc import Mapping

import msgspec

_LENGTH_MAX = 200


def part_text(select: object) -> str | None:
    """`tasks lift, push; splits test, and nothing else`; None for the whole.

    select: schema SelectionView as JSON; in a record it may be anything.
    """
    if not select:
        return None
    try:
        chosen = msgspec.convert(select, Mapping[str, list[str] | None])
    except msgspec.ValidationError:
        text = msgspec.json.encode(select).decode()
    else:
        named = {what: names for what, names in chosen.items() if names}
        if not named:
            return None
        text = "; ".join(f"{what} {', '.join(named[what])}" for what in named)
    if len(text) > _LENGTH_MAX:
        text = f"{text[:_LENGTH_MAX]}…"
    return f"{text}, and nothing else"
