"""The tabletop tasks: what counts as done, what is worth how much, what varies."""

from collections.abc import Callable

import numpy as np
import pytest

from reference_sim.benchmarks.tabletop import layout, tasks, variation
from reference_sim.benchmarks.tabletop.benchmark import MAX_STEPS
from reference_sim.benchmarks.tabletop.scene import TabletopScene
from reference_sim.benchmarks.tabletop.tasks import TASKS
from tests.support.sim.physical_play import play
from tests.support.sim.tabletop import (
    TASKS_AND_SPLITS,
    Tabletop,
    expert,
    scene_elements,
    tabletop,
)

CUBE = layout.CUBE_HALF_M
Arrange = Callable[[TabletopScene], None]


@pytest.fixture
def sim() -> Tabletop:
    return tabletop(cameras=False)


# What counts as done


def _drawer(opening_m: float) -> Arrange:
    return lambda scene: scene.world.set_joint_positions(("drawer",), [opening_m])


def _button(travel_m: float) -> Arrange:
    return lambda scene: scene.world.set_joint_positions(("button",), [travel_m])


def _at(*things: tuple[str, float, float, float]) -> Arrange:
    """Each thing: name, x, y, z in m."""

    def arrange(scene: TabletopScene) -> None:
        for thing, x, y, z in things:
            scene.place(thing, x, y, z=z)

    return arrange


def _cubes(second_z: float, x: float, z: float) -> Arrange:
    return _at(("second_cube", 0.4, 0.1, second_z), ("cube", x, 0.1, z))


# The gripper is open at home, some 40 cm ahead and 35 cm up: it touches nothing.
GOALS = {
    "reach": {
        "at it": (_at(("ball", 0.403, 0.0, 0.355)), True),
        "3 cm beside": (_at(("ball", 0.433, 0.0, 0.355)), False),
    },
    "push": {
        "on it": (_at(("disc", 0.4, 0.1, 0), ("cube", 0.42, 0.1, CUBE)), True),
        "beside": (_at(("disc", 0.4, 0.1, 0), ("cube", 0.44, 0.1, CUBE)), False),
        "above": (_at(("disc", 0.4, 0.1, 0), ("cube", 0.4, 0.1, 0.05)), False),
    },
    "lift_cube": {"in the air, not gripped": (_at(("cube", 0.4, 0, 0.2)), False)},
    "pick_and_place": {
        "in it": (_at(("tray", 0.4, 0.1, 0), ("cube", 0.44, 0.1, 0.03)), True),
        "above": (_at(("tray", 0.4, 0.1, 0), ("cube", 0.44, 0.1, 0.06)), False),
        "beside": (_at(("tray", 0.4, 0.1, 0), ("cube", 0.5, 0.1, CUBE)), False),
    },
    "stack": {
        "on it": (_cubes(CUBE, 0.41, 3 * CUBE), True),
        "under it": (_cubes(3 * CUBE, 0.4, CUBE), False),
        "about to topple": (_cubes(CUBE, 0.425, 3 * CUBE), False),
        "above": (_cubes(CUBE, 0.4, 3.5 * CUBE), False),
    },
    "open_drawer": {
        "12.1 cm": (_drawer(0.121), True),
        "11.9 cm": (_drawer(0.119), False),
    },
    "press_button": {
        "9.1 mm": (_button(0.0091), True),
        "8.9 mm": (_button(0.0089), False),
    },
    "insert_peg": {
        "3.1 cm deep": (_at(("hole", 0.4, 0.1, 0), ("peg", 0.402, 0.1, 0.069)), True),
        "2.9 cm deep": (_at(("hole", 0.4, 0.1, 0), ("peg", 0.402, 0.1, 0.071)), False),
        "on the table": (_at(("hole", 0.4, 0.1, 0), ("peg", 0.5, 0.1, 0.05)), False),
    },
}


@pytest.mark.parametrize(
    ("task", "case"), [(task, case) for task, cases in GOALS.items() for case in cases]
)
def test_the_goal_holds_where_it_should(task: str, case: str) -> None:
    arrange, holds = GOALS[task][case]
    scene = TabletopScene()
    scene.reset()
    arrange(scene)
    scene.world.forward()
    assert TASKS[task]().goal_holds(scene) is holds


def test_every_task_has_goal_cases() -> None:
    assert set(GOALS) == set(TASKS)


@pytest.mark.parametrize("task", ["pick_and_place", "stack"])
def test_a_cube_that_is_still_held_is_not_placed(sim: Tabletop, task: str) -> None:
    """The gripper never opens again. Expect all stages but the goal."""
    policy = expert(sim, task, 2)
    steps = len(play(sim, policy, MAX_STEPS))
    policy = expert(sim, task, 2)
    play(sim, policy, steps // 2)
    held = play(sim, lambda seen: {**policy(seen), "gripper": [0.0]}, 60)
    assert not held[-1].success
    assert held[-1].score == pytest.approx(4 / 5)


# What is worth how much


@pytest.mark.parametrize(("task", "split"), TASKS_AND_SPLITS)
def test_scores_grow_by_stages_to_one(sim: Tabletop, task: str, split: str) -> None:
    """An expert's episode. Expect every stage, in order, and 1 only on success."""
    policy = expert(sim, task, 1, split)
    stages = len(TASKS[task]().stages)
    outcomes = play(sim, policy, MAX_STEPS)
    scores = [outcome.score for outcome in outcomes]
    assert outcomes[-1].success
    assert outcomes[-1].terminated
    assert len(outcomes) < 120
    assert scores == sorted(scores)
    assert all((one.score == 1.0) == one.success for one in outcomes)
    assert set(scores) <= {stage / (stages + 1) for stage in range(stages + 2)}
    assert scores[-2] == stages / (stages + 1), "the goal comes after every stage"
    if stages:
        half_done = max(score for score in scores if score < 1)
        assert len(set(scores)) >= 3
        assert 0.5 <= half_done < 1


def test_a_dropped_cube_is_picked_up_again(sim: Tabletop) -> None:
    """The gripper opens on the way up; meanwhile the score stays at its best."""
    policy = expert(sim, "lift_cube", 0)
    up = 2 * CUBE
    while sim.observe().state["cube_pose"][2] < up:
        best = play(sim, policy, 1)[-1].score
    dropping = play(sim, lambda seen: {**policy(seen), "gripper": [1.0]}, 8)
    assert {outcome.score for outcome in dropping} == {best}
    assert sim.observe().state["cube_pose"][2] < up
    assert play(sim, policy, MAX_STEPS)[-1].success


def test_stages_count_in_order_only() -> None:
    """A cube already high up but never gripped has reached none."""
    scene = TabletopScene()
    scene.reset()
    scene.place("cube", 0.5, 0.0, z=0.3)
    scene.world.forward()
    assert not any(tasks.LiftCube().reached(scene))


# What varies


def test_seeds_place_the_cube_differently_and_by_split(sim: Tabletop) -> None:
    """Inside the area in val_train; in a band around it elsewhere."""
    area = tasks.LiftCube.AREA
    around = area.grown(variation.BAND_M)
    for split in variation.SPLITS:
        poses = []
        for seed in range(50):
            sim.reset("lift_cube", seed, split)
            poses.append(sim.observe().state["cube_pose"])
        assert len({tuple(pose) for pose in poses}) == 50
        nominal = split == "val_train"
        assert {area.holds(x, y) for x, y, *_ in poses} == {nominal}
        assert all(around.holds(x, y) for x, y, *_ in poses)
        heights = {float(pose[2]) for pose in poses}
        if nominal:
            assert heights == {CUBE}
        else:
            low, high = (scale * CUBE for scale in variation.CUBE_SCALES)
            assert low <= min(heights) < 0.95 * CUBE
            assert 1.05 * CUBE < max(heights) <= high


def test_unseen_splits_look_different() -> None:
    """The picture of the same seed; and an unseen split differs from seed to seed."""
    sim = tabletop(cameras=True)
    fronts = {}
    for split in variation.SPLITS:
        for seed in (5, 6):
            sim.reset("open_drawer", seed, split)
            fronts[split, seed] = sim.observe().images["front"][-10:].astype(int)
    sim.close()
    nominal = fronts["val_train", 5]
    assert np.array_equal(nominal, fronts["val_train", 6]), "the bare table below"
    for split in ("val_unseen", "test"):
        for seed in (5, 6):
            assert np.abs(fronts[split, seed] - nominal).mean() > 5
        assert np.abs(fronts[split, 5] - fronts[split, 6]).mean() > 1


def test_instructions_name_the_colours_shown() -> None:
    nominal = variation.draw_look(np.random.default_rng(0), "val_train")
    drawn = scene_elements("geom")
    for thing, word in nominal.colours.items():
        shown = tuple(float(number) for number in drawn[thing]["rgba"].split())
        assert shown == variation.COLOURS[word], thing
    for split in ("val_unseen", "test"):
        for seed in range(20):
            look = variation.draw_look(np.random.default_rng(seed), split)
            assert len(set(look.colours.values())) == len(look.colours)
            for thing, word in look.colours.items():
                assert look.rgba[thing] == variation.COLOURS[word]


def test_instructions_differ_by_colour_and_name_no_placeholder(sim: Tabletop) -> None:
    instructions_by_task = {
        task: {sim.reset(task, seed, split) for seed in range(8)}
        for task, split in TASKS_AND_SPLITS
    }
    for task, instructions in instructions_by_task.items():
        for instruction in instructions:
            assert instruction[0].isupper()
            assert instruction.endswith(".")
            assert "{" not in instruction
        coloured = "{" in getattr(TASKS[task], "wording")  # noqa: B009 - not in Task
        assert (len(instructions) > 1) == coloured


def test_an_unknown_split_is_refused(sim: Tabletop) -> None:
    with pytest.raises(KeyError):
        sim.reset("reach", 0, "holiday")


def test_objects_start_with_room_for_the_gripper(sim: Tabletop) -> None:
    """Two hundred arrangements: what is to be gripped stands free."""
    apart = {"pick_and_place": "tray_pose", "insert_peg": "hole_pose"}
    for split in variation.SPLITS:
        for seed in range(30):
            for task, obstacle in apart.items():
                sim.reset(task, seed, split)
                state = sim.observe().state
                thing = "peg_pose" if task == "insert_peg" else "cube_pose"
                distance = np.hypot(*(state[thing] - state[obstacle])[:2])
                assert distance >= 0.14
            sim.reset("stack", seed, split)
            state = sim.observe().state
            between = state["cube_pose"] - state["second_cube_pose"]
            assert np.hypot(*between[:2]) >= tasks.Stack.APART_M
