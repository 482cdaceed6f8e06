"""Servers that are broken on purpose, to prove that the kit sees it.

A mutant is the reference server with one thing wrong. Its name says what it does wrong,
its docstring what a user would suffer, and `kills` which requirements it breaks: the
kit has to fail exactly those, no more and no fewer.
"""

from __future__ import annotations

import importlib
import inspect
import pkgutil
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

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
    """Replace what `owner` has under `name`; a typo would make a mutant of nothing.

    A function has to take what the right one takes: a mutant that fails on a parameter
    that was added later is broken otherwise than it says.
    """
    assert hasattr(owner, name), f"{owner} has no {name}"
    right = getattr(owner, name)
    if inspect.isfunction(right) and inspect.isfunction(wrong):
        _check_parameters(right, wrong)
    setattr(owner, name, wrong)


def _check_parameters(right: Callable[..., object], wrong: Callable[..., Any]) -> None:
    """Fail unless `wrong` can be called with every argument that `right` names."""
    named = inspect.signature(right).parameters.values()
    keywords = {p.name: None for p in named if p.kind is p.KEYWORD_ONLY}
    places = [
        p for p in named if p.kind in (p.POSITIONAL_ONLY, p.POSITIONAL_OR_KEYWORD)
    ]
    try:
        inspect.signature(wrong).bind(*places, **keywords)
    except TypeError as error:
        raise AssertionError(f"instead of {right.__qualname__}: {error}") from error


def load() -> dict[str, Mutant]:
    """All mutants, by name: those of each file in a folder of this one."""
    for module in pkgutil.walk_packages(__path__, f"{__name__}."):
        if not module.ispkg and module.name.count(".") > __name__.count(".") + 1:
            importlib.import_module(module.name)  # which registers its mutants
    return MUTANTS
