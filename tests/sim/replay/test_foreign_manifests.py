"""Manifests of unknown origin are checked before anything is simulated."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import msgspec
import pytest

from reference_record.broken import BrokenRecord, UnusableRecord
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


@pytest.mark.parametrize(
    ("changed", "said"),
    [
        ({"max_steps": 7}, "max_steps is {max_steps} here, 7 in the record"),
        ({"new": {"a": "x" * 99}}, f'new is absent here, {{{{"a":"{"x" * 34}…'),
        ({"title": "\x1b[2J"}, "title is {title} here, \\x1b[2J in the record"),
        (
            {"max_attempts": 1, "max_faults": 9, "title": "t", "version": "9"},
            "title is {title} here, t in the record; and 1 more",
        ),
    ],
)
def test_the_members_are_named_in_which_the_benchmark_differs_here(
    changed: dict[str, Any], said: str, tmp_path: Path
) -> None:
    bundle = open_bundle(save_calibration_record(tmp_path / "r", tmp_path))
    here = msgspec.json.decode(bundle.read("manifest.json"))
    evaluation = verify(bundle).evaluation
    evaluation = msgspec.structs.replace(evaluation, manifest_sha256="0" * 64)
    with pytest.raises(UnusableRecord, match=re.escape(said.format(**here))):
        resolve(evaluation, msgspec.json.encode(here | changed))
