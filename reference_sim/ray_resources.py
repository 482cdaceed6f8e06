"""Resources that one simulator takes of a machine of a Ray cluster, by Ray's names.

A benchmark declares them; a setting does for benchmarks that do not. Nothing here knows
Ray: a resource that the cluster lacks is found when a simulator is requested.
"""

from __future__ import annotations

import re
from collections.abc import Mapping

NAMES_MAX = 16
AMOUNT_MIN, AMOUNT_MAX = 0.0001, 2.0**50  # Ray's precision; a pebibyte of memory
_NAME = re.compile(r"[A-Za-z0-9_.:-]{1,100}")
_SHOWN_MAX = 100  # characters of an invalid name that an error quotes


def check_resources(declared: object) -> dict[str, float]:
    """The amounts by name. Raises ValueError with one sentence."""
    if not isinstance(declared, Mapping) or not declared:
        raise ValueError("a simulator needs at least one resource, such as CPU = 1")
    if len(declared) > NAMES_MAX:
        raise ValueError(f"a simulator takes at most {NAMES_MAX} kinds of resources")
    for name, amount in declared.items():
        _check_amount(name, amount)
    return dict(declared)


def _check_amount(name: object, amount: object) -> None:
    if not isinstance(name, str) or not _NAME.fullmatch(name):
        raise ValueError(
            f"{repr(name)[:_SHOWN_MAX]} is no name of a resource: 1 to 100 letters, "
            "digits and characters of _.:-"
        )
    if (
        isinstance(amount, bool)
        or not isinstance(amount, int | float)
        or not AMOUNT_MIN <= amount <= AMOUNT_MAX  # nor is NaN
    ):
        raise ValueError(
            f"{name}: the amount has to be a number from {AMOUNT_MIN:g} to 2^50"
        )
    if amount != int(amount) and (amount > 1 or name == "memory"):
        raise ValueError(f"{name}: Ray takes fractions below 1 only, of memory none")


def parse_resources(text: str) -> dict[str, float]:
    """`CPU=0.5,GPU=1` as amounts by name. Raises ValueError with one sentence."""
    amounts: dict[str, float] = {}
    for part in filter(None, map(str.strip, text.split(","))):
        name, _, written = map(str.strip, part.partition("="))
        if name in amounts:
            raise ValueError(f"{name} is named twice")
        try:
            amounts[name] = float(written)
        except ValueError:
            raise ValueError(f"{part!r} is not NAME=AMOUNT") from None
    return check_resources(amounts)


def format_resources(resources: Mapping[str, float]) -> str:
    """As `parse_resources` reads it, in the order of the names."""
    return ",".join(
        f"{name}={int(amount) if amount == int(amount) else amount}"
        for name, amount in sorted(resources.items())
    )
