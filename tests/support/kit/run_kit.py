"""A whole kit in a process of its own, as its user starts it, but without its imports.

It is forked (`tests/support/forking`). Only a test of how the program itself starts has
a reason to start another interpreter.
"""

from __future__ import annotations

import json
import os
import subprocess
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

import jsonschema_rs

from tests.support.forking.forked_kits import POLICY_KIT, SIMULATOR_KIT, kit_command
from tests.support.paths import ROOT

REPORT_SCHEMA = jsonschema_rs.validator_for(
    json.loads((ROOT / "conformance" / "reports" / "report.schema.json").read_text())
)
TIMEOUT_S = 1200.0


@dataclass(frozen=True)
class KitRun:
    """The exit code, the output and the folder of reports of a kit that has ended."""

    code: int
    output: str
    folder: Path

    @cached_property
    def report(self) -> dict[str, Any]:
        """The document report.json, which fits its schema; empty if there is none."""
        path = self.folder / "report.json"
        if not path.exists():
            return {}
        report: dict[str, Any] = json.loads(path.read_text())
        REPORT_SCHEMA.validate(report)
        assert report["exit_code"] == self.code
        return report

    @cached_property
    def rows(self) -> dict[str, dict[str, Any]]:
        """The rows of the report by the ids of their rules."""
        return {row["requirement_id"]: row for row in self.report["rows"]}

    @property
    def outcomes(self) -> dict[str, str]:
        return {rule: row["outcome"] for rule, row in self.rows.items()}

    def rules_with(self, outcome: str) -> set[str]:
        return {rule for rule, found in self.outcomes.items() if found == outcome}

    @property
    def last_line(self) -> str:
        return self.output.strip().splitlines()[-1]


def run_kit(
    folder: Path, *options: str | Path, command: Sequence[str] = (), **environment: str
) -> KitRun:
    """Run a kit to its end. The kit may not break: a traceback fails the test.

    folder: of its reports. command: starts the kit, if not as a forked `conformance`,
        which plays no further histories, unless `options` say how long.
    environment: variables of the kit beside those of the tests.
    """
    plain = (*kit_command(), "--history-time", "0")
    done = subprocess.run(
        [*(command or plain), "--report", folder, *options],
        cwd=ROOT,
        env=os.environ | {"COLUMNS": "80"} | environment,
        capture_output=True,
        text=True,
        timeout=TIMEOUT_S,
        check=False,
    )
    assert "Traceback" not in done.stderr, done.stderr
    return KitRun(done.returncode, done.stdout, folder)


def run_policy_kit(folder: Path, *options: str | Path, **environment: str) -> KitRun:
    """Run the kit of policy servers to its end."""
    command = kit_command(POLICY_KIT)
    return run_kit(folder, *options, command=command, **environment)


def run_simulator_kit(
    folder: Path, *options: str | Path, command: Sequence[str]
) -> KitRun:
    """Run the kit of simulators to its end."""
    kit = kit_command(SIMULATOR_KIT)
    return run_kit(folder, *options, *command, command=kit)
