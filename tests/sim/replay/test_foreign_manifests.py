"""Manifests of unknown origin are checked before anything is simulated."""

import hashlib
import re
from pathlib import Path
from typing import Any

import msgspec
import pytest

from reference_record.broken import BrokenRecord, UnusableRecord
from reference_record.formats.bundle import open_bundle
from reference_record.pages.record_documents import read_reported_run
from reference_record.verification import verify
from reference_sim import benchmark_registry
from reference_sim.replay.record_replay import replay_record, resolve
from tests.support.record.played_records import (
    OPTIONS,
    play_chunks,
    save_calibration_record,
    save_played_record,
)


@pytest.mark.parametrize(
    "changed",
    [{"sealed_splits": 5}, {"seeds": [2**53]}, {"episodes": [1]}, {"episodes": {}}],
)
def test_other_types_break_a_manifest(changed: dict[str, Any], tmp_path: Path) -> None:
    bundle = open_bundle(save_calibration_record(tmp_path / "r", tmp_path))
    manifest = msgspec.json.decode(bundle.read("manifest.json")) | changed
    with pytest.raises(BrokenRecord, match=r"manifest\.json"):
        resolve(verify(bundle).evaluation, msgspec.json.encode(manifest))


@pytest.mark.parametrize(
    ("changed", "said"),
    [
        ({"max_steps": 7}, "max_steps is {max_steps} here, 7 in the record"),
        ({"new": {"a": "x" * 99}}, f'new is absent here, {{{{"a":"{"x" * 34}…'),
        ({"version": "\x1b[2J"}, "version is {version} here, \\x1b[2J in the record"),
        (
            {"max_attempts": 1, "max_faults": 9, "success_rule": "t", "version": "9"},
            "success_rule is {success_rule} here, t in the record; and 1 more",
        ),
        ({"version": "Übung\n\u202e"}, r"Übung\n\u202e in the record"),
    ],
)
def test_the_members_are_named_in_which_the_benchmark_differs_here(
    changed: dict[str, Any], said: str, tmp_path: Path
) -> None:
    bundle = open_bundle(save_calibration_record(tmp_path / "r", tmp_path))
    here = msgspec.json.decode(bundle.read("manifest.json"))
    evaluation = verify(bundle).evaluation
    with pytest.raises(UnusableRecord, match=re.escape(said.format(**here))):
        resolve(evaluation, msgspec.json.encode(here | changed))


@pytest.mark.parametrize("has_earlier_form", [False, True])
def test_a_record_of_either_form_is_verified_replayed_and_shown(
    has_earlier_form: bool, tmp_path: Path
) -> None:
    found = benchmark_registry.resolve("calibration", OPTIONS)
    sha256 = None
    if has_earlier_form:
        text = msgspec.json.encode(found.manifest, order="deterministic")
        sha256 = hashlib.sha256(text).hexdigest()
    path, folder = tmp_path / "r.proctor", tmp_path
    save_played_record(path, folder, found, play_chunks, sha256=sha256)
    bundle = open_bundle(path)
    manifest = bundle.read("manifest.json")
    assert (b'"title"' in manifest) is has_earlier_form
    known = resolve(verify(bundle).evaluation, manifest)
    assert replay_record(path, known).result == "exact"
    shown = read_reported_run(bundle, {}).benchmark
    assert shown is not None
    assert shown["title"] == found.manifest["title"]
    assert shown["image_sizes"] == found.manifest["image_sizes"]
    image = shown["observation_space"]["images"]["pattern"]
    assert (
        image["description"]
        == (found.manifest["observation_space"]["images"]["pattern"]["description"])
    )
