"""The newest pictures of the trial at a cell, while a page shows them.

A turn costs nothing but a comparison while no page shows the cell.
"""

from __future__ import annotations

import time
from dataclasses import dataclass, field

import numpy as np

from reference_sim.process.observation_encoding import (
    EncodedImage,
    EncodedObservation,
    encode_image,
)

WATCHED_S = 5.0  # after the cell was requested, which a page does every second
PAUSE_S = 0.4  # between two pictures that are kept


@dataclass(slots=True)
class LiveView:
    """The pictures as the policy was sent them, by camera."""

    _watched_until: float = 0.0
    _kept_at: float = 0.0
    _images: dict[str, EncodedImage] = field(default_factory=dict)

    def clear(self) -> None:
        """Another trial begins."""
        self._images.clear()
        self._kept_at = 0.0

    def keep(self, observation: EncodedObservation | None) -> None:
        """Copy the pictures, which the next turn overwrites, if a page shows them."""
        now = time.monotonic()
        is_wanted = now < self._watched_until and now >= self._kept_at + PAUSE_S
        if observation is None or not is_wanted:
            return
        self._kept_at = now
        for camera, image in observation["images"].items():
            data = memoryview(bytes(image["data"]))
            self._images[camera] = {**image, "data": data}

    def watch(self) -> None:
        """A page shows the cell."""
        self._watched_until = time.monotonic() + WATCHED_S

    def newest(self, camera: str) -> EncodedImage | None:
        """The newest picture; None if there is none yet."""
        return self._images.get(camera)


def file_of(image: EncodedImage) -> tuple[bytes, str]:
    """A picture as a browser shows it, and its media type. Blocks."""
    codec, data = image["codec"], bytes(image["data"])
    if codec == "raw":
        codec = "jpeg" if image["channels"] in (1, 3) else "png"
        shape = image["height"], image["width"], image["channels"]
        pixels = np.frombuffer(data, np.uint8).reshape(shape)
        data = bytes(encode_image(pixels, codec)["data"])
    return data, f"image/{codec}"
