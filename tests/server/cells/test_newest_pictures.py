"""The newest pictures of a cell, at a bounded rate, while a page shows them."""

from __future__ import annotations

import time
from typing import Any

import numpy as np
import pytest

from reference_server.cells import newest_pictures
from reference_server.cells.newest_pictures import LiveView, file_of
from reference_sim.process.observation_encoding import encode_image

NOW_S = 1000.0


def observation(value: int, codec: str = "raw", channels: int = 3) -> Any:
    pixels = np.full((4, 6, channels), value, np.uint8)
    return {
        "state": {},
        "tensors": {},
        "images": {"front": encode_image(pixels, codec)},
    }


def first_byte(view: LiveView) -> int | None:
    image = view.newest("front")
    return None if image is None else image["data"][0]


def test_pictures_are_kept_while_a_page_is_open(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Expect none without a page, a new one after each pause, and none afterwards."""
    now = NOW_S
    monkeypatch.setattr(time, "monotonic", lambda: now)
    view = LiveView()
    view.keep(observation(1))
    assert first_byte(view) is None
    view.watch()
    view.keep(None)
    view.keep(observation(2))
    now += newest_pictures.PAUSE_S / 2
    view.keep(observation(3))
    assert first_byte(view) == 2
    now += newest_pictures.PAUSE_S
    view.keep(observation(4))
    assert first_byte(view) == 4
    now += newest_pictures.WATCHED_S
    view.keep(observation(5))
    assert first_byte(view) == 4
    assert view.newest("other") is None
    view.clear()
    assert first_byte(view) is None


def test_a_kept_picture_is_a_copy() -> None:
    """The next turn overwrites the memory of this one."""
    view, seen = LiveView(), observation(7)
    memory = bytearray(seen["images"]["front"]["data"])
    seen["images"]["front"]["data"] = memoryview(memory)
    view.watch()
    view.keep(seen)
    memory[:] = bytes(len(memory))
    assert first_byte(view) == 7


@pytest.mark.parametrize(
    ("codec", "channels", "start"),
    [
        ("raw", 3, b"\xff\xd8"),
        ("raw", 1, b"\xff\xd8"),
        ("raw", 4, b"\x89PNG"),
        ("png", 3, b"\x89PNG"),
        ("jpeg", 3, b"\xff\xd8"),
    ],
)
def test_a_browser_can_show_it(codec: str, channels: int, start: bytes) -> None:
    image = observation(7, codec, channels)["images"]["front"]
    data, media_type = file_of(image)
    assert data.startswith(start)
    assert media_type == ("image/png" if start == b"\x89PNG" else "image/jpeg")
