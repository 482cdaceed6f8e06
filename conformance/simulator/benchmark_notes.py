"""Notes on likely mistakes of a simulator that break no rule of its protocol."""

import contextlib
import re
from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from conformance.cli.kit_command import close_names
from conformance.client.check_context import CheckContext
from conformance.client.request_context import SharedContext
from conformance.run_settings import Settings
from conformance.simulator.description_faults import MEMBERS, OBSERVED
from conformance.simulator.simulator_client import (
    STEPS,
    known_members,
    simulator,
    tasks_of,
)
from conformance.specification.document import load_spec
from conformance.verdicts.expect import SetUpFailed

# A name of others begins with a domain in reverse; underscores stand for its dots.
_EXTENSION = re.compile(
    r"(?:[a-z]{2}|com|dev|edu|gov|info|net|org)_[a-z0-9]\w*_\w+", re.ASCII
)


def notes_on_members(benchmark: Mapping[str, Any]) -> Iterator[str]:
    """One for each member that a server ignores, of a description without faults."""
    observed = benchmark["observation_space"]
    yield from _notes_on_map("", benchmark, MEMBERS)
    yield from _notes_on_map("observation_space.", observed, OBSERVED)
    groups = {"action_space": ("VectorSpace", benchmark["action_space"])}
    for group, schema in OBSERVED.items():
        groups[f"observation_space.{group}"] = schema, observed.get(group, {})
    for group, (schema, spaces) in groups.items():
        for name, space in spaces.items():
            at = f"{group}.{name}."
            yield from _notes_on_map(at, space, _properties(schema))
            for part, members in space.get("parts", {}).items():
                known = _properties("VectorPart")
                yield from _notes_on_map(f"{at}parts.{part}.", members, known)


def _properties(schema: str) -> Mapping[str, Any]:
    properties: Mapping[str, Any] = load_spec().schema(schema)["properties"]
    return properties


def notes_on_replies(settings: Settings) -> Iterator[str]:
    """One for each member of an episode that a server ignores."""
    shared = SharedContext.of(settings)
    try:
        context = CheckContext(shared, "replies")
        with contextlib.suppress(SetUpFailed), simulator(context) as client:
            for task in tasks_of(context):
                replies = client.play(task, settings.seed, steps=1)
                for call, reply in zip(("reset", "step"), replies, strict=False):
                    known = known_members(call)
                    yield from _notes_on_map("", reply, known, f"`{call}` of {task}")
    finally:
        shared.close()


def _notes_on_map(
    at: str,
    members: Mapping[str, Any],
    known: Iterable[str],
    what: str = "its description",
) -> Iterator[str]:
    for name in members:
        if name not in known and not _EXTENSION.fullmatch(name):
            meant = close_names(name, known) or f"; there is {', '.join(known)}"
            yield f"{what} has `{at}{name}`, which is ignored{meant}"


def notes_on_seeds(settings: Settings) -> Iterator[str]:
    """One where two seeds give the same episode, of a simulator that repeats itself.

    That may be meant; then its description has splits of one seed.
    """
    benchmark, seed = settings.simulator["benchmark"], settings.seed
    splits = benchmark.get("splits") or [{}]
    if all(
        len(split.get("seeds", ())) == 1 or split.get("episodes") == 1
        for split in splits
    ):
        return
    shared = SharedContext.of(settings)
    try:
        context = CheckContext(shared, "seeds")
        with contextlib.suppress(SetUpFailed), simulator(context) as client:
            played = {"observed": True, "digested": bool(benchmark.get("digest"))}
            alike = [
                task
                for task in tasks_of(context)
                if client.play(task, seed, **played)
                == client.play(task, seed + 1, **played)
            ]
            if alike:
                yield (
                    f"seeds {seed} and {seed + 1} give the same episode of "
                    f"{', '.join(alike)} ({STEPS} steps, all that is observed): does "
                    "its `reset` use the seed? If it is meant so, give each split one "
                    "seed: more are copies of one episode"
                )
    finally:
        shared.close()
