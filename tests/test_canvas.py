"""Raw images that two processes share: right, private, and never torn."""

import asyncio
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
from reference_sim.process.encoding import EncodedObservation, encode_image
from reference_sim.process.pool import SimulatorPool
from reference_sim.process.shared_frame_buffer import Canvas, Shared, mapped
from reference_sim.process.simulator_process import Process
from tests.test_simulator_pool import action

HEIGHT, WIDTH = 30, 40
SIZE = HEIGHT * WIDTH * 3


def draw(canvas: Canvas, shade: int, images: int = 1) -> list[NDArray[np.uint8]]:
    """An observation of some images, all of one shade."""
    canvas.turn_page()
    pictures = [canvas.blank(HEIGHT, WIDTH) for _ in range(images)]
    for picture in pictures:
        picture.fill(shade)
    return pictures


def test_memory_is_shared_as_soon_as_it_is_known_how_much() -> None:
    canvas = Canvas()
    (first,) = draw(canvas, 1)
    assert canvas.place_of(first) is None
    assert canvas.news() is None
    (second,) = draw(canvas, 2)
    told = canvas.news()
    assert told is not None
    assert canvas.news() is None
    assert canvas.place_of(second) is not None
    seen = mapped(os.getpid(), told)
    offset, length = canvas.place_of(second) or (0, 0)
    assert seen[offset : offset + length] == bytes([2]) * SIZE
    more = draw(canvas, 3, images=2)
    assert [canvas.place_of(picture) is None for picture in more] == [False, True]
    assert None not in map(canvas.place_of, draw(canvas, 4, images=2))


def test_an_observation_stays_while_the_next_one_is_drawn() -> None:
    canvas = Canvas()
    draw(canvas, 1)
    (second,) = draw(canvas, 2)
    (third,) = draw(canvas, 3)
    assert (second.max(), third.min()) == (2, 3)
    (fourth,) = draw(canvas, 4)
    assert (second.max(), third.max(), fourth.max()) == (4, 3, 4)


def test_another_episode_draws_elsewhere() -> None:
    """What is still being sent to one client never shows what another one sees."""
    canvas = Canvas()
    draw(canvas, 1)
    (mine,) = draw(canvas, 2)
    canvas.begin_episode()
    for shade in (3, 4, 5):
        (theirs,) = draw(canvas, shade)
    assert (mine.max(), theirs.max()) == (2, 5)
    assert canvas.place_of(mine) is None


def test_pixels_from_elsewhere_are_copied() -> None:
    canvas = Canvas()
    draw(canvas, 1)
    (shared,) = draw(canvas, 2)
    assert "place" in encode_image(shared, "raw", canvas)
    for pixels in (np.ones((2, 2, 3), np.uint8), shared[::-1], shared[:, :2]):
        image = encode_image(pixels, "raw", canvas)
        assert "place" not in image
        assert image["data"] == pixels.tobytes()
    assert "place" not in encode_image(shared, "png", canvas)


def test_memory_that_could_shrink_under_its_reader_is_refused() -> None:
    descriptor = os.memfd_create("loose", os.MFD_ALLOW_SEALING)
    os.ftruncate(descriptor, 4096)
    with pytest.raises(ValueError, match="could shrink"):
        mapped(os.getpid(), Shared(descriptor, 4096))
    fcntl.fcntl(descriptor, fcntl.F_ADD_SEALS, fcntl.F_SEAL_SHRINK)
    with pytest.raises(ValueError, match="could shrink"):
        mapped(os.getpid(), Shared(descriptor, 4097))
    assert mapped(os.getpid(), Shared(descriptor, 4096)) == bytes(4096)
    os.close(descriptor)


def test_descriptors_do_not_pile_up() -> None:
    canvas, counts = Canvas(), []
    for _ in range(20):
        canvas.begin_episode()
        draw(canvas, 1)
        draw(canvas, 2)
        canvas.news()
        canvas.parent_has_read()
        counts.append(len(list(Path("/proc/self/fd").iterdir())))
    assert set(counts) == {counts[0]}


def pixels_of(observation: EncodedObservation) -> bytes:
    return bytes(observation["images"]["pattern"]["data"])


def test_images_come_out_of_the_process_bit_for_bit() -> None:
    world = benchmark_registry.resolve(
        "calibration", images={"codec": "raw", "width": 64, "height": 48}
    ).world
    row, column, channel = np.ogrid[:48, :64, :3]

    def pattern(count: int) -> bytes:
        grey = 7 * column + 13 * row + 29 * channel + count
        return bytes(grey.astype(np.uint8).tobytes())

    async def story() -> None:
        pool = SimulatorPool()
        await pool.start()
        handle = await pool.acquire(world)
        for _ in range(2):
            begun = await handle.begin("echo", 7, max_steps=9, success_rule="any_step")
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
            assert [pixels_of(one) for one in chunk.observations] == [
                pattern(5),
                pattern(6),
                pattern(7),
            ]
        await handle.release()
        await pool.close()

    asyncio.run(story())


def test_a_place_beside_the_memory_ends_the_process() -> None:
    process = Process.__new__(Process)
    process._canvas = memoryview(bytes(10))
    for place in ((5, 6), (-2, 1), (11, 1)):
        image = encode_image(np.zeros((1, 1, 1), np.uint8), "raw")
        image["place"] = place
        with pytest.raises(ValueError, match="beside"):
            process._take_down({"state": {}, "tensors": {}, "images": {"a": image}})


PIXELS = memoryview(bytes(range(256)) * (LARGE_BYTES // 64))
TURN = {
    "seq": 1,
    "observation": {
        "state": {"a": [1.0]},
        "images": {
            name: {"codec": "raw", "data": data}
            for name, data in (
                ("x", PIXELS),
                ("y", memoryview(b"\x01" * 10)),
                ("z", PIXELS[1:]),
            )
        },
        "tensors": {},
    },
    "done": False,
}


def test_large_images_leave_as_they_are() -> None:
    parts = encode_segments(TURN)
    assert sum(part is PIXELS for part in parts) == 1
    assert b"".join(parts) == msgspec.msgpack.encode(TURN)


@pytest.mark.parametrize(
    ("media_type", "encode"),
    [(MSGPACK, msgspec.msgpack.encode), (JSON, msgspec.json.encode)],
)
def test_an_answer_in_parts_is_that_in_one(media_type: str, encode: Any) -> None:
    parts = encode_segments(TURN, media_type)
    assert len(parts) == 5
    assert b"".join(parts) == encode(TURN)
    answer = encode_response(TURN, media_type)
    assert answer.media_type == media_type
    assert int(answer.headers["content-length"]) == len(encode(TURN))


@pytest.mark.parametrize("content", [{"observation": {}}, {"observation": 1}, [1], {}])
def test_what_is_no_turn_is_one_part(content: Any) -> None:
    assert encode_segments(content, JSON) == [msgspec.json.encode(content)]
