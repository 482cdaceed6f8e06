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


def successes_in_order(manifest: Sequence[str], entry: Mapping[str, Any]) -> str | None:
    """`1` or `0` for each episode of the manifest; None where others were played."""
    ids = entry.get("episode_ids", manifest)
    known = dict(zip(ids, entry["successes"], strict=True))
    if set(known) != set(manifest):
        return None
    return "".join(known[name] for name in manifest)
