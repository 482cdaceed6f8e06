"""Numbers with their nouns, as people write them."""

from __future__ import annotations


def counted(number: int, noun: str, plural: str = "") -> str:
    """`1 episode`, `2 episodes`; plural: where it is not the noun and an s."""
    return f"{number} {noun if number == 1 else plural or noun + 's'}"
