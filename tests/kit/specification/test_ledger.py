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
from typing import Any

import pytest

from conformance.specification.document import SPEC_DIRECTORY, load_spec
from conformance.specification.ledger import load_areas, load_ledger
from tests.support.paths import ROOT

CHECKS = ROOT / "conformance" / "checks"
COMMANDS = re.compile(r"\b(MUST|SHALL|SHOULD|MAY|REQUIRED|RECOMMENDED)\b")
EXTENSIONS = ("x-areas", "x-requirements", "x-lifecycle", "x-problems")
LONGEST_CHECK = 45


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


def test_every_check_is_named_after_its_row(checks: list[list[str]]) -> None:
    for requirement_id, name, _ in checks:
        # The cells of the lifecycle table are walked by one function.
        area = requirement_id.partition("-")[0].lower()
        prefix = f"test_{requirement_id.lower().replace('-', '_')}_"
        assert name.startswith(prefix) or f"{area}_" in name, name


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
    document = load_spec().document
    rest = {name: node for name, node in document.items() if name not in EXTENSIONS}
    assert [text for text in texts(rest) if COMMANDS.search(text)] == []
    assert [t for t in texts(document["x-problems"]) if COMMANDS.search(t)] == []


@pytest.mark.parametrize("name", ["scoring.md", "record.md", "calibration.md"])
def test_normative_sentences_are_rows(name: str) -> None:
    known = {row.text for row in load_ledger().values()}
    for line in (SPEC_DIRECTORY / name).read_text(encoding="utf-8").splitlines():
        if COMMANDS.search(line):
            text = re.sub(r"^- \[[A-Z]+-\d{3}(, verifier)?\] ", "", line)
            assert text in known, f"{name}: {line}"


def test_each_row_has_one_normative_keyword() -> None:
    for row in load_ledger().values():
        commands = COMMANDS.findall(row.text)
        assert commands in (["MUST"], ["SHOULD"], ["MUST", "MUST"]), row
        assert row.level in commands, row
        assert row.text.endswith("."), row


def test_operations_cite_known_rows() -> None:
    known = set(load_ledger())
    for operation in load_spec().operations.values():
        cited = operation.description.get("x-requirements", [])
        assert set(cited) <= known, operation.operation_id
        assert len(cited) == len(set(cited)), operation.operation_id


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
    problems = load_spec().problems
    for row in load_ledger().values():
        for code in re.findall(r"refused with `([a-z_]+)`", row.text):
            assert code in problems, row


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
