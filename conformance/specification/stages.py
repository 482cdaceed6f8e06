"""The stages in which a server is written, and the rules that each of them adds.

A rule belongs to the first stage whose operations are enough for its check. Rules of
further profiles are judged in the last stage, where every rule that applies is.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field

from conformance.specification.document import load_spec
from conformance.specification.ledger import CORE, LEVELS, SERVICE, Requirement

SERVICE_LEVEL = "service"


@dataclass(frozen=True)
class Stage:
    """The operations of a stage, and by profile what else it adds."""

    number: int
    name: str
    operations: tuple[str, ...]
    more: Mapping[str, tuple[str, ...]] = field(default_factory=dict)

    def adds(self, level: str | None) -> str:
        """Say what a server of a level, by default the largest, serves from here on."""
        profiles = LEVELS[level or SERVICE_LEVEL]
        operations = load_spec().operations
        own = [
            f"`{name}`"
            for name in self.operations
            if operations[name].profile in profiles
        ]
        for profile, texts in self.more.items():
            own += texts if profile in profiles else ()
        *before, last = own or [""]
        return f"{', '.join(before)} and {last}" if before else last


STAGES = (
    Stage(1, "describe", ("describe_service",)),
    Stage(
        2,
        "benchmarks",
        ("list_benchmarks", "get_benchmark"),
        {CORE: ("the benchmark `calibration`", "tokens", "refusals as problems")},
    ),
    Stage(
        3,
        "runs",
        ("submit_run", "get_run", "stop_run", "list_runs", "list_episodes"),
        {"submit_once": ("Idempotency-Keys",)},
    ),
    Stage(
        4,
        "turns",
        ("attach_worker", "predict", "detach_worker"),
        {CORE: ("the tasks of `calibration`", "the refusal of every wrong body")},
    ),
    Stage(
        5,
        "leases and takeover",
        ("heartbeat", "resume_run"),
        {"sessions": ("the end of a lease", "takeover"), "faults": ("faults",)},
    ),
    Stage(
        6,
        "scores and crashes",
        ("get_score",),
        {
            CORE: ("every cell of the lifecycle",),
            "control": ("what outlives a crash",),
            "strict_http": ("the profiles that you announce",),
        },
    ),
)
BENCHMARKS, RUNS, TURNS, LEASES, LAST = 2, 3, 4, 5, STAGES[-1].number
_BY_AREA = {
    **dict.fromkeys(("BEN", "VER"), 2),
    "RUN": 3,
    **dict.fromkeys(("ATT", "PRED", "DET", "EPI", "ENC", "CAL"), 4),
    **dict.fromkeys(("LEASE", "STOP", "RES", "FAULT"), 5),
}
# Whose checks need less or more than their area does.
_BY_ID = {
    **dict.fromkeys(("SVC-001", "SVC-002", "SVC-006"), 1),
    **dict.fromkeys(("AUTH-001", "AUTH-002", "ERR-001"), 2),
    **dict.fromkeys(("CONV-001", "CONV-002", "CONV-003"), 2),
    **dict.fromkeys(("ERR-002", "ERR-003", "ERR-004", "ERR-007"), 4),
    **dict.fromkeys(("ERR-012", "ERR-015", "ERR-016", "ERR-020"), 4),
    **dict.fromkeys(("LIFE-201", "LIFE-302", "LIFE-804"), 4),
    **dict.fromkeys(
        ("AUTH-004", "BEN-003", "BEN-005", "BEN-006", "ERR-009", "LEASE-007"), 3
    ),
    **dict.fromkeys(("LIFE-102", "LIFE-103", "LIFE-202", "LIFE-203"), 3),
    **dict.fromkeys(("RUN-003", "RUN-013", "RUN-014"), 4),
    **dict.fromkeys(("RUN-024", "RUN-025"), 4),
    **dict.fromkeys(("RUN-016", "RUN-018", "RUN-019", "RUN-020", "RUN-021"), 5),
    **dict.fromkeys(("RUN-008", "RUN-012", "RUN-022", "RUN-023"), 5),
    "RUN-030": 5,
    **dict.fromkeys(("ATT-004", "ATT-006", "ATT-022", "EPI-002"), 5),
    **dict.fromkeys(("PRED-003", "PRED-024"), 5),
    **dict.fromkeys(("ATT-005", "ATT-019", "PRED-002", "DET-005"), 5),
    **dict.fromkeys(("EPI-003", "EPI-004", "EPI-010", "EPI-011", "EPI-012"), 5),
    **dict.fromkeys(("ATT-010", "ATT-017", "EPI-009", "LEASE-011"), LAST),
    **dict.fromkeys(("DET-002", "DET-004", "RES-003", "STOP-001", "STOP-005"), LAST),
}


# Whose checks need less of a server of Core, which has no leases and no stage for them.
_OF_CORE = dict.fromkeys(("LIFE-501", "LIFE-502", "LIFE-701", "LIFE-702"), TURNS)


def stage_of(rule: Requirement, level: str | None = None) -> int:
    """Give the number of the first stage in which a rule is judged, at a level."""
    if rule.profile not in (CORE, *SERVICE):
        return LAST
    number = _BY_ID.get(rule.id) or _BY_AREA.get(rule.area, LAST)
    if level != CORE:
        return number
    return _OF_CORE.get(rule.id, TURNS if number == LEASES else number)


def stage_of_operation(operation_id: str) -> int:
    """Give the number of the first stage in which an operation is served."""
    return next(
        (stage.number for stage in STAGES if operation_id in stage.operations), LAST
    )


def advice_when_not_done(number: int, first_step: str) -> str:
    """Say where to begin; first_step: the cause of most rows that are not verified."""
    return f"{_here(number)} is not done; {first_step}"


def _here(number: int) -> str:
    return f"stage {number} of {LAST} ({STAGES[number - 1].name})"


def advice_when_done(number: int, level: str | None, *, skips: bool) -> str:
    """Say what comes next. skips: rules of the stage were left out."""
    here = _here(number)
    if skips:
        return f"{here}: nothing is wrong so far; run it without --quick to finish it"
    if number == LAST:
        return (
            f"{here} is done: the server is whole; run it without --stage to claim it"
        )
    following = next(stage for stage in STAGES[number:] if stage.adds(level))
    options = f"--stage {following.number}" + (f" --level {level}" if level else "")
    return f"{here} is done; next, serve {following.adds(level)}: {options}"
