"""Pickles of EBench's API: written opcode by opcode, read as plain data only.

The only module of the kit that uses pickle. Responses are read with an unpickler that
refuses every global, so that it builds plain data and calls nothing.
"""

import io
import pickle
import struct
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, NoReturn


class GlobalInPickle(Exception):
    """A pickle that references a global; the text names it."""


@dataclass(frozen=True)
class PickledArray:
    """Numbers as numpy pickles them; `core` depends on its major version."""

    numbers: Sequence[float]
    core: str = "_core"


@dataclass(frozen=True)
class PickledCall:
    """A call that is executed when the pickle is read without protection."""

    module: str
    name: str
    arguments: Sequence[Any] = ()


class _Plain(pickle.Unpickler):
    def find_class(self, module: str, name: str) -> NoReturn:
        raise GlobalInPickle(f"{module}.{name}")


def read(body: bytes) -> Any:
    """Read plain data; raises GlobalInPickle, or ValueError for invalid pickles."""
    try:
        return _Plain(io.BytesIO(body)).load()
    except GlobalInPickle:
        raise
    except Exception as error:  # the unpickler raises any exception
        raise ValueError(f"no pickle: {error!r}") from error


def write(value: Any) -> bytes:
    """Write a pickle of plain data, arrays and calls."""
    return b"".join((b"\x80\x03", *_parts(value), b"."))


def _parts(value: Any) -> Iterator[bytes]:
    match value:
        case PickledArray():
            yield from _array(value)
        case PickledCall():
            yield _global(value.module, value.name)
            yield b"("
            for argument in value.arguments:
                yield from _parts(argument)
            yield b"tR"
        case Mapping():
            yield b"}("
            for key, item in value.items():
                yield from (*_parts(key), *_parts(item))
            yield b"u"
        case list() | tuple():
            yield b"]("
            for item in value:
                yield from _parts(item)
            yield b"e"
        case _:
            yield _bare(value)


def _bare(value: float | str | bytes | None) -> bytes:
    """A value without the header and the end of a pickle."""
    return pickle.dumps(value, protocol=3)[2:-1]


def _global(module: str, name: str) -> bytes:
    return f"c{module}\n{name}\n".encode()


def _array(array: PickledArray) -> Iterator[bytes]:
    """The opcodes with which numpy writes a vector of float64."""
    data = struct.pack(f"<{len(array.numbers)}d", *array.numbers)
    yield _global(f"numpy.{array.core}.multiarray", "_reconstruct")
    yield b"(" + _global("numpy", "ndarray") + b"K\x00\x85C\x01btR("
    yield from (b"K\x01", _bare(len(array.numbers)), b"\x85")
    yield _global("numpy", "dtype") + b"X\x02\x00\x00\x00f8\x89\x88\x87R"
    yield b"(K\x03X\x01\x00\x00\x00<NNNJ\xff\xff\xff\xffJ\xff\xff\xff\xffK\x00tb"
    yield from (b"\x89", _bare(data), b"tb")
