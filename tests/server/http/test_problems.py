"""Refusals: what a problem says, and when it says to come back."""

import msgspec
import pytest

from reference_server.http.problems import MOVED_HEADER, RETRY_AFTER_S, problem_response
from reference_server.rules.refusal import (
    NAME_CHARS_MAX,
    Refused,
    no_profile,
    not_found,
)
from reference_server.rules.run_owner import OwnedElsewhere
from reference_server.rules.runs.lifecycle import Refuse
from tests.support.repository.answer_schemas import check_answer


def test_a_problem_states_the_error_and_the_next_step() -> None:
    verdict = Refuse(
        "seq_out_of_order",
        "Turn 9 was asked for.",
        "PRED-004",
        (("/seq", "is 9"),),
        {"expected_seq": 4},
    )
    answer = problem_response(Refused.from_verdict(verdict))
    body = msgspec.json.decode(bytes(answer.body))
    assert (answer.status_code, answer.media_type) == (409, "application/problem+json")
    assert body["detail"] == "Turn 9 was asked for. Send `expected_seq`."
    assert body["errors"] == [{"pointer": "/seq", "detail": "is 9"}]
    assert (body["expected_seq"], body["requirement"]) == (4, "PRED-004")
    assert "retry-after" not in answer.headers
    check_answer("Problem", body)


@pytest.mark.parametrize(
    ("refused", "detail"),
    [
        (Refused("not_found", "There is no run run_1."),
         "There is no run run_1. Check the id; runs of other accounts are not shown."),
        (Refused("not_found", "Here is a path.", act="Use another."),
         "Here is a path. Use another."),
        (Refused("not_found", "It is gone.", act=""), "It is gone."),
        (Refused.from_verdict(Refuse("not_comparable", "A.", act="Do B.")), "A. Do B."),
        (no_profile("It has no leaderboard."), ("It has no leaderboard. "
         "describe_service names the profiles that it has.")),
        (not_found("track", "lettres", ["letters", "digits"]),
         "There is no track lettres. There are: digits, letters."),
        (not_found("track", "x" * 99, ()),
         f"There is no track {'x' * NAME_CHARS_MAX}. There are: none."),
        (not_found("phase", "a", map(str, range(10, 32))),
         (f"There is no phase a. There are: {', '.join(map(str, range(10, 30)))} "
         "and 2 more.")),
    ],
)  # fmt: skip
def test_what_to_do_is_of_what_was_refused(refused: Refused, detail: str) -> None:
    """Expect no sentence of a catalogue that is about something else."""
    body = msgspec.json.decode(bytes(problem_response(refused).body))
    assert body["detail"] == detail


def test_a_problem_states_retry_after_and_authentication() -> None:
    for code in ("worker_limit", "no_capacity"):
        busy = problem_response(Refused(code, "Full."))
        assert busy.headers["retry-after"] == str(RETRY_AFTER_S)
    later = problem_response(Refused("unavailable", "Soon."), {"Retry-After": "9"})
    assert later.headers["retry-after"] == "9"
    unauthenticated = problem_response(Refused("unauthenticated", "Who?"))
    assert unauthenticated.headers["www-authenticate"] == "Bearer"
    body = msgspec.json.decode(bytes(unauthenticated.body))
    assert "errors" not in body
    assert "requirement" not in body


def test_a_node_says_that_another_one_has_the_run() -> None:
    """A node that passed the request on repeats it there. Expect it of nothing else."""
    moved = problem_response(OwnedElsewhere("run_1"))
    assert moved.headers[MOVED_HEADER] == "1"
    assert moved.status_code == 503
    assert MOVED_HEADER not in problem_response(Refused("unavailable", "")).headers
