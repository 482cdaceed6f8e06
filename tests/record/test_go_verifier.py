"""The verifier in Go, which was written from spec/record.md, names the same."""

import json
import os
import subprocess
from pathlib import Path

import pytest

from tests.support.paths import ROOT
from tools.example_servers import GO

VECTORS = ROOT / "spec" / "vectors" / "record"
SOURCE = ROOT / "examples" / "verify_go"

pytestmark = [
    pytest.mark.slow("builds a program"),
    pytest.mark.skipif(not GO, reason="set-up brings no Go"),
]


def run_go(*arguments: str | Path) -> None:
    done = subprocess.run(
        [str(GO), *arguments],
        cwd=SOURCE,
        env=os.environ | {"GOTOOLCHAIN": "local", "GOFLAGS": "-mod=readonly"},
        capture_output=True,
        text=True,
        timeout=600,
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr


def test_the_go_verifier_agrees_on_every_vector(tmp_path: Path) -> None:
    program = tmp_path / "verify-go"
    run_go("vet", "./...")
    run_go("build", "-o", program, ".")
    listed = json.loads((VECTORS / "records.json").read_text())
    keys = [w for k, name in listed["keys"].items() for w in ("--key", f"{name}={k}")]
    paths = [str(VECTORS / one["record"]) for one in listed["records"]]
    done = subprocess.run(
        [program, *keys, *paths], capture_output=True, text=True, check=False
    )
    assert done.returncode == 1, done.stderr
    found = [json.loads(line) for line in done.stdout.splitlines()]
    members = ("file", "rule", "levels")
    assert [[Path(a["record"]).name, *(a[m] for m in members)] for a in found] == [
        [one["record"], *(one[m] for m in members)] for one in listed["records"]
    ]
