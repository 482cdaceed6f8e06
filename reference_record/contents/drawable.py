"""Which episodes there is a picture of, for who would draw them again."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Final

# A benchmark without cameras → the one that has them and is the same otherwise: in it
# the same actions lead to equal states.
DRAWN_AS: Final[Mapping[str, str]] = {
    "tabletop_state": "tabletop",
    "mobile_bimanual_state": "mobile_bimanual",
}


def has_camera(benchmark_id: str, described: Mapping[str, Any] | None) -> bool:
    """Whether episodes of a benchmark can be drawn.

    described: the schema Benchmark as JSON; of one that is not known it may be so.
    """
    space = (described or {}).get("observation_space")
    return benchmark_id in DRAWN_AS or space is None or bool(space.get("images"))
