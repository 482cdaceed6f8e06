"""`python -m tests.mutants.kill [NAME…]`: run the kit against mutants, compare.

A mutant is killed when the kit fails exactly the requirements that it breaks. The rows
MODEL-… say that all rules hold together, so whatever breaks one rule may break them as
well: they have to fail where a mutant names them, may fail with it, and are left out
elsewhere. What is broken in a profile of its own, on whose code no other rule rests, is
judged by the rows of that profile. With --write the result of all of them becomes
docs/contribute/kill-matrix.md.
"""

from __future__ import annotations

import argparse
import contextlib
import json
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

from conformance.specification.ledger import PROFILES, load_ledger
from reference_sim.mujoco.rendering import RenderingUnavailable, find_backend
from tests.mutants import Mutant, load

ROOT = Path(__file__).parents[2]
# Long enough for every wait in the kit to time out one after another.
KIT_TIMEOUT_S = 600
# Profiles that are off unless asked for, and those with code of their own.
OPTIONAL_PROFILES = {"ebench", "flageval"}
SEPARATE_PROFILES = {*OPTIONAL_PROFILES, "compare", "events", "push"}


@dataclass(frozen=True, slots=True)
class Kill:
    """What the kit said of a mutant."""

    mutant: Mutant
    failed: frozenset[str]
    not_verified: frozenset[str]
    exit_code: int
    elapsed_s: float

    @property
    def counted_failures(self) -> frozenset[str]:
        """What failed, but for the rows on all rules that the mutant does not name."""
        unexpected = self.failed - self.mutant.kills
        return self.failed - {id_ for id_ in unexpected if id_.startswith("MODEL-")}

    @property
    def is_exact(self) -> bool:
        return self.exit_code == 1 and self.counted_failures == self.mutant.kills

    def __str__(self) -> str:
        if self.is_exact:
            return f"killed   {self.mutant.name} ({self.elapsed_s:.0f} s)"
        missed = sorted(self.mutant.kills - self.failed)
        unexpected = sorted(self.counted_failures - self.mutant.kills)
        return (
            f"SURVIVED {self.mutant.name} ({self.elapsed_s:.0f} s): "
            f"missed {missed}, foreign {unexpected}, kit's exit code {self.exit_code}"
        )


def run_mutant(mutant: Mutant) -> Kill:
    """Run the whole kit against one mutant, with another seed while it is not exact.

    A race may hide, and a broken server on a busy machine may break in more ways than
    it was meant to; the servers that are right get one try only.
    """
    for seed in range(1, mutant.tries):
        kill = _run_kit(mutant, seed)
        if kill.is_exact:
            return kill
    return _run_kit(mutant, mutant.tries)


def _run_kit(mutant: Mutant, seed: int) -> Kill:
    with contextlib.suppress(RenderingUnavailable):
        find_backend()  # once for all servers: they inherit what was found
    with tempfile.TemporaryDirectory() as report:
        server = f"{sys.executable} -m tests.mutants.serve {mutant.name}"
        profiles = {load_ledger()[id_].profile for id_ in mutant.kills}
        if enabled_profiles := profiles & OPTIONAL_PROFILES:
            server += f" --profiles {','.join(sorted(enabled_profiles))}"
        kit = [sys.executable, "-m", "conformance", "--start-cmd", server]
        kit += _selection(mutant, profiles)
        done = subprocess.run(
            [*kit, "--report", report, "--seed", str(seed)],
            cwd=ROOT,
            capture_output=True,
            timeout=KIT_TIMEOUT_S,
            check=False,
        )
        found = json.loads(Path(report, "report.json").read_text())
    outcomes = {row["requirement_id"]: row["outcome"] for row in found["rows"]}
    return Kill(
        mutant,
        frozenset(id_ for id_, outcome in outcomes.items() if outcome == "failed"),
        frozenset(id_ for id_, o in outcomes.items() if o == "not_verified"),
        done.returncode,
        found["elapsed_s"],
    )


def _selection(mutant: Mutant, profiles: set[str]) -> list[str]:
    """Which rows the kit looks at."""
    if len(profiles) == 1 and profiles <= SEPARATE_PROFILES:
        return ["--profile", *profiles]
    # Killing, restarting, calling policies and following take most of the kit's time.
    left_out = {"crash", "events", "push"} - profiles
    selection = ["--profile", ",".join(p for p in PROFILES if p not in left_out)]
    if not any(id_.startswith("MODEL-") for id_ in mutant.kills):
        areas = {id_.partition("-")[0] + "-" for id_ in load_ledger()}
        selection += ["--only", ",".join(sorted(areas - {"MODEL-"}))]
    return selection


def matrix(kills: Sequence[Kill]) -> str:
    """The kill matrix as Markdown."""
    lines = [
        "# Kill matrix",
        "",
        "Servers broken on purpose, and the requirements that the kit fails on each:",
        "exactly those that the mutant breaks. Written by `make kill-matrix`.",
        "",
        "| mutant | what a user would suffer | fails |",
        "|---|---|---|",
    ]
    lines += [
        f"| `{kill.mutant.name}` | {' '.join(kill.mutant.user_impact.split())} "
        f"| {' '.join(sorted(kill.counted_failures))} |"
        for kill in sorted(kills, key=lambda k: k.mutant.name)
    ]
    exact = sum(kill.is_exact for kill in kills)
    broken = frozenset[str]().union(*(kill.counted_failures for kill in kills))
    lines += ["", f"{exact} of {len(kills)} mutants killed exactly; "]
    lines[-1] += f"{len(broken)} requirements seen to fail."
    return "\n".join(lines) + "\n"


def main() -> int:
    """Returns 0 when every mutant is killed exactly."""
    arguments = argparse.ArgumentParser(description=__doc__)
    arguments.add_argument("names", nargs="*")
    arguments.add_argument("-j", type=int, default=2, help="kits at once")
    arguments.add_argument("--write", action="store_true")
    options = arguments.parse_args()
    mutants = load()
    chosen = [mutants[name] for name in options.names or mutants]
    kills = []
    with ThreadPoolExecutor(options.j) as executor:
        for kill in executor.map(run_mutant, chosen):
            kills.append(kill)
            print(kill, flush=True)
    if options.write:
        (ROOT / "docs" / "contribute" / "kill-matrix.md").write_text(matrix(kills))
    exact = sum(kill.is_exact for kill in kills)
    print(f"{exact} of {len(kills)} mutants killed exactly")
    return 0 if exact == len(kills) else 1


if __name__ == "__main__":
    sys.exit(main())
