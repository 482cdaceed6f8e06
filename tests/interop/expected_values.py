"""What the task `echo` of spec/calibration.md shows, computed from its page.

Also what it means that two JSON values are the same. It must not know the server.
"""

import math
import struct
from datetime import datetime
from typing import Any

INTEGERS = {"int8": "b", "int16": "<h", "int32": "<i", "int64": "<q"}
NATURALS = {"uint8": "B", "uint16": "<H", "uint32": "<I", "uint64": "<Q"}
# code, smallest positive normal, largest finite
FLOATS = {
    "float16": ("<e", 2.0**-14, 65504.0),
    "float32": ("<f", 2.0**-126, (2 - 2.0**-23) * 2.0**127),
    "float64": ("<d", 2.0**-1022, (2 - 2.0**-52) * 2.0**1023),
}


def pattern(height: int, width: int, *, count: int) -> bytes:
    """The image `pattern`, height × width × 3 bytes."""
    return bytes(
        (7 * x + 13 * y + 29 * c + count) % 256
        for y in range(height)
        for x in range(width)
        for c in range(3)
    )


def tensors() -> dict[str, dict[str, Any]]:
    """Every tensor of `echo`: name → dtype, shape, data in hexadecimal digits."""
    data = {"bool": bytes([0, 1, 0, 1, 0, 1])}
    for name, code in INTEGERS.items():
        top = 2 ** (8 * struct.calcsize(code) - 1)
        numbers = [-2, -1, 0, 1, -top, top - 1]
        data[name] = b"".join(struct.pack(code, n) for n in numbers)
    for name, code in NATURALS.items():
        top = 2 ** (8 * struct.calcsize(code))
        data[name] = b"".join(struct.pack(code, n) for n in [0, 1, 2, 3, 4, top - 1])
    for name, (code, tiny, huge) in FLOATS.items():
        values = [-2.0, -0.5, 0.0, 0.5, tiny, huge]
        data[name] = b"".join(struct.pack(code, x) for x in values)
    encoded = {
        name: {"dtype": name, "shape": [2, 3], "data": raw.hex()}
        for name, raw in data.items()
    }
    return encoded | {"empty": {"dtype": "float64", "shape": [0, 3], "data": ""}}


def parse_time(text: str) -> datetime:
    """The time that a text names; it can be written in several ways."""
    return datetime.fromisoformat(text)


def values_equal(one: Any, other: Any) -> bool:
    """Whether two parsed JSON values are equal; 1 and 1.0 are, true and 1 are not.
    Members whose name ends in `_at` are times, equal when they name the same
    instant."""
    if isinstance(one, dict) and isinstance(other, dict):
        return one.keys() == other.keys() and all(
            parse_time(value) == parse_time(other[name])
            if name.endswith("_at")
            else values_equal(value, other[name])
            for name, value in one.items()
        )
    if isinstance(one, list) and isinstance(other, list):
        return len(one) == len(other) and all(
            values_equal(left, right) for left, right in zip(one, other, strict=True)
        )
    if isinstance(one, bool) or isinstance(other, bool):
        return one is other
    if isinstance(one, float) and isinstance(other, float):
        return one == other and math.copysign(1, one) == math.copysign(1, other)
    return bool(one == other)
