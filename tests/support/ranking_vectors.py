"""The cases of spec/vectors/ranking: entries with their episodes, and their ranking."""

import json
from collections.abc import Mapping, Sequence
from typing import Any

from tests.support.paths import SPEC

CASES: list[dict[str, Any]] = [
    case
    for path in sorted((SPEC / "vectors" / "ranking").iterdir())
    for case in json.loads(path.read_text())["cases"]
]


def successes_by_id(
    manifest: Sequence[str], entry: Mapping[str, Any]
) -> dict[str, bool]:
    """Whether each episode of an entry was a success."""
    ids = entry.get("episode_ids", manifest)
    return {name: one == "1" for name, one in zip(ids, entry["successes"], strict=True)}


def successes_in_order(manifest: Sequence[str], entry: Mapping[str, Any]) -> str | None:
    """`1` or `0` for each episode of the manifest; None where others were played."""
    known = successes_by_id(manifest, entry)
    if set(known) != set(manifest):
        return None
    return "".join(str(int(known[name])) for name in manifest)
