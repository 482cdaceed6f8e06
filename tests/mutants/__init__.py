"""Servers that are broken on purpose, to prove that the kit sees it.

A mutant is the reference server with one thing wrong. Its name says what it does wrong,
its docstring what a user would suffer, and `kills` which requirements it breaks: the
kit has to fail exactly those, no more and no fewer.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

Patch = Callable[[], None]


@dataclass(frozen=True, slots=True)
class Mutant:
    """tries: with how many seeds the kit may look; a race needs luck to be seen."""

    name: str
    kills: frozenset[str]
    user_impact: str
    patch: Patch
    tries: int = 2


MUTANTS: dict[str, Mutant] = {}


def mutant(*kills: str, tries: int = 2) -> Callable[[Patch], Patch]:
    """Register a patch of the server under its function's name."""

    def register(patch: Patch) -> Patch:
        user_impact = (patch.__doc__ or "").strip()
        assert user_impact, f"{patch.__name__} does not say what a user would suffer"
        assert patch.__name__ not in MUTANTS, f"{patch.__name__} exists twice"
        MUTANTS[patch.__name__] = Mutant(
            patch.__name__, frozenset(kills), user_impact, patch, tries
        )
        return patch

    return register


def put(owner: object, name: str, wrong: object) -> None:
    """Replace what `owner` has under `name`; a typo would make a mutant of nothing."""
    assert hasattr(owner, name), f"{owner} has no {name}"
    setattr(owner, name, wrong)


def load() -> dict[str, Mutant]:
    """All mutants, by name."""
    from tests.mutants import (  # noqa: F401 - importing them registers them
        answers,
        chat,
        compare,
        connections,
        control_plane,
        ebench,
        episodes,
        events,
        faults,
        flageval,
        histories,
        http_messages,
        idempotency,
        invalid_requests,
        lifecycle,
        long_lists,
        players,
        push,
        record,
        restarts,
        sealed_seeds,
        sessions,
        shown_members,
        simulators,
        subsets,
        turns,
    )

    return MUTANTS
