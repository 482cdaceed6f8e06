"""The reference server with a clock that a campaign can set.

`python -m tests.campaigns.patched_server`, with a directory in CAMPAIGN_DIRECTORY: its
file `clock` holds seconds that the wall clock is wrong by, read at each look.
"""

from __future__ import annotations

import os
import sys
import time
from pathlib import Path


def _patch_clock(file: Path) -> None:
    original = time.time

    def wrong_time() -> float:
        try:
            return original() + float(file.read_text() or 0)
        except (OSError, ValueError):
            return original()

    time.time = wrong_time


def main() -> int:
    directory = Path(os.environ["CAMPAIGN_DIRECTORY"])
    _patch_clock(directory / "clock")
    from reference_server.__main__ import main as serve

    return serve()


if __name__ == "__main__":
    sys.exit(main())
