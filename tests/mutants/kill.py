"""`python -m tests.mutants.kill [NAME…]`: run the kit against mutants, compare.

A mutant is killed when the kit fails exactly the requirements that it breaks. Judged by
its own rows (`own`), each of them has to fail; by all rows (`all`), no other may fail.
selection.py says which mutants `make test` judges, and by which rows; `make test-all`
and `make kill-matrix` judge all by all rows, and the latter writes PAGE.

The rows MODEL-… say that all rules hold together, so whatever breaks one rule may break
them as well: they have to fail where a mutant names them, may fail with it, and are
left out elsewhere. What is broken in a profile of its own, on whose code no other rule
rests, is judged by the rows of that profile.
"""

from __future__ import annotations

import argparse
import contextlib
import json
import shlex
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

from conformance.specification.ledger import PROFILES, load_ledger
from conformance.verdicts.universal_rules import UNIVERSAL_RULES
from reference_sim.mujoco.rendering import RenderingUnavailable, find_backend
from tests.mutants import Mutant, load
from tests.mutants.fork_servers import PLAIN, Commands, fork_servers
from tests.mutants.seeded_rows import seeded_rows
from tests.mutants.selection import Rows
from tools.measurements.git_commit import read_commit

ROOT = Path(__file__).parents[2]
PAGE = ROOT / "build" / "kill-matrix.md"
ROBOT = ROOT / "tests" / "support" / "cells" / "breakable_robot.py"
# Long enough for every wait in the kit to time out one after another.
KIT_TIMEOUT_S = 600
# Profiles that are off unless asked for, and those with code of their own.
OPTIONAL_PROFILES = {"ebench", "flageval"}
SEPARATE_PROFILES = {
    *OPTIONAL_PROFILES,
    *(
        "board",
        "cluster",
        "compare",
        "deletion",
        "events",
        "hosting",
        "limits",
        "physical",
        "public_board",
        "push",
        "record",
    ),
    "record_import",
}


@dataclass(frozen=True, slots=True)
class Kill:
    """What the kit said of a mutant."""

    mutant: Mutant
    failed: frozenset[str]
    not_verified: frozenset[str]
    exit_code: int
    elapsed_s: float
    rows: Rows
    seed: int

    @property
    def counted_failures(self) -> frozenset[str]:
        """What failed, but for the rows on all rules that the mutant does not name."""
        unexpected = self.failed - self.mutant.kills
        return self.failed - {id_ for id_ in unexpected if id_.startswith("MODEL-")}

    @property
    def is_exact(self) -> bool:
        return self.exit_code == 1 and self.counted_failures == self.mutant.kills

    def __str__(self) -> str:
        judged = f"{self.rows} rows, seed {self.seed}, {self.elapsed_s:.1f} s"
        if self.is_exact:
            return f"killed   {self.mutant.name} ({judged})"
        missed = sorted(self.mutant.kills - self.failed)
        unexpected = sorted(self.counted_failures - self.mutant.kills)
        return (
            f"SURVIVED {self.mutant.name} ({judged}): "
            f"missed {missed}, foreign {unexpected}, kit's exit code {self.exit_code}"
        )


def run_mutant(mutant: Mutant, rows: Rows, commands: Commands = PLAIN) -> Kill:
    """Run the kit against one mutant, with the next seed while it is not exact.

    A race may hide, and a broken server on a busy machine may break in more ways than
    it was meant to. The seed of the result says how many seeds that took.
    """
    for seed in range(1, mutant.tries):
        kill = run_once(mutant, rows, seed, commands)
        if kill.is_exact:
            return kill
    return run_once(mutant, rows, mutant.tries, commands)


def run_once(mutant: Mutant, rows: Rows, seed: int, commands: Commands) -> Kill:
    """Run the kit against one mutant with one seed."""
    with contextlib.suppress(RenderingUnavailable):
        find_backend()  # once for all servers: they inherit what was found
    with tempfile.TemporaryDirectory() as report:
        server = [*commands.server, mutant.name]
        profiles = {load_ledger()[id_].profile for id_ in mutant.kills}
        profiles |= mutant.needs
        if enabled_profiles := profiles & OPTIONAL_PROFILES:
            server += ["--profiles", ",".join(sorted(enabled_profiles))]
        if "hosting" in profiles:
            server = [sys.executable, "-m", "tests.mutants.serve_host", mutant.name]
        if "physical" in profiles:
            server += ["--simulator", shlex.join([sys.executable, str(ROBOT)])]
        if "public_board" in profiles:
            server += ["--public-board", "on"]
        if is_cluster := "cluster" in profiles:
            server += ["--cluster", "on", "--recordings", "off"]
        if "record_import" in profiles:
            server += ["--record-imports", "on"]
        selection = _own_rows if rows == "own" else _all_rows
        done = subprocess.run(
            [
                *(*commands.kit, "--start-cmd", shlex.join(server)),
                *("--nodes", "2" if is_cluster else "1"),
                *selection(mutant, profiles),
                *("--report", report, "--seed", str(seed)),
            ],
            cwd=ROOT,
            capture_output=True,
            text=True,
            timeout=KIT_TIMEOUT_S,
            check=False,
        )
        file = Path(report, "report.json")
        assert file.exists(), f"the kit wrote no report: {done.stderr[-2000:]}"
        found = json.loads(file.read_text())
    outcomes = {row["requirement_id"]: row["outcome"] for row in found["rows"]}
    return Kill(
        mutant,
        frozenset(id_ for id_, outcome in outcomes.items() if outcome == "failed"),
        frozenset(id_ for id_, o in outcomes.items() if o == "not_verified"),
        done.returncode,
        found["elapsed_s"],
        rows,
        seed,
    )


def _own_rows(mutant: Mutant, profiles: set[str]) -> list[str]:
    if mutant.kills & set(UNIVERSAL_RULES):
        # Rules on every answer are judged by the answers that other rows cause.
        return _all_rows(mutant, profiles)
    only, profile = ",".join(sorted(mutant.kills)), ",".join(sorted(profiles))
    return ["--profile", profile, "--only", only]


def _all_rows(mutant: Mutant, profiles: set[str]) -> list[str]:
    if len(profiles) == 1 and profiles <= SEPARATE_PROFILES:
        return ["--profile", *profiles]
    # Killing, restarting, calling policies and following take most of the kit's time;
    # what rests on no rule of the core is judged by its own mutants.
    left_out = {"crash", *SEPARATE_PROFILES - {"compare"}} - profiles
    selection = ["--profile", ",".join(p for p in PROFILES if p not in left_out)]
    if not any(id_.startswith("MODEL-") for id_ in mutant.kills):
        areas = {id_.partition("-")[0] + "-" for id_ in load_ledger()}
        selection += ["--only", ",".join(sorted(areas - {"MODEL-"}))]
    return selection


def matrix(kills: Sequence[Kill], version: str) -> str:
    """The kill matrix as Markdown. version: the commit judged, and its date."""
    exact = [kill for kill in kills if kill.is_exact]
    broken = frozenset[str]().union(*(kill.counted_failures for kill in kills))
    retried = sum(kill.seed > 1 for kill in exact)
    lines = [
        "# Kill matrix",
        "",
        "Servers broken on purpose, and the requirements that the kit fails on each:",
        "exactly those that the mutant breaks. Written by `make kill-matrix`",
        f"from {version}.",
        "",
        f"{len(exact)} of {len(kills)} mutants killed exactly, {retried} of them not",
        f"with the first seed; {len(broken)} requirements seen to fail. `seeds` is how",
        "many seeds it took until exactly these failed: a race needs luck to be seen.",
        "",
        "| mutant | what a user would suffer | fails | seeds |",
        "|---|---|---|---|",
    ]
    lines += [
        f"| `{kill.mutant.name}` | {' '.join(kill.mutant.user_impact.split())} "
        f"| {' '.join(sorted(kill.counted_failures))} "
        f"| {kill.seed if kill.is_exact else 'survived'} |"
        for kill in sorted(kills, key=lambda k: k.mutant.name)
    ]
    return "\n".join(lines) + "\n"


def _seeds_of(mutant: Mutant, seeds: int) -> range:
    """The seeds by which its own rows send different requests."""
    return range(1, (seeds if mutant.kills & seeded_rows() else 1) + 1)


def main() -> int:
    """Returns 0 when every mutant is killed exactly."""
    arguments = argparse.ArgumentParser(description=__doc__)
    arguments.add_argument("names", nargs="*")
    arguments.add_argument("-j", type=int, default=2, help="kits at once")
    arguments.add_argument("--rows", choices=["own", "all"], default="all")
    arguments.add_argument("--write", action="store_true", help="rewrite the page")
    arguments.add_argument(
        "--seeds",
        type=int,
        metavar="N",
        help="each of 1 to N, where a row of the mutant draws from the seed; "
        "no second chance",
    )
    options = arguments.parse_args()
    if options.write and (options.names or options.rows != "all" or options.seeds):
        arguments.error("the page is written from all rows of all mutants")
    mutants = load()
    chosen = [mutants[name] for name in options.names or mutants]
    kills = []
    with fork_servers() as commands, ThreadPoolExecutor(options.j) as executor:
        if options.seeds:
            runs = [
                executor.submit(run_once, mutant, options.rows, seed, commands)
                for mutant in chosen
                for seed in _seeds_of(mutant, options.seeds)
            ]
        else:
            runs = [
                executor.submit(run_mutant, mutant, options.rows, commands)
                for mutant in chosen
            ]
        for kill in (run.result() for run in runs):
            kills.append(kill)
            print(kill, flush=True)
    if options.write:
        PAGE.parent.mkdir(exist_ok=True)
        PAGE.write_text(matrix(kills, "commit {} of {}".format(*read_commit())))
    exact = sum(kill.is_exact for kill in kills)
    what = "mutants with a seed" if options.seeds else "mutants"
    print(f"{exact} of {len(kills)} {what} killed exactly")
    return 0 if exact == len(kills) else 1


if __name__ == "__main__":
    sys.exit(main())
