"""`python -m tests.simulation`: play many schedules, say which seeds are wrong."""

from __future__ import annotations

import argparse
import logging
import sys
import time
from concurrent.futures import ProcessPoolExecutor

from tests.simulation.schedule import Outcome, play_schedule

CHUNK = 50


def play_quietly(seed: int) -> Outcome:
    """Without the log of the simulated servers, which break all the time."""
    logging.disable(logging.CRITICAL)
    return play_schedule(seed)


def main() -> int:
    """Returns 1 if a schedule was wrong."""
    arguments = argparse.ArgumentParser(prog="python -m tests.simulation")
    arguments.add_argument("--schedules", type=int, default=1000, metavar="N")
    arguments.add_argument("--first", type=int, default=0, metavar="SEED")
    arguments.add_argument("--jobs", type=int, default=2, metavar="J")
    options = arguments.parse_args()
    seeds = range(options.first, options.first + options.schedules)
    started = time.monotonic()
    wrong = actions = kills = 0
    with ProcessPoolExecutor(options.jobs) as executor:
        for outcome in executor.map(play_quietly, seeds, chunksize=CHUNK):
            actions, kills = actions + outcome.actions, kills + outcome.kills
            if outcome.wrong:
                wrong += 1
                print(f"seed {outcome.seed}: {outcome.wrong[0]}", flush=True)
                print(
                    f"  again: python -m tests.simulation --first {outcome.seed} "
                    "--schedules 1"
                )
    rate = len(seeds) / (time.monotonic() - started)
    print(
        f"{len(seeds)} schedules, {wrong} wrong; {actions} actions executed, {kills} "
        f"servers killed; {rate:.0f} schedules a second"
    )
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
