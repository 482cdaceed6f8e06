"""An observation as a policy receives it: pixels, tensors, state."""

import copy
import io
import multiprocessing
from typing import Any

import msgspec
import numpy as np
import PIL.Image
import pytest

from reference_client import ProctorError
from reference_client.api.observation import observation_of
from reference_client.generated.messages import Turn
from reference_sim.process.observation_encoding import encode_image
from tests.support.kit.null_servers import TURN

BLACK = np.zeros((2, 2, 3), np.uint8)


def turn_with(**parts: Any) -> Turn:
    """A turn whose observation has these parts."""
    episode = {"episode_id": "e1", "instruction": "Lift it.", "step": 3}
    observation = {"state": {}, "images": {}, "tensors": {}} | parts
    turn = TURN | {"episode": TURN["episode"] | episode, "observation": observation}
    return msgspec.convert(turn, Turn)


def image(codec: str, width: int, height: int, channels: int, data: bytes) -> Any:
    size = {"width": width, "height": height, "channels": channels}
    return {"camera": {"codec": codec, "data": memoryview(data), **size}}


def compressed(pixels: Any, codec: str) -> bytes:
    file = io.BytesIO()
    PIL.Image.fromarray(pixels).save(file, codec)
    return file.getvalue()


def test_an_observation_knows_its_episode() -> None:
    observation = observation_of(turn_with(state={"joints": [1, 0.5]}))
    assert {n: v.tolist() for n, v in observation.state.items()} == {"joints": [1, 0.5]}
    assert (observation.episode_id, observation.step) == ("e1", 3)
    assert observation.instruction == "Lift it."


def test_an_observation_with_pictures_is_copied_and_sent() -> None:
    """For a model in another process, which may forward the message that came."""
    tensor = {"dtype": "uint8", "shape": [2], "data": memoryview(b"ab")}
    parts = {"images": image("raw", 2, 2, 3, BLACK.tobytes()), "tensors": {"t": tensor}}
    seen = observation_of(turn_with(state={"x": [1.0]}, **parts))
    here, there = multiprocessing.Pipe()
    with here, there:
        there.send(seen)
        received = here.recv()
    for copied in (copy.deepcopy(seen), received):
        assert copied.turn == seen.turn
        assert copied.step == seen.step
        assert copied.images["camera"].tolist() == BLACK.tolist()
        assert copied.tensors["t"].tolist() == [97, 98]
        with pytest.raises(KeyError, match=r"observation\.state has x"):
            copied.state["y"]


def test_a_state_is_an_array_to_calculate_with() -> None:
    """Expect float64 as documented, and no way to change what the live view shows."""
    given = {"a": [1, 2], "b": [0.5, 1], "none": []}
    state = observation_of(turn_with(state=given)).state
    assert (state["a"] - state["b"]).tolist() == [0.5, 1]
    assert {v.dtype for v in state.values()} == {np.dtype(np.float64)}
    assert [v.shape for v in state.values()] == [(2,), (2,), (0,)]
    with pytest.raises(ValueError, match="read-only"):
        state["a"][0] = 9


@pytest.mark.parametrize("channels", [1, 2, 3, 4])
def test_pixels_arrive_in_rows_columns_and_channels(channels: int) -> None:
    pixels = np.arange(5 * 4 * channels, dtype=np.uint8).reshape(5, 4, channels)
    png = compressed(pixels.squeeze(), "png")
    for codec, data in (("raw", pixels.tobytes()), ("png", png)):
        images = image(codec, 4, 5, channels, data)
        seen = observation_of(turn_with(images=images)).images["camera"]
        assert np.array_equal(seen, pixels)
        assert not seen.flags.writeable


@pytest.mark.parametrize("channels", [1, 3])
def test_a_jpeg_keeps_its_colours(channels: int) -> None:
    pixels = np.zeros((48, 64, channels), np.uint8)
    pixels[:24, :, 0] = 200  # of three channels the red one
    data = bytes(encode_image(pixels[::-1], "jpeg")["data"])
    assert data.startswith(b"\xff\xd8\xff")
    images = image("jpeg", 64, 48, channels, data)
    seen = observation_of(turn_with(images=images)).images["camera"]
    assert not seen.flags.writeable
    assert seen.shape == pixels.shape
    assert np.abs(seen[:16].astype(int)).max() < 8
    assert np.abs(seen[32:].astype(int) - pixels[:16]).max() < 8


def test_tensors_are_little_endian_views() -> None:
    data = bytes([1, 0, 2, 0])
    tensor = {"dtype": "uint16", "shape": [2, 1], "data": memoryview(data)}
    seen = observation_of(turn_with(tensors={"t": tensor})).tensors["t"]
    assert seen.tolist() == [[1], [2]]
    assert np.shares_memory(seen, np.frombuffer(data, np.uint8))
    assert not seen.flags.writeable


@pytest.mark.parametrize(
    ("codec", "channels", "data", "text"),
    [
        ("raw", 3, bytes(11), "its declared size"),
        ("png", 3, b"no png", "is not a valid png"),
        ("png", 3, compressed(BLACK[:1], "png"), "declared as"),
        ("png", 3, compressed(BLACK, "gif"), "is not a valid png"),
        ("jpeg", 3, b"no jpeg", "is not a valid jpeg"),
        ("jpeg", 3, compressed(BLACK, "jpeg")[:-2], "is not a valid jpeg"),
        ("jpeg", 3, compressed(BLACK[:1], "jpeg"), "declared as"),
        ("jpeg", 2, compressed(BLACK, "jpeg"), "is not a valid jpeg"),
        ("jpeg", 3, compressed(BLACK, "png"), "is not a valid jpeg"),
    ],
)
def test_an_undecodable_observation_is_an_error(
    codec: str, channels: int, data: bytes, text: str
) -> None:
    images = image(codec, 2, 2, channels, data)
    with pytest.raises(ProctorError, match=text) as caught:
        observation_of(turn_with(images=images))
    assert caught.value.code == "bad_answer"
