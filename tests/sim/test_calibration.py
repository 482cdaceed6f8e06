"""The benchmark `calibration`: its tables, its observations, its manifest."""

import io
import struct
from typing import Any

import numpy as np
import pytest
from PIL import Image

from reference_sim import benchmark_registry
from reference_sim.benchmarks.calibration import DEATH_EXIT_CODE, Calibration
from reference_sim.interface import TaskUnplayable
from reference_sim.process.observation_encoding import (
    encode,
    encode_image,
    encode_tensor,
)
from tests.support.sim.calibration_action import calibration_action as action

WIDTH, HEIGHT = 16, 12


def start_episode(task: str) -> Calibration:
    simulator = Calibration(WIDTH, HEIGHT)
    simulator.reset(task, 1000)
    return simulator


def test_an_unknown_task_is_unplayable() -> None:
    with pytest.raises(TaskUnplayable):
        Calibration(WIDTH, HEIGHT).reset("juggle", 1)


def test_fault_breaks_down_in_its_task_only(monkeypatch: pytest.MonkeyPatch) -> None:
    deaths: list[int] = []
    monkeypatch.setattr("os._exit", deaths.append)
    start_episode("score").step(action(fault=2))
    start_episode("fault").step(action(fault=0))
    assert deaths == []
    start_episode("fault").step(action(fault=1))
    assert deaths == [DEATH_EXIT_CODE]
    with pytest.raises(TaskUnplayable):
        start_episode("fault").step(action(fault=2))


def test_grey_images_have_one_channel() -> None:
    pixels = np.arange(6, dtype=np.uint8).reshape(2, 3, 1)
    image = encode_image(pixels, "png")
    assert image["channels"] == 1
    with Image.open(io.BytesIO(image["data"])) as decoded:
        assert (decoded.mode, decoded.tobytes()) == ("L", pixels.tobytes())


def test_an_unknown_codec_is_an_error() -> None:
    with pytest.raises(ValueError, match="codec"):
        encode(start_episode("echo").observe(), "webp")


def test_encodings_do_not_depend_on_the_memory_layout() -> None:
    pixels = np.arange(24, dtype=np.uint8).reshape(2, 4, 3)
    flipped = encode_image(pixels[::-1], "raw")
    assert flipped["data"] == pixels[1].tobytes() + pixels[0].tobytes()
    big_endian = encode_tensor(np.array([[1, 2], [3, 4]], dtype=">i4").T)
    assert big_endian["dtype"] == "int32"
    assert big_endian["data"] == struct.pack("<4i", 1, 3, 2, 4)


def test_an_encoding_owns_its_bytes() -> None:
    pixels = np.zeros((1, 1, 3), dtype=np.uint8)
    image = encode_image(pixels, "raw")
    pixels[:] = 255
    assert bytes(image["data"]) == b"\0\0\0"


# The manifest


def test_simulator_configs_differ_only_by_images() -> None:
    default = benchmark_registry.resolve("calibration").world
    assert benchmark_registry.resolve("calibration", {"max_steps": 3}).world == default
    larger = {"codec": "png", "width": 64, "height": 48}
    resolved = benchmark_registry.resolve("calibration", images=larger)
    assert resolved.images == larger
    assert resolved.world != default
    assert resolved.world.image_codec == "png"


@pytest.mark.parametrize(
    ("images", "pointer"),
    [
        ({"codec": "webp", "width": 16, "height": 12}, "/images/codec"),
        ({"codec": "raw", "width": 16, "height": 48}, "/images/width"),
    ],
)
def test_images_not_offered_are_refused(images: dict[str, Any], pointer: str) -> None:
    with pytest.raises(benchmark_registry.InvalidChoice) as refused:
        benchmark_registry.resolve("calibration", images=images)
    assert refused.value.pointer == pointer


def test_the_benchmark_list_is_sorted() -> None:
    assert benchmark_registry.benchmark_ids() == (
        "calibration",
        "mobile_bimanual",
        "mobile_bimanual_ee",
        "mobile_bimanual_mobile_manip",
        "mobile_bimanual_state",
        "mobile_bimanual_table_top_manip",
        "question_answering",
        "tabletop",
        "tabletop_state",
    )
    assert benchmark_registry.unavailable_reason("calibration") is None
    with pytest.raises(benchmark_registry.UnknownBenchmark):
        benchmark_registry.resolve("juggling")


def test_tabletop_offers_cameras_and_tabletop_state_none() -> None:
    cameras = benchmark_registry.resolve("tabletop").manifest
    blind = benchmark_registry.resolve("tabletop_state").manifest
    assert set(cameras["observation_space"]["images"]) == {"front", "wrist"}
    assert blind["observation_space"]["images"] == {}
    assert cameras["observation_space"]["state"] == blind["observation_space"]["state"]
    assert cameras["episodes"] == blind["episodes"]
    assert cameras["action_space"]["gripper"]["parts"]["all"]["gripper_open"] == 1.0
    tasks = len(cameras["tasks"])
    splits = [episode["split"] for episode in cameras["episodes"]]
    assert splits == [
        split
        for split, episodes in (("val_train", 2), ("val_unseen", 2), ("test", 4))
        for _ in range(episodes * tasks)
    ]
