"""Answers that the oracle does not allow: which row of the report they fail."""

import pytest

from conformance.exchanges.exchange import Exchange
from conformance.run_settings import Settings
from conformance.specification.document import load_spec
from conformance.verdicts.expect import ANY_CORE_SEQUENCE, ANY_SEQUENCE
from conformance.verdicts.result import Result
from conformance.verdicts.universal_rules import Tally
from conformance.verdicts.verdict import Outcome, Verdict
from tests.support.kit.concluded_results import concluded

ROWS = ["RUN-014", "SCORE-006", "EPI-001", ANY_SEQUENCE]


def exchange_of(check: str) -> Exchange:
    return Exchange(1, f"{check}/1", "GET", "http://x", None, {}, b"", 0, 200)


def with_differences(
    *differences: tuple[str, list[str]],
    failed: str = "",
    known: str = "",
    rows: list[str] = ROWS,
    profiles: tuple[str, ...] = ("core", "control"),
) -> Result:
    """Conclude a run. Differences are (check, rules that explain it)."""
    announced = list(profiles)
    settings = Settings(profiles=announced, only=rows, service={"profiles": announced})
    tally = Tally(load_spec())
    for check, rules in differences:
        tally.note_difference(rules, "a", "b", exchange_of(check), [exchange_of("X")])
    verdicts = [Verdict(failed, Outcome.FAILED)] if failed else []
    result = concluded(settings, *verdicts, known=[known], tally=tally)
    for row in result.rows.values():
        if row.expected:
            assert row.exchanges[0].correlation_id == "X/1"
    return result


def failed_rows(result: Result) -> set[str]:
    return {id_ for id_, row in result.rows.items() if row.outcome == Outcome.FAILED}


@pytest.mark.parametrize(
    ("differences", "failed", "expected"),
    [
        ([("EPI-001", ["RUN-014"])], "", {"RUN-014"}),
        ([("RUN-014", ["RUN-014"])], "EPI-001", {"RUN-014", "EPI-001"}),
        # A rule that has failed explains it, and needs no second row.
        ([("EPI-001", ["RUN-014", "EPI-001"])], "EPI-001", {"EPI-001"}),
        # It may follow from the mistake that a check found.
        ([("EPI-001", ["RUN-014"])], "SCORE-006", {"SCORE-006", ANY_SEQUENCE}),
        # A later difference of the same check may follow from the first.
        (
            [("EPI-001", ["RUN-014"]), ("EPI-001", ["SCORE-006"])],
            "",
            {"RUN-014", ANY_SEQUENCE},
        ),
        (
            [("EPI-001", ["RUN-014"]), ("SCORE-006", ["SCORE-006"])],
            "",
            {"SCORE-006", ANY_SEQUENCE},
        ),
    ],
)
def test_a_difference_fails_one_row(
    differences: list[tuple[str, list[str]]], failed: str, expected: set[str]
) -> None:
    assert failed_rows(with_differences(*differences, failed=failed)) == expected


def test_a_known_failure_hides_no_difference() -> None:
    difference = ("EPI-001", ["RUN-014"])
    result = with_differences(difference, failed="SCORE-006", known="SCORE-006")
    assert failed_rows(result) == {"SCORE-006", "RUN-014"}


def test_a_rule_that_is_not_selected_does_not_fail() -> None:
    differences = [("EPI-001", ["RUN-014"])] * 3
    result = with_differences(*differences, failed="EPI-001", rows=["EPI-001"])
    assert failed_rows(result) == {"EPI-001"}
    assert result.notes == ["RUN-014: expected a, observed b (and 2 more answers)"]


def test_a_rule_that_passed_beside_a_failed_one_is_doubted() -> None:
    difference = ("EPI-001", ["RUN-014"])
    result = with_differences(
        difference, failed="SCORE-006", rows=["SCORE-006", "RUN-014"]
    )
    assert failed_rows(result) == {"SCORE-006"}
    [note] = result.notes
    assert note.startswith("RUN-014 may be violated, too, or this follows from")


def test_a_core_server_fails_the_rule_on_all_answers_of_core() -> None:
    differences = [("EPI-001", ["RUN-014"]), ("RUN-014", ["EPI-001"])]
    rows = [*ROWS, ANY_CORE_SEQUENCE]
    result = with_differences(
        *differences, failed="SCORE-006", rows=rows, profiles=("core",)
    )
    assert failed_rows(result) == {"SCORE-006", ANY_CORE_SEQUENCE}
    assert result.notes == []


def test_a_tally_with_differences_survives_json() -> None:
    tally, copy = Tally(load_spec()), Tally(load_spec())
    tally.note_difference(["RUN-014"], "a", "b", exchange_of("Y"), [exchange_of("X")])
    tally.note_difference(["RUN-014"], "a", "b", exchange_of("Y"), [])
    copy.add_plain(tally.as_plain())
    assert copy.breaches == tally.breaches
    assert copy.broken == tally.broken
