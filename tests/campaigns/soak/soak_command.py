"""`python -m tests.campaigns soak`: submissions through a host that fails, judged.

40 submissions; with --long 200, as promised. As root the disk can be full, too.
"""

from __future__ import annotations

import argparse
import os
import tempfile
import time
from pathlib import Path
from random import Random

from tests.campaigns.soak.participants import Participant
from tests.campaigns.soak.soak_host import FAULTS, SoakHost, soak_host
from tests.campaigns.soak.soak_judge import (
    PROMISED,
    Soak,
    judge_all,
    judge_participant,
    summary,
    write,
)
from tests.support.platform.uploaded_policies import go_image
from tools.built_pages import write_page

SHORT = 40
CALM = 3
# After the last fault, what is removed in the background is gone.
TIDY_S = 20.0


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--submissions", type=int, default=0, metavar="N")
    parser.add_argument("--participants", type=int, default=4)
    parser.add_argument(
        "--pause-s", type=float, default=6.0, help="most between two faults"
    )


def run(options: argparse.Namespace, names: list[str]) -> bool:
    count = options.submissions or (PROMISED if options.long else SHORT)
    if os.geteuid() != 0:  # who may not mount has no disk to fill
        names = [name for name in names if name != "disk full"]
    load = os.getloadavg()[0]
    soak = play(
        count, options.participants, names, seed=options.seed, pause_s=options.pause_s
    )
    print(*soak.findings, summary(soak), *judge_all(soak), sep="\n")
    if soak.output:
        write_page("soak.log", soak.output)
    write(
        soak,
        f"seed {options.seed}, {options.participants} participants, load before it "
        f"{load:.1f}",
    )
    return not soak.findings


def play(
    count: int, participants: int, names: list[str], *, seed: int, pause_s: float
) -> Soak:
    """names: of the faults."""
    soak = Soak()
    with (
        tempfile.TemporaryDirectory(prefix="soak-") as folder,
        soak_host(Path(folder)) as host,
    ):
        players = _begin(host, Path(folder), count, participants, seed)
        chance = Random(seed)
        waiting: list[str] = []  # each fault, before one comes again
        while any(player.is_alive for player in players):
            host.approve_images()
            waiting = waiting or chance.sample(names, len(names))
            name = waiting.pop()
            # The last ones end in calm: else each fault would hit the same submission.
            is_calm = count - _ended(players) < CALM
            has_happened = not is_calm and FAULTS[name](host, chance)
            soak.faults[name] += has_happened
            what = name if has_happened else f"no {name}"
            print(f"{what}; ended: {_ended(players)} of {count}", flush=True)
            host.ensure_running()
            time.sleep(chance.uniform(0.5, pause_s))
        for player in players:
            judge_participant(soak, player)
            player.end()
        if count >= PROMISED:
            soak.absent += [name for name in names if not soak.faults[name]]
        soak.left += _left(host)
        if soak.findings:
            soak.output = (host.directory / "log").read_text(errors="replace")
    mounts = Path("/proc/mounts").read_text().splitlines()
    soak.left += [line for line in mounts if str(host.submissions) in line]
    return soak


def _begin(
    host: SoakHost, folder: Path, count: int, participants: int, seed: int
) -> list[Participant]:
    accounts = [f"player{number}" for number in range(participants)]
    image = folder / "policy.tar"
    go_image(image)
    players = [
        Participant(
            host.url, key, name, seed=seed, image=image.read_bytes(),
            count=count // participants + (number < count % participants),
        )
        for number, (name, key) in enumerate(
            zip(accounts, host.keys_of(accounts), strict=True)
        )
    ]  # fmt: skip
    for player in players:
        player.start()
    return players


def _ended(players: list[Participant]) -> int:
    return sum(handed.is_ended for player in players for handed in player.handed)


def _left(host: SoakHost) -> list[str]:
    """List the remains beside a host that runs, and then after its end."""
    deadline = time.monotonic() + TIDY_S
    kinds = ("bubblewrap", "first process", "policy", "unpacking")
    while time.monotonic() < deadline:
        processes = [p.name() for kind in kinds for p in host.find(kind)]
        left = [*host.files_left(), *host.groups_left(), *processes]
        if not left:
            break
        time.sleep(0.2)
    if (code := host.end()) not in (0, 143):
        left.append(f"the host ended with {code}")
    time.sleep(1.0)
    return [*left, *host.processes_left(), *host.groups_left()]
