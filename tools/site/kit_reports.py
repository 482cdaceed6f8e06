"""Reports of the kit on servers, for the pages: worked exchanges and verdicts.

The reference server is judged here, once for each state of the code; the report is kept
in build/site/ and read again until the specification, the kit or the server changes.
Reports of other servers are files NAME.json in build/implementations/.
"""

import hashlib
import json
import shlex
import subprocess
import sys
import tempfile
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from tools.site.exchanges import worked_exchanges

ROOT = Path(__file__).resolve().parents[2]
REPORT = ROOT / "build" / "site" / "reference_report.json"
IMPLEMENTATIONS = ROOT / "build" / "implementations"
REFERENCE = "Reference server (Python)"
SEED = 1
# With every profile that one server can have.
SERVER = shlex.join(
    [
        *(sys.executable, "-m", "reference_server"),
        *("--profiles", "ebench,flageval"),
        *("--public-board", "on", "--record-imports", "on"),
    ]
)
RECORDED = ("spec", "conformance", "reference_*")

Plain = dict[str, Any]


@dataclass(frozen=True)
class KitReports:
    """exchanges: rule → its exchanges. verdicts: server → what a page shows of it."""

    exchanges: Mapping[str, Sequence[Plain]]
    verdicts: Mapping[str, Plain]


def read_reports() -> KitReports:
    """Judge the reference server if that is not done yet, and read all reports.

    Raises RuntimeError where the kit does not find the server conformant, ValueError
    where a report is not one of a whole run.
    """
    reports = {REFERENCE: _reference_report()} | {
        path.stem: json.loads(path.read_text())
        for path in sorted(IMPLEMENTATIONS.glob("*.json"))
    }
    verdicts = {name: summarize(name, report) for name, report in reports.items()}
    return KitReports(worked_exchanges(reports[REFERENCE]), verdicts)


def _reference_report() -> Plain:
    """Read the kept report, or make a new one where the code has changed."""
    digest = _digest()
    if REPORT.exists():
        kept: Plain = json.loads(REPORT.read_text())
        if kept["digest"] == digest:
            report: Plain = kept["report"]
            return report
    print("site: the kit judges the reference server, some minutes", flush=True)
    report = judge()
    REPORT.parent.mkdir(parents=True, exist_ok=True)
    REPORT.write_text(json.dumps({"digest": digest, "report": report}))
    return report


def _digest() -> str:
    """Hash the files whose change may change an exchange."""
    digest = hashlib.sha256()
    for pattern in RECORDED:
        for folder in sorted(ROOT.glob(pattern)):
            for path in sorted(folder.rglob("*")):
                if path.suffix in (".py", ".md", ".yaml", ".json"):
                    digest.update(f"{path.relative_to(ROOT)}\n".encode())
                    digest.update(path.read_bytes())
    return digest.hexdigest()


def judge(rules: Sequence[str] = (), *, quick: bool = False) -> Plain:
    """Run the kit against the reference server; return its report, with exchanges.

    rules: ids, or the beginnings of ids; all without them.
    """
    with tempfile.TemporaryDirectory(prefix="proctor-exchanges-") as directory:
        command = [sys.executable, "-m", "conformance", "--start-cmd", SERVER]
        command += ["--seed", str(SEED), "--exchanges", "--report", directory]
        command += ["--only", ",".join(rules)] if rules else []
        command += ["--quick", "-n", "1"] if quick else []
        done = subprocess.run(
            command, cwd=ROOT, capture_output=True, text=True, check=False
        )
        if done.returncode != 0:
            raise RuntimeError(done.stdout[-3000:] + done.stderr[-1000:])
        report: Plain = json.loads((Path(directory) / "report.json").read_text())
        return report


def summarize(name: str, report: Plain) -> Plain:
    """Select what a page shows of a report."""
    is_excused = any(row["is_known_failure"] for row in report["rows"])
    if report["only"] or report["quick"] or report["stage"] or is_excused:
        raise ValueError(f"{name}: its report is not one of a whole run")
    return {
        "server": f"{report['server']['name']} {report['server']['version']}",
        "specification": report["spec"]["version"],
        "date": report["started_at"][:10],
        "conclusion": report["conclusion"],
        "headline": report["headline"],
        "rules": {row["requirement_id"]: row["outcome"] for row in report["rows"]},
    }
