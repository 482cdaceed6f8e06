"""The content of the page of an episode: names, units, constants, stages."""

import math
from collections.abc import Sequence
from typing import Any

import msgspec
import pytest

from reference_record.pages.episode_plots import (
    component_labels,
    fold_constants,
    plot_data,
)
from reference_record.pages.recorded_episode import RecordedEpisode
from reference_record.recordings.recording import Turn


def space(size: int, unit: str, **more: Any) -> dict[str, Any]:
    return {"size": size, "unit": unit, "rotation": "none", "frame": "none"} | more


POSE = [("x", "m"), ("y", "m"), ("z", "m")]
QUATERNION = [("qw", ""), ("qx", ""), ("qy", ""), ("qz", "")]


@pytest.mark.parametrize(
    ("size", "described", "labels"),
    [
        pytest.param(1, space(1, "s"), [("v", "s")], id="single"),
        pytest.param(
            2, space(2, "rad", frame="joint"),
            [("joint 1", "rad"), ("joint 2", "rad")], id="joints",
        ),
        pytest.param(
            7, space(7, "m,1", rotation="quaternion_wxyz"),
            [*POSE, *QUATERNION], id="pose",
        ),
        pytest.param(
            6, space(6, "m,m,m,rad,rad,rad", rotation="euler_xyz"),
            [*POSE, ("roll", "rad"), ("pitch", "rad"), ("yaw", "rad")], id="each-unit",
        ),
        pytest.param(3, space(3, "m"), POSE, id="position"),
        pytest.param(
            3, space(3, "N"), [(f"v[{i}]", "N") for i in range(3)], id="no-convention"
        ),
        pytest.param(
            2, space(2, "m", rotation="rot6d_columns"), [("x", "m"), ("y", "m")],
            id="a-rotation-that-does-not-fit",
        ),
        pytest.param(2, space(7, "rad"), [("v[0]", ""), ("v[1]", "")], id="other-size"),
        pytest.param(2, None, [("v[0]", ""), ("v[1]", "")], id="not-known"),
    ],
)  # fmt: skip
def test_numbers_have_names_and_units(
    size: int, described: dict[str, Any] | None, labels: list[tuple[str, str]]
) -> None:
    assert component_labels("v", size, described) == labels


def turn(score: float = 0.0, **values: float) -> Turn:
    actions = [{name: [value] for name, value in values.items()}]
    return Turn(1, 1, actions, [0.0], 1, score, False, False, "d", 1.0, 2.0, "t")


def test_turns_are_counted_in_the_episode() -> None:
    """A session counts those of all its episodes: the first may be the 1925th."""
    played = [msgspec.structs.replace(turn(a=1), seq=seq) for seq in (1925, 1926)]
    assert plot_data(RecordedEpisode(played))["turns"] == [1, 2]


def plots_of(data: dict[str, Any]) -> list[str]:
    return [plot["name"] for group in data["groups"] for plot in group["plots"]]


def test_a_number_that_never_changes_is_listed() -> None:
    """Two plays that are shown together: only if both have the same value."""
    first = plot_data(RecordedEpisode([turn(a=1, b=2, c=3), turn(a=1, b=2, c=4)]))
    second = plot_data(RecordedEpisode([turn(a=1, b=5, c=3), turn(a=1, b=5, c=3)]))
    alone = plot_data(RecordedEpisode([turn(a=1, b=2, c=3), turn(a=1, b=2, c=4)]))
    assert fold_constants([alone])[:2] == ["a 1", "b 2"]
    assert plots_of(alone) == ["c"]
    assert "a 1" in fold_constants([first, second])
    assert plots_of(first) == plots_of(second) == ["b", "c"]


@pytest.mark.parametrize(
    ("scores", "successes", "steps"),
    [
        pytest.param([0, 1 / 3, 2 / 3, 1], "---+", [2, 3, 4], id="one-after-another"),
        pytest.param([0.34, 0.34], "--", [1, None, None], id="first-only"),
        pytest.param([0, 1], "-+", [2, 2, 2], id="the-goal-implies-all"),
        pytest.param([0], "-", [None] * 3, id="none"),
        pytest.param([], "", [None] * 3, id="no-turn"),
        pytest.param([1e300, math.inf, math.nan], "---", [1, 1, None], id="hostile"),
        pytest.param([0.6], "+", [1, 1, 1], id="success-with-a-lower-score"),
        pytest.param([1, 1 / 3], "++", [1, 1, 1], id="success-of-any-step"),
        pytest.param([1, 1 / 3], "+-", [1, 1, None], id="success-that-was-lost"),
        pytest.param([1, 0, 1], "+-+", [1, 1, 3], id="success-of-the-last-step"),
        pytest.param([1, 1], "--", [1, 1, None], id="score-without-success"),
    ],
)
def test_stages_are_reached(
    scores: Sequence[float], successes: str, steps: list[int | None]
) -> None:
    """The goal is reached in the episodes that succeed, and in no other."""
    turns = [
        msgspec.structs.replace(turn(score), success=flag == "+")
        for score, flag in zip(scores, successes, strict=True)
    ]
    names = ["a", "b", "goal"]
    shown = RecordedEpisode(turns, stages=["a", "b"]).stages_reached
    assert shown == list(zip(names, steps, strict=True))
    assert (shown[-1][1] is not None) is successes.endswith("+")
    assert RecordedEpisode(turns).stages_reached == [], "none is known"
    assert RecordedEpisode(turns, stages=names).stages_reached == [], "it counts it"
