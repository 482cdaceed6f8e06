"""A program behind the reference server: scored, and replaced when it dies."""

from __future__ import annotations

import json
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
