"""docs/host/performance.md: text between two marks is written by tools.

    <!-- round_trips -->
    …
    <!-- /round_trips -->

All other text is written by hand. Knows nothing about the measurements.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path

FILE = Path(__file__).resolve().parents[1] / "docs" / "host" / "performance.md"


def put(part: str, text: str, file: Path = FILE) -> None:
    """Replace the text between the marks. Raises ValueError if they are missing."""
    old = file.read_text()
    marks = f"<!-- {part} -->", f"<!-- /{part} -->"
    between = re.compile(f"({marks[0]}\n).*?({marks[1]})", re.DOTALL)
    new, count = between.subn(lambda found: f"{found[1]}\n{text}\n\n{found[2]}", old)
    if count != 1:
        raise ValueError(f"{file.name} has {count} places {marks[0]} … {marks[1]}")
    file.write_text(new)


def table(head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """Markdown; every column but the first is of numbers."""
    ruler = ["---", *(["--:"] * (len(head) - 1))]
    return "\n".join(f"| {' | '.join(row)} |" for row in (head, ruler, *rows))
