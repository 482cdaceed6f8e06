"""The kit on our server: rules that no other test of `make test` judges as a whole."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

from conformance.specification.ledger import load_ledger
from tests.support.paths import ROOT


@pytest.mark.slow("starts a server and a kit")
@pytest.mark.parametrize(
    ("profiles", "area"),
    [("ebench", "EBE"), ("flageval", "FLE"), ("", "CRASH"), ("", "PUSH")],
)
def test_the_reference_server_obeys_the_rules_of_an_area(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, profiles: str, area: str
) -> None:
    # The kit's model servers are on this machine.
    monkeypatch.setenv("PROCTOR_ALLOW_PRIVATE_POLICIES", "127.0.0.0/8")
    monkeypatch.setenv("PROCTOR_PROFILES", profiles)
    server = f"{sys.executable} -m reference_server"
    kit = [sys.executable, "-m", "conformance", "--start-cmd", server, "--only", area]
    done = subprocess.run(
        [*kit, "--report", str(tmp_path)],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stdout[-3000:]
    rows = json.loads((tmp_path / "report.json").read_text())["rows"]
    outcomes = {row["requirement_id"]: row["outcome"] for row in rows}
    assert outcomes == {
        row.id: "passed" if row.is_observable else "not_verified"
        for row in load_ledger().values()
        if row.id.startswith(f"{area}-")
    }
