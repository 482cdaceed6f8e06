"""A set-up that finds a violation: the rule that it names fails, whatever its check."""

import sys
from pathlib import Path

import pytest

from conformance.exchanges.exchange import Exchange
from conformance.run_settings import Settings
from conformance.verdicts.expect import ANY_SEQUENCE
from conformance.verdicts.result import Result
from conformance.verdicts.verdict import Outcome, Verdict
from tests.support.kit.concluded_results import concluded
from tests.support.kit.run_kit import run_kit

SEEN = Exchange(1, "SCORE-006/1", "GET", "http://x", None, {}, b"", 0, 200)


def result_of(*verdicts: Verdict) -> Result:
    ids = [verdict.requirement_id for verdict in verdicts]
    profiles = ["core", "control"]
    settings = Settings(profiles=profiles, only=ids, service={"profiles": profiles})
    return concluded(settings, *verdicts)


def unverified(breaks: str) -> Verdict:
    return Verdict(
        "SCORE-006",
        Outcome.NOT_VERIFIED,
        "episodes come in another order",
        breaks=breaks,
        exchanges=[SEEN],
    )


def test_the_rule_that_a_set_up_found_broken_fails() -> None:
    result = result_of(unverified("EPI-001"), Verdict("EPI-001", Outcome.PASSED))
    broken = result.rows["EPI-001"]
    assert broken.outcome == Outcome.FAILED
    assert "set-up of SCORE-006" in broken.reason
    assert broken.exchanges == [SEEN]
    assert result.rows["SCORE-006"].outcome == Outcome.NOT_VERIFIED
    assert result.exit_code == 1


def test_a_rule_that_is_not_judged_is_not_failed() -> None:
    assert result_of(unverified("EPI-001")).exit_code == 2
    skipped = Verdict("EPI-001", Outcome.NOT_VERIFIED, "another reason")
    assert result_of(unverified("EPI-001"), skipped).exit_code == 2


def test_the_rule_on_all_answers_fails_only_where_nothing_else_explains() -> None:
    model = Verdict(ANY_SEQUENCE, Outcome.PASSED)
    assert result_of(unverified(ANY_SEQUENCE), model).exit_code == 1
    assert model.outcome == Outcome.FAILED
    model = Verdict(ANY_SEQUENCE, Outcome.PASSED)
    cause = Verdict("PRED-001", Outcome.FAILED)
    result = result_of(unverified(ANY_SEQUENCE), model, cause)
    assert result.rows[ANY_SEQUENCE].outcome == Outcome.PASSED


@pytest.mark.slow("a server and a kit")
def test_a_server_that_breaks_a_rule_only_in_another_checks_set_up(
    tmp_path: Path,
) -> None:
    """Runs with one attempt are played backwards; the check of EPI-001 has more. Expect
    EPI-001 to fail, with the requests of the set-up that saw it."""
    server = f"{sys.executable} -m tests.support.kit.server_with_one_wrong_order"
    kit = run_kit(tmp_path, "--only", "EPI-001,SCORE-006", "--start-cmd", server)
    assert kit.code == 1, kit.output[-3000:]
    assert kit.outcomes == {"EPI-001": "failed", "SCORE-006": "not_verified"}
    assert kit.rows["EPI-001"]["exchanges"]
    assert "another order" in kit.rows["EPI-001"]["observed"]
