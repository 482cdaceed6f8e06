"""The element types of tensors, as observations.md lists them."""

import math
import struct
from collections.abc import Mapping
from typing import Any

# dtype → the format of one element, for the module `struct`.
TENSOR_FORMATS = {"bool": "B"}
TENSOR_FORMATS |= {"int8": "b", "int16": "h", "int32": "i", "int64": "q"}
TENSOR_FORMATS |= {"uint8": "B", "uint16": "H", "uint32": "I", "uint64": "Q"}
TENSOR_FORMATS |= {"float16": "e", "float32": "f", "float64": "d"}


def tensor_bytes(space: Mapping[str, Any]) -> int:
    """Give the length of the data of a tensor."""
    element = struct.calcsize(f"<{TENSOR_FORMATS[space['dtype']]}")
    return int(math.prod(space["shape"])) * element
