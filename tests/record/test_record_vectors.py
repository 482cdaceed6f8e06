"""The vectors of spec/vectors/record/: what is wrong is named."""

import json
from typing import Any

import pytest

from reference_record.broken import BrokenRecord
from reference_record.formats.bundle import open_bundle
from reference_record.verification import verify_signer
from tests.support.paths import ROOT
from tools.record_vectors import files

FOLDER = ROOT / "spec" / "vectors" / "record"
LISTED = json.loads((FOLDER / "records.json").read_text())


def test_the_vectors_are_as_their_tool_writes_them() -> None:
    found = {path.name: path.read_bytes() for path in FOLDER.iterdir()}
    wanted = files()
    assert found.keys() == wanted.keys()
    assert [name for name in wanted if found[name] != wanted[name]] == []


CASES = LISTED["records"] + LISTED["with_other_keys"]


@pytest.mark.parametrize("case", CASES, ids=lambda case: case["record"])
def test_a_vector(case: dict[str, Any]) -> None:
    path, keys = FOLDER / case["record"], case.get("keys", LISTED["keys"])
    if case["rule"] is None:
        report = verify_signer(open_bundle(path), keys)
        assert report.levels == case["levels"]
        return
    with pytest.raises(BrokenRecord) as broken:
        verify_signer(open_bundle(path), keys)
    assert (broken.value.file, broken.value.rule) == (case["file"], case["rule"])
