"""The machine that changes servers: its operators, ids, samples, and its page."""

from __future__ import annotations

import json
import sys
from dataclasses import asdict, replace
from pathlib import Path

import pytest

from tests.mutation.campaign import Killers, Record, choose, read_results
from tests.mutation.judge import judge
from tests.mutation.operators import OPERATORS, find_mutants
from tests.mutation.page import score, section, tally, whole_page
from tests.mutation.syntax import has_same_tree
from tests.mutation.targets import TARGETS
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


def changed(operator: str, source: str, file: str = "a.js") -> set[str]:
    """The whole text after each change that an operator makes."""
    return {
        one.apply(source.encode()).decode()
        for one in find_mutants(file, source.encode())
        if one.operator == operator
    }


@pytest.mark.parametrize(
    ("operator", "source", "results"),
    [
        ("negate_condition", "if (a) b();", {"if (!(a)) b();"}),
        (
            "fix_condition",
            "x = a ? b : c;",
            {"x = true || (a) ? b : c;", "x = false && (a) ? b : c;"},
        ),
        ("swallow_error", "try { f(); } catch { g(); }", {"try { f(); } catch {}"}),
        ("drop_operand", "x = a ?? b;", {"x = a;", "x = b;"}),
        ("change_logic", "x = !a && b;", {"x = a && b;", "x = !a || b;"}),
        ("change_comparison", "x = a < b;", {"x = a <= b;", "x = a >= b;"}),
        (
            "change_arithmetic",
            "x += a - b;",
            {"x += a + b;", "x -= a - b;", "x = a - b;"},
        ),
        ("change_status", "x = 404;", {"x = 403;"}),
        ("change_number", "x = 7;", {"x = 8;", "x = 6;"}),
        (
            "change_string",
            "x = 'a' + '' + 'to read';",
            {"x = '' + '' + 'to read';", "x = 'a' + 'x' + 'to read';"},
        ),
        ("change_boolean", "x = true;", {"x = false;"}),
        (
            "change_regex",
            "x = /^a{3}$/i;",
            {
                "x = /a{3}$/i;",
                "x = /^a{3}/i;",
                "x = /^a{3}$/;",
                "x = /^a{4}$/i;",
                "x = /^a{2}$/i;",
            },
        ),
        ("shift_index", "x = a[i];", {"x = a[(i) + 1];"}),
        ("drop_member", "x = { a: 1, b };", {"x = {  b };", "x = { a: 1 };"}),
        ("empty_list", "x = [a, b];", {"x = [];"}),
        ("swap_members", "x = { a: p, b: q };", {"x = { a: q, b: p };"}),
        (
            "read_other_member",
            "x = a.b; y = a.c;",
            {"x = a.c; y = a.c;", "x = a.b; y = a.b;"},
        ),
        ("swap_arguments", "f(a, b);", {"f(b, a);"}),
        ("swap_arguments", "Math.min(a, b);", set()),
        ("drop_call", "x = a.trim();", {"x = a;"}),
        ("call_other_method", "x = Math.min(a);", {"x = Math.max(a);"}),
        ("drop_await", "x = await a;", {"x = a;"}),
        ("drop_chain", "x = a?.b;", {"x = a.b;"}),
        ("drop_default", "const { a = 1 } = b;", {"const { a } = b;"}),
        ("drop_statement", "f();", {";"}),
        ("drop_value", "function f() { return a; }", {"function f() { return; }"}),
        ("return_early", "function f() { g(); }", {"function f() { return; g(); }"}),
    ],
)
def test_operator_changes_javascript(
    operator: str, source: str, results: set[str]
) -> None:
    assert changed(operator, source) == results


@pytest.mark.parametrize(
    ("operator", "statement", "results"),
    [
        ("negate_condition", "if a { b() }", {"if !(a) { b() }"}),
        (
            "swallow_error",
            "if err != nil { b() }",
            {"if false && (err != nil) { b() }"},
        ),
        ("swallow_error", "return 1, err", {"return 1, nil"}),
        ("drop_statement", "a = b", {"_ = b"}),
        ("drop_statement", "defer a()", {""}),
        ("change_status", "x := http.StatusOK", {"x := http.StatusAccepted"}),
        ("shift_index", "x := a[b:]", {"x := a[(b) + 1:]", "x := a[(b) - 1:]"}),
        ("drop_member", "x := T{A: 1, B: 2}", {"x := T{ B: 2}", "x := T{A: 1}"}),
        ("call_other_method", "x := min(a, b)", {"x := max(a, b)"}),
    ],
)
def test_operator_changes_go(operator: str, statement: str, results: set[str]) -> None:
    whole = "package a\nfunc f() {{\n{}\n}}\n"
    found = changed(operator, whole.format(statement), "a.go")
    assert found == {whole.format(result) for result in results}


def test_go_functions_return_zero_values() -> None:
    source = "package a\nfunc f() (int, error) { return 1, nil }\n"
    [found] = changed("return_early", source, "a.go")
    assert "{ return *new(int), *new(error)\n" in found


def test_go_tags_are_renamed() -> None:
    source = 'package a\ntype T struct { A int `json:"a"` }\n'
    tags = ('`json:"a_"`', '`json:"a,omitempty"`')
    assert changed("rename_tag", source, "a.go") == {
        source.replace('`json:"a"`', tag) for tag in tags
    }


def test_every_operator_has_a_purpose() -> None:
    assert all(change.__doc__ for change in OPERATORS.values())


def test_texts_for_people_and_output_stay() -> None:
    assert changed("change_string", "console.log('a');") == set()
    assert changed("change_string", "import a from 'b';") == set()


def test_ids_outlive_changes_elsewhere() -> None:
    function = b"function f() { return a + 1; }\n"
    before = {one.id for one in find_mutants("a.js", function)}
    after = {one.id for one in find_mutants("a.js", b"const b = 1;\n" + function)}
    assert before < after


def test_ids_are_unique() -> None:
    """Twice the same statement: two ids."""
    for target in TARGETS.values():
        ids = [one.id for one in target.mutants()]
        assert len(ids) == len(set(ids))
    found = find_mutants("a.js", b"function f() { g(1); g(1); }")
    assert len({one.id for one in found}) == len(found)


def test_white_space_is_no_change() -> None:
    assert has_same_tree(".js", b"a( b )", b"a(b)")
    assert not has_same_tree(".js", b"a(b)", b"a(c)")


def test_a_smaller_sample_is_part_of_a_larger_one() -> None:
    mutants = find_mutants("a.js", b"x = a + 1; y = b + 2; z = c + 3;")
    small, large = choose(mutants, 2, seed=4), choose(mutants, 4, seed=4)
    assert large[:2] == small
    assert len(choose(mutants, 0, seed=4)) == len(mutants)


def test_the_last_record_of_an_id_counts(tmp_path: Path) -> None:
    file = tmp_path / "results"
    records = [RECORD, replace(RECORD, outcome="survived")]
    file.write_text("".join(json.dumps(asdict(one)) + "\n" for one in records))
    assert read_results(file) == {"a": records[-1]}
    assert read_results(tmp_path / "absent") == {}


def test_rules_that_failed_nearby_come_first() -> None:
    killers = Killers()
    for function, rules in [("f", ["B-1"]), ("g", ["A-1"]), ("g", ["A-1"])]:
        killers.add(replace(RECORD, function=function, failed=rules))
    assert killers.of("a.js", "f") == ["B-1", "A-1"]
    assert killers.of("a.js", "h") == ["A-1", "B-1"]


def test_excused_survivors_do_not_count_against_the_kit() -> None:
    records = [
        replace(RECORD, id=id_, outcome=outcome)
        for id_, outcome in [("a", "killed"), ("b", "survived"), ("c", "undecided")]
    ]
    reasons = {"b": Reason("equivalent", "…"), "c": Reason("missing check", "…")}
    assert tally(records, reasons)["excused"] == 1
    assert score(records, reasons) == 0.5
    assert score([], reasons) is None


def test_page_shows_survivors_with_their_reasons() -> None:
    [mutant, *_] = find_mutants("a.js", b"x = true;")
    record = replace(RECORD, id=mutant.id, outcome="survived")
    reasons = {mutant.id: Reason("free", "a | b")}
    page = whole_page([section(TARGETS["js"], [mutant], {mutant.id: record}, reasons)])
    assert f"| {mutant.id} | `a.js:1` f | `` true `` → `` false `` | free" in page
    assert "a \\| b" in page


def test_triage_is_of_mutants_that_exist() -> None:
    """An entry whose place was changed is of no use any more. Expect none."""
    made = {
        one.id
        for target in TARGETS.values()
        for one in [*target.mutants(), *(bug.mutant for bug in read_bugs(target))]
    }
    assert read_triage().keys() - made == set()


@pytest.mark.parametrize(
    "entry",
    [
        '[[survivor]]\nids = ["a", "a"]\nverdict = "free"\nreason = "b"',
        '[[survivor]]\nids = ["a"]\nverdict = "unknown"\nreason = "b"',
        '[[survivor]]\nids = ["a"]\nverdict = "free"\nreason = " "',
    ],
)
def test_triage_is_complete(tmp_path: Path, entry: str) -> None:
    file = tmp_path / "triage.toml"
    file.write_text(entry)
    with pytest.raises(ValueError, match="a"):
        read_triage(file)


FAKE_KIT = """
import json, sys
from pathlib import Path
options = sys.argv[1:]
report = Path(options[options.index("--report") + 1])
code = int(options[options.index("--start-cmd") + 1])
outcome = {0: "passed", 1: "failed", 2: "not_verified"}[code]
row = {"requirement_id": "RUN-001", "outcome": outcome}
problem = "no server" if "--quick" in options and code == 2 else None
report.joinpath("report.json").write_text(json.dumps({
    "rows": [row], "exit_code": code, "problem": problem,
    "conclusion": " ".join(options), "elapsed_s": 0.5,
}))
"""


@pytest.mark.parametrize(
    ("code", "outcome", "is_quick"),
    [(0, "survived", False), (1, "killed", True), (2, "unusable", True)],
)
def test_kit_is_run_with_the_cheap_rows_first(
    tmp_path: Path, code: int, outcome: str, *, is_quick: bool
) -> None:
    """A kit that fails ends at once; one that passes judges all rows whole."""
    kit = tmp_path / "kit.py"
    kit.write_text(FAKE_KIT)
    found = judge([sys.executable, str(kit)], str(code), 1, ["RUN-002"])
    assert (found.outcome, "--quick" in found.conclusion) == (outcome, is_quick)
    assert found.failed == (["RUN-001"] if code == 1 else [])
    only = found.conclusion.partition("--only ")[2].split(",")
    assert only[0] == ("RUN-002" if is_quick else "")
    assert ("RUN-001" in only) == is_quick
