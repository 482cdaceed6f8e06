"""The machine that changes servers: its operators, ids, samples, and its page."""

from dataclasses import replace
from pathlib import Path

import pytest

from conformance.specification.ledger import load_ledger
from tests.mutation.campaign import Record
from tests.mutation.operators import OPERATORS, find_mutants
from tests.mutation.page import score, tally
from tests.mutation.syntax import has_same_tree
from tests.mutation.targets import ROOT, TARGETS
from tests.mutation.triage import Reason, read_triage
from tests.mutation.written.written_bugs import read_bugs

RECORD = Record(
    id="a",
    file="a.js",
    line=1,
    function="f",
    operator="change_boolean",
    original="true",
    replacement="false",
    outcome="killed",
    failed=["RUN-001"],
    conclusion="NOT conformant",
    elapsed_s=1.5,
    seed=1,
    kit="abc",
    date="2026-01-01",
)


@pytest.mark.slow("parses two servers for each mutant")
def test_ids_are_unique_and_every_operator_changes_something() -> None:
    """An operator that stopped would make the kit look better than it is."""
    used = set()
    for target in TARGETS.values():
        mutants = target.mutants()
        assert len({mutant.id for mutant in mutants}) == len(mutants)
        used |= {mutant.operator for mutant in mutants}
    assert used == set(OPERATORS)
    found = find_mutants("a.js", b"function f() { g(1); g(1); }")
    assert len({one.id for one in found}) == len(found)


def test_excused_survivors_do_not_count_against_the_kit() -> None:
    records = [
        replace(RECORD, id=id_, outcome=outcome)
        for id_, outcome in [("a", "killed"), ("b", "survived"), ("c", "undecided")]
    ]
    reasons = {"b": Reason("equivalent", "…"), "c": Reason("missing check", "…")}
    assert tally(records, reasons)["excused"] == 1
    assert score(records, reasons) == 0.5
    assert score([], reasons) is None


@pytest.mark.slow("parses two servers for each mutant")
def test_triage_is_of_mutants_that_exist() -> None:
    """An entry whose place was changed is of no use any more. Expect none."""
    made = {mutant.id for target in TARGETS.values() for mutant in target.mutants()}
    assert read_triage().keys() - made == set()


@pytest.mark.parametrize(
    "entry",
    ['[free]\n"a b" = "x"\n"c a" = "x"', '[unknown]\na = "x"', '[free]\na = " "'],
)
def test_triage_is_complete(tmp_path: Path, entry: str) -> None:
    file = tmp_path / "triage.toml"
    file.write_text(entry)
    with pytest.raises(ValueError, match="a"):
        read_triage(file)


@pytest.mark.parametrize("server", TARGETS)
def test_written_bugs_change_the_server_and_name_rules(server: str) -> None:
    target = TARGETS[server]
    bugs = read_bugs(target)
    for bug in bugs:
        before = (ROOT / target.folder / bug.mutant.file).read_bytes()
        after = bug.mutant.apply(before)
        assert not has_same_tree(target.suffix, before, after), bug.mutant.id
        assert set(bug.rules) <= load_ledger().keys(), bug.mutant.id
    assert len({bug.mutant.id for bug in bugs}) == len(bugs) > 0
