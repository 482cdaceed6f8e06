"""An operator of a robot cell who does what a plan says, and counts it."""

import json
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from io import BytesIO
from pathlib import Path
from typing import Any, Protocol
from zipfile import ZipFile

import httpx

from reference_record.recordings.mcap_reader import McapReader
from tests.support.waiting import wait_until


class OperatedCell(Protocol):
    """A cell, and the acts of its operator."""

    def cell(self) -> dict[str, Any]: ...
    def act(self, act: str, **members: Any) -> httpx.Response: ...


class ScriptedOperator:
    """Prepares and judges until it is ended; counts what it judged itself. plan: what
    to do with each trial in turn, the last one from then on."""

    def __init__(self, bench: OperatedCell, *plan: str) -> None:
        self._bench, self._plan = bench, list(plan)
        self.judged: list[tuple[str, bool]] = []
        self.success_by_trial: dict[int, bool] = {}
        self.voids = 0
        self.errors: list[str] = []
        self._ended = threading.Event()

    def work(self) -> None:
        last = None
        while not self._ended.wait(0.02):
            cell = self._bench.cell()
            trial = cell["trial"]
            if cell["phase"] in ("preparing", "judging") and trial != last:
                self.doing = self._plan.pop(0) if self._plan[1:] else self._plan[0]
                last = trial
            if cell["phase"] == "preparing":
                self._act("ready", trial=trial)
            elif cell["phase"] == "playing" and self.doing == "stop":
                self._act("stop")
            elif cell["phase"] == "judging":
                self._judge(cell)
            elif cell["phase"] == "done":
                self._act("next", trial=trial)

    def _judge(self, cell: dict[str, Any]) -> None:
        if self.doing == "void":
            self.voids += 1
            self._act("void", trial=cell["trial"], reason="the light went out")
            return
        success = self.doing == "success"
        self.judged.append((cell["setup"]["name"], success))
        self.success_by_trial[cell["trial"]] = success
        self._act("judge", trial=cell["trial"], success=success, met=[0], note="seen")

    def _act(self, name: str, **members: Any) -> None:
        answer = self._bench.act(name, **members)
        if answer.status_code != 200:
            self.errors.append(answer.text)

    def has_judged(self, trials: int) -> Callable[[], bool]:
        """Whether it has judged so many trials."""
        return lambda: len(self.judged) >= trials

    def _is_between_trials(self) -> bool:
        return self._bench.cell()["phase"] in {"free", "preparing"}

    @contextmanager
    def working(self) -> Iterator[None]:
        thread = threading.Thread(target=self.work, daemon=True)
        thread.start()
        try:
            yield
            # A run is over before its last judgement is put away.
            wait_until(self._is_between_trials, "the cell is between two trials")
        finally:
            self._ended.set()
            thread.join()


def judgements_of(record: Path) -> list[dict[str, Any]]:
    """The judgements in the recordings of a record, in the order of the episodes."""
    said = []
    with ZipFile(record) as archive:
        for name in sorted(archive.namelist()):
            if name.endswith(".mcap"):
                data = archive.read(name)
                reader = McapReader(name, BytesIO(data), len(data))
                said += [
                    json.loads(bytes(message))
                    for topic, message in reader.messages()
                    if topic == "/judgement"
                ]
    return said
