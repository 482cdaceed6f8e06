"""A program behind the reference server: its record promises no more than it keeps."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from reference_client import evaluate
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
