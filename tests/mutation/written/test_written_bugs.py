"""Bugs that people wrote fit today's servers, and their page says what is known."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from conformance.specification.ledger import load_ledger
from tests.mutation.campaign import Record
from tests.mutation.syntax import has_same_tree
from tests.mutation.targets import ROOT, TARGETS
from tests.mutation.triage import Reason
from tests.mutation.written.unseen_bugs_page import section_of_written
from tests.mutation.written.written_bugs import read_all_results, read_bugs

BUG = """
[[bug]]
name = "lease"
rules = ["LEASE-003"]
seen = "A | b."
file = "sessions.js"
original = "{original}"
replacement = "x"
"""


@pytest.mark.parametrize("server", TARGETS)
def test_bugs_change_the_server_and_name_rules(server: str) -> None:
    target = TARGETS[server]
    bugs = read_bugs(target)
    for bug in bugs:
        before = (ROOT / target.folder / bug.mutant.file).read_bytes()
        after = bug.mutant.apply(before)
        assert not has_same_tree(target.suffix, before, after), bug.mutant.id
        assert set(bug.rules) <= load_ledger().keys(), bug.mutant.id
    assert len({bug.mutant.id for bug in bugs}) == len(bugs)


def test_a_server_without_verdicts_has_no_section(tmp_path: Path) -> None:
    target = TARGETS["js"]
    assert read_all_results(tmp_path / "absent") == {}
    assert section_of_written(target, read_bugs(target), {}, {}) == ""


@pytest.mark.parametrize("original", ["is nowhere", "const "])
def test_a_bug_that_does_not_fit_is_refused(tmp_path: Path, original: str) -> None:
    (tmp_path / "js.toml").write_text(BUG.format(original=original))
    with pytest.raises(ValueError, match="lease"):
        read_bugs(TARGETS["js"], tmp_path)


def test_page_shows_the_first_and_the_last_verdict(tmp_path: Path) -> None:
    original = "export async function attach(run, worker, body) {"
    (tmp_path / "js.toml").write_text(BUG.format(original=original))
    bugs = read_bugs(TARGETS["js"], tmp_path)
    missed = Record(
        id="lease",
        file="sessions.js",
        line=1,
        function="",
        operator="written",
        original=original,
        replacement="x",
        outcome="survived",
        failed=[],
        conclusion="conformant",
        elapsed_s=1.5,
        seed=1,
        kit="abc",
        date="2026-01-01",
    )
    found = replace(missed, outcome="killed", failed=["LEASE-004"])
    results = {"lease": [missed, found]}
    text = section_of_written(TARGETS["js"], bugs, results, {})
    assert "Unseen, 0 (0 %) were noticed; now 1 (100 %) are." in text
    assert "| lease | A \\| b. | LEASE-003 | **not noticed** | LEASE-004 |" in text
    reasons = {"lease": Reason("free", "Either is right.")}
    text = section_of_written(TARGETS["js"], bugs, results, reasons)
    assert "| **not noticed** | Either is right. |" in text
