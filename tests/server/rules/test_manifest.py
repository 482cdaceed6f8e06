"""Seeds that a host draws in secret: what follows from the secret, what is shown."""

import hashlib
import json
from typing import Any, cast

from reference_record.contents.benchmark_manifest import (
    manifest_file,
    manifest_of,
    manifest_sha256,
    without_sealed_seeds,
)
from reference_server.rules.manifest import Manifest, is_sealed
from reference_server.rules.runs.run import Episode
from reference_sim.host_seeds import seal

SECRET, OTHER = b"s" * 32, b"o" * 32
SEED_MAX = 2**32 - 1


def manifest(**members: Any) -> Any:
    episodes = [
        {"task": task, "split": split, "seed": first + index}
        for split, first in (("open", 0), ("test", 100))
        for index in range(24)
        for task in ("a", "b")
    ]
    return {
        "benchmark_id": "bench",
        "sealed_splits": ["test"],
        "episodes": episodes,
    } | members


def seeds(found: Any, split: str, task: str = "a") -> list[int]:
    return [
        e["seed"] for e in found["episodes"] if (e["split"], e["task"]) == (split, task)
    ]


def test_open_splits_keep_their_seeds_and_sealed_ones_get_others() -> None:
    found = seal(manifest(), SECRET, 1, SEED_MAX)
    assert seeds(found, "open") == list(range(24))
    drawn = seeds(found, "test")
    assert drawn == seeds(found, "test", "b"), "tasks stay paired"
    assert len(set(drawn)) == 24
    assert all(0 <= seed <= SEED_MAX for seed in drawn)
    assert not set(drawn) & set(range(1000))
    assert drawn != sorted(drawn), "no seed follows from another one"
    assert is_sealed(found, "test")
    assert not is_sealed(found, "open")


def test_seeds_follow_from_the_secret_and_the_benchmark_alone() -> None:
    found = seal(manifest(), SECRET, 1, SEED_MAX)
    assert seal(manifest(), SECRET, 1, SEED_MAX) == found
    assert manifest_sha256(seal(manifest(), SECRET, 1, SEED_MAX)) == manifest_sha256(
        found
    )
    other = seal(manifest(), OTHER, 1, SEED_MAX)
    assert not set(seeds(other, "test")) & set(seeds(found, "test"))
    assert other["seeds_sha256"] != found["seeds_sha256"]
    assert manifest_sha256(other) != manifest_sha256(found)
    renamed = seal(manifest(benchmark_id="bench_2"), SECRET, 1, SEED_MAX)
    assert not set(seeds(renamed, "test")) & set(seeds(found, "test"))


def test_nothing_that_is_hashed_has_a_sealed_seed() -> None:
    """Of few seeds the right one could be found by its hash."""
    found = seal(manifest(), SECRET, 1, SEED_MAX)
    shown = without_sealed_seeds(found)
    assert [("seed" in e) for e in shown["episodes"]] == 48 * [True] + 48 * [False]
    in_records = manifest_file(found, manifest_sha256(found))
    assert json.loads(in_records) == manifest_of(shown)
    assert hashlib.sha256(in_records).hexdigest() == manifest_sha256(found)
    elsewhere: Any = {**found, "episodes": [dict(e) for e in found["episodes"]]}
    elsewhere["episodes"][-1]["seed"] = 7
    assert manifest_sha256(elsewhere) == manifest_sha256(found)
    plain = hashlib.sha256(str(seeds(found, "test")).encode()).hexdigest()
    assert found["seeds_sha256"] != plain


def test_seeds_that_belong_together_are_drawn_as_blocks() -> None:
    blocks = seal(manifest(), SECRET, 4, SEED_MAX)
    drawn = seeds(blocks, "test")  # 100 to 123: six whole blocks of four
    for place in range(0, 24, 4):
        first = drawn[place]
        assert first % 4 == 0
        assert drawn[place : place + 4] == [first, first + 1, first + 2, first + 3]
    assert all(seed <= SEED_MAX for seed in drawn)


def test_a_manifest_without_sealed_splits_is_unchanged() -> None:
    none, absent = manifest(sealed_splits=[]), manifest()
    del absent["sealed_splits"]
    for plain in (none, absent):
        assert seal(plain, SECRET, 1, SEED_MAX) is plain
        assert without_sealed_seeds(plain) is plain


def test_an_episode_knows_whether_its_seed_is_sealed() -> None:
    found = cast(Manifest, seal(manifest(), SECRET, 1, SEED_MAX))
    assert not Episode.of(found, 0).is_sealed
    last = Episode.of(found, 95)
    assert (last.index, last.task, last.split) == (95, "b", "test")
    assert last.is_sealed
    assert last.seed == seeds(found, "test")[-1]
