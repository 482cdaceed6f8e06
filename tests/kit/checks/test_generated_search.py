"""The search on generated examples: what `--minutes` adds, and what it reports."""

from typing import Any

import pytest
from hypothesis import strategies as st

from conformance.checks.support.generated.generated_examples import for_all
from conformance.client.check_context import CheckContext
from conformance.client.request_context import SharedContext
from conformance.exchanges.exchange import Exchange
from conformance.run_settings import Settings
from conformance.specification.ledger import PROFILES
from conformance.verdicts.coverage import Coverage
from conformance.verdicts.expect import Violation


def make_context(**settings: Any) -> CheckContext:
    shared = SharedContext.of(Settings(url="http://127.0.0.1:1", **settings))
    return CheckContext(shared, "MODEL-001")


def try_numbers(minutes: float, share: float, seed: int = 1) -> list[int]:
    seen: list[int] = []
    context = make_context(minutes=minutes, seed=seed)
    for_all(context, st.integers(0, 10**9), seen.append, times=5, share=share)
    return seen


def test_more_minutes_try_more_and_others() -> None:
    without, longer = try_numbers(0, 1.0), try_numbers(0.02, 1.0)
    assert longer[: len(without)] == without
    assert len(set(longer)) > 2 * len(without)
    assert try_numbers(0.02, 0.0) == without


def test_a_further_round_tries_others_and_none_of_the_known() -> None:
    seen: dict[int, list[int]] = {}
    shared = SharedContext.of(Settings(url="http://127.0.0.1:1", seed=1))
    for number in (0, 1, 2):
        context = CheckContext(shared, "MODEL-001", round_number=number)
        seen[number] = []
        numbers = st.integers(0, 10**9)
        for_all(context, numbers, seen[number].append, times=9, known=[-1])
    assert seen[0][0] == -1
    assert -1 not in seen[1] + seen[2]
    assert len(seen[2]) == 9
    assert len({*seen[0], *seen[1], *seen[2]}) > 20
    longer = try_numbers(0.02, 1.0, seed=1)
    assert longer[5:10] == try_numbers(0, 1.0, seed=1 + 1_000_003)


def test_a_failure_has_the_requests_of_its_own_example() -> None:
    context = make_context()
    log = context.exchange_log

    def check_property(name: str) -> None:
        log.add(Exchange(1, name, "GET", "http://h", None, {}, b"", 0, 200))
        if name == "wrong":
            raise Violation("right", "wrong", 1)

    known = ["fine", "wrong", "never"]
    with pytest.raises(Violation, match="for the example wrong"):
        for_all(context, st.just("fine"), check_property, times=1, known=known)
    assert [exchange.correlation_id for exchange in log.exchanges] == ["wrong"]


def test_pairs_are_counted_on_one_run() -> None:
    coverage, others = Coverage(), Coverage()
    for operation, run in (("get_run", "a"), ("stop_run", "b"), ("resume_run", "a")):
        coverage.note(operation, run)
    coverage.note("list_runs", None)
    others.note("stop_run", "a")
    others.note("stop_run", "a")
    others.histories = 2
    coverage.add_plain(others.as_plain())
    assert coverage.pairs == {("get_run", "resume_run"), ("stop_run", "stop_run")}
    said = coverage.sentence(Settings(service={"profiles": [*PROFILES]}))
    assert said.startswith("2 generated histories; 2 of ")
