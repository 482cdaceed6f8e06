"""How long a record of many episodes takes to sign and write, and to verify."""

import multiprocessing
import resource
import tempfile
from collections.abc import Callable
from pathlib import Path

import numpy as np

from benchmarks import measuring
from reference_record.formats.bundle import open_bundle
from reference_record.recordings.recording import Message, Turn
from reference_record.unsigned_record import save_blocks
from reference_record.verification import verify
from tests.support.record.sample_records import (
    Messages,
    Sample,
    at,
    ended,
    result,
    started,
)

TITLE = "Records"
EPISODES, TURNS, JOINTS = 1000, 200, 8


def make_episode(index: int, turns: int) -> Messages:
    chance = np.random.default_rng(index)
    played: list[tuple[str, Message]] = [started(1, index)]
    for seq in range(1, turns + 1):
        think = float(chance.uniform(5, 50))
        is_last = seq == turns
        turn = Turn(
            attempt=1,
            seq=seq,
            actions=[{"arm": chance.uniform(-1, 1, JOINTS).tolist()}],
            rewards=[0.0],
            steps=1,
            score=float(is_last),
            success=is_last,
            ended=is_last,
            state_digest=chance.bytes(16).hex(),
            simulate_ms=round(think / 10, 4),
            think_ms=round(think, 4),
            at=at(seq),
        )
        played.append(("/turn", turn))
    return [*played, ended(1, "scored"), result("success", 1.0, turns, 1)]


def measure(*, trying: bool) -> str:
    """Export and verify one record, each in a process of its own."""
    episodes, turns = (50, 50) if trying else (EPISODES, TURNS)
    where = measuring.machine()
    with tempfile.TemporaryDirectory(prefix="proctor-records-") as scratch:
        folder = Path(scratch)
        path = folder / "run.proctor"
        # One recording for all places: what is measured does not depend on its content.
        sample = Sample([make_episode(0, turns)] * episodes)
        (folder / "recordings").mkdir()
        lines = sample.play(folder / "recordings")

        def export() -> None:
            signed = sample.sign(lines, folder / "recordings")
            save_blocks(path, signed.stream())

        def check() -> None:
            measuring.say(str(verify(open_bundle(path)).levels))

        rows = [
            _in_its_own_process("sign and write", export),
            _in_its_own_process("verify", check),
        ]
        size_mb = path.stat().st_size / 1e6
    head = [f"{episodes} episodes of {turns} turns", "seconds", "memory, MiB"]
    return f"{measuring.table(head, rows)}\n\n{size_mb:.1f} MB. {where}"


def _in_its_own_process(name: str, work: Callable[[], None]) -> list[str]:
    """A row of the table: seconds, and peak memory of a process that does no more."""
    fork = multiprocessing.get_context("fork")
    answers = fork.SimpleQueue()

    def do_work() -> None:
        seconds = measuring.seconds_of(work)
        memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
        answers.put([name, f"{seconds:.2f}", f"{memory:.0f}"])

    process = fork.Process(target=do_work)
    process.start()
    process.join()
    if process.exitcode:
        raise RuntimeError(f"{name} failed")
    row: list[str] = answers.get()
    return row
