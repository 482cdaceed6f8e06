"""MessagePack with numpy arrays, in openpi's dialect.

An array is a map with binary keys, {b"__ndarray__": true, b"data": bytes, b"dtype":
str, b"shape": [int]}; a numpy number is {b"__npgeneric__": true, b"data": …, b"dtype":
…}. Dialects with string keys of the same names are not supported. Only dtypes of
numbers and text are decoded, none that could hold an object.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import msgspec
import numpy as np


class BadMessage(ValueError):
    """The bytes are not of this dialect."""


def pack(value: Any) -> bytes:
    """Raises TypeError for unsupported types."""
    return msgspec.msgpack.encode(value, enc_hook=_packed)


def unpack(data: bytes) -> Any:
    """Arrays come as read-only views of `data`. Raises BadMessage."""
    try:
        return _unpacked(msgspec.msgpack.decode(data))
    except (msgspec.DecodeError, KeyError, TypeError, ValueError) as error:
        raise BadMessage(f"is not openpi's MessagePack: {error}") from error


def _packed(value: Any) -> Any:
    if isinstance(value, np.ndarray):
        _checked(value.dtype)
        return {
            b"__ndarray__": True,
            b"data": value.tobytes(),
            b"dtype": value.dtype.str,
            b"shape": value.shape,
        }
    if isinstance(value, np.generic):
        dtype = _checked(value.dtype).str
        return {b"__npgeneric__": True, b"data": value.item(), b"dtype": dtype}
    raise TypeError(f"{type(value).__name__} is not supported in a request")


def _unpacked(value: Any) -> Any:
    if isinstance(value, list):
        return [_unpacked(item) for item in value]
    if not isinstance(value, Mapping):
        return value
    if b"__ndarray__" in value:
        dtype = _checked(np.dtype(value[b"dtype"]))
        return np.frombuffer(value[b"data"], dtype).reshape(value[b"shape"])
    if b"__npgeneric__" in value:
        return _checked(np.dtype(value[b"dtype"])).type(value[b"data"])
    return {key: _unpacked(item) for key, item in value.items()}


def _checked(dtype: np.dtype[Any]) -> np.dtype[Any]:
    if dtype.kind not in "biufSU":
        raise ValueError(f"dtype {dtype} is not supported")
    return dtype
