"""Documents are written in the field's terms, for readers of any first language.

Ordinary words that have a meaning in this project alone are not used;
docs/glossary.md has the words that are. Code, and pages that tools write from texts of
other files, are not read here.
"""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from tests.support.paths import DOCS, ROOT

WRITTEN_BY_TOOLS = {
    *("kill-matrix.md", "traceability.md", "settings.md", "interop.md"),
    *("performance.md", "tasks.md", "metaworld.md"),
}
PAGES = [
    ROOT / "README.md",
    ROOT / "examples" / "README.md",
    *(page for page in DOCS.rglob("*.md") if page.name not in WRITTEN_BY_TOOLS),
]
WORD = re.compile(
    r"\b(houses?|doors?|desks?|nursery|puppets?|tales?|strangers?|whoever|nobody"
    r"|somebody|anybody|told|tells?)\b",
    re.IGNORECASE,
)
CODE = re.compile(r"^```.*?^```|`[^`\n]*`", re.MULTILINE | re.DOTALL)


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.relative_to(ROOT).name)
def test_a_page_uses_the_terms_of_the_field(page: Path) -> None:
    prose = CODE.sub("", page.read_text())
    assert [match[0] for match in WORD.finditer(prose)] == []
