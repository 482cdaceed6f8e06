"""build/performance.md: each tool that measures writes a section of its own.

    <!-- round_trips -->
    …
    <!-- /round_trips -->

docs/host/performance.md says what is measured and how. Knows nothing about the
measurements.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path

from tools.built_pages import BUILD

FILE = BUILD / "performance.md"
HEAD = """# Performance, measured here

[What is measured, and how](../docs/host/performance.md).
"""


def put(part: str, title: str, text: str, file: Path = FILE) -> None:
    """Write a section, or replace it where the page has it already."""
    page = file.read_text() if file.exists() else HEAD
    marks = f"<!-- {part} -->", f"<!-- /{part} -->"
    section = f"{marks[0]}\n\n## {title}\n\n{text}\n\n{marks[1]}\n"
    written = re.compile(f"{marks[0]}\n.*?{marks[1]}\n", re.DOTALL)
    page, count = written.subn(lambda _: section, page)
    file.parent.mkdir(exist_ok=True)
    file.write_text(page if count else f"{page}\n{section}")


def table(head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """Markdown; every column but the first is of numbers."""
    ruler = ["---", *(["--:"] * (len(head) - 1))]
    return "\n".join(f"| {' | '.join(row)} |" for row in (head, ruler, *rows))
