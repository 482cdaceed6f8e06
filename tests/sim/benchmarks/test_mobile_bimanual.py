"""The mobile bimanual world: it can be solved, not by luck, and always the same way.

These tests draw pictures; where nothing can be drawn they fail with the apt command
that changes it. None is skipped.
"""

import itertools
import json
import multiprocessing
from concurrent.futures import ProcessPoolExecutor

import numpy as np
import pytest

from reference_sim.benchmarks.mobile_bimanual.benchmark import MAX_STEPS
from reference_sim.benchmarks.mobile_bimanual.experts import (
    MobileBimanualExpert,
    UnknownInstruction,
    make_expert,
)
from reference_sim.benchmarks.mobile_bimanual.layout import (
    ACTION_CHANNELS,
    BOX_HALF_M,
    CAMERAS,
    FINGER_STROKE_M,
    HOME_RAD,
    MAT_HALF_M,
    SUBSTEPS,
    TABLE_TOP_M,
    THINGS,
)
from reference_sim.benchmarks.mobile_bimanual.scene import MobileBimanualScene
from reference_sim.benchmarks.mobile_bimanual.splits import SPLITS
from reference_sim.benchmarks.mobile_bimanual.tasks import (
    LIFTED_M,
    TASKS,
    FetchAndPlace,
    TwoHandedLift,
)
from reference_sim.interface import Action, Observation, Simulator
from reference_sim.mujoco.task_simulator import PhysicalSimulator
from tests.support.sim.physical_play import Policy, observation_digest, play

pytestmark = pytest.mark.slow("simulates and draws for seconds")

WIDTH, HEIGHT = 64, 48
STILL: Action = {
    "joint_position": HOME_RAD * 2,
    "gripper": [FINGER_STROKE_M] * 4,
    "base_motion": [0.0] * 3,
}
MODES = tuple(ACTION_CHANNELS)

Sim = PhysicalSimulator[MobileBimanualScene]


def make(*, cameras: bool = False, control: str = "joint_position") -> Sim:
    """With the things' poses, so that the expert can play and be looked at."""
    return PhysicalSimulator(
        MobileBimanualScene(control=control, thing_poses=True),
        TASKS,
        substeps=SUBSTEPS,
        cameras=tuple(CAMERAS) if cameras else (),
        camera_size=(WIDTH, HEIGHT),
    )


def expert(
    sim: Simulator, task: str, seed: int, split: str = "", control: str = MODES[0]
) -> Policy:
    """Begins an episode; the expert's actions pass through JSON, as over the wire."""
    player = MobileBimanualExpert(control)
    player.reset(sim.reset(task, seed, split))

    def choose(seen: Observation) -> Action:
        state = {name: values.tolist() for name, values in seen.state.items()}
        action: Action = json.loads(json.dumps(player.act(state)))
        return action

    return choose


def random_actions(control: str = MODES[0]) -> Policy:
    """The same lively actions each time, from all that may be sent."""
    rng = np.random.Generator(np.random.PCG64(99))

    def choose(_: Observation) -> Action:
        return {
            one.name: rng.uniform(one.low or (), one.high or ()).tolist()
            for one in ACTION_CHANNELS[control]
        }

    return choose


def random_action_digests(control: str) -> list[str]:
    """Three episodes' observations, images included; also run by a second process."""
    sim = make(cameras=True, control=control)
    seen = []
    for seed, task in enumerate(TASKS):
        sim.reset(task, seed, "test")
        policy = random_actions(control)
        for _ in range(6):
            seen.append(observation_digest(sim.observe()))
            play(sim, policy, 2)
    sim.close()
    return seen


# The same way each time


def test_another_process_sees_the_same_bits() -> None:
    spawn = multiprocessing.get_context("spawn")
    with ProcessPoolExecutor(1, mp_context=spawn) as other:
        remote = [other.submit(random_action_digests, control) for control in MODES]
        local_digests = [random_action_digests(control) for control in MODES]
        assert [digests.result(timeout=60) for digests in remote] == local_digests
    all_digests = [*itertools.chain(*local_digests)]
    # Each episode begins alike in both modes; nothing else may repeat.
    assert len(set(all_digests)) == len(all_digests) - len(TASKS)


@pytest.mark.parametrize("task", TASKS)
def test_reset_restores_the_initial_state(task: str) -> None:
    """Other colours, sizes and cameras, things moved, score above zero: all gone."""
    used, fresh = make(cameras=True), make(cameras=True)
    outcomes = play(used, expert(used, task, 3, "test"), 400)
    assert outcomes[-1].success
    for sim in (used, fresh):
        sim.reset("handover", 11, "val_train")
    assert used.snapshot().world.tobytes() == fresh.snapshot().world.tobytes()
    for _ in range(5):
        assert observation_digest(used.observe()) == observation_digest(fresh.observe())
        assert used.step(STILL) == fresh.step(STILL)
    used.close()
    fresh.close()


@pytest.mark.parametrize(
    ("task", "steps_before"),
    [
        ("fetch_and_place", 40),  # driving
        ("fetch_and_place", 120),  # driving, with the box in the hand
        ("two_handed_lift", 31),
        ("handover", 70),
    ],
)
def test_a_snapshot_continues_exactly(task: str, steps_before: int) -> None:
    played, other = make(cameras=True), make(cameras=True)
    policy = expert(played, task, 3, "val_unseen")
    play(played, policy, steps_before)
    snapshot = played.snapshot()
    play(other, expert(other, "handover", 40, "test"), 15)
    other.restore(snapshot)
    assert other.snapshot().world.tobytes() == snapshot.world.tobytes()
    for _ in range(12):
        seen = played.observe()
        assert observation_digest(other.observe()) == observation_digest(seen)
        action = policy(played.observe())
        assert other.step(action) == played.step(action)
    played.close()
    other.close()


def test_a_snapshot_continues_exactly_with_hand_poses() -> None:
    """Where a search for joint angles begins is part of what is kept."""
    played, other = make(control="ee_pose"), make(control="ee_pose")
    for sim, steps in ((played, 9), (other, 4)):
        sim.reset("fetch_and_place", 3)
        play(sim, random_actions("ee_pose"), steps)
    other.restore(played.snapshot())
    policy, same_policy = random_actions("ee_pose"), random_actions("ee_pose")
    for _ in range(6):
        seen = played.observe()
        assert observation_digest(other.observe()) == observation_digest(seen)
        assert other.step(policy(seen)) == played.step(same_policy(seen))


# Solvable, not by luck


@pytest.mark.parametrize("split", SPLITS)
@pytest.mark.parametrize("task", TASKS)
def test_the_expert_solves_it_stage_by_stage(task: str, split: str) -> None:
    sim = make()
    outcomes = play(sim, expert(sim, task, 17, split), MAX_STEPS)
    scores = [outcome.score for outcome in outcomes]
    assert outcomes[-1].success
    assert len(outcomes) < MAX_STEPS * 2 / 3
    assert scores == sorted(scores)
    assert {0.25, 0.5, 0.75, 1.0} <= set(scores), "each stage counts on its own"


@pytest.mark.parametrize("task", TASKS)
def test_the_expert_solves_it_by_hand_poses_too(task: str) -> None:
    sim = make(control="ee_pose")
    policy = expert(sim, task, 4, "val_unseen", control="ee_pose")
    assert play(sim, policy, MAX_STEPS)[-1].success


def test_the_expert_picks_up_a_dropped_box() -> None:
    """Meanwhile the score stays at its best."""
    sim = make()
    policy = expert(sim, "fetch_and_place", 0)
    on_table = sim.observe().state["box_pose"][2]
    while sim.observe().state["box_pose"][2] < on_table + 0.06:
        best = sim.step(policy(sim.observe())).score
    open_hands = {"gripper": [FINGER_STROKE_M] * 4}
    dropping = play(sim, lambda seen: {**policy(seen), **open_hands}, 6)
    assert {outcome.score for outcome in dropping} == {best}
    assert sim.observe().state["box_pose"][2] < on_table + 0.02
    assert play(sim, policy, MAX_STEPS)[-1].success


@pytest.mark.parametrize("kind", ["still", "random_actions"])
@pytest.mark.parametrize("task", TASKS)
def test_random_and_still_policies_solve_nothing(task: str, kind: str) -> None:
    sim = make()
    sim.reset(task, 1)
    policy = random_actions() if kind == "random_actions" else lambda _: STILL
    outcomes = play(sim, policy, MAX_STEPS)
    assert len(outcomes) == MAX_STEPS
    assert not outcomes[-1].success


def test_a_box_counts_when_it_lies_on_the_mat() -> None:
    scene, task = MobileBimanualScene(), FetchAndPlace()
    scene.reset()
    places = {
        "on it": (0.0, BOX_HALF_M, True),
        "beside it": (MAT_HALF_M + 0.01, BOX_HALF_M, False),
        "above it": (0.0, BOX_HALF_M + 0.02, False),
    }
    scene.place("mat", 0.5, 0.1, TABLE_TOP_M, 0.0)
    for name, (beside, height, counts) in places.items():
        scene.place("box", 0.5 + beside, 0.1, TABLE_TOP_M + height, 0.0)
        scene.world.forward()
        assert task.goal_holds(scene) == counts, name


def test_a_tray_in_the_air_is_not_lifted_unless_held() -> None:
    scene, task = MobileBimanualScene(), TwoHandedLift()
    scene.reset()
    task.reset(scene, np.random.default_rng(0), "val_train")
    for thing, x, z in (("tray", 0.5, 0.0), ("box", 0.5, BOX_HALF_M + 0.005)):
        scene.place(thing, x, 0.0, TABLE_TOP_M + 2 * LIFTED_M + z, 0.0)
    scene.world.forward()
    assert scene.lies_on("box", "tray")
    assert not task.goal_holds(scene)


def test_an_expert_rejects_an_unknown_instruction() -> None:
    player = make_expert()
    with pytest.raises(RuntimeError, match="reset"):
        player.act({})
    with pytest.raises(UnknownInstruction, match="Juggle"):
        player.reset("Juggle.")


# What differs between episodes


def test_unseen_splits_look_different_and_reach_further() -> None:
    sim = make(cameras=True)
    fronts, spreads = {}, {}
    for split in SPLITS:
        places = []
        for seed in range(30):
            sim.reset("fetch_and_place", seed, split)
            places.append(sim._scene.state()["box_pose"][:2])
        spreads[split] = float(np.ptp(places, axis=0)[0])
        fronts[split] = sim.observe().images["front"].astype(int)
    x_low, x_high = FetchAndPlace.BOX_X_M
    assert spreads["val_train"] < 0.7 * (x_high - x_low) + 1e-9
    assert spreads["val_train"] < spreads["val_unseen"] <= x_high - x_low
    for one, other in (("val_train", "val_unseen"), ("val_unseen", "test")):
        assert np.count_nonzero(fronts[one] != fronts[other]) > 500
    sim.close()


def test_unused_objects_stay_parked() -> None:
    """Weightless, and back there when the next task does not need them."""
    sim = make()
    for task in (*TASKS, *TASKS):
        sim.reset(task, 0)
        before = sim.observe().state
        play(sim, lambda _: STILL, 10)
        after = sim.observe().state
        waiting = [thing for thing in THINGS if before[f"{thing}_pose"][0] < -1.5]
        assert len(waiting) == {"handover": 3}.get(task, 2)
        for thing in waiting:
            name = f"{thing}_pose"
            assert np.allclose(before[name], after[name], atol=1e-9)


def test_images_are_upright_and_change_with_motion() -> None:
    sim = make(cameras=True)
    sim.reset("two_handed_lift", 2)
    before = sim.observe().images
    assert tuple(before) == tuple(CAMERAS)
    for image in before.values():
        assert image.shape == (HEIGHT, WIDTH, 3)
        assert image.dtype == np.uint8
        assert len(np.unique(image.reshape(-1, 3), axis=0)) > 20
    red, _, blue = before["head"].astype(int).mean(axis=1).T
    assert red[HEIGHT // 2] > blue[HEIGHT // 2] + 15, "the wooden table is in front"
    assert blue[2] >= red[2], "the floor behind it is above"
    play(sim, random_actions(), 10)
    after = sim.observe().images
    for camera in CAMERAS:
        assert np.count_nonzero(before[camera] != after[camera]) > 300, camera
    sim.close()
