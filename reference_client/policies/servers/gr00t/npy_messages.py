"""MessagePack with numpy arrays, in GR00T's dialect.

An array is a map {"__ndarray_class__": true, "as_npy": bytes of an .npy file}. Only
dtypes of numbers and text are read, none that could hold an object. A description is a
map {"__ModalityConfig_class__": true, "as_json": its members}.
"""

from __future__ import annotations

import io
import tokenize
from typing import Any

import msgspec
import numpy as np

# The last two: numpy repairs headers of Python 2, and fails so on what is none.
_UNREADABLE = (
    msgspec.DecodeError,
    RecursionError,
    TypeError,
    ValueError,
    SyntaxError,
    tokenize.TokenError,
)


class BadNpyMessage(ValueError):
    """The bytes are not of this dialect."""


def pack(value: Any) -> bytes:
    """Raises TypeError or ValueError for what cannot be sent."""
    return msgspec.msgpack.encode(value, enc_hook=_packed)


def unpack(data: bytes) -> Any:
    """Raises BadNpyMessage."""
    try:
        return _unpacked(msgspec.msgpack.decode(data))
    except _UNREADABLE as error:
        raise BadNpyMessage(f"is not GR00T's MessagePack: {error}") from error


def _packed(value: Any) -> Any:
    if not isinstance(value, np.ndarray):
        raise TypeError(f"{type(value).__name__} is not supported in a request")
    file = io.BytesIO()
    np.save(file, value, allow_pickle=False)
    return {"__ndarray_class__": True, "as_npy": file.getvalue()}


def _unpacked(value: Any) -> Any:
    if isinstance(value, list):
        return [_unpacked(item) for item in value]
    if not isinstance(value, dict):
        return value
    if "__ndarray_class__" in value:
        return _array(value.get("as_npy"))
    if "__ModalityConfig_class__" in value:
        return _unpacked(value.get("as_json"))
    return {key: _unpacked(item) for key, item in value.items()}


def _array(data: Any) -> np.ndarray[Any, Any]:
    """A read-only view. np.load would also read archives, and believe any size."""
    file = io.BytesIO(data)
    version = np.lib.format.read_magic(file)
    if version == (1, 0):
        shape, is_fortran, dtype = np.lib.format.read_array_header_1_0(file)
    elif version == (2, 0):
        shape, is_fortran, dtype = np.lib.format.read_array_header_2_0(file)
    else:
        raise ValueError(f"an .npy file of version {version}")
    if dtype.kind not in "biufSU":
        raise ValueError(f"dtype {dtype} is not supported")
    numbers = np.frombuffer(file.read(), dtype)
    return numbers.reshape(shape, order="F" if is_fortran else "C")
