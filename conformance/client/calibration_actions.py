"""Actions of the benchmark `calibration`, in the form of schema Action."""

from typing import Any

# Name → size, from calibration.md.
ACTION_SIZES = {
    "score": 1,
    "success": 1,
    "end": 1,
    "delay_s": 1,
    "fault": 1,
    "vector": 8,
    "clipped": 2,
}


def action(**values: Any) -> dict[str, Any]:
    """Give an action; omitted names are zero, numbers become vectors."""
    vectors: dict[str, Any] = {n: [0.0] * size for n, size in ACTION_SIZES.items()}
    for name, value in values.items():
        vectors[name] = value if isinstance(value, list) else [value]
    return {"values": vectors}
