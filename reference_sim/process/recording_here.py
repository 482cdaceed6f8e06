"""Writes on this machine what a simulator of another machine records."""

from __future__ import annotations

import threading
from pathlib import Path

import msgspec

from reference_record.recordings.recording_parts import PartWriter
from reference_sim.process.recorder import PARTS_MAX, RecordingPlan


class RecordingHere:
    """The recording of one simulator, attempt after attempt. All raise OSError."""

    def __init__(self) -> None:
        self._part: PartWriter | None = None
        # A session may end while a thread writes.
        self._lock = threading.Lock()

    def begin(self, plan: RecordingPlan | None) -> RecordingPlan | None:
        """Open a part; the plan that the simulator gets."""
        self.close()
        if plan is None:
            return None
        self._part = PartWriter(Path(plan.folder), PARTS_MAX)
        return msgspec.structs.replace(plan, folder="")

    def append(self, recorded: bytes) -> None:
        """Survives the end of this process once this returns."""
        with self._lock:
            if self._part is not None:  # else its session has just ended
                self._part.append(recorded)

    def close(self) -> None:
        with self._lock:
            part, self._part = self._part, None
            if part is not None:
                part.close()
