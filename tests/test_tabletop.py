"""The tabletop benchmark: it can be solved, not by luck, and always the same way.

These tests draw pictures; where nothing can be drawn they fail with the apt command
that changes it. None is skipped.
"""

from __future__ import annotations

import hashlib
import json
import math
import multiprocessing
from collections.abc import Callable, Iterator
from concurrent.futures import ProcessPoolExecutor

import numpy as np
import pytest

from reference_sim import tabletop
from reference_sim.tabletop.experts import LiftCubeExpert
from reference_sim.interface import (
    Action,
    Observation,
    Simulator,
    StepOutcome,
    TaskUnplayable,
)
from reference_sim.kinematics import ArmKinematics
from reference_sim.mujoco_world import SimulationDiverged, World
from reference_sim.tabletop import LiftCube, Scene, Tabletop

WIDTH, HEIGHT = 64, 48
HOME: Action = {"joint_position": list(tabletop.HOME_RAD), "gripper": [1.0]}

Policy = Callable[[Observation], Action]


@pytest.fixture
def sim() -> Iterator[Tabletop]:
    """State only."""
    yield from _closing(Tabletop(WIDTH, HEIGHT, cameras=False))


@pytest.fixture
def seeing_sim() -> Iterator[Tabletop]:
    """With cameras."""
    yield from _closing(Tabletop(WIDTH, HEIGHT))


def _closing(sim: Tabletop) -> Iterator[Tabletop]:
    yield sim
    sim.close()


def play(sim: Simulator, policy: Policy, steps: int) -> list[StepOutcome]:
    """Plays on until the task ends or the steps are used up."""
    outcomes: list[StepOutcome] = []
    while len(outcomes) < steps and not (outcomes and outcomes[-1].terminated):
        outcomes.append(sim.step(policy(sim.observe())))
    return outcomes


def expert(sim: Simulator, seed: int) -> Policy:
    """Begins an episode; the expert's actions pass through JSON, as over the wire."""
    lifter = LiftCubeExpert()
    lifter.reset(sim.reset("lift_cube", seed))

    def act(seen: Observation) -> Action:
        state = {name: values.tolist() for name, values in seen.state.items()}
        action: Action = json.loads(
            json.dumps(lifter.act(json.loads(json.dumps(state))))
        )
        return action

    return act


def waving() -> Policy:
    """The same lively actions each time, whatever is seen."""
    swing = np.random.Generator(np.random.PCG64(99))
    reach = np.array([0.5, 0.9, 0.3, 1.0, 0.5, 1.0, 0.5])

    def act(_: Observation) -> Action:
        joints = reach * swing.uniform(-0.2, 1.0, 7)
        return {"joint_position": joints.tolist(), "gripper": [swing.uniform()]}

    return act


def bits(seen: Observation) -> str:
    digest = hashlib.sha256()
    for name, values in sorted(seen.state.items()):
        digest.update(name.encode() + values.tobytes())
    for name, image in sorted(seen.images.items()):
        digest.update(name.encode() + image.tobytes())
    return digest.hexdigest()


def waving_bits(seed: int) -> list[str]:
    """Two episodes' observations, images included; also run by a second process."""
    sim = Tabletop(WIDTH, HEIGHT)
    seen = []
    for episode in (seed, seed + 1):
        sim.reset("lift_cube", episode)
        seen.append(bits(sim.observe()))
        policy = waving()
        for _ in range(12):
            play(sim, policy, 2)
            seen.append(bits(sim.observe()))
    sim.close()
    return seen


# The same way each time


def test_another_process_sees_the_same_bits() -> None:
    spawn = multiprocessing.get_context("spawn")
    with ProcessPoolExecutor(1, mp_context=spawn) as other:
        theirs = other.submit(waving_bits, 7)
        ours = waving_bits(7)
        assert theirs.result(timeout=60) == ours
    assert len(set(ours)) == len(ours), (
        "an observation that never changes proves little"
    )


def test_reset_forgets_a_dirty_episode(seeing_sim: Tabletop) -> None:
    """A cube in the gripper, warm solver, score above zero: nothing of it is left."""
    play(seeing_sim, expert(seeing_sim, 3), 25)
    fresh = Tabletop(WIDTH, HEIGHT)
    for sim in (seeing_sim, fresh):
        sim.reset("lift_cube", 11)
    assert seeing_sim.snapshot().world.tobytes() == fresh.snapshot().world.tobytes()
    assert seeing_sim.snapshot().score == 0.0
    for _ in range(10):
        assert bits(seeing_sim.observe()) == bits(fresh.observe())
        assert seeing_sim.step(HOME) == fresh.step(HOME)
    fresh.close()


def test_seeds_place_the_cube_differently_and_within_bounds(sim: Tabletop) -> None:
    poses = []
    for seed in range(50):
        sim.reset("lift_cube", seed)
        poses.append(sim.observe().state["cube_pose"])
    x, y, z = np.array(poses)[:, :3].T
    assert len({tuple(pose) for pose in poses}) == 50
    assert LiftCube.CUBE_X_M[0] <= x.min() < x.max() <= LiftCube.CUBE_X_M[1]
    assert LiftCube.CUBE_Y_M[0] <= y.min() < y.max() <= LiftCube.CUBE_Y_M[1]
    assert set(z) == {tabletop.CUBE_HALF_M}


def test_looking_does_not_change_what_happens(
    sim: Tabletop, seeing_sim: Tabletop
) -> None:
    for simulator in (sim, seeing_sim):
        simulator.reset("lift_cube", 5)
    policy, same_policy = waving(), waving()
    for _ in range(20):
        assert bits(seeing_sim.observe()) == bits(seeing_sim.observe())
        seen = seeing_sim.observe()
        assert sim.step(policy(seen)) == seeing_sim.step(same_policy(seen))
    assert sim.snapshot().world.tobytes() == seeing_sim.snapshot().world.tobytes()


@pytest.mark.parametrize("steps_before", [4, 22, 29])
def test_a_snapshot_continues_exactly(seeing_sim: Tabletop, steps_before: int) -> None:
    """In the air, with the cube gripped, and while the goal is being held."""
    policy = expert(seeing_sim, 3)
    play(seeing_sim, policy, steps_before)
    snapshot = seeing_sim.snapshot()
    other = Tabletop(WIDTH, HEIGHT)
    play(other, expert(other, 40), 15)
    other.restore(snapshot)
    assert other.snapshot().world.tobytes() == snapshot.world.tobytes()
    success = False
    while not success:
        assert bits(other.observe()) == bits(seeing_sim.observe())
        action = policy(seeing_sim.observe())
        outcome = seeing_sim.step(action)
        assert other.step(action) == outcome
        success = outcome.success
    other.close()


# Solvable, not by luck


def test_the_expert_lifts_the_cube_and_the_score_grows(sim: Tabletop) -> None:
    for seed in range(20):
        outcomes = play(sim, expert(sim, seed), LiftCube.max_steps)
        scores = [outcome.score for outcome in outcomes]
        assert outcomes[-1].success, f"seed {seed}"
        assert outcomes[-1].terminated
        assert len(outcomes) < 120
        assert scores == sorted(scores)
        assert all((one.score == 1.0) == one.success for one in outcomes)
        assert {0.0, 0.2, 0.4} < set(scores), "reached and gripped count on their own"


def test_the_expert_fetches_a_cube_it_lost(sim: Tabletop) -> None:
    """Meanwhile the score stays at its best."""
    policy = expert(sim, 0)
    best = play(sim, policy, 27)[-1].score
    assert sim.observe().state["cube_pose"][2] > 2 * tabletop.CUBE_HALF_M
    dropping = play(sim, lambda seen: {**policy(seen), "gripper": [1.0]}, 8)
    assert {outcome.score for outcome in dropping} == {best}
    assert sim.observe().state["cube_pose"][2] < 2 * tabletop.CUBE_HALF_M
    assert play(sim, policy, LiftCube.max_steps)[-1].success


def test_a_slow_hand_gets_graded_scores(sim: Tabletop) -> None:
    """Stopped half way up, an episode is worth more than a grasp, less than success."""
    outcomes = play(sim, expert(sim, 0), LiftCube.max_steps)
    partial = play(sim, expert(sim, 0), len(outcomes) - 4)
    assert 0.4 < partial[-1].score < 0.9
    assert not partial[-1].terminated


@pytest.mark.parametrize("kind", ["still", "anywhere", "from end to end"])
def test_luck_lifts_nothing(sim: Tabletop, kind: str) -> None:
    low, high = tabletop.JOINT_LOW_RAD, tabletop.JOINT_HIGH_RAD
    rng = np.random.Generator(np.random.PCG64(1))

    def act(_: Observation) -> Action:
        if kind == "still":
            return HOME
        joints = rng.uniform(low, high)
        if kind == "from end to end":  # hard enough to throw the cube about
            joints = np.where(joints > 0, high, low)
        return {"joint_position": joints.tolist(), "gripper": [rng.uniform()]}

    episodes = 10 if kind == "still" else 50
    successes = 0
    for seed in range(episodes):
        sim.reset("lift_cube", seed)
        successes += play(sim, act, LiftCube.max_steps)[-1].success
    assert successes <= 0.02 * episodes


def test_a_cube_in_the_air_is_not_lifted_unless_gripped() -> None:
    world = World(tabletop.scene_mjcf())
    scene = Scene(world)
    scene.reset()
    world.set_free_pose("cube", (0.45, 0.0, 0.5, 1, 0, 0, 0))
    world.forward()
    assert scene.cube_clearance_m() > LiftCube.LIFT_M
    assert not LiftCube().goal_holds(scene)


# What a policy sends and sees


def test_pictures_show_the_scene_upright_and_moving(seeing_sim: Tabletop) -> None:
    seeing_sim.reset("lift_cube", 2)
    before = seeing_sim.observe().images
    assert tuple(before) == tabletop.CAMERAS
    for image in before.values():
        assert image.shape == (HEIGHT, WIDTH, 3)
        assert image.dtype == np.uint8
        assert len(np.unique(image.reshape(-1, 3), axis=0)) > 50
    red, _, blue = before["front"].astype(int).mean(axis=1).T
    assert blue[0] >= red[0], "the wall is on top"
    assert red[-1] > blue[-1] + 20, "the wooden table is below"
    r, g, b = before["front"].astype(int).reshape(-1, 3).T
    assert np.count_nonzero((r > 2 * g) & (r > 2 * b)) > 5, "the cube is red"
    play(seeing_sim, waving(), 10)
    after = seeing_sim.observe().images
    for camera in tabletop.CAMERAS:
        assert np.count_nonzero(before[camera] != after[camera]) > 500, camera


def test_standard_quality_draws_shadows() -> None:
    plain, shaded = Tabletop(WIDTH, HEIGHT), Tabletop(WIDTH, HEIGHT, quality="standard")
    for sim in (plain, shaded):
        sim.reset("lift_cube", 2)
    front = plain.observe().images["front"], shaded.observe().images["front"]
    assert front[1].mean() < front[0].mean() - 1
    plain.close()
    shaded.close()


def test_targets_beyond_their_bounds_are_clipped(sim: Tabletop) -> None:
    farthest: Action = {"joint_position": tabletop.JOINT_HIGH_RAD, "gripper": [1.0]}
    beyond: Action = {"joint_position": [1e300] * 7, "gripper": [1e300]}
    ends = []
    for action in (farthest, beyond):
        sim.reset("lift_cube", 0)
        sim.step(action)
        ends.append(bits(sim.observe()))
    assert ends[0] == ends[1]


def test_the_state_has_the_declared_channels(sim: Tabletop) -> None:
    sim.reset("lift_cube", 0)
    state = sim.observe().state
    assert {name: values.shape for name, values in state.items()} == {
        channel.name: (channel.size,) for channel in tabletop.STATE_CHANNELS
    }
    assert {values.dtype for values in state.values()} == {np.dtype(np.float64)}
    assert state["joint_position"] == pytest.approx(tabletop.HOME_RAD)
    assert state["gripper"] == pytest.approx([1.0])
    assert state["ee_pose"][3:] == pytest.approx([0, 0, 1, 0], abs=1e-9)


def test_constants_agree_with_the_scene() -> None:
    world = World(tabletop.scene_mjcf())
    declared = np.array([tabletop.JOINT_LOW_RAD, tabletop.JOINT_HIGH_RAD]).T
    assert np.array_equal(world.joint_ranges(tabletop.JOINTS), declared)
    strokes = np.array([[0, tabletop.FINGER_STROKE_M]] * 2)
    assert np.array_equal(world.joint_ranges(tabletop.FINGERS), strokes)
    assert world.body_pose("cube")[2] == tabletop.CUBE_HALF_M
    assert math.isclose(
        world.timestep_s * tabletop.SUBSTEPS, 1 / tabletop.CONTROL_RATE_HZ
    )


def test_an_unknown_task_is_unplayable(sim: Tabletop) -> None:
    with pytest.raises(TaskUnplayable, match="juggle"):
        sim.reset("juggle", 0)
    with pytest.raises(RuntimeError, match="reset"):
        sim.observe()


def test_a_diverged_world_says_so() -> None:
    world = World(tabletop.scene_mjcf())
    world.set_joint_positions(tabletop.JOINTS, [math.nan] * 7)
    with pytest.raises(SimulationDiverged):
        world.advance(1)


# The arm


def test_inverse_kinematics_arrives() -> None:
    arm = ArmKinematics()
    rng = np.random.Generator(np.random.PCG64(0))
    for _ in range(50):
        joints = np.array(tabletop.HOME_RAD) + rng.uniform(-0.4, 0.4, 7)
        target = arm.forward(joints)
        reached = arm.forward(arm.inverse(target, tabletop.HOME_RAD))
        assert reached[:3] == pytest.approx(target[:3], abs=1e-4)
        assert abs(reached[3:] @ target[3:]) == pytest.approx(1, abs=1e-6)


def test_an_unreachable_pose_ends_within_the_limits() -> None:
    far = np.array([3.0, 0.0, 0.2, 0, 0, 1, 0])
    joints = ArmKinematics().inverse(far, tabletop.HOME_RAD)
    assert np.all(joints >= tabletop.JOINT_LOW_RAD)
    assert np.all(joints <= tabletop.JOINT_HIGH_RAD)
