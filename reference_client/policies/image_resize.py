"""Image resizing for policies: bilinear, with black padding to keep proportions.

The same arithmetic as openpi's `resize_with_pad`, with which its policies are trained:
a shift of half a pixel changes the input of a network.
"""

from __future__ import annotations

import io
from typing import Any

import numpy as np
import numpy.typing as npt


def resize_picture(
    picture: npt.NDArray[Any], height: int, width: int, *, pad: bool = True
) -> npt.NDArray[np.uint8]:
    """uint8 (h, w, channels) to (height, width, channels), bilinear.

    pad: keep the proportions and leave bars of zeros; otherwise stretch.
    """
    import PIL.Image

    if picture.shape[:2] == (height, width):
        return picture
    have_h, have_w, channels = picture.shape
    flat = picture[:, :, 0] if channels == 1 else picture
    image = PIL.Image.fromarray(np.ascontiguousarray(flat))
    ratio = max(have_w / width, have_h / height)
    inner = (width, height)
    if pad:  # at least one pixel of a picture that is far wider than high
        inner = (max(1, int(have_w / ratio)), max(1, int(have_h / ratio)))
    small = np.asarray(image.resize(inner, PIL.Image.Resampling.BILINEAR))
    small = small.reshape(inner[1], inner[0], channels)
    out = np.zeros((height, width, channels), np.uint8)
    top, left = (height - inner[1]) // 2, (width - inner[0]) // 2
    out[top : top + inner[1], left : left + inner[0]] = small
    return out


def compress_picture(picture: npt.NDArray[np.uint8], codec: str) -> bytes:
    """A JPEG (quality 95) or PNG file of uint8 (h, w, channels)."""
    import PIL.Image

    flat = picture[:, :, 0] if picture.shape[2] == 1 else picture
    file = io.BytesIO()
    image = PIL.Image.fromarray(np.ascontiguousarray(flat))
    image.save(file, codec.upper(), quality=95)
    return file.getvalue()
