"""Videos of a run that has just been played, drawn from its record.

They are made by the program of `proctor video`, in a process of its own.
"""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path

import msgspec
from proctor_client import Episode

from reference_client.command import programs
from reference_record.unsigned_record import save_blocks


def draw_videos(
    fetch: Callable[[], Iterator[bytes]],
    episodes: Sequence[Episode],
    count: int,
    folder: Path,
) -> list[Path]:
    """Videos of `count` episodes, failures first, in `folder`.

    Episodes whose seeds are sealed cannot be drawn; they are left out.

    fetch: the record of the run, block by block.
    Raises ProctorError where there is no record, UsageError where the program is not
    installed, and RuntimeError with what it says.
    """
    module = programs.require("video")
    played = [e for e in episodes if e.result and e.result.seed is not None]
    played.sort(key=lambda e: (e.result is not None and e.result.score, e.index))
    if not played:
        raise RuntimeError("no episode has a seed that is shown to this account")
    record = folder / "run.proctor"
    save_blocks(record, fetch())
    output = folder / "videos"
    job = {
        "kind": "video",
        "record": str(record),
        "output": str(output),
        "episodes": [episode.index for episode in played[:count]],
        "json": True,
    }
    made = subprocess.run(
        [sys.executable, "-m", module, msgspec.json.encode(job).decode()],
        capture_output=True,
        text=True,
        check=False,
    )
    videos = sorted(output.glob("*.mp4"))
    if not videos:
        said = made.stderr.strip().splitlines()
        reason = said[-1] if said else f"exit code {made.returncode}"
        raise RuntimeError(reason.removeprefix("proctor: "))
    return videos
