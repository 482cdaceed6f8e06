"""The only module that imports PyAV: H.264 in MP4, one picture after another.

Keyframes stand at a fixed distance, so that a player that is sent to a second begins
there. Pictures that browsers play have even sides and a quarter of the colours.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from fractions import Fraction
from pathlib import Path
from typing import Any

import av
import numpy as np
from numpy.typing import NDArray

_BT601, _LIMITED = 6, 1  # numbers that H.264 gives to colours, as FFmpeg converts them
OPTIONS = {"preset": "veryfast", "crf": "18"}
PIXEL_FORMAT = "yuv420p"


class VideoFile:
    """Writes one file; `close` makes it whole. Raises OSError.

    rate: pictures in a second. size: width and height of all pictures, in pixels.
    keyframe_every: distance of keyframes, in pictures. texts: metadata of the file.
    """

    def __init__(
        self,
        path: Path,
        rate: Fraction,
        size: tuple[int, int],
        *,
        keyframe_every: int,
        texts: Mapping[str, str],
    ) -> None:
        self.size = size
        self.pictures = 0
        self._path = path
        with self._encoding():
            self._container = av.open(
                str(path), "w", format="mp4", options={"movflags": "+faststart"}
            )
        self._container.metadata.update(texts)
        # One where the picture changes much would stand at no fixed distance.
        fixed = f"keyint={keyframe_every}:min-keyint={keyframe_every}:scenecut=0"
        options = OPTIONS | {"x264-params": fixed}
        stream: Any = self._container.add_stream("libx264", rate=rate, options=options)
        stream.width, stream.height = encoded_size(size)
        stream.pix_fmt = PIXEL_FORMAT
        stream.codec_context.max_b_frames = 0
        stream.codec_context.colorspace = _BT601
        stream.codec_context.color_range = _LIMITED
        self._stream = stream
        self._time_base = 1 / rate

    def add(self, picture: NDArray[np.uint8]) -> None:
        """picture: (height, width, 1 or 3), grey or RGB."""
        frame: Any = av.VideoFrame.from_ndarray(_even_rgb(picture), format="rgb24")
        frame = frame.reformat(format=PIXEL_FORMAT, dst_colorspace="ITU601")
        frame.pts, frame.time_base = self.pictures, self._time_base
        with self._encoding():
            self._container.mux(self._stream.encode(frame))
        self.pictures += 1

    def close(self) -> None:
        """Write the frames that the encoder still holds, and the index."""
        with self._encoding():
            self._container.mux(self._stream.encode())
            self._container.close()

    @contextmanager
    def _encoding(self) -> Iterator[None]:
        """The library's errors are of a class of their own."""
        try:
            yield
        except av.FFmpegError as error:
            text = f"the video could not be written: {error.strerror}"
            raise OSError(error.errno, text, str(self._path)) from error


def encoded_size(size: tuple[int, int]) -> tuple[int, int]:
    """Width and height of a video of pictures of this size."""
    width, height = size
    return width + width % 2, height + height % 2


def _even_rgb(picture: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """The last row or column stands twice where their number is odd."""
    height, width, channels = picture.shape
    if channels == 1:
        picture = np.repeat(picture, 3, axis=2)
    if height % 2 or width % 2:
        edges = (0, height % 2), (0, width % 2), (0, 0)
        picture = np.pad(picture, edges, mode="edge")
    return np.ascontiguousarray(picture)
