"""Simulators and sandboxes on a real Ray cluster, in the environment that has Ray.

The wheel of Ray takes 250 MB, so it is in .venv-cluster, which `make test` makes.
"""

from __future__ import annotations

import os
import subprocess

import pytest

from tests.support.paths import ROOT

PYTHON = ROOT / ".venv-cluster" / "bin" / "python"
TIMEOUT_S = 300.0  # 25 s on a machine with nothing else to do


@pytest.mark.slow("starts a Ray cluster")
def test_simulators_on_a_ray_cluster() -> None:
    run_checks("ray_checks.py")


@pytest.mark.release("sandboxes on a Ray cluster")
def test_sandboxes_on_a_ray_cluster() -> None:
    run_checks("sandbox_checks.py")


def run_checks(name: str) -> None:
    checks = [str(PYTHON), "-m", "pytest", "-q", f"tests/cluster/on_ray/{name}"]
    # Ray leaves its own processes and files to the collector.
    quiet = ["-p", "no:cacheprovider", "-W", "ignore::ResourceWarning"]
    # Of the outer pytest, whose plugins may not be there.
    inherited = {k: v for k, v in os.environ.items() if not k.startswith("PYTEST_")}
    done = subprocess.run(
        [*checks, *quiet],
        cwd=ROOT,
        env=inherited,
        capture_output=True,
        text=True,
        timeout=TIMEOUT_S,
        check=False,
    )
    assert done.returncode == 0, done.stdout[-6000:] + done.stderr[-2000:]
