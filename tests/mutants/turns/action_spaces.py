"""Mutants of actions: which are refused, clipped and filled in."""

from __future__ import annotations

import math
from collections.abc import Mapping
from types import SimpleNamespace
from typing import Any

from reference_server.rules.runs import action_space
from tests.mutants import instead_of, mutant, put

SpaceErrors = list[tuple[str, str]]


def _before_playing(change: Any) -> None:
    """Let `change(values, action_space)` alter every action on its way."""
    right = action_space.clip_actions

    def wrong(actions: Any, manifest: Mapping[str, Any]) -> Any:
        space = manifest["action_space"]
        return right([change(values, space) for values in actions], manifest)

    put(action_space, "clip_actions", wrong)


@mutant("PRED-013")
def accepts_vectors_of_any_length() -> None:
    """A policy for another robot moves this one."""
    right = action_space._vector_errors

    def wrong(at: str, vector: Any, entry: Mapping[str, Any]) -> SpaceErrors:
        padded = [*vector, *[0.0] * entry["size"]][: entry["size"]]
        return right(at, padded, entry)

    put(action_space, "_vector_errors", wrong)
    _before_playing(
        lambda values, space: {
            name: [*vector, *[0.0] * space[name]["size"]][: space[name]["size"]]
            for name, vector in values.items()
        }
    )


@mutant("PRED-014")
def ignores_unknown_names() -> None:
    """A misspelt part of an action is not sent to the robot, without an error."""
    right = action_space.action_errors

    def wrong(actions: Any, manifest: Mapping[str, Any]) -> SpaceErrors:
        space = manifest["action_space"]
        described = [{k: v for k, v in a.items() if k in space} for a in actions]
        return right(described, manifest)

    put(action_space, "action_errors", wrong)
    _before_playing(
        lambda values, space: {k: v for k, v in values.items() if k in space}
    )


@mutant("PRED-015", through=instead_of(action_space, "action_errors"))
def accepts_chunks_of_any_length(
    right: Any, actions: Any, manifest: Mapping[str, Any]
) -> Any:
    """One client can keep a simulator for any time."""
    return right(actions, {**manifest, "max_chunk": len(actions)})


@mutant("PRED-016")
def accepts_numbers_that_are_not_finite() -> None:
    """A policy that has diverged continues to drive the robot."""
    every = {name: getattr(math, name) for name in dir(math)}
    fake = SimpleNamespace(**(every | {"isfinite": lambda _: True}))
    put(action_space, "math", fake)
    from reference_server.generated.models import Action, Predict

    for model in (Action, Predict):
        model.model_config["allow_inf_nan"] = True
        model.model_rebuild(force=True)


@mutant("PRED-017")
def clips_what_it_should_refuse() -> None:
    """A policy in the wrong unit gets a score instead of an error."""
    right = action_space._vector_errors

    def wrong(at: str, vector: Any, entry: Mapping[str, Any]) -> SpaceErrors:
        return right(at, vector, {**entry, "out_of_range": "clip"})

    put(action_space, "_vector_errors", wrong)
    _before_playing(
        lambda values, space: {
            name: action_space._clip(
                vector, (space[name]["minimum"], space[name]["maximum"])
            )
            if space[name]["out_of_range"] == "refuse"
            else vector
            for name, vector in values.items()
        }
    )


@mutant("PRED-018")
def refuses_what_it_should_clip() -> None:
    """A policy that slightly exceeds a limit is refused."""
    right = action_space._vector_errors

    def wrong(at: str, vector: Any, entry: Mapping[str, Any]) -> SpaceErrors:
        if entry["out_of_range"] == "clip":
            entry = {**entry, "out_of_range": "refuse"}
        return right(at, vector, entry)

    put(action_space, "_fits", lambda _values, _space: False)
    put(action_space, "_vector_errors", wrong)


@mutant(
    *("PRED-013", "PRED-014", "PRED-017", "PRED-019"),
    through=instead_of(action_space, "action_errors"),
)
def checks_only_the_first_action(
    right: Any, actions: Any, manifest: Mapping[str, Any]
) -> Any:
    """Half a chunk is executed before the invalid action is found."""
    errors = right(actions[:1], manifest)
    if len(actions) > manifest["max_chunk"]:
        return right(actions, manifest)
    return errors
