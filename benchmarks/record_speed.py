"""How long a record of many episodes takes: `python -m benchmarks.record_speed`.

Prints seconds, peak memory and bytes for export (sign and stream) and for verification
of EPISODES × TURNS, each in a process of its own; docs/evaluate/records.md has the
figures.
"""

from __future__ import annotations

import argparse
import multiprocessing
import resource
import shutil
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np

from reference_record.export import save_blocks
from reference_record.formats.bundle import open_bundle
from reference_record.recording import Message, Turn
from reference_record.verification import verify
from tests.support.record.sample_records import (
    Messages,
    Sample,
    at,
    ended,
    result,
    started,
)

JOINTS = 8


def make_episode(index: int, turns: int) -> Messages:
    chance = np.random.default_rng(index)
    played: list[tuple[str, Message]] = [started(1, index)]
    for seq in range(1, turns + 1):
        actions = [{"arm": chance.uniform(-1, 1, JOINTS).tolist()}]
        digest = chance.bytes(16).hex()
        think = float(chance.uniform(5, 50))
        is_last = seq == turns
        played.append(
            (
                "/turn",
                Turn(
                    attempt=1,
                    seq=seq,
                    actions=actions,
                    rewards=[0.0],
                    steps=1,
                    score=float(is_last),
                    success=is_last,
                    ended=is_last,
                    state_digest=digest,
                    simulate_ms=round(think / 10, 4),
                    think_ms=round(think, 4),
                    at=at(seq),
                ),
            )
        )
    return [*played, ended(1, "scored"), result("success", 1.0, turns, 1)]


def measure(what: str, work: Callable[[], None]) -> None:
    begun = time.monotonic()
    work()
    seconds = time.monotonic() - begun
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    print(f"{what}: {seconds:.2f} s, at most {memory:.0f} MiB")


def in_its_own_process(what: str, work: Callable[[], None]) -> None:
    process = multiprocessing.get_context("fork").Process(
        target=measure, args=(what, work)
    )
    process.start()
    process.join()
    if process.exitcode:
        sys.exit(f"{what} failed")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--episodes", type=int, default=1000)
    parser.add_argument("--turns", type=int, default=200)
    args = parser.parse_args()
    folder = Path(tempfile.mkdtemp(prefix="proctor-records-"))
    try:
        path = folder / "run.proctor"
        # One recording for all places: what is measured does not depend on its content.
        sample = Sample([make_episode(0, args.turns)] * args.episodes)
        (folder / "recordings").mkdir()
        lines = sample.play(folder / "recordings")

        def export() -> None:
            signed = sample.sign(lines, folder / "recordings")
            save_blocks(path, signed.stream())

        in_its_own_process("export", export)
        print(f"size: {path.stat().st_size / 1e6:.1f} MB")
        in_its_own_process("verify", lambda: print(verify(open_bundle(path)).levels))
    finally:
        shutil.rmtree(folder)


if __name__ == "__main__":
    main()
