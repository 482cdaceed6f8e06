"""A program behind the reference server: scored, and replaced when it dies."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from reference_client import evaluate
from reference_sim.external import LIBRARIES
from tests.support.processes import descendants, wait_until_ended
from tests.support.servers import TOKENS, ReferenceServer
from tests.support.sim import breakable_simulator

pytestmark = pytest.mark.slow("starts servers")


class AddTheMost:
    """After 20 steps the sum is 2 of 3."""

    def reset(self, instruction: str) -> None:
        assert instruction in ("Please count.", "Please hold.")

    def act(self, observation: Any) -> dict[str, list[float]]:
        assert observation.images["bar"].shape == (6, 8, 1)
        assert observation.tensors["sums"].shape == (2,)
        return {"add": [0.1]}


def test_a_program_that_dies_costs_a_fault_and_no_score(tmp_path: Path) -> None:
    """Its first process dies in an episode. Expect every episode scored, and one fault.

    Nothing that the server started outlives it.
    """
    library = f"PYTHONPATH={LIBRARIES}"
    program = [sys.executable, "-S", breakable_simulator.__file__, "dies_once"]
    benchmark = tmp_path / "counting.toml"
    benchmark.write_text(f"simulator = {json.dumps(['env', library, *program])}\n")
    with ReferenceServer(tmp_path, PROCTOR_BENCHMARKS=str(benchmark)) as server:
        score = evaluate(
            AddTheMost,
            url=server.url,
            token=TOKENS["alice"],
            benchmark="counting",
            workers=2,
        )
        assert (score.counts.total, score.counts.failure) == (6, 6)
        assert score.mean == pytest.approx(2 / 3)
        log = server.log()
        assert "env ended with exit code 9" in log
        started = descendants(server.process.pid)
        assert len(started) > 4
    wait_until_ended(started)


def test_a_record_of_chance_promises_no_replay(tmp_path: Path) -> None:
    """Expect the record to say so, `verify` to show it, and `replay` to refuse."""
    program = [sys.executable, "-S", breakable_simulator.__file__, "by_chance"]
    benchmark = tmp_path / "chance.toml"
    benchmark.write_text(f"simulator = {json.dumps(program)}\n")
    record = tmp_path / "run.proctor"
    settings = {"PROCTOR_BENCHMARKS": str(benchmark), "PROCTOR_RECORD_PROMISE": "exact"}
    with ReferenceServer(tmp_path, **settings) as server:
        score = evaluate(
            AddTheMost, url=server.url, token=TOKENS["alice"], benchmark="chance"
        )
        done = proctor("export", score.run_id, "--output", str(record), server=server)
        assert done.returncode == 0, done.stderr
    shown = proctor("verify", str(record)).stdout
    assert "no replay, because its simulator is not deterministic" in shown
    for command, options in (("replay", ()), ("video", ("--episode", "1"))):
        of = (str(record), "--benchmarks", str(benchmark))
        done = proctor(command, *of, *options)
        assert done.returncode == 2, done.stdout
        assert "its records promise no replay" in done.stderr


def proctor(
    *arguments: str, server: ReferenceServer | None = None
) -> subprocess.CompletedProcess[str]:
    environment = os.environ | (
        {}
        if server is None
        else {"PROCTOR_URL": server.url, "PROCTOR_TOKEN": TOKENS["alice"]}
    )
    command = [sys.executable, "-m", "reference_client.command", *arguments]
    return subprocess.run(
        command, env=environment, capture_output=True, text=True, check=False
    )
