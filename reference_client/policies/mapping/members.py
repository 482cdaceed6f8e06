"""The types of the members of a mapping file, and how a table of it is read.

The description of a type is what a refusal says that the member is. Nothing is
converted here, and no array is touched.
"""

from __future__ import annotations

import json
import re
import sys
from collections.abc import Mapping
from typing import Annotated, Any, TypeAlias, TypeVar, get_args

import msgspec
import numpy.typing as npt
from msgspec import Meta

from reference_record.command_line.spelling import unknown
from reference_record.texts.counted_text import counted
from reference_record.texts.shortened_text import shortened

_SHOWN_CHARS = 60
_LARGEST = sys.float_info.max
_RANGE = re.compile("([0-9]{1,5}):([0-9]{1,5})")

# Comparisons with a number refuse nan, too.
_Finite: TypeAlias = Annotated[float, Meta(ge=-_LARGEST, le=_LARGEST)]
_Length: TypeAlias = Annotated[int, Meta(ge=1, le=8192)]
_Index: TypeAlias = Annotated[int, Meta(ge=0)]

Flag: TypeAlias = Annotated[bool, Meta(description="true or false")]
Text: TypeAlias = Annotated[str, Meta(description="a text")]
Number: TypeAlias = Annotated[_Finite, Meta(description="a finite number")]
Factors: TypeAlias = Annotated[
    _Finite | tuple[_Finite, ...],
    Meta(description="a finite number, or a list with one for each column"),
]
# msgspec 0.22 crashes on a union of a text with a pattern and a list with a length:
# `indices_of` checks both.
Columns: TypeAlias = Annotated[
    str | tuple[_Index, ...],
    Meta(
        description='"first:last", such as "0:7", the first below the last, or a list '
        "of whole numbers from 0"
    ),
]
PictureSize: TypeAlias = Annotated[
    tuple[_Length, _Length],
    Meta(description="[height, width], two whole numbers above 0, each at most 8192"),
]
Bounds: TypeAlias = Annotated[
    tuple[float, float],
    Meta(description="[low, high], two numbers, the first below the second"),
]
Dimensions: TypeAlias = Annotated[
    int, Meta(ge=0, le=8, description="a whole number from 0 to 8")
]
Count: TypeAlias = Annotated[int, Meta(ge=1, description="a whole number above 0")]
Table: TypeAlias = Annotated[dict[str, Any], Meta(description="a table")]
Array: TypeAlias = npt.NDArray[Any]

Members = TypeVar("Members", bound=msgspec.Struct)


class BadMapping(ValueError):
    """The mapping is invalid, or does not fit the benchmark; the message says why."""


class SizeMismatch(ValueError):
    """A member does not fit the numbers that it is for; the message names no file."""


def read_members(kind: type[Members], at: str, table: Any) -> Members:
    """The structure of a table of the file. Raises BadMapping.

    at: the file and the place of the table in it, for messages.
    """
    table = require_table(at, table, may_be_empty=True)
    known = {field.encode_name: field for field in msgspec.structs.fields(kind)}
    check_known(at, table, known)
    members: dict[str, Any] = {}
    for name, given in table.items():
        field = known[name]
        is_one_place = name == "from" and isinstance(given, str)
        try:
            value = msgspec.convert([given] if is_one_place else given, field.type)
        except msgspec.ValidationError as error:
            raise wrong_member(kind, at, name, given) from error
        members[field.name] = value
    return kind(**members)


def wrong_member(
    kind: type[msgspec.Struct], at: str, name: str, given: Any
) -> BadMapping:
    """The refusal of a member: what it is by its description, and what was given."""
    (field,) = (f for f in msgspec.structs.fields(kind) if f.encode_name == name)
    return BadMapping(f"{at}: {name} is {_description(field.type)}; not {shown(given)}")


def shown(given: Any) -> str:
    """A value as the file has it, more or less."""
    text = json.dumps(given, default=str, ensure_ascii=False)
    return shortened(text, _SHOWN_CHARS)


def require_table(
    at: str, table: Any, *, may_be_empty: bool = False
) -> Mapping[str, Any]:
    """The table. Raises BadMapping."""
    if not isinstance(table, Mapping) or not (table or may_be_empty):
        raise BadMapping(f"{at} is missing or not a table")
    return table


def check_known(at: str, table: Mapping[str, Any], names: Any) -> None:
    """Raises BadMapping for keys of other names."""
    if wrong := sorted(set(table) - set(names)):
        faults = [unknown("key", name, sorted(names)) for name in wrong]
        raise BadMapping(f"{at}: {'; '.join(faults)}")


def indices_of(columns: str | tuple[int, ...]) -> tuple[int, ...]:
    """The columns by their numbers; none if the text is not FIRST:LAST."""
    if isinstance(columns, tuple):
        return columns
    match = _RANGE.fullmatch(columns)
    return tuple(range(int(match[1]), int(match[2]))) if match else ()


def width_of_columns(
    member: str, columns: str | tuple[int, ...], width: int | None
) -> int:
    """How many of `width` numbers they are. Raises SizeMismatch if any is not there."""
    indices = indices_of(columns)
    if width is not None and max(indices) >= width:
        there = counted(width, "number")
        raise SizeMismatch(f"{member} is {shown(columns)}; it chooses from {there}")
    return len(indices)


def check_factors(
    member: str, factors: float | tuple[float, ...], width: int | None
) -> int | None:
    """The width of the product. Raises SizeMismatch for a list of another length."""
    if not isinstance(factors, tuple):
        return width
    if width is not None and len(factors) != width:
        given = counted(len(factors), "number")
        raise SizeMismatch(f"{member} has {given}, for {counted(width, 'number')}")
    return len(factors)


def _description(kind: Any) -> str:
    """The description of an annotated type, or of the one that may be None."""
    for meta in getattr(kind, "__metadata__", ()):
        if meta.description is not None:
            return str(meta.description)
    return _description(get_args(kind)[0])
