"""The tabletop world: always the same way, and as it was declared.

These tests draw pictures; where nothing can be drawn they fail with the apt command
that changes it. None is skipped.
"""

import math
from collections.abc import Iterator

import numpy as np
import pytest

from reference_sim.benchmarks.tabletop import benchmark, layout, variation
from reference_sim.benchmarks.tabletop.experts import tabletop_arm
from reference_sim.benchmarks.tabletop.scene import scene_mjcf
from reference_sim.benchmarks.tabletop.tasks import TASKS
from reference_sim.interface import Action, TaskUnplayable
from reference_sim.mujoco.kinematics import ArmKinematics
from reference_sim.mujoco.world import SimulationDiverged, World
from tests.support.sim.physical_play import observation_digest, play
from tests.support.sim.tabletop import (
    HEIGHT,
    HOME,
    TASKS_AND_SPLITS,
    WIDTH,
    Tabletop,
    expert,
    scene_elements,
    scripted_motion,
    tabletop,
)

pytestmark = pytest.mark.slow("simulates and draws for seconds")


@pytest.fixture
def sim() -> Iterator[Tabletop]:
    """State only."""
    yield from _closing(tabletop(cameras=False))


@pytest.fixture
def seeing_sim() -> Iterator[Tabletop]:
    """With cameras."""
    yield from _closing(tabletop(cameras=True))


def _closing(sim: Tabletop) -> Iterator[Tabletop]:
    yield sim
    sim.close()


# The same way each time


def digest(simulator: Tabletop) -> str:
    return observation_digest(simulator.observe())


def assert_same_view(one: Tabletop, other: Tabletop) -> None:
    seen = one.observe(), other.observe()
    assert observation_digest(seen[0]) == observation_digest(seen[1])


def test_reset_restores_the_initial_state(sim: Tabletop) -> None:
    """A thing gripped, another size, score above zero: nothing of it is left."""
    for (before, look), (task, split) in zip(
        TASKS_AND_SPLITS[4:] + TASKS_AND_SPLITS[:4], TASKS_AND_SPLITS, strict=True
    ):
        play(sim, expert(sim, before, 3, look), 22)
        fresh = tabletop(cameras=False)
        for one in (sim, fresh):
            one.reset(task, 11, split)
        assert sim.snapshot().stages_reached == 0
        assert sim.snapshot().world.tobytes() == fresh.snapshot().world.tobytes()
        for _ in range(3):
            assert sim.step(HOME) == fresh.step(HOME)
            assert_same_view(sim, fresh)


def test_reset_restores_the_appearance(seeing_sim: Tabletop) -> None:
    """Colours, camera and light of an unseen split, seen or not, leave no trace."""
    for split in variation.SPLITS:
        fresh = tabletop(cameras=True)
        for look in variation.SPLITS:
            seeing_sim.reset("stack", 3, look)
            seeing_sim.observe()
        for one in (seeing_sim, fresh):
            one.reset("push", 11, split)
        assert digest(seeing_sim) == digest(fresh)
        fresh.close()


def test_rendering_changes_no_physics(sim: Tabletop, seeing_sim: Tabletop) -> None:
    for simulator in (sim, seeing_sim):
        simulator.reset("stack", 5, "test")
    policy, same_policy = scripted_motion(), scripted_motion()
    for _ in range(20):
        assert digest(seeing_sim) == digest(seeing_sim)
        seen = seeing_sim.observe()
        assert sim.step(policy(seen)) == seeing_sim.step(same_policy(seen))
    assert sim.snapshot().world.tobytes() == seeing_sim.snapshot().world.tobytes()


@pytest.mark.parametrize(("task", "split"), TASKS_AND_SPLITS)
def test_a_snapshot_continues_exactly(task: str, split: str) -> None:
    """Half way and while the goal is being held, in a world that played another."""
    sim, other = tabletop(cameras=False), tabletop(cameras=False)
    whole = len(play(sim, expert(sim, task, 3, split), benchmark.MAX_STEPS))
    for steps_before in (whole // 2, whole - 1):
        policy = expert(sim, task, 3, split)
        play(sim, policy, steps_before)
        snapshot = sim.snapshot()
        play(other, expert(other, "insert_peg", 40, "val_unseen"), 15)
        other.restore(snapshot)
        assert other.snapshot().world.tobytes() == snapshot.world.tobytes()
        success = False
        while not success:
            assert digest(other) == digest(sim)
            action = policy(sim.observe())
            outcome = sim.step(action)
            assert other.step(action) == outcome
            success = outcome.success


def test_a_scaled_body_moves_like_a_compiled_one() -> None:
    """Size, inertia and what the solver derives of them, against the XML's own."""
    factor = 1.1
    half = scene_elements("geom")["cube"]["size"]
    assert scene_mjcf().count(half) == 2  # the second cube's as well
    larger = " ".join(str(float(side) * factor) for side in half.split())
    made = scene_mjcf().replace(half, larger)
    nominal, compiled = World(scene_mjcf()), World(made)
    scaled = World(scene_mjcf())
    scaled.scale_body("cube", factor)
    for world in (nominal, compiled, scaled):
        world.set_gravity_compensation("cube", 0.0)
        world.set_free_pose("cube", (0.45, 0, 0.1, 0.9, 0.3, 0.3, 0.1))  # on an edge
        world.advance(80)
    landed = compiled.body_pose("cube")
    assert scaled.body_pose("cube") == pytest.approx(landed, abs=1e-9)
    assert nominal.body_pose("cube") != pytest.approx(landed, abs=1e-3)


# What a policy sends and sees


def test_images_are_upright_and_change_with_motion(seeing_sim: Tabletop) -> None:
    seeing_sim.reset("lift_cube", 2)
    before = seeing_sim.observe().images
    assert tuple(before) == layout.CAMERAS
    for image in before.values():
        assert image.shape == (HEIGHT, WIDTH, 3)
        assert image.dtype == np.uint8
        assert len(np.unique(image.reshape(-1, 3), axis=0)) > 50
    red, _, blue = before["front"].astype(int).mean(axis=1).T
    assert blue[0] >= red[0], "the wall is on top"
    assert red[-1] > blue[-1] + 20, "the wooden table is below"
    r, g, b = before["front"].astype(int).reshape(-1, 3).T
    assert np.count_nonzero((r > 2 * g) & (r > 2 * b)) > 5, "the cube is red"
    play(seeing_sim, scripted_motion(), 10)
    after = seeing_sim.observe().images
    for camera in layout.CAMERAS:
        assert np.count_nonzero(before[camera] != after[camera]) > 500, camera


def test_standard_quality_draws_shadows() -> None:
    plain = tabletop(cameras=True)
    shaded = tabletop(cameras=True, quality="standard")
    for sim in (plain, shaded):
        sim.reset("lift_cube", 2)
    front = plain.observe().images["front"], shaded.observe().images["front"]
    assert front[1].mean() < front[0].mean() - 1
    plain.close()
    shaded.close()


def test_targets_beyond_their_bounds_are_clipped(sim: Tabletop) -> None:
    farthest: Action = {"joint_position": layout.JOINT_HIGH_RAD, "gripper": [1.0]}
    beyond: Action = {"joint_position": [1e300] * 7, "gripper": [1e300]}
    ends = []
    for action in (farthest, beyond):
        sim.reset("lift_cube", 0)
        sim.step(action)
        ends.append(observation_digest(sim.observe()))
    assert ends[0] == ends[1]


@pytest.mark.parametrize("task", TASKS)
def test_the_state_has_the_declared_channels(sim: Tabletop, task: str) -> None:
    """The same in every task, in the order declared."""
    sim.reset(task, 0)
    state = sim.observe().state
    assert [(name, values.shape) for name, values in state.items()] == [
        (channel.name, (channel.size,)) for channel in layout.STATE_CHANNELS
    ]
    assert {values.dtype for values in state.values()} == {np.dtype(np.float64)}
    assert state["joint_position"] == pytest.approx(layout.HOME_RAD)
    assert state["gripper"] == pytest.approx([1.0])
    assert state["ee_pose"][3:] == pytest.approx([0, 0, 1, 0], abs=1e-9)


def test_unused_objects_stay_parked(sim: Tabletop) -> None:
    """Its pose says so: farther than 2 m. What has a part is within reach."""
    parts = {
        "reach": {"ball_position"},
        "push": {"cube_pose", "disc_position"},
        "lift_cube": {"cube_pose"},
        "pick_and_place": {"cube_pose", "tray_pose"},
        "stack": {"cube_pose", "second_cube_pose"},
        "open_drawer": {"handle_pose"},
        "press_button": {"button_position"},
        "insert_peg": {"peg_pose", "hole_pose"},
    }
    assert set(parts) == set(TASKS)
    for task, named in parts.items():
        sim.reset(task, 4, "test")
        first = sim.observe().state
        play(sim, scripted_motion(), 30)
        later = sim.observe().state
        for name in first:
            is_pose = name.endswith(("_pose", "_position"))
            if not is_pose or name.startswith(("ee", "joint")):
                continue
            distance = float(np.linalg.norm(first[name][:3]))
            assert (distance < 0.7) == (name in named), (task, name)
            if name not in named:
                assert distance > 2
                assert later[name] == pytest.approx(first[name], abs=1e-9)


def test_constants_agree_with_the_scene() -> None:
    world = World(scene_mjcf())
    declared = np.array([layout.JOINT_LOW_RAD, layout.JOINT_HIGH_RAD]).T
    assert np.array_equal(world.joint_ranges(layout.JOINTS), declared)
    strokes = np.array([[0, layout.FINGER_STROKE_M]] * 2)
    assert np.array_equal(world.joint_ranges(layout.FINGERS), strokes)
    travels = np.array([[0, layout.DRAWER_TRAVEL_M], [0, layout.BUTTON_TRAVEL_M]])
    assert np.array_equal(world.joint_ranges(("drawer", "button")), travels)
    assert math.isclose(world.timestep_s * layout.SUBSTEPS, 1 / layout.CONTROL_RATE_HZ)
    numbers = {
        name: [float(number) for number in element["size"].split()]
        for name, element in scene_elements("geom").items()
    }
    (x, y, z) = scene_elements("camera")["front"]["pos"].split()
    assert (float(x), float(y), float(z)) == layout.CAMERA_POSITION_M
    assert numbers["cube"] == numbers["second_cube"] == [layout.CUBE_HALF_M] * 3
    assert numbers["peg"][2] == layout.PEG_HALF_LENGTH_M


def test_an_unknown_task_is_unplayable(sim: Tabletop) -> None:
    with pytest.raises(TaskUnplayable, match="juggle"):
        sim.reset("juggle", 0)
    with pytest.raises(RuntimeError, match="reset"):
        sim.observe()


def test_a_diverged_simulation_raises() -> None:
    world = World(scene_mjcf())
    world.set_joint_positions(layout.JOINTS, [math.nan] * 7)
    with pytest.raises(SimulationDiverged):
        world.advance(1)


# The arm


@pytest.fixture
def arm() -> ArmKinematics:
    return tabletop_arm()


def test_inverse_kinematics_reaches_the_target(arm: ArmKinematics) -> None:
    rng = np.random.Generator(np.random.PCG64(0))
    for _ in range(50):
        joints = np.array(layout.HOME_RAD) + rng.uniform(-0.4, 0.4, 7)
        target = arm.forward(joints)
        reached = arm.forward(arm.inverse(target, layout.HOME_RAD))
        assert reached[:3] == pytest.approx(target[:3], abs=1e-4)
        assert abs(reached[3:] @ target[3:]) == pytest.approx(1, abs=1e-6)


def test_an_unreachable_pose_ends_within_the_limits(arm: ArmKinematics) -> None:
    far = np.array([3.0, 0.0, 0.2, 0, 0, 1, 0])
    joints = arm.inverse(far, layout.HOME_RAD)
    assert np.all(joints >= layout.JOINT_LOW_RAD)
    assert np.all(joints <= layout.JOINT_HIGH_RAD)
