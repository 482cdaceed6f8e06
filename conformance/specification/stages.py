"""The stages in which a server is written, and the rules that each of them adds.

A rule belongs to the first stage whose operations are enough for its check. Rules of
further profiles are judged in the last stage, where every rule that applies is.
"""

from dataclasses import dataclass

from conformance.specification.ledger import CORE, SERVICE, Requirement


@dataclass(frozen=True)
class Stage:
    """`adds` says what the server serves from this stage on."""

    number: int
    name: str
    adds: str


STAGES = (
    Stage(1, "describe", "`describe_service`"),
    Stage(
        2,
        "benchmarks",
        "`list_benchmarks` and `get_benchmark` with the benchmark `calibration`, "
        "tokens, and refusals as problems",
    ),
    Stage(
        3,
        "runs",
        "`submit_run` with Idempotency-Keys, `get_run`, `list_runs`, `list_episodes` "
        "and `stop_run`",
    ),
    Stage(
        4,
        "turns",
        "`attach_worker`, `predict` and `detach_worker`, and the tasks of "
        "`calibration`",
    ),
    Stage(
        5,
        "leases and takeover",
        "`heartbeat`, the end of a lease, takeover, faults and `resume_run`",
    ),
    Stage(
        6,
        "scores and crashes",
        "`get_score`, every cell of the lifecycle, what outlives a crash, and the "
        "profiles that you announce",
    ),
)
BENCHMARKS, RUNS, LAST = 2, 3, STAGES[-1].number
_BY_AREA = {
    "BEN": 2,
    "RUN": 3,
    **dict.fromkeys(("ATT", "PRED", "DET", "EPI", "ENC", "CAL"), 4),
    **dict.fromkeys(("LEASE", "STOP", "RES", "FAULT"), 5),
}
# Whose checks need less or more than their area does.
_BY_ID = {
    **dict.fromkeys(("SVC-001", "SVC-002"), 1),
    **dict.fromkeys(
        ("AUTH-004", "BEN-003", "BEN-005", "BEN-006", "ERR-009", "LEASE-007"), 3
    ),
    **dict.fromkeys(("LIFE-102", "LIFE-103", "LIFE-202", "LIFE-203"), 3),
    **dict.fromkeys(("RUN-003", "RUN-008", "RUN-012", "RUN-014"), 4),
    **dict.fromkeys(("RUN-024", "RUN-025"), 4),
    **dict.fromkeys(("RUN-016", "RUN-018", "RUN-019", "RUN-020", "RUN-021"), 5),
    **dict.fromkeys(("RUN-022", "RUN-023", "RUN-030"), 5),
    **dict.fromkeys(("ATT-005", "ATT-019", "PRED-002", "DET-005"), 5),
    **dict.fromkeys(("EPI-003", "EPI-004", "EPI-010", "EPI-011", "EPI-012"), 5),
    **dict.fromkeys(("ATT-003", "ATT-010", "ATT-017", "EPI-009"), LAST),
    **dict.fromkeys(("DET-002", "DET-004", "RES-003", "STOP-001", "STOP-005"), LAST),
}


def stage_of(rule: Requirement) -> int:
    """Give the number of the first stage in which a rule is judged."""
    if rule.profile not in (CORE, *SERVICE):
        return LAST
    return _BY_ID.get(rule.id) or _BY_AREA.get(rule.area, LAST)


def advice(number: int, *, is_done: bool, first: str | None, skips: bool) -> str:
    """Say what to do next.

    first: the first rule that is not verified. skips: rules of the stage were left out.
    """
    stage = STAGES[number - 1]
    here = f"stage {number} of {LAST} ({stage.name})"
    if not is_done:
        begin = (
            f"begin with {first}: --only {first}" if first else "see the reason above"
        )
        return f"{here} is not done; {begin}"
    if skips:
        return f"{here}: nothing is wrong so far; run it without --quick to finish it"
    if number == LAST:
        return (
            f"{here} is done: the server is whole; run it without --stage to claim it"
        )
    following = STAGES[number]
    return f"{here} is done; next, serve {following.adds}: --stage {following.number}"
