"""The verifier in Go, written from spec/profiles/record.md, names the same."""

import json
import subprocess
from pathlib import Path

import pytest

from tests.support.paths import ROOT
from tools.example_servers import GO, run_go

VECTORS = ROOT / "spec" / "vectors" / "record"
SOURCE = ROOT / "examples" / "verify_go"

pytestmark = [
    pytest.mark.slow("builds a program"),
    pytest.mark.skipif(not GO, reason="set-up brings no Go"),
]


def test_the_go_verifier_agrees_on_every_vector(tmp_path: Path) -> None:
    program = tmp_path / "verify-go"
    run_go("vet", "./...", folder=SOURCE)
    run_go("build", "-o", program, ".", folder=SOURCE)
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
