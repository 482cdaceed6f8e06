"""The manifest of a benchmark is the same on every make of server (BEN-006)."""

import hashlib
import json
import re
from typing import Any

import msgspec
import pytest

from conformance.oracle.expected_manifest import canonical_bytes, manifest_of
from reference_record.contents.benchmark_manifest import (
    is_manifest,
    manifest_file,
    manifest_sha256,
    merged,
    texts_of,
    without_sealed_seeds,
)
from reference_sim import benchmark_registry
from tests.support.paths import SPEC
from tools import manifest_vectors

CASES = json.loads(manifest_vectors.PATH.read_text())["cases"]


def test_the_vectors_are_as_their_tool_writes_them() -> None:
    assert manifest_vectors.PATH.read_text() == manifest_vectors.text()


@pytest.mark.parametrize("case", CASES, ids=lambda case: case["description"])
def test_a_vector(case: dict[str, Any]) -> None:
    """Server and kit have code of their own, and the vectors judge both."""
    canonical = case["canonical"].encode()
    assert hashlib.sha256(canonical).hexdigest() == case["manifest_sha256"]
    benchmark = case["benchmark"]
    assert canonical_bytes(manifest_of(benchmark)) == canonical
    assert manifest_file(benchmark, case["manifest_sha256"]) == canonical
    assert manifest_sha256(benchmark) == case["manifest_sha256"]


@pytest.mark.parametrize("benchmark", ["calibration", "tabletop"])
def test_what_is_not_in_the_manifest_is_shown_beside_it(benchmark: str) -> None:
    found = benchmark_registry.resolve(benchmark).manifest
    manifest = json.loads(manifest_file(found, manifest_sha256(found)))
    whole = merged(manifest, texts_of(found))
    shown = without_sealed_seeds(found)
    assert whole == json.loads(json.dumps(shown))
    assert "title" not in manifest


def test_a_run_keeps_the_digest_that_it_has_shown() -> None:
    found = benchmark_registry.resolve("calibration").manifest
    earlier = msgspec.json.encode(found, order="deterministic")
    sha256 = hashlib.sha256(earlier).hexdigest()
    assert is_manifest(found, sha256)
    assert manifest_file(found, sha256) == earlier
    assert is_manifest(found, manifest_sha256(found))
    assert not is_manifest(found, "0" * 64)


@pytest.mark.parametrize("spaces", [5, [1], {"arm": 5}, {"arm": {"parts": [1]}}])
def test_spaces_of_unknown_origin_have_some_digest(spaces: Any) -> None:
    assert manifest_sha256({"action_space": spaces, "observation_space": spaces})


def test_the_overview_shows_the_digest_of_today() -> None:
    """Its run has the options of the first vector, which are the defaults."""
    shown = re.findall(
        '"manifest_sha256": "([0-9a-f]{64})"', (SPEC / "overview.md").read_text()
    )
    assert set(shown) == {CASES[0]["manifest_sha256"]}


@pytest.mark.parametrize("name", ["tabletop", "tabletop_state", "mobile_bimanual"])
def test_each_task_says_its_goal_and_no_digest_changes_by_it(name: str) -> None:
    found = benchmark_registry.resolve(name).manifest
    goals = found["task_goals"]
    assert list(goals) == found["tasks"]
    assert all(re.fullmatch(r"[A-Z].{20,}\.", goal) for goal in goals.values()), goals
    silent = {key: value for key, value in found.items() if key != "task_goals"}
    assert manifest_sha256(found) == manifest_sha256(silent)
    assert canonical_bytes(manifest_of(found)) == canonical_bytes(manifest_of(silent))
    earlier = msgspec.json.encode(without_sealed_seeds(silent), order="deterministic")
    assert is_manifest(found, hashlib.sha256(earlier).hexdigest())
