"""One mutant per cell of the lifecycle table: it decides the opposite.

The rows are read from the specification, so that no cell can be forgotten.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from conformance.specification.ledger import load_ledger
from reference_server.rules.runs import effects
from reference_server.rules.runs import lifecycle as protocol
from reference_server.rules.runs.run import Run
from reference_server.runs.admission.run_admission import RunAdmission
from tests.mutants import Json, Row, mutants, put
from tests.support.repository.specification import DOCUMENT

# Cells through which the kit must go to reach anything else. A server that refuses them
# is seen by their own row; whatever else fails with them stands here.
ALSO: dict[str, set[str]] = {
    "LIFE-202": {"ATR-005", "ERR-017", "SUB-003"},
    "LIFE-301": {"ATR-001"},
    "LIFE-501": {"STOP-002"},
    "LIFE-504": {"ATR-005", "ERR-017", "RUN-008", "SUB-003"},
    "LIFE-802": {"ATT-015", "LEASE-011", "LEASE-012", "RUN-012"},
    "LIFE-803": {"ATT-015", "LEASE-012"},
    "LIFE-804": {
        *("AUTH-005", "EPI-009", "LEASE-012"),
        *("SEAL-001", "SEAL-002", "SUB-001"),
    },
    "LIFE-805": {"EPI-009"},
    "LIFE-806": {"FAULT-005", "FAULT-010", "RUN-012", "RUN-023"},
}

# Without these nothing can be played: there is nothing to judge.
NOT_MUTATED = {"LIFE-201", "LIFE-302", "LIFE-801"}


def _rows() -> Iterator[Row]:
    lifecycle = DOCUMENT["x-lifecycle"]
    for row in lifecycle["transitions"]:
        rule = load_ledger()[row["id"]]
        if not rule.is_observable or rule.id in NOT_MUTATED:
            continue
        verb = "accepts" if row["to"] == "refused" else "refuses"
        if row["event"] in lifecycle["events"]:
            verb = "misses"
        state = row["from"]
        if state == "failed":
            state = row.get("when", state)
        name = f"{verb}_{row['event']}_when_{state}"
        kills = {row["id"]} | ALSO.get(row["id"], set())
        yield Row(name, tuple(kills), f"The opposite of: {rule.text}", row)


@mutants(*_rows())
def break_cell(row: Json) -> None:
    """Let one cell of the lifecycle table decide the opposite."""
    cell: Any = (row["from"], row["event"])
    if row.get("when") in ("retryable", "not_retryable"):
        _flip_retryable(resumes=row["when"] == "not_retryable")
    elif row["to"] == "refused":
        protocol.TRANSITIONS[cell] = row["from"]
        if row["event"] == "attach_worker":
            # Such a run has no place to be played, either.
            put(RunAdmission, "take_place", lambda _self, _run: None)
    else:
        del protocol.TRANSITIONS[cell]


def _flip_retryable(*, resumes: bool) -> None:
    right = protocol.legal

    def wrong(run: Run, event: protocol.Event) -> bool:
        if (run.state, event) == ("failed", "resume_run"):
            return resumes
        return right(run, event)

    put(protocol, "legal", wrong)
    put(effects, "legal", wrong)
