"""Numbers of any array library as float64 of numpy; no such library is imported here.

A conversion that changes no number is made: from bfloat16 and half, from a GPU, from a
tensor that records gradients, from a sparse one. Anything else is refused with the
library's own reason and what to write instead.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
import numpy.typing as npt

from reference_record.texts.shortened_text import shortened

# Library → what its users write, so that the client need not convert.
_CURES = {
    "torch": "return `x.detach().float().cpu()`",
    "jax": "return `jax.device_get(x)`, outside of `jax.jit`",
    "jaxlib": "return `jax.device_get(x)`, outside of `jax.jit`",
    "tensorflow": "return `x.numpy()` of a dense tensor, outside of `tf.function`",
}
_CURE = "return a list or a numpy array of real numbers"
_TEXT_MAX, _QUOTED_MAX = 200, 40


class UnreadableNumbers(ValueError):
    """The value holds no real numbers; the message says why, and what to write."""


def as_numpy(value: Any) -> npt.NDArray[np.float64]:
    """The same numbers and shape. Raises UnreadableNumbers."""
    try:
        array = np.asarray(_readable(value))
        _check_kind(array)
        return array.astype(np.float64)
    except Exception as error:
        words = " ".join(str(error).split())
        reason = shortened(words, _TEXT_MAX) or type(error).__name__
        raise UnreadableNumbers(
            f"holds a value that is no number: {_name_in(value)}: {reason}; "
            f"{_CURES.get(_library_in(value), _CURE)}"
        ) from error


def kind_of_answer(value: Any) -> str:
    """Name the value that an answer of another program has in the place of numbers."""
    match _first_strange(value):
        case None:
            kind = "null"
        case str(text):
            kind = f"the text {shortened(text, _QUOTED_MAX)!r}"
        case bytes():
            kind = "bytes"
        case Mapping() as table:
            kind = f"an object with {', '.join(map(repr, table)) or 'no members'}"
        case np.ndarray() as array:
            kind = f"an array of dtype {array.dtype}"
        case list() | tuple():
            return "lists of different lengths"
        case other:
            kind = f"a value of the type {_name_in(other).removeprefix('a ')}"
    return f"a list with {kind}" if isinstance(value, list | tuple) else kind


def _readable(value: Any) -> Any:
    """A value that numpy reads; lists of tensors, too."""
    if isinstance(value, list | tuple):
        return [_readable(item) for item in value]
    if _is_tensor(value):
        return _tensor_on_cpu(value)
    if isinstance(value, np.ma.MaskedArray) and np.ma.is_masked(value):
        raise ValueError("it has masked numbers")
    return np.asarray(value) if hasattr(value, "__array__") else value


def _is_tensor(value: Any) -> bool:
    """Whether it is a torch.Tensor, or of a class that is derived from it."""
    return any(
        kind.__name__ == "Tensor" and kind.__module__ == "torch"
        for kind in type(value).__mro__
    )


def _tensor_on_cpu(tensor: Any) -> Any:
    tensor = tensor.detach()
    if tensor.is_quantized:
        tensor = tensor.dequantize()
    if str(tensor.layout) != "torch.strided":
        tensor = tensor.to_dense()
    if tensor.is_complex():
        raise ValueError("it is complex")
    # Every narrower dtype fits into float64, which some devices do not have.
    return tensor.cpu().double().numpy()


def _check_kind(array: npt.NDArray[Any]) -> None:
    """Refuses what numpy would convert by leaving something out, or by parsing."""
    if array.dtype.kind in "cUSMm" or array.dtype.type is np.void:
        raise ValueError(f"it is of dtype {array.dtype}")
    if array.dtype.kind == "O":
        for item in array.flat:
            if item is None or isinstance(item, str | bytes):
                raise ValueError(f"it has {item!r:.40}")


def _first_strange(value: Any) -> Any:
    """The value, or the first item of a list other than a plain number."""
    if isinstance(value, list | tuple):
        items = (_first_strange(item) for item in value)
        strange = (x for x in items if not isinstance(x, int | float | list | tuple))
        return next(strange, value)
    return value


def _library_in(value: Any) -> str:
    """The first library among the classes of a value that has a cure of its own."""
    kinds = type(_first_strange(value)).__mro__
    names = (kind.__module__.partition(".")[0] for kind in kinds)
    return next((name for name in names if name in _CURES), "")


def _name_in(value: Any) -> str:
    kind = type(_first_strange(value))
    library = kind.__module__.partition(".")[0]
    name = kind.__name__ if library == "builtins" else f"{library}.{kind.__name__}"
    return f"a {name}"
