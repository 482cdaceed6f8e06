"""The formats of requests and answers: MessagePack and JSON with numpy arrays.

| format | an array is |
|---|---|
| `msgpack` | {b"__ndarray__": true, b"data": …, b"dtype": …, b"shape": …} (openpi) |
| `msgpack-text` | the same with text keys (vla-eval) |
| `json` | nested lists |
| `json-numpy` | {"__numpy__": base64, "dtype": …, "shape": …} (json_numpy) |

Every kind of array is decoded in each. Only dtypes of numbers and text are decoded,
none that could hold an object.
"""

from __future__ import annotations

import base64
import contextlib
import json
from collections.abc import Callable, Mapping
from typing import Any

import msgspec
import numpy as np

FORMATS = ("msgpack", "msgpack-text", "json", "json-numpy")
_KEYS = ("data", "dtype", "shape")


class BadMessage(ValueError):
    """The bytes are not of this format."""


def pack(value: Any, wire_format: str = "msgpack") -> bytes:
    """Raises TypeError or ValueError for values that cannot be sent."""
    hook = _HOOKS[wire_format]
    if wire_format.startswith("json"):
        return msgspec.json.encode(value, enc_hook=hook)
    return msgspec.msgpack.encode(value, enc_hook=hook)


def unpack(data: str | bytes, wire_format: str = "msgpack") -> Any:
    """Arrays of MessagePack come as read-only views of `data`. Raises BadMessage."""
    is_json = wire_format.startswith("json")
    try:
        if is_json:
            return _unpacked(json.loads(data))
        return _unpacked(
            msgspec.msgpack.decode(data.encode() if isinstance(data, str) else data)
        )
    except (
        msgspec.DecodeError,
        KeyError,
        RecursionError,
        TypeError,
        ValueError,
    ) as error:
        kind = "JSON" if is_json else "MessagePack"
        raise BadMessage(f"is not {kind} with numpy arrays: {error}") from error


def kind_of(data: str | bytes) -> str | None:
    """`json` or `msgpack`, if it is a table or a list in that format; else None."""
    for kind in ("json", "msgpack"):
        with contextlib.suppress(BadMessage):
            if isinstance(unpack(data, kind), Mapping | list):
                return kind
    return None


def _packed(value: Any) -> Any:
    if isinstance(value, np.ndarray):
        return {b"__ndarray__": True} | {
            key.encode(): part for key, part in _parts(value).items()
        }
    if isinstance(value, np.generic):
        dtype = _checked(value.dtype).str
        return {b"__npgeneric__": True, b"data": value.item(), b"dtype": dtype}
    raise _unsupported(value)


def _packed_with_text_keys(value: Any) -> Any:
    if isinstance(value, np.ndarray):
        return {"__ndarray__": True} | _parts(value)
    return _plain(value)


def _packed_as_json_numpy(value: Any) -> Any:
    if isinstance(value, np.ndarray):
        parts = _parts(value)
        data = base64.b64encode(parts.pop("data")).decode()
        return {"__numpy__": data} | parts
    return _plain(value)


def _plain(value: Any) -> Any:
    if isinstance(value, np.ndarray | np.generic):
        _checked(value.dtype)
        return value.tolist()
    raise _unsupported(value)


_HOOKS: Mapping[str, Callable[[Any], Any]] = {
    "msgpack": _packed,
    "msgpack-text": _packed_with_text_keys,
    "json": _plain,
    "json-numpy": _packed_as_json_numpy,
}


def _parts(array: np.ndarray[Any, Any]) -> dict[str, Any]:
    return {
        "data": array.tobytes(),
        "dtype": _checked(array.dtype).str,
        "shape": array.shape,
    }


def _unsupported(value: Any) -> TypeError:
    return TypeError(f"{type(value).__name__} is not supported in a request")


def _unpacked(value: Any) -> Any:
    if isinstance(value, list):
        return [_unpacked(item) for item in value]
    if not isinstance(value, Mapping):
        return value
    for marker, unmarked in _MARKED.items():
        if marker in value:
            return unmarked(value)
    return {key: _unpacked(item) for key, item in value.items()}


def _array(data: bytes, dtype: Any, shape: Any) -> np.ndarray[Any, Any]:
    return np.frombuffer(data, _checked(np.dtype(dtype))).reshape(shape)


_MARKED: Mapping[Any, Callable[[Any], Any]] = {
    b"__ndarray__": lambda value: _array(*(value[key.encode()] for key in _KEYS)),
    "__ndarray__": lambda value: _array(*(value[key] for key in _KEYS)),
    "__numpy__": lambda value: _array(
        base64.b64decode(value["__numpy__"], validate=True),
        value["dtype"],
        value["shape"],
    ),
    b"__npgeneric__": lambda value: _checked(np.dtype(value[b"dtype"])).type(
        value[b"data"]
    ),
}


def _checked(dtype: np.dtype[Any]) -> np.dtype[Any]:
    if dtype.kind not in "biufSU":
        raise ValueError(f"dtype {dtype} is not supported")
    return dtype
