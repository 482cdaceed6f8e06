"""Servers that are broken on purpose, to prove that the kit sees it.

A mutant is the reference server with one thing wrong. Its name says what it does wrong,
its docstring what a user would suffer, and `kills` which requirements it breaks: the
kit has to fail exactly those, no more and no fewer.

Each rule has a mutant, and so has each function of the server that decides one. The
folders follow the server: service/ is HTTP, tokens and limits; runs/ the control plane;
turns/ the data plane; profiles/ has a file per profile. Three forms exist:

- `@mutant("RUN-001", through=instead_of(Handlers, "submit_run"))` above a function that
  stands in the place of the right one and gets it as its first argument;
- `@mutant("RUN-001")` above a function without arguments that calls `put` itself;
- `@mutants(Row(…), …)` above a function that is called with a value of its row.
"""

from __future__ import annotations

import functools
import importlib
import inspect
import pkgutil
import sys
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from types import ModuleType
from typing import Any, NamedTuple, TypeVar

Json = dict[str, Any]
Patch = Callable[[], None]
Function = TypeVar("Function", bound=Callable[..., Any])


@dataclass(frozen=True, slots=True)
class Mutant:
    """tries: with how many seeds the kit may look; a race needs luck to be seen.

    needs: profiles to be switched on, besides those of the requirements in `kills`.
    """

    name: str
    kills: frozenset[str]
    user_impact: str
    patch: Patch
    tries: int = 2
    needs: frozenset[str] = frozenset()


class Row(NamedTuple):
    """One mutant of a family whose members break one thing by different values."""

    name: str
    kills: tuple[str, ...]
    user_impact: str
    wrong: Any


MUTANTS: dict[str, Mutant] = {}


def mutant(
    *kills: str,
    through: Callable[[Any], None] | None = None,
    tries: int = 2,
    needs: Iterable[str] = (),
) -> Callable[[Function], Function]:
    """Register a mutant under the name of the decorated function.

    The function patches the server, or is what `through` patches the server with.
    """

    def register(function: Function) -> Function:
        @functools.wraps(function)
        def patch() -> None:
            function() if through is None else through(function)

        user_impact = (function.__doc__ or "").strip()
        name, ids = function.__name__, frozenset(kills)
        _add(Mutant(name, ids, user_impact, patch, tries, frozenset(needs)))
        return function

    return register


def mutants(*rows: Row) -> Callable[[Callable[[Any], None]], Callable[[Any], None]]:
    """Register a mutant per row: the decorated function, called with `row.wrong`."""

    def register(family: Callable[[Any], None]) -> Callable[[Any], None]:
        for name, kills, user_impact, wrong in rows:
            patch = functools.partial(family, wrong)
            _add(Mutant(name, frozenset(kills), user_impact, patch))
        return family

    return register


def _add(added: Mutant) -> None:
    assert added.user_impact, f"{added.name} does not say what a user would suffer"
    assert added.name not in MUTANTS, f"{added.name} exists twice"
    MUTANTS[added.name] = added


def instead_of(owner: object, name: str) -> Callable[[Callable[..., Any]], None]:
    """Replace `owner.name` by a function whose first argument is the right one."""

    def patch(wrong: Callable[..., Any]) -> None:
        right = getattr(owner, name)

        @functools.wraps(right)
        def replacement(*arguments: Any, **named: Any) -> Any:
            return wrong(right, *arguments, **named)

        signature = inspect.signature(wrong)
        _, *parameters = signature.parameters.values()
        replacement.__signature__ = signature.replace(  # type: ignore[attr-defined]
            parameters=parameters
        )
        put(owner, name, replacement)

    return patch


def put(owner: object, name: str, wrong: object) -> None:
    """Replace what `owner` has under `name`; a typo would make a mutant of nothing.

    A function has to take what the right one takes: a mutant that fails on a parameter
    that was added later is broken otherwise than it says. A name that is replaced in
    the module that defines it is replaced in each module that imported it, too.
    """
    assert hasattr(owner, name), f"{owner} has no {name}"
    right = getattr(owner, name)
    if inspect.isfunction(right) and inspect.isfunction(wrong):
        _check_parameters(right, wrong)
    setattr(owner, name, wrong)
    if getattr(right, "__module__", "") == getattr(owner, "__name__", None):
        for module in _importers(name, right):
            setattr(module, name, wrong)


def _importers(name: str, right: object) -> list[ModuleType]:
    """The modules of the server that hold what another module defines."""
    return [
        module
        for path, module in list(sys.modules.items())
        if path.startswith("reference_") and vars(module).get(name) is right
    ]


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
