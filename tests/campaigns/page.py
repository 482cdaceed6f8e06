"""Writes build/reliability.md: a part for each campaign, with promises and cases."""

from __future__ import annotations

import os
from collections.abc import Iterable, Sequence
from datetime import UTC, datetime
from pathlib import Path

from tests.campaigns.promises import Verdict
from tools.measurements.git_commit import read_commit

PAGE = Path(__file__).resolve().parents[2] / "build" / "reliability.md"


def write_part(
    campaign: str, conditions: str, verdicts: Iterable[Verdict], cases: Iterable[str]
) -> None:
    """Replace the part of a campaign; the other one is left as it is.

    conditions: under which it was measured. cases: lines of Markdown.
    """
    commit, _ = read_commit()
    date = datetime.now(UTC).date().isoformat()
    rows = [(verdict.text, verdict.worst, verdict.state) for verdict in verdicts]
    part = [
        f"# make {campaign}\n",
        f"Commit {commit} of {date}, {os.cpu_count()} processors, {conditions}.\n",
        *table(("promise", "worst of all", "verdict"), rows),
        "",
        *cases,
    ]
    folder = PAGE.with_suffix("")
    folder.mkdir(parents=True, exist_ok=True)
    (folder / f"{campaign}.md").write_text("\n".join(part) + "\n")
    parts = (file.read_text() for file in sorted(folder.iterdir()))
    PAGE.write_text("\n".join(parts))


def table(header: Sequence[str], rows: Iterable[Sequence[str]]) -> list[str]:
    """Lines of Markdown."""
    lines = [header, ["---"] * len(header), *rows]
    return [f"| {' | '.join(line)} |" for line in lines]
