"""A worker's latest turn for the live view: small images, texts and times.

Made on request only, from the snapshot that the worker stores.
"""

from __future__ import annotations

import base64
import io
from typing import Any

import numpy as np
import numpy.typing as npt

from reference_client.evaluation.status_board import TurnSnapshot

WIDTH_MAX = 320  # pixels, of a picture on the page


def describe_turn(snapshot: TurnSnapshot) -> dict[str, Any]:
    """JSON-able: texts, times in seconds, and JPEG pictures in base64 by camera."""
    turn, observation = snapshot.turn, snapshot.observation
    return {
        "instruction": observation.instruction,
        "episode_id": observation.episode_id,
        "step": observation.step + turn.executed_steps,
        "task": turn.episode.task if turn.episode else "",
        "think_s": snapshot.think_s,
        "server_s": turn.timing.total_s,
        "wire_s": max(0.0, snapshot.turn_s - turn.timing.total_s),
        "done": turn.done,
        "images": {
            name: _jpeg(picture) for name, picture in observation.images.items()
        },
    }


def _jpeg(picture: npt.NDArray[np.uint8]) -> str:
    import PIL.Image

    flat = picture[:, :, 0] if picture.shape[2] < 3 else picture[:, :, :3]
    every = -(-picture.shape[1] // WIDTH_MAX)
    image = PIL.Image.fromarray(np.ascontiguousarray(flat[::every, ::every]))
    file = io.BytesIO()
    image.save(file, "JPEG", quality=80)
    return base64.b64encode(file.getvalue()).decode()
