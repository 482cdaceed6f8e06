"""Only rules command: other sentences of spec/ that sound like one name the rule.

A reader finds every obligation under an id. A sentence of a description, or of a page,
with a word such as MUST or "refused" says what follows from rules, and names them; or
it is a rule that permits.
"""

import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
import yaml

from conformance.specification.rule_documents import read_rules
from tests.support.paths import SPEC

WORDS = re.compile(
    r"\b(MUST|SHOULD|SHALL|must|should|shall|has to|have to|refused)\b", re.ASCII
)
ID = re.compile(r"\b[A-Z]{2,6}-\d{3}\b")
RULE = re.compile(r"^- \[[A-Z]{2,6}-\d{3}.*\n(?:  .*\n)*", re.MULTILINE)
DOCUMENTS = sorted(SPEC.glob("*.yaml")) + sorted(SPEC.glob("profiles/*.yaml"))
# On the text itself, not on servers: how it changes, and what may be said of it.
ON_THE_TEXT = {"CHANGELOG.md", "CONFORMANCE.md", "README.md", "VERSIONING.md"}
PAGES = [path for path in sorted(SPEC.rglob("*.md")) if path.name not in ON_THE_TEXT]


def commands(text: str) -> list[str]:
    """The sentences that command and name no rule."""
    return [
        sentence
        for paragraph in re.split(r"\n\s*\n|\n(?=[|#-])", text)
        for sentence in re.split(r"(?<=[.;]) (?=\W*\w)", " ".join(paragraph.split()))
        if WORDS.search(sentence) and not ID.search(sentence)
    ]


def descriptions(node: Any, at: str = "#") -> Iterator[tuple[str, str]]:
    """Every description and summary with its place; `x-` members are left out."""
    if isinstance(node, dict):
        for key, value in node.items():
            if key in ("description", "summary") and isinstance(value, str):
                yield f"{at}/{key}", value
            elif not str(key).startswith("x-"):
                yield from descriptions(value, f"{at}/{key}")
    elif isinstance(node, list):
        for place, value in enumerate(node):
            yield from descriptions(value, f"{at}/{place}")


@pytest.mark.parametrize("path", DOCUMENTS, ids=lambda path: path.name)
def test_descriptions_never_command(path: Path) -> None:
    document = yaml.safe_load(path.read_text())
    found = {at: commands(text) for at, text in descriptions(document)}
    assert {at: said for at, said in found.items() if said} == {}


@pytest.mark.parametrize("path", PAGES, ids=lambda path: path.name)
def test_pages_command_in_rules_alone(path: Path) -> None:
    assert commands(RULE.sub("\n", path.read_text())) == []


@pytest.mark.parametrize("path", [*DOCUMENTS, *PAGES], ids=lambda path: path.name)
def test_rules_that_a_text_names_exist(path: Path) -> None:
    known = {rule.id for rule in read_rules(SPEC)}
    areas = {id_.partition("-")[0] for id_ in known}
    named = {one for one in ID.findall(path.read_text()) if one[:-4] in areas}
    withdrawn: set[str] = set()
    assert named - known == withdrawn


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("A server must answer.", 1),
        ("A server MUST answer (SVC-001).", 0),
        ("It is refused. See SVC-001.", 1),
        ("Here SVC-001 holds; the other\nhas to wait.", 1),
        ("It mustered all.", 0),
    ],
)
def test_a_command_without_a_rule_is_found(text: str, found: int) -> None:
    assert len(commands(text)) == found
