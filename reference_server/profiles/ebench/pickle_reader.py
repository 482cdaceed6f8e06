"""Reads pickles of plain data without executing them (EBE-011, EBE-015).

EBench's client sends pickles, and a pickle is a program that may call anything. Why
this is our own code and not `pickle.Unpickler` with a restricted `find_class`: that one
restricts names, and bounds nothing. It builds every object before a limit can be
checked, so that a short pickle that converts one text again and again, or nests or
repeats its parts, takes all memory or time. Here the limits below are checked before
something is built: opcodes, values, depth, text, bytes, sizes of arrays.

The arguments of opcodes are decoded by `pickletools`, which executes nothing; a small
stack machine knows the few opcodes of plain data. Numpy's arrays and numbers are
recognised by the pattern in which numpy writes them, and made with `frombuffer`. Any
other name is refused. A value that a pickle refers to many times counts as many times.

Must not know requests, and must not import `pickle`.
"""

from __future__ import annotations

import math
import pickletools
from collections.abc import Callable, Iterator, Mapping
from io import BytesIO
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

OPCODES_MAX = 400_000
VALUES_MAX = 400_000
# Values that a pickle of any length may have, and values that each byte may add:
# actions that many workers share are few bytes, but a hundred bytes never stand for a
# million values.
VALUES_OF_ANY, VALUES_PER_BYTE = 2**15, 4
TEXT_MAX = 2**22  # characters, repeated references included
DEPTH_MAX = 16
DIMENSIONS_MAX = 8
INTEGER_MAX = 2**64
KEY_MAX = 2**31  # larger numbers as keys could be chosen to collide
AXIS_LENGTH_MAX = 2**31  # of an array; multiplying longer numbers takes long

_DTYPES = {f"{kind}{size}" for kind in "iu" for size in (1, 2, 4, 8)}
_DTYPES |= {"b1", "f2", "f4", "f8"}
_DTYPE_STATE = (None, None, None, -1, -1, 0)  # no fields, no alignment
_EMPTY: tuple[int, ...] = (0,)  # what numpy writes before it sets the data


class BadPickle(ValueError):
    """The body is not a pickle of plain values and arrays; the message says why."""


class TooManyValues(BadPickle):
    """It stands for more values than its reader takes."""


class _Name(str):
    """A global of numpy's pattern: a marker only, no object is behind it."""

    __slots__ = ()


_RECONSTRUCT, _FROMBUFFER = _Name("_reconstruct"), _Name("_frombuffer")
_SCALAR, _NDARRAY, _DTYPE = _Name("scalar"), _Name("ndarray"), _Name("dtype")
_ENCODE = _Name("encode")

# numpy renamed `core` to `_core` in version 2; `encode` is how bytes are written in
# protocols that have none.
_NAMES: Mapping[tuple[str, str], _Name] = {
    **{
        (f"numpy.{core}.{module}", name): name
        for core in ("core", "_core")
        for module, name in (
            ("multiarray", _RECONSTRUCT),
            ("multiarray", _SCALAR),
            ("numeric", _FROMBUFFER),
        )
    },
    ("numpy", "ndarray"): _NDARRAY,
    ("numpy", "dtype"): _DTYPE,
    ("_codecs", "encode"): _ENCODE,
}


class _Dtype:
    """A dtype; complete once its byte order is set."""

    def __init__(self, code: str) -> None:
        self.code = code
        self.order = ""

    def get(self) -> np.dtype[Any]:
        _require(self.order, "a dtype without byte order")
        return np.dtype(self.order + self.code)


class _Array:
    """An array; numpy's older pattern creates it first and sets its data later."""

    def __init__(self) -> None:
        self.filled: NDArray[Any] | None = None


def read(body: bytes, values_max: int = VALUES_MAX) -> Any:
    """The value in a pickle of any protocol, tuples as lists.

    Dicts, lists, strings, numbers, booleans, None and numpy arrays (boolean, integer or
    floating; in the byte order of this machine). Raises BadPickle and nothing else.
    """
    machine = _Machine(len(body))
    try:
        return _Tree(len(body), values_max).of(machine.run(body))
    except BadPickle:
        raise
    except (LookupError, TypeError, ValueError, OverflowError) as error:
        # Stack underflow, an unhashable key, text that is not valid Unicode.
        raise BadPickle(f"malformed, {str(error)[:200]!a}") from error


class _Machine:
    """The stack machine of one pickle: stack, marks and memo."""

    def __init__(self, size: int) -> None:
        self.stack: list[Any] = []
        self._outer_stacks: list[list[Any]] = []
        self.memo: dict[int, Any] = {}
        # Each byte sent may become bytes from text once, and an array once.
        self._bytes_left = 2 * size

    def run(self, body: bytes) -> Any:
        data = BytesIO(body)
        for _ in range(OPCODES_MAX):
            code = data.read(1)
            if code == b".":
                break
            opcode = _OPCODES.get(code)
            if opcode is None:
                raise BadPickle(f"the opcode {code!r} is not supported")
            read_argument, handler = opcode
            handler(self, read_argument(data))
        else:
            raise BadPickle(f"more than {OPCODES_MAX} opcodes")
        is_complete = len(self.stack) == 1 and not self._outer_stacks
        _require(is_complete, "it has data left on the stack at STOP")
        return self.stack[0]

    def mark(self) -> None:
        self._outer_stacks.append(self.stack)
        self.stack = []

    def since_mark(self) -> list[Any]:
        items, self.stack = self.stack, self._outer_stacks.pop()
        return items

    def last(self, count: int) -> list[Any]:
        _require(len(self.stack) >= count, "stack underflow")
        items = self.stack[-count:]
        del self.stack[-count:]
        return items

    def name(self, module: Any, name: Any) -> None:
        _require(type(module) is str and type(name) is str, "a name that is not text")
        constructor = _NAMES.get((module, name))
        if constructor is None:
            raise BadPickle(
                f"it names {module[:60]!a} {name[:60]!a}; only plain values "
                "and numpy arrays are allowed"
            )
        self.stack.append(constructor)

    def call(self) -> None:
        """REDUCE: only the calls of numpy's pattern (EBE-015)."""
        arguments, called = self.stack.pop(), self.stack.pop()
        _require(isinstance(called, _Name), "it calls an object that is not allowed")
        _require(isinstance(arguments, tuple), "it calls without arguments")
        self.stack.append(_CALLS[called](self, *arguments))

    def fill(self) -> None:
        """BUILD: complete a dtype or an array that was created before."""
        state, made = self.stack.pop(), self.stack[-1]
        _require(isinstance(state, tuple), "a state that is not numpy's")
        if isinstance(made, _Dtype) and not made.order:
            version, order, *rest = state
            _require(
                version == 3 and tuple(rest) == _DTYPE_STATE, "an unsupported dtype"
            )
            _require(order in ("<", ">", "|", "="), "an unsupported byte order")
            made.order = order
        elif isinstance(made, _Array) and made.filled is None:
            version, shape, dtype, is_fortran, data = state
            _require(version == 1, "an unsupported array")
            made.filled = self.array(data, dtype, shape, "F" if is_fortran else "C")
        else:
            raise BadPickle("it sets the state of an object that is not allowed")

    def encoded(self, text: Any, codec: Any) -> bytes:
        _require(isinstance(text, str) and codec == "latin1", "an unsupported encoding")
        self._spend(len(text))
        encoded: bytes = text.encode("latin-1")
        return encoded

    def array(self, data: Any, dtype: Any, shape: Any, order: Any) -> NDArray[Any]:
        """The array; its bytes are counted each time that it is made."""
        _require(isinstance(data, bytes | bytearray), "an array without its bytes")
        _require(isinstance(dtype, _Dtype), "an array without a dtype")
        _require(
            isinstance(shape, tuple) and len(shape) <= DIMENSIONS_MAX, "a bad shape"
        )
        _require(
            all(type(n) is int and 0 <= n < AXIS_LENGTH_MAX for n in shape),
            "a bad shape",
        )
        _require(order in ("C", "F"), "an unsupported memory order")
        kind = dtype.get()
        size = math.prod(shape) * kind.itemsize
        _require(size == len(data), "an array of another size")
        self._spend(size)
        array = np.frombuffer(data, kind).reshape(shape, order=order)
        return array.astype(kind.newbyteorder("="), copy=False)

    def _spend(self, count: int) -> None:
        """Count bytes that are made against the limit."""
        self._bytes_left -= count
        _require(self._bytes_left >= 0, "it expands to too many bytes")


def _require(condition: object, otherwise: str) -> None:
    if not condition:
        raise BadPickle(otherwise)


def _dtype(_: _Machine, code: Any, align: Any, copy: Any) -> _Dtype:
    _require(isinstance(code, str) and code in _DTYPES, "a dtype that is not numeric")
    _require(align in (0, 1) and copy in (0, 1), "an unsupported dtype")
    return _Dtype(code)


def _reconstruct(_: _Machine, kind: Any, shape: Any, code: Any) -> _Array:
    _require(
        kind is _NDARRAY and shape == _EMPTY and code == b"b", "an unsupported array"
    )
    return _Array()


def _frombuffer(
    machine: _Machine, data: Any, dtype: Any, shape: Any, order: Any = "C"
) -> _Array:
    array = _Array()
    array.filled = machine.array(data, dtype, shape, order)
    return array


def _scalar(machine: _Machine, dtype: Any, data: Any) -> Any:
    return machine.array(data, dtype, (1,), "C").item()


_CALLS: Mapping[_Name, Callable[..., Any]] = {
    _DTYPE: _dtype,
    _RECONSTRUCT: _reconstruct,
    _FROMBUFFER: _frombuffer,
    _SCALAR: _scalar,
    _ENCODE: _Machine.encoded,
}

_Handler: TypeAlias = Callable[[_Machine, Any], None]


def _ignore(_machine: _Machine, _argument: Any) -> None:
    """PROTO and FRAME: what follows is read without them."""


def _push(machine: _Machine, argument: Any) -> None:
    machine.stack.append(argument)


def _constant(make: Callable[[], Any]) -> _Handler:
    return lambda machine, _: machine.stack.append(make())


def _tuple_of(count: int) -> _Handler:
    return lambda machine, _: machine.stack.append(tuple(machine.last(count)))


def _tuple(machine: _Machine, _: Any) -> None:
    items = machine.since_mark()
    machine.stack.append(tuple(items))


def _list(machine: _Machine, _: Any) -> None:
    items = machine.since_mark()
    machine.stack.append(items)


def _dict(machine: _Machine, _: Any) -> None:
    items = machine.since_mark()
    machine.stack.append({})
    _set(machine.stack[-1], items)


def _extend(machine: _Machine, items: list[Any]) -> None:
    target = machine.stack[-1]
    _require(type(target) is list, "it appends to no list")
    target += items


def _set(target: Any, items: list[Any]) -> None:
    _require(
        type(target) is dict and len(items) % 2 == 0,
        "it sets items of no dict",
    )
    for key, value in zip(items[::2], items[1::2], strict=True):
        is_number = type(key) is int and abs(key) < KEY_MAX
        _require(type(key) is str or is_number, "a key that is not a string")
        target[key] = value


def _set_one(machine: _Machine, _: Any) -> None:
    pair = machine.last(2)
    _set(machine.stack[-1], pair)


def _set_many(machine: _Machine, _: Any) -> None:
    items = machine.since_mark()
    _set(machine.stack[-1], items)


def _put(machine: _Machine, index: int) -> None:
    _require(0 <= index < KEY_MAX, "an unsupported memo index")
    machine.memo[index] = machine.stack[-1]


def _read_global(data: BytesIO) -> tuple[str, str]:
    """The two lines of GLOBAL as they are; `pickletools` would decode escapes."""
    module, name = (data.readline().decode("ascii") for _ in range(2))
    return module.removesuffix("\n"), name.removesuffix("\n")


def _global(machine: _Machine, argument: tuple[str, str]) -> None:
    machine.name(*argument)


def _stack_global(machine: _Machine, _: Any) -> None:
    machine.name(*machine.last(2))


_HANDLERS: Mapping[str, _Handler] = {
    "PROTO": _ignore,
    "FRAME": _ignore,
    "MARK": lambda machine, _: machine.mark(),
    "NONE": _constant(lambda: None),
    "NEWTRUE": _constant(lambda: True),
    "NEWFALSE": _constant(lambda: False),
    **dict.fromkeys(("INT", "BININT", "BININT1", "BININT2"), _push),
    **dict.fromkeys(("LONG", "LONG1", "LONG4", "FLOAT", "BINFLOAT"), _push),
    **dict.fromkeys(("UNICODE", "BINUNICODE", "SHORT_BINUNICODE"), _push),
    **dict.fromkeys(("BINBYTES", "SHORT_BINBYTES", "BINBYTES8"), _push),
    **dict.fromkeys(("BINUNICODE8", "BYTEARRAY8"), _push),
    "EMPTY_LIST": _constant(list),
    "LIST": _list,
    "APPEND": lambda machine, _: _extend(machine, machine.last(1)),
    "APPENDS": lambda machine, _: _extend(machine, machine.since_mark()),
    "EMPTY_TUPLE": _constant(tuple),
    "TUPLE": _tuple,
    "TUPLE1": _tuple_of(1),
    "TUPLE2": _tuple_of(2),
    "TUPLE3": _tuple_of(3),
    "EMPTY_DICT": _constant(dict),
    "DICT": _dict,
    "SETITEM": _set_one,
    "SETITEMS": _set_many,
    **dict.fromkeys(("PUT", "BINPUT", "LONG_BINPUT"), _put),
    "MEMOIZE": lambda machine, _: _put(machine, len(machine.memo)),
    **dict.fromkeys(
        ("GET", "BINGET", "LONG_BINGET"),
        lambda machine, index: machine.stack.append(machine.memo[index]),
    ),
    "GLOBAL": _global,
    "STACK_GLOBAL": _stack_global,
    "REDUCE": lambda machine, _: machine.call(),
    "BUILD": lambda machine, _: machine.fill(),
}

_Opcode: TypeAlias = tuple[Callable[[BytesIO], Any], _Handler]


def _opcodes() -> Iterator[tuple[bytes, _Opcode]]:
    """Supported opcode → the reader of its argument, and its handler."""
    for opcode in pickletools.opcodes:
        if opcode.name in _HANDLERS:
            reader: Any = opcode.arg.reader if opcode.arg else lambda _: None
            if opcode.name == "GLOBAL":
                reader = _read_global
            yield opcode.code.encode("latin-1"), (reader, _HANDLERS[opcode.name])


_OPCODES = dict(_opcodes())


class _Tree:
    """The result, copied: a part that is referenced many times counts many times."""

    def __init__(self, size: int, values_max: int) -> None:
        self._most = min(values_max, VALUES_OF_ANY + VALUES_PER_BYTE * size)
        self._left = self._most
        self._text_left = TEXT_MAX

    def of(self, value: Any, depth: int = 0) -> Any:
        array = value.filled if isinstance(value, _Array) else None
        self._left -= 1 if array is None else max(array.size, 1)
        if self._left < 0:
            raise TooManyValues(f"more than {self._most} values")
        _require(depth <= DEPTH_MAX, "it is nested too deeply, or contains itself")
        if array is not None:
            return array
        if type(value) in (list, tuple):
            return [self.of(item, depth + 1) for item in value]
        if type(value) is dict:
            return {
                self.of(key, depth): self.of(item, depth + 1)
                for key, item in value.items()
            }
        if type(value) is str:
            self._text_left -= len(value)
            _require(self._text_left >= 0, f"more than {TEXT_MAX} characters of text")
            value.encode()  # raises for a lone surrogate, which is not valid text
            return value
        plain = value is None or type(value) in (bool, int, float)
        _require(plain, f"a bare {type(value).__name__.strip('_')} is not a value")
        _require(
            type(value) is not int or abs(value) < INTEGER_MAX, "too large a number"
        )
        return value
