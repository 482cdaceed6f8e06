"""Writes build/attack.md and others: the promises and cases of a campaign."""

from __future__ import annotations

import os
from collections.abc import Iterable, Sequence
from datetime import UTC, datetime

from tests.campaigns.promises import Verdict
from tools.built_pages import write_page
from tools.measurements.git_commit import read_commit


def write(
    campaign: str, conditions: str, verdicts: Iterable[Verdict], cases: Iterable[str]
) -> None:
    """conditions: under which it was measured. cases: lines of Markdown."""
    commit, _ = read_commit()
    date = datetime.now(UTC).date().isoformat()
    rows = [(verdict.text, verdict.worst, verdict.state) for verdict in verdicts]
    lines = [
        f"# The campaign {campaign}\n",
        f"Commit {commit} of {date}, {os.cpu_count()} processors, {conditions}.\n",
        *(table(("promise", "worst of all", "verdict"), rows) if rows else ()),
        "",
        *cases,
    ]
    write_page(f"{campaign}.md", "\n".join(lines) + "\n")


def table(header: Sequence[str], rows: Iterable[Sequence[str]]) -> list[str]:
    """Lines of Markdown."""
    lines = [header, ["---"] * len(header), *rows]
    return [f"| {' | '.join(line)} |" for line in lines]
