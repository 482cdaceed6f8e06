"""Raw images that two processes share: right, private, and never torn."""

import contextlib
import fcntl
import os
from pathlib import Path
from typing import Any

import msgspec
import numpy as np
import pytest
from numpy.typing import NDArray

from reference_server.http.codec import (
    JSON,
    LARGE_BYTES,
    MSGPACK,
    encode_response,
    encode_segments,
)
from reference_sim import benchmark_registry
from reference_sim.process.observation_encoding import EncodedObservation, encode_image
from reference_sim.process.pool import Begin, SimulatorPool
from reference_sim.process.simulator_process import LocalProcess
from reference_sim.shared_frame_buffer import (
    SharedFrameBuffer,
    SharedMemoryRegion,
    map_memory,
)
from tests.support.sim.calibration_action import calibration_action as action

HEIGHT, WIDTH = 30, 40
SIZE = HEIGHT * WIDTH * 3


def draw(
    frame_buffer: SharedFrameBuffer, shade: int, images: int = 1
) -> list[NDArray[np.uint8]]:
    """An observation of some images, all of one shade."""
    frame_buffer.swap()
    pictures = [frame_buffer.allocate(HEIGHT, WIDTH) for _ in range(images)]
    for picture in pictures:
        picture.fill(shade)
    return pictures


def test_memory_is_shared_once_its_size_is_known() -> None:
    frame_buffer = SharedFrameBuffer()
    (first,) = draw(frame_buffer, 1)
    assert frame_buffer.place_of(first) is None
    assert frame_buffer.pending_mapping() is None
    (second,) = draw(frame_buffer, 2)
    mapping = frame_buffer.pending_mapping()
    assert mapping is not None
    assert frame_buffer.pending_mapping() is None
    assert frame_buffer.place_of(second) is not None
    seen = map_memory(os.getpid(), mapping)
    offset, length = frame_buffer.place_of(second) or (0, 0)
    assert seen[offset : offset + length] == bytes([2]) * SIZE
    more = draw(frame_buffer, 3, images=2)
    assert [frame_buffer.place_of(picture) is None for picture in more] == [False, True]
    assert None not in map(frame_buffer.place_of, draw(frame_buffer, 4, images=2))


def test_an_observation_is_valid_until_the_next_but_one() -> None:
    frame_buffer = SharedFrameBuffer()
    draw(frame_buffer, 1)
    (second,) = draw(frame_buffer, 2)
    (third,) = draw(frame_buffer, 3)
    assert (second.max(), third.min()) == (2, 3)
    (fourth,) = draw(frame_buffer, 4)
    assert (second.max(), third.max(), fourth.max()) == (4, 3, 4)


def test_a_new_episode_uses_other_memory() -> None:
    """Pictures still being sent to one client never show those of another one."""
    frame_buffer = SharedFrameBuffer()
    draw(frame_buffer, 1)
    (own_image,) = draw(frame_buffer, 2)
    frame_buffer.begin_episode()
    for shade in (3, 4, 5):
        (other_image,) = draw(frame_buffer, shade)
    assert (own_image.max(), other_image.max()) == (2, 5)
    assert frame_buffer.place_of(own_image) is None


def test_memory_that_no_view_is_left_of_is_drawn_into_again() -> None:
    frame_buffer = SharedFrameBuffer()
    draw(frame_buffer, 0)
    numbers = []
    for unread in (0, 0, 1, 0, 2, 0):
        frame_buffer.begin_episode(unread)
        (picture,) = draw(frame_buffer, 1)
        mapping = frame_buffer.pending_mapping()
        assert mapping is not None
        seen = map_memory(os.getpid(), mapping)
        offset, length = frame_buffer.place_of(picture) or (0, 0)
        assert seen[offset : offset + length] == bytes([1]) * SIZE
        numbers.append(mapping.number)
    # 2 was given up when 3 was made.
    assert numbers == [1, 2, 1, 3, 4, 5]
    frame_buffer.forget()
    frame_buffer.begin_episode(5)
    (picture,) = draw(frame_buffer, 1)
    assert frame_buffer.file.number == 6


async def test_pictures_that_are_still_read_are_not_drawn_over() -> None:
    """A client may read the answer of one episode while the next but one begins."""
    world = benchmark_registry.resolve(
        "calibration", images={"codec": "raw", "width": 64, "height": 48}
    ).world
    pool = SimulatorPool()
    await pool.start()
    handle = await pool.acquire(world)
    plan = Begin("echo", 7, max_steps=9, success_rule="any_step")
    kept, used = [], []
    for episode in range(6):
        begun = await handle.begin(plan)
        played = await handle.play([action()], observe_all=False)
        assert played.observation is not None
        if episode in (0, 1):
            data = played.observation["images"]["pattern"]["data"]
            kept.append((data, bytes(data)))
        del begun, played
        used.append(list(handle._process._frames)[-1])
    assert [data == copied for data, copied in kept] == [True, True]
    # Once the older ones are not read any more, two memories are enough.
    assert used == [1, 2, 3, 4, 3, 4]
    await handle.release()
    await pool.close()


def test_pixels_from_elsewhere_are_copied() -> None:
    frame_buffer = SharedFrameBuffer()
    draw(frame_buffer, 1)
    (shared,) = draw(frame_buffer, 2)
    assert "place" in encode_image(shared, "raw", frame_buffer)
    for pixels in (np.ones((2, 2, 3), np.uint8), shared[::-1], shared[:, :2]):
        image = encode_image(pixels, "raw", frame_buffer)
        assert "place" not in image
        assert image["data"] == pixels.tobytes()
    assert "place" not in encode_image(shared, "png", frame_buffer)


def test_memory_that_could_shrink_under_its_reader_is_refused() -> None:
    descriptor = os.memfd_create("loose", os.MFD_ALLOW_SEALING)
    os.ftruncate(descriptor, 4096)
    with pytest.raises(ValueError, match="not sealed"):
        map_memory(os.getpid(), SharedMemoryRegion(1, descriptor, 4096))
    fcntl.fcntl(descriptor, fcntl.F_ADD_SEALS, fcntl.F_SEAL_SHRINK)
    with pytest.raises(ValueError, match="not sealed"):
        map_memory(os.getpid(), SharedMemoryRegion(1, descriptor, 4097))
    mapped = map_memory(os.getpid(), SharedMemoryRegion(1, descriptor, 4096))
    assert mapped[:] == bytes(4096)
    os.close(descriptor)


def count_open(name: str) -> int:
    """The descriptors of memory of this name; those of other objects come and go."""
    links = []
    for descriptor in Path("/proc/self/fd").iterdir():
        with contextlib.suppress(FileNotFoundError):  # it was closed meanwhile
            links.append(str(descriptor.readlink()))
    return sum(name in link for link in links)


def test_descriptors_do_not_accumulate(monkeypatch: pytest.MonkeyPatch) -> None:
    create, name = os.memfd_create, "memory of one test"
    monkeypatch.setattr(os, "memfd_create", lambda _, flags: create(name, flags))
    frame_buffer, counts = SharedFrameBuffer(), []
    for _ in range(20):
        frame_buffer.begin_episode()
        draw(frame_buffer, 1)
        draw(frame_buffer, 2)
        frame_buffer.pending_mapping()
        frame_buffer.acknowledge()
        counts.append(count_open(name))
    assert counts[1] > 0
    assert set(counts[1:]) == {counts[1]}


def pixels_of(observation: EncodedObservation) -> bytes:
    return bytes(observation["images"]["pattern"]["data"])


async def test_images_come_out_of_the_process_bit_for_bit() -> None:
    world = benchmark_registry.resolve(
        "calibration", images={"codec": "raw", "width": 64, "height": 48}
    ).world
    row, column, channel = np.ogrid[:48, :64, :3]

    def pattern(count: int) -> bytes:
        grey = 7 * column + 13 * row + 29 * channel + count
        return bytes(grey.astype(np.uint8).tobytes())

    pool = SimulatorPool()
    await pool.start()
    handle = await pool.acquire(world)
    for _ in range(2):
        begun = await handle.begin(Begin("echo", 7, 9, "any_step"))
        shown = [begun.observation]
        for _ in range(4):
            played = await handle.play([action()], observe_all=False)
            assert played.observation is not None
            shown.append(played.observation)
        # Older ones may have been drawn over by now.
        assert [pixels_of(one) for one in shown[-2:]] == [pattern(3), pattern(4)]
        assert pixels_of(await handle.observe()) == pattern(4)
        chunk = await handle.play([action()] * 3, observe_all=True)
        assert chunk.observations is not None
        assert [*map(pixels_of, chunk.observations)] == [*map(pattern, (5, 6, 7))]
    await handle.release()
    await pool.close()


def test_an_offset_outside_the_memory_is_an_error() -> None:
    process = LocalProcess.__new__(LocalProcess)
    process._frame_memory = memoryview(bytes(10))
    for place in ((5, 6), (-2, 1), (11, 1)):
        image = encode_image(np.zeros((1, 1, 1), np.uint8), "raw")
        image["place"] = place
        seen: Any = {"state": {}, "tensors": {}, "images": {"a": image}}
        with pytest.raises(ValueError, match="outside"):
            process._resolve_pixels(seen)


PIXELS = memoryview(bytes(range(256)) * (LARGE_BYTES // 64))
IMAGES = {"x": PIXELS, "y": memoryview(b"\x01" * 10), "z": PIXELS[1:]}
TURN = {
    "seq": 1,
    "observation": {
        "state": {"a": [1.0]},
        "images": {name: {"codec": "raw", "data": d} for name, d in IMAGES.items()},
        "tensors": {},
    },
    "done": False,
}


def test_large_images_are_sent_without_a_copy() -> None:
    parts = encode_segments(TURN)
    assert sum(part is PIXELS for part in parts) == 1
    assert b"".join(parts) == msgspec.msgpack.encode(TURN)


@pytest.mark.parametrize(
    ("media_type", "encode"),
    [(MSGPACK, msgspec.msgpack.encode), (JSON, msgspec.json.encode)],
)
def test_a_segmented_answer_equals_the_whole(media_type: str, encode: Any) -> None:
    parts = encode_segments(TURN, media_type)
    assert len(parts) == 5
    assert b"".join(parts) == encode(TURN)
    answer = encode_response(TURN, media_type)
    assert answer.media_type == media_type
    assert int(answer.headers["content-length"]) == len(encode(TURN))


@pytest.mark.parametrize("content", [{"observation": {}}, {"observation": 1}, [1], {}])
def test_a_body_that_is_not_a_turn_is_one_segment(content: Any) -> None:
    assert encode_segments(content, JSON) == [msgspec.json.encode(content)]
