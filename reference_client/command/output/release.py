"""Whether a run may be released in place of its baseline, and the reason for people.

The difference of the protocol is baseline minus run: it is positive where the run is
worse. Only what is worse is a reason against a release.
"""

from __future__ import annotations

from typing import Final

from proctor_client import ComparedRun, Comparison

from reference_record.comparison.difference_evidence import Evidence

ROUNDING: Final = 1e-9  # CMP-008 has the same: no rounding decides


def may_release(comparison: Comparison, run: ComparedRun) -> bool:
    """Whether all episodes are paired and nothing is worse beyond the tolerance.

    The protocol's `release` is false, too, where a run is better beyond the tolerance:
    it is the gate for a policy that has to stay the same on another chip.
    """
    return run.complete and not _beyond(comparison, run)[0]


def _beyond(comparison: Comparison, run: ComparedRun) -> tuple[list[str], list[str]]:
    """The groups that are worse and those that are better beyond the tolerance."""
    limit = comparison.tolerance + ROUNDING
    differences = {name: group.difference for name, group in run.by_task.items()}
    groups = [("overall", run.difference or 0.0)]
    groups += [(name, number or 0.0) for name, number in differences.items()]
    worse = [name for name, difference in groups if difference > limit]
    return worse, [name for name, difference in groups if difference < -limit]


def explain_release(
    comparison: Comparison, run: ComparedRun, evidence: Evidence
) -> str:
    """Only what is worse is a reason against it, unless chance explains it."""
    tolerance = f"{comparison.tolerance:g}"
    if not run.complete:
        return "no: not every episode is scored in both"
    worse, better = _beyond(comparison, run)
    if not worse and not better:
        return f"yes: no difference exceeds {tolerance}"
    if not worse:
        return (
            f"yes: nothing is worse by more than {tolerance}; "
            f"better by more: {', '.join(better)}"
        )
    by_group = {"overall": evidence.overall} | evidence.by_task
    if shown := [name for name in worse if by_group[name].is_shown]:
        return f"no: worse by more than {tolerance} in {', '.join(shown)}"
    return (
        f"not decided: worse by more than {tolerance} in {', '.join(worse)}, "
        "but chance alone may explain it; more episodes decide"
    )
