"""The commands of pages: which server they reach, and that templates write none."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from reference_record.command_line.default_server import DEFAULT_URL
from reference_record.command_line.printed_commands import server_check, server_command
from tests.support.paths import ROOT

TEMPLATES = [
    path
    for folder in ("reference_record", "reference_platform")
    for path in (ROOT / folder / "pages/templates").rglob("*.j2")
]


@pytest.mark.parametrize("path", TEMPLATES, ids=lambda path: path.name)
def test_a_template_writes_no_command_by_itself(path: Path) -> None:
    """One function names the server of each; `admin` is for the machine of it."""
    assert re.findall(r"proctor (?!admin)[a-z]+", path.read_text()) == []


@pytest.mark.parametrize(
    ("url", "place"),
    [
        ("https://e.org/", " --url https://e.org"),
        ("http://e.org/a b", " --url 'http://e.org/a b'"),
        (DEFAULT_URL, ""),
        ("", ""),
    ],
)
def test_a_command_names_every_server_but_the_default_one(url: str, place: str) -> None:
    assert server_command(url, "board", "verify") == f"proctor board verify{place}"
    checked = place.replace("--url", "--server")
    if url == DEFAULT_URL:
        checked = f" --server {url}"
    assert server_check(url, "a.proctor") == f"proctor verify a.proctor{checked}"
