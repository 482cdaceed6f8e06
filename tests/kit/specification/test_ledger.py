"""The ledger is closed: every command of the specification is a row, every row that
can be seen has exactly one check, and no check cites a rule that does not exist.
"""

import ast
import json
import re
import subprocess
import sys
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from conformance.specification.document import (
    SPEC_DIRECTORY,
    load_policy_spec,
    load_spec,
)
from conformance.specification.ledger import (
    CORE,
    PROFILES,
    SERVICE,
    load_areas,
    load_ledger,
)
from conformance.specification.rule_documents import read_rules, rule_documents
from conformance.verdicts.universal_rules import ORACLE_RULES
from tests.support.paths import ROOT
from tests.support.repository.specification import load

CHECKS = ROOT / "conformance" / "checks"
COMMANDS = re.compile(r"\b(MUST|SHALL|SHOULD|MAY|REQUIRED|RECOMMENDED)\b")
LONGEST_CHECK = 45
LONGEST_RULE = 30  # in words
DOCUMENTS = rule_documents(SPEC_DIRECTORY)


# What pytest collects is what will run; each in a process that ends with it.
LIST_CHECKS = """
import json
from conformance.runner.execution import list_checks
print(json.dumps(list_checks()))
"""


@pytest.fixture(scope="module")
def checks() -> list[list[str]]:
    """Id, function and docstring of every check."""
    listed = subprocess.run(
        [sys.executable, "-c", LIST_CHECKS],
        cwd=CHECKS.parents[1],
        capture_output=True,
        text=True,
        check=True,
    )
    found: list[list[str]] = json.loads(listed.stdout)
    return found


def functions() -> Iterator[ast.FunctionDef]:
    for path in sorted(CHECKS.rglob("test_*.py")):
        for node in ast.parse(path.read_text(encoding="utf-8")).body:
            if isinstance(node, ast.FunctionDef) and node.name.startswith("test_"):
                yield node


def test_every_observable_row_has_exactly_one_check(checks: list[list[str]]) -> None:
    cited = Counter(requirement_id for requirement_id, _, _ in checks)
    wanted = {row.id for row in load_ledger().values() if row.is_observable}
    assert {row for row in wanted if cited[row] != 1} == set()


def test_every_check_cites_a_known_observable_row(checks: list[list[str]]) -> None:
    ledger = load_ledger()
    for requirement_id, name, _ in checks:
        assert requirement_id in ledger, f"{name} cites {requirement_id}"
        assert ledger[requirement_id].is_observable, name


def test_every_check_is_named_after_one_of_its_rows(checks: list[list[str]]) -> None:
    rows: dict[str, list[str]] = {}
    for requirement_id, name, _ in checks:
        rows.setdefault(name, []).append(requirement_id)
    for name, ids in rows.items():
        # The cells of the lifecycle table are walked by one function.
        assert any(
            name.startswith(f"test_{id_.lower().replace('-', '_')}_")
            or f"{id_.partition('-')[0].lower()}_" in name
            for id_ in ids
        ), name
        # An assertion could not say which of several rules is broken.
        assert len(ids) == 1 or set(ids) <= set(ORACLE_RULES), name


def test_every_check_says_what_it_expects(checks: list[list[str]]) -> None:
    for _, name, docstring in checks:
        assert "xpect" in docstring, name


def test_every_area_has_a_name() -> None:
    assert load_areas().keys() == {row.area for row in load_ledger().values()}


def test_every_check_is_short() -> None:
    checks = list(functions())
    assert len(checks) > 300
    for check in checks:
        lines = (check.end_lineno or 0) - check.lineno + 1
        assert lines <= LONGEST_CHECK, f"{check.name} has {lines} lines"


def texts(node: Any) -> Iterator[str]:
    if isinstance(node, str):
        yield node
    elif isinstance(node, dict):
        for value in node.values():
            yield from texts(value)
    elif isinstance(node, list):
        for value in node:
            yield from texts(value)


def test_descriptions_of_the_document_state_no_requirement() -> None:
    assert [t for t in texts(load_spec().document) if COMMANDS.search(t)] == []


@pytest.mark.parametrize("path", DOCUMENTS, ids=lambda path: path.name)
def test_normative_sentences_are_rules(path: Path) -> None:
    """Expect each item with an id to be read as a rule, and no command beside rules."""
    text = path.read_text(encoding="utf-8")
    document = path.relative_to(SPEC_DIRECTORY).as_posix()
    rules = [rule for rule in read_rules(SPEC_DIRECTORY) if rule.document == document]
    assert re.findall(r"^- \[([A-Z]+-\d{3})", text, re.MULTILINE) == [
        r.id for r in rules
    ]
    prose = re.sub(r"^- \[[A-Z]+-\d{3}.*(?:\n  .*)*", "", text, flags=re.MULTILINE)
    assert COMMANDS.findall(prose) == []


def test_a_rule_is_one_short_sentence_with_one_normative_word() -> None:
    rules = list(read_rules(SPEC_DIRECTORY))
    assert len({rule.id for rule in rules}) == len(rules)
    for rule in rules:
        assert COMMANDS.findall(rule.text) == [rule.level], rule
        assert rule.text.endswith("."), rule
        assert len(rule.text.split()) <= LONGEST_RULE, rule


def test_rules_name_known_operations() -> None:
    documents = [load_spec().document, load_policy_spec().document]
    profiles = (SPEC_DIRECTORY / "profiles").glob("*.yaml")
    documents += [load(path.read_text()) for path in profiles]
    known = {
        described["operationId"]
        for document in documents
        for item in document["paths"].values()
        for described in item.values()
    }
    for rule in load_ledger().values():
        assert known >= set(rule.operations), rule.id
        assert len(rule.operations) == len(set(rule.operations)), rule.id


def test_each_cell_of_the_lifecycle_is_a_rule() -> None:
    cells = {row["id"] for row in load_spec().lifecycle["transitions"]}
    assert cells <= load_ledger().keys()


@pytest.mark.parametrize(
    ("text", "rule"),
    [
        ("- [A-1] No rule.", None),
        (
            "Profile: `a`.\n- [AB-001] I MUST\n  go. — `a`,\n  `b`\n  *Not judged: N.*",
            ("a", "I MUST go.", ("a", "b"), "N"),
        ),
        (
            "Profile: `a`.\n## S\nProfile: `b`.\n## T\n- [AB-001] I MUST go.",
            ("a", "I MUST go.", (), None),
        ),
        ("# D\nProfile: `a`.\n- [AB-001, b] I MUST go.", ("b", "I MUST go.", (), None)),
        (
            "Profile: `a`.\n## S\n- [ABC-001, verifier] It MUST — or not.",
            ("a", "It MUST — or not.", (), None),
        ),
    ],
)
def test_a_rule_is_read_from_its_item(
    tmp_path: Path, text: str, rule: tuple[object, ...] | None
) -> None:
    """Wrapped lines are joined; operations and a reason stand behind the sentence."""
    for path in rule_documents(tmp_path):
        path.write_text(text if path.name == "runs.md" else "# Nothing\n")
    read = [
        (rule.profile, rule.text, rule.operations, rule.why_not_judged)
        for rule in read_rules(tmp_path)
    ]
    assert read == ([] if rule is None else [rule])


def test_a_rule_without_a_profile_is_an_error(tmp_path: Path) -> None:
    for path in rule_documents(tmp_path):
        path.write_text("- [ABC-001] A server MUST answer.\n")
    with pytest.raises(ValueError, match=r"http\.md names no profile above ABC-001"):
        list(read_rules(tmp_path))


def test_levels_are_profiles_and_each_is_closed() -> None:
    """Expect the levels of `x-levels`, and each rule about an operation of its own
    profile or of one that this needs."""
    spec = load_spec()
    assert spec.document["x-levels"] == {"core": [], "service": [*SERVICE]}
    needs = spec.document["x-needs"]
    named = {name for names in needs.values() for name in names}
    assert needs.keys() | named <= {*SERVICE} <= {*PROFILES}
    for rule in load_ledger().values():
        if rule.profile in (CORE, *SERVICE) and rule.operations:
            known = {CORE, rule.profile, *needs.get(rule.profile, [])}
            profiles = {spec.operations[name].profile for name in rule.operations}
            assert profiles & known, rule.id


def test_lifecycle_states_each_cell_once_with_declared_names() -> None:
    lifecycle = load_spec().lifecycle
    states = set(lifecycle["states"])
    inputs = set(lifecycle["commands"]) | set(lifecycle["events"])
    cells = Counter[tuple[str, str, str]]()
    for row in lifecycle["transitions"]:
        assert row["from"] in states
        assert row["to"] in states | {"refused"}
        assert row["event"] in inputs
        cells[row["from"], row["event"], row.get("when", "")] += 1
    assert max(cells.values()) == 1
    for state in states:
        for command in lifecycle["commands"]:
            assert any(cell[:2] == (state, command) for cell in cells), (state, command)


def test_every_problem_code_in_a_rule_is_declared() -> None:
    """A rule on a refusal names a code of openapi.yaml, or is one of the few below."""
    problems = load_spec().problems.keys()
    without_code = set()
    for rule in load_ledger().values():
        words = set(re.findall(r"`(\w+)`", rule.text))
        if "MUST refuse" in rule.text and not words & problems:
            without_code.add(rule.id)
    assert without_code == {"FLE-003", "FLE-023", "REC-030"}


def test_released_ids_are_never_used_again() -> None:
    """A released rule keeps level and profile; a withdrawn id names no other one."""
    lines = (SPEC_DIRECTORY / "ids.txt").read_text(encoding="utf-8").splitlines()
    listed = [line for line in lines if not line.startswith("#")]
    assert listed == sorted(set(listed))
    withdrawn = {line.split()[0] for line in listed if line.endswith(" withdrawn")}
    rules = {f"{row.id} {row.level} {row.profile}" for row in load_ledger().values()}
    assert {line for line in listed if line.split()[0] not in withdrawn} <= rules
    assert withdrawn.isdisjoint(load_ledger())
    assert len(listed) == len({line.split()[0] for line in listed})
    changes = (SPEC_DIRECTORY / "CHANGELOG.md").read_text(encoding="utf-8")
    assert all(id_ in changes for id_ in withdrawn)
