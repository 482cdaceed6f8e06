"""Numbers on command lines: each has an end, and none is nan."""

from __future__ import annotations

from reference_record.command_line.click_commands import checked

MOST = 1e9  # of what has no other bound
DAYS_MAX = 36_500.0  # a later date may not be one that can be written


@checked
def count(text: str) -> int:
    if not text.isdecimal() or not 1 <= int(text) <= MOST:
        raise ValueError(f"{text}: expected an integer >= 1")
    return int(text)


@checked
def seconds(text: str) -> float:
    return _number(text, MOST, "seconds >= 0")


@checked
def fraction(text: str) -> float:
    return _number(text, 1.0, "a number from 0 to 1")


@checked
def days(text: str) -> float:
    return _number(text, DAYS_MAX, f"a number of days from 0 to {DAYS_MAX:g}")


@checked
def amount(text: str) -> float:
    expected = f"a number > 0, at most {MOST:g}"
    if (given := _number(text, MOST, expected)) == 0:
        raise ValueError(f"{text}: expected {expected}")
    return given


def _number(text: str, most: float, expected: str) -> float:
    try:
        given = float(text)
    except ValueError:
        given = -1.0
    if not 0 <= given <= most:  # nor nan, of which no comparison holds
        raise ValueError(f"{text}: expected {expected}")
    return given
