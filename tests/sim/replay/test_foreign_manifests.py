"""Manifests of unknown origin are checked before anything is simulated."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import msgspec
import pytest

from reference_record.broken import BrokenRecord
from reference_record.formats.bundle import open_bundle
from reference_record.verification import verify
from reference_sim.replay.record_replay import resolve
from tests.support.record.played_records import save_calibration_record


@pytest.mark.parametrize(
    "changed",
    [{"sealed_splits": 5}, {"max_chunk": 10**9}, {"episodes": [1]}, {"episodes": {}}],
)
def test_a_manifest_of_other_types_is_broken(
    changed: dict[str, Any], tmp_path: Path
) -> None:
    bundle = open_bundle(save_calibration_record(tmp_path / "r", tmp_path))
    manifest = msgspec.json.decode(bundle.read("manifest.json")) | changed
    with pytest.raises(BrokenRecord, match=r"manifest\.json"):
        resolve(verify(bundle).evaluation, msgspec.json.encode(manifest))
