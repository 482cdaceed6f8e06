"""The mobile bimanual benchmarks keep the promises of their manifests."""

import math
import xml.etree.ElementTree as ET

import numpy as np
import pytest

from reference_sim import benchmark_registry
from reference_sim.benchmarks.mobile_bimanual import frames, layout
from reference_sim.benchmarks.mobile_bimanual.benchmark import VARIANTS, make_simulator
from reference_sim.benchmarks.mobile_bimanual.mjcf import scene_mjcf
from reference_sim.benchmarks.mobile_bimanual.scene import MobileBimanualScene
from reference_sim.benchmarks.mobile_bimanual.splits import SPLITS
from reference_sim.benchmarks.mobile_bimanual.tasks import TASKS, TRACKS
from reference_sim.interface import Action
from reference_sim.mujoco.world import Vector, World

SIZE = {"width": 32, "height": 24}
STILL_ARMS: Action = {
    "joint_position": layout.HOME_RAD * 2,
    "gripper": [layout.FINGER_STROKE_M] * 4,
}


def step(scene: MobileBimanualScene, steps: int, action: Action) -> None:
    for _ in range(steps):
        scene.command(action)
        scene.world.advance(layout.SUBSTEPS)


def drive(scene: MobileBimanualScene, steps: int, *motion: float) -> Vector:
    """The base's way in its own frame."""
    before = scene.base()
    step(scene, steps, {**STILL_ARMS, "base_motion": motion})
    return frames.motion_between(before, scene.base())


# The table of benchmarks


@pytest.mark.parametrize("benchmark_id", VARIANTS)
def test_the_manifest_matches_the_simulator(benchmark_id: str) -> None:
    variant = VARIANTS[benchmark_id]
    resolved = benchmark_registry.resolve(benchmark_id)
    manifest = resolved.manifest
    assert manifest["tasks"] == list(TRACKS[variant.track])
    assert {one["task"] for one in manifest["episodes"]} == set(manifest["tasks"])
    assert {one["split"] for one in manifest["episodes"]} == set(SPLITS)
    assert manifest["splits"] == list(SPLITS)
    sim = make_simulator(variant, {**resolved.world.settings, **SIZE})
    first = manifest["episodes"][0]
    assert sim.reset(first["task"], first["seed"], first["split"])
    action = {
        name: np.add(space.get("minimum"), space.get("maximum")) / 2
        for name, space in manifest["action_space"].items()
    }
    assert not sim.step({name: list(v) for name, v in action.items()}).success
    seen, promised = sim.observe(), manifest["observation_space"]
    assert {name: v.shape for name, v in seen.state.items()} == {
        name: (space["size"],) for name, space in promised["state"].items()
    }
    assert set(seen.images) == set(promised["images"])
    assert all(image.shape == (24, 32, 3) for image in seen.images.values())
    sim.close()


def test_tracks_share_their_episodes() -> None:
    def episodes(benchmark_id: str) -> list[tuple[str, str, int]]:
        plans = benchmark_registry.resolve(benchmark_id).episodes
        return sorted((plan.task, plan.split, plan.seed) for plan in plans)

    whole = episodes("mobile_bimanual")
    tracks = TRACKS.keys() - {"generalist"}
    parts = [one for t in tracks for one in episodes(f"mobile_bimanual_{t}")]
    assert sorted(parts) == whole
    assert episodes("mobile_bimanual_state") == whole
    assert episodes("mobile_bimanual_ee") == whole
    assert set(TRACKS["generalist"]) == set(TASKS)


def test_object_poses_are_hidden_where_there_are_cameras() -> None:
    poses = {f"{thing}_pose" for thing in layout.THINGS}
    for benchmark_id, variant in VARIANTS.items():
        space = benchmark_registry.resolve(benchmark_id).manifest["observation_space"]
        assert set(space["images"]) == set(layout.CAMERAS if variant.cameras else ())
        assert poses & set(space["state"]) == (set() if variant.cameras else poses)


def test_sizes_and_modes_offered() -> None:
    manifest = benchmark_registry.resolve("mobile_bimanual").manifest
    assert manifest["image_sizes"] == [
        {"width": 640, "height": 480},
        {"width": 224, "height": 224},
        {"width": 128, "height": 128},
    ]
    joints = {name: one["size"] for name, one in manifest["action_space"].items()}
    assert joints == {"joint_position": 12, "gripper": 4, "base_motion": 3}
    hands = benchmark_registry.resolve("mobile_bimanual_ee").manifest["action_space"]
    assert list(hands) == ["left_ee_pose", "right_ee_pose", "gripper", "base_motion"]
    orientation = hands["left_ee_pose"]["parts"]["orientation"]
    assert orientation["rotation"] == "quaternion_wxyz"
    assert hands["base_motion"]["parts"]["yaw"]["relative_to"] == "commanded"


def test_constants_agree_with_the_scene() -> None:
    world, scene = World(scene_mjcf()), ET.fromstring(scene_mjcf())  # noqa: S314 - our own file
    ranges = np.array([layout.JOINT_LOW_RAD, layout.JOINT_HIGH_RAD]).T
    for side in layout.SIDES:
        assert np.array_equal(world.joint_ranges(layout.ARM_JOINTS[side]), ranges)
        strokes = world.joint_ranges(layout.FINGERS[side])
        assert np.array_equal(strokes, [[0, layout.FINGER_STROKE_M]] * 2)

    def numbers(path: str, attribute: str) -> Vector:
        element = scene.find(path)
        assert element is not None, path
        return np.array([float(one) for one in element.attrib[attribute].split()])

    tops = {"work_table": (0, layout.WORK_TABLE_EDGE_M)}
    tops["side_table"] = (1, layout.SIDE_TABLE_EDGE_M)
    for table, (axis, edge_m) in tops.items():
        middle = numbers(f".//body[@name='{table}']", "pos")
        half = numbers(f".//body[@name='{table}']/geom", "size")
        assert middle[2] + half[2] == pytest.approx(layout.TABLE_TOP_M)
        assert middle[axis] - half[axis] == pytest.approx(edge_m)
    for thing, half_m in (
        ("box", layout.BOX_HALF_M),
        ("bar", layout.BAR_HALF_M),
        ("tray", layout.TRAY_HALF_M),
    ):
        assert numbers(f".//geom[@name='{thing}']", "size")[2] == half_m
    assert numbers(".//geom[@name='mat']", "size")[0] == layout.MAT_HALF_M
    for camera, position in layout.CAMERA_POSITIONS_M.items():
        assert tuple(numbers(f".//camera[@name='{camera}']", "pos")) == position
    motors = [motor.attrib["name"] for motor in scene.findall("./actuator/position")]
    left = (*layout.ARM_JOINTS["left"], *layout.FINGERS["left"])
    right = (*layout.ARM_JOINTS["right"], *layout.FINGERS["right"])
    assert motors == [*layout.BASE_JOINTS, *left, *right]
    period_s = world.timestep_s * layout.SUBSTEPS
    assert math.isclose(period_s, 1 / layout.CONTROL_RATE_HZ)


# The base


def test_the_base_moves_in_its_own_frame_and_reaches_its_target() -> None:
    scene = MobileBimanualScene()
    scene.reset()
    scene.place_base(-0.5, 0.2, math.pi / 2)
    scene.world.forward()
    drive(scene, 10, 0.03, 0.0, 0.0)
    drive(scene, 10, 0.0, 0.0, 0.0)
    assert scene.base() == pytest.approx([-0.5, 0.5, math.pi / 2], abs=0.005)
    way = drive(scene, 10, 0.0, 0.02, 0.0) + drive(scene, 10, 0.0, 0.0, 0.0)
    assert way == pytest.approx([0.0, 0.2, 0.0], abs=0.005)
    drive(scene, 10, 0.0, 0.0, -0.1)
    drive(scene, 12, 0.0, 0.0, 0.0)
    assert scene.base()[2] == pytest.approx(math.pi / 2 - 1.0, abs=0.01)


def test_a_motion_beyond_its_bounds_is_clipped() -> None:
    ways = []
    for motion in (layout.BASE_STEP, (1e300, 1e300, 1e300)):
        scene = MobileBimanualScene()
        scene.reset()
        scene.place_base(-0.8, 0.0, 0.0)
        scene.world.forward()
        ways.append(drive(scene, 5, *motion).tolist())
    assert ways[0] == ways[1]
    assert ways[0][2] > 0.05


def test_a_blocked_base_accumulates_no_motion() -> None:
    scene = MobileBimanualScene()
    scene.reset()
    drive(scene, 60, 0.05, 0.0, 0.0)
    at_table = scene.base()[0]
    assert at_table < layout.WORK_TABLE_EDGE_M - 0.2
    assert drive(scene, 10, -0.05, 0.0, 0.0)[0] < -0.25


# The hands


def test_a_hand_reaches_its_target_in_the_base_frame() -> None:
    scene = MobileBimanualScene(control="ee_pose")
    scene.reset()
    scene.place_base(-0.8, 0.1, 2.0)
    scene.world.forward()
    half = math.sqrt(0.5)
    left = np.array([0.45, 0.25, 1.0, 0.0, -half, half, 0.0])
    right = np.array([0.40, -0.10, 0.9, 0.0, 0.0, 1.0, 0.0])
    action: Action = {
        "left_ee_pose": left.tolist(),
        "right_ee_pose": (right * [1, 1, 1, 0.5, 0.5, 0.5, 0.5]).tolist(),
        "gripper": [0.0, 0.0, 0.02, 0.02],
        "base_motion": [0.0, 0.0, 0.0],
    }
    step(scene, 40, action)
    state = scene.state()
    for side, pose in (("left", left), ("right", right)):
        reached = state[f"{side}_ee_pose"]
        assert reached[:3] == pytest.approx(pose[:3], abs=0.005)
        assert abs(reached[3:] @ pose[3:]) == pytest.approx(1, abs=1e-3)
    assert state["gripper"] == pytest.approx([0, 0, 0.02, 0.02], abs=0.002)


def test_an_unreachable_hand_pose_keeps_the_state_finite() -> None:
    scene = MobileBimanualScene(control="ee_pose")
    scene.reset()
    nowhere = [1e300, -1e300, 0.0, 0.0, 0.0, 0.0, 0.0]
    hands = {"left_ee_pose": nowhere, "right_ee_pose": nowhere}
    step(scene, 5, {**hands, "gripper": [-1e300] * 4, "base_motion": [0.0] * 3})
    for values in scene.state().values():
        assert np.isfinite(values).all()


# Frames


def test_frame_conversions_are_inverse() -> None:
    rng = np.random.Generator(np.random.PCG64(0))
    for _ in range(20):
        base, goal = rng.uniform(-3, 3, 3), rng.uniform(-3, 3, 3)
        pose = frames.upright(*rng.uniform(-1, 1, 4))
        back = frames.from_base(base, frames.to_base(base, pose))
        assert back[:3] == pytest.approx(pose[:3])
        assert abs(back[3:] @ pose[3:]) == pytest.approx(1)
        arrived = frames.moved(base, frames.motion_between(base, goal))
        assert arrived[:2] == pytest.approx(goal[:2])
        assert frames.wrapped(arrived[2] - goal[2]) == pytest.approx(0, abs=1e-9)
        turned = frames.yaw_of(frames.to_base(base, pose)[3:])
        turned -= frames.yaw_of(pose[3:]) - base[2]
        assert frames.wrapped(turned) == pytest.approx(0, abs=1e-9)
