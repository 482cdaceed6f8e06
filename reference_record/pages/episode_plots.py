"""The plots of a recorded episode: its actions by name and unit, rewards, score, times.

A plot shows one number over the steps. State is not recorded, only digests of it.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from typing import Any, Final

from reference_record.contents.declared_parts import (
    ROTATION_NUMBERS,
    DeclaredPart,
    declared_parts,
)
from reference_record.pages.recorded_episode import RecordedEpisode
from reference_record.recordings.recording import Turn

# Beyond this, a plot would have more points than a screen has.
POINTS_MAX: Final = 4000
SERIES_MAX: Final = 64
DIGITS: Final = 5
# Steps of a second where the benchmark does not say it.
RATE_HZ: Final = 10.0
OUTCOME_GROUP: Final = "score and times of turns"
Series = list[float | None]


def plot_data(
    episode: RecordedEpisode,
    action_space: Mapping[str, Any] | None = None,
    control_rate_hz: float | None = None,
) -> dict[str, Any]:
    """The content of the plots as JSON.

    action_space: name → schema VectorSpace, for names and units of the numbers.
    groups: each with a title and its plots; a plot has name, unit, values, and which
    column of `x` they belong to. Long episodes are thinned out.
    """
    total = episode.steps
    stride = max(1, math.ceil(total / POINTS_MAX))
    steps, rewards, columns = _columns(episode.turns, stride)
    groups: list[dict[str, Any]] = []
    for name, series in columns.items():
        labels = component_labels(name, len(series), (action_space or {}).get(name))
        plots = [
            {"name": label, "unit": unit, "x": "step", "y": values}
            for (label, unit), values in zip(labels, series, strict=True)
        ]
        groups.append({"title": name, "plots": plots})
    turns = _turn_columns(episode.turns)
    return {
        "total": total,
        "rate": control_rate_hz or RATE_HZ,
        "x": {"step": steps, "first": turns["first"], "last": turns["last"]},
        "groups": [*groups, *_outcome_groups(turns, rewards)],
        "turns": turns["turn"],
        "think_ms": turns["think_ms"],
    }


def fold_constants(data: Sequence[Mapping[str, Any]]) -> list[str]:
    """Remove the plots of what had one value in all plays; returns it as texts.

    data: `plot_data` of each play that is shown together.
    """
    values: dict[tuple[str, str], set[float | None]] = {}
    units: dict[tuple[str, str], str] = {}
    for play in data:
        for group in play["groups"]:
            for plot in group["plots"]:
                key = group["title"], plot["name"]
                values.setdefault(key, set()).update(plot["y"])
                units[key] = plot["unit"]
    constant = {key: value for key, (value, *more) in _ordered(values) if not more}
    for play in data:
        for group in play["groups"]:
            group["plots"] = [
                plot
                for plot in group["plots"]
                if (group["title"], plot["name"]) not in constant
            ]
        play["groups"][:] = [group for group in play["groups"] if group["plots"]]
    return [
        f"{_whole_name(*key)} {value:g} {units[key]}".rstrip()
        for key, value in constant.items()
        if value is not None
    ]


def _ordered(
    values: Mapping[tuple[str, str], set[float | None]],
) -> Iterator[tuple[tuple[str, str], list[float | None]]]:
    return ((key, list(seen)) for key, seen in values.items() if seen)


def _whole_name(title: str, name: str) -> str:
    return name if title in (name, OUTCOME_GROUP) else f"{title} {name}"


def component_labels(
    name: str, size: int, space: Mapping[str, Any] | None
) -> list[tuple[str, str]]:
    """Name and unit of each number of a vector, by the conventions of its parts.

    A unit of 1, or one that is not known, is an empty text.
    """
    if not space or space.get("size") != size:
        space = {"size": size}
    parts = declared_parts(space)
    labels: list[tuple[str, str]] = []
    for part_name, part in parts.items():
        alone = len(parts) == 1
        unit = "" if part.unit == "unspecified" else part.scaled_unit
        own = _number_names(name if alone else part_name, part)
        labels += [(label, unit) for label in own]
    counts = Counter(label for label, _ in labels)
    owners = [part_name for part_name, part in parts.items() for _ in range(part.size)]
    return [
        (label if counts[label] == 1 else f"{owner} {label}", unit)
        for (label, unit), owner in zip(labels, owners, strict=True)
    ]


def _number_names(name: str, part: DeclaredPart) -> Sequence[str]:
    numbers = ROTATION_NUMBERS.get(part.rotation, ())
    if len(numbers) == part.size:
        return numbers
    if part.frame == "joint" and part.size > 1:
        return [f"joint {number}" for number in range(1, part.size + 1)]
    if part.size in (2, 3) and (part.quantity == "position" or part.unit == "m"):
        return ("x", "y", "z")[: part.size]
    return [name] if part.size == 1 else [f"{name}[{at}]" for at in range(part.size)]


def _columns(
    turns: Sequence[Turn], stride: int
) -> tuple[list[int], Series, dict[str, list[Series]]]:
    """The steps that are drawn, their rewards, and the series of each action name."""
    steps: list[int] = []
    rewards: Series = []
    columns: dict[str, list[Series]] = {}
    step = 0
    for turn in turns:
        for action, reward in zip(turn.actions, turn.rewards, strict=False):
            step += 1
            if (step - 1) % stride:
                continue
            _add_action(columns, action, len(steps))
            steps.append(step)
            rewards.append(_short(reward))
    for series in columns.values():
        for column in series:
            column.extend([None] * (len(steps) - len(column)))
    return steps, rewards, columns


def _add_action(
    columns: dict[str, list[Series]], action: Mapping[str, Sequence[float]], at: int
) -> None:
    drawn = sum(map(len, columns.values()))
    for name, values in action.items():
        if name not in columns:
            room = min(len(values), SERIES_MAX - drawn)
            if room <= 0:
                continue
            columns[name] = [[] for _ in range(room)]
            drawn += room
        for column, value in zip(columns[name], values, strict=False):
            column.extend([None] * (at - len(column)))
            column.append(_short(value))


def _outcome_groups(
    turns: Mapping[str, list[Any]], rewards: Series
) -> list[dict[str, Any]]:
    """Score, reward and times, each where it says anything."""
    plots: list[dict[str, Any]] = []
    if any(rewards):
        plots.append({"name": "reward", "unit": "", "x": "step", "y": rewards})
    if len(turns["last"]) > 1:
        plots = [
            {"name": "score", "unit": "", "x": "last", "y": turns["score"]},
            *plots,
            {"name": "policy time", "unit": "ms", "x": "first", "y": turns["think_ms"]},
            {"name": "simulator time", "unit": "ms", "x": "first",
             "y": turns["simulate_ms"]},
        ]  # fmt: skip
    return [{"title": OUTCOME_GROUP, "plots": plots}] if plots else []


def _turn_columns(turns: Sequence[Turn]) -> dict[str, list[Any]]:
    """Columns of the turns that are drawn: first and last step, times and score.

    turn: its number in the episode, from 1; a session counts those of all its episodes.
    """
    stride = max(1, math.ceil(len(turns) / POINTS_MAX))
    names = ("turn", "first", "last", "think_ms", "simulate_ms", "score")
    columns: dict[str, list[Any]] = {name: [] for name in names}
    last = 0
    for number, turn in enumerate(turns, start=1):
        first, last = last + 1, last + turn.steps
        if (number - 1) % stride:
            continue
        columns["turn"].append(number)
        columns["first"].append(first)
        columns["last"].append(last)
        columns["think_ms"].append(_short(turn.think_ms))
        columns["simulate_ms"].append(_short(turn.simulate_ms))
        columns["score"].append(_short(turn.score))
    return columns


def _short(value: float) -> float | None:
    """Five digits: a file is half as long, and a plot the same."""
    return float(f"{value:.{DIGITS}g}") if math.isfinite(value) else None
