"""Seeds that a host has opened: the vectors, and files that are no such thing."""

import json
from pathlib import Path
from typing import Any

import pytest

from reference_record.broken import UnusableRecord
from reference_record.formats import opened_seeds
from reference_record.formats.opened_seeds import load_opened_seeds, seeds_for
from tests.support.paths import ROOT

CASES = json.loads((ROOT / "spec" / "vectors" / "seeds" / "opened.json").read_text())


@pytest.mark.parametrize("case", CASES["cases"], ids=lambda case: case["description"])
def test_a_vector(case: dict[str, Any], tmp_path: Path) -> None:
    path = tmp_path / "seeds.json"
    path.write_text(json.dumps(case["file"]))
    if case["rule"] is None:
        found = seeds_for(load_opened_seeds(path), case["manifest"])
        assert {str(index): seed for index, seed in found.items()} == case["seeds"]
        return
    with pytest.raises(UnusableRecord, match=rf"\[{case['rule']}\]"):
        seeds_for(load_opened_seeds(path), case["manifest"])


@pytest.mark.parametrize(
    ("content", "said"),
    [
        (b"", "REC-015"),
        (b"\xff", "REC-015"),
        (b'{"benchmark_id": "b", "benchmark_id": "b", "opened": []}', "stands twice"),
        (b" " * 101, "REC-030"),
    ],
)
def test_what_is_no_such_file_is_said(
    content: bytes, said: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(opened_seeds, "FILE_BYTES_MAX", 100)
    path = tmp_path / "seeds.json"
    path.write_bytes(content)
    with pytest.raises(UnusableRecord, match=said):
        load_opened_seeds(path)


def test_a_file_that_cannot_be_read_is_named(tmp_path: Path) -> None:
    """Whatever the command writes at that time."""
    for path in (tmp_path, tmp_path / "nothing"):
        with pytest.raises(UnusableRecord, match=f"^{path}: (Is a|No such)"):
            load_opened_seeds(path)
