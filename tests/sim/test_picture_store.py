"""The picture store: what is stored is found, and nothing else is."""

import os
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest

from reference_sim.benchmarks.question_answering import simulator as questions
from reference_sim.benchmarks.question_answering.arrangement import Arrangement
from reference_sim.benchmarks.question_answering.items import (
    BLOCK,
    CAMERA,
    FIRST_SEEDS,
    TASKS,
)
from reference_sim.picture_store import SLOT_BYTES, PictureStore

SHAPE = (4, 5, 3)
PICTURE = np.arange(60, dtype=np.uint8).reshape(SHAPE)


@pytest.fixture
def store() -> Iterator[PictureStore]:
    opened = PictureStore()
    opened.open()
    yield opened
    opened.close()


def test_a_picture_is_found_under_its_slot_and_key(store: PictureStore) -> None:
    assert store.find(3, "a", SHAPE) is None
    store.put(3, "a", PICTURE)
    found = store.find(3, "a", SHAPE)
    assert found is not None
    assert found.tolist() == PICTURE.tolist()
    for slot, key, shape in ((3, "b", SHAPE), (2, "a", SHAPE), (3, "a", (4, 4, 3))):
        assert store.find(slot, key, shape) is None
    store.put(3, "b", PICTURE)
    assert store.find(3, "a", SHAPE) is None


def test_a_picture_that_is_half_written_is_not_found(store: PictureStore) -> None:
    store.put(0, "a", PICTURE)
    assert store._file is not None
    os.pwrite(store._file.fileno(), b"\xff", 100)
    assert store.find(0, "a", SHAPE) is None


def test_a_picture_beyond_a_slot_is_not_stored(store: PictureStore) -> None:
    large = np.zeros((SLOT_BYTES, 1, 1), np.uint8)
    store.put(0, "a", large)
    assert store.find(0, "a", (SLOT_BYTES, 1, 1)) is None


def test_without_a_file_nothing_is_stored() -> None:
    store = PictureStore()
    store.put(0, "a", PICTURE)
    assert store.find(0, "a", SHAPE) is None
    store.close()


def test_a_broken_file_stores_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    def fail(*_: Any) -> Any:
        raise OSError("no space")

    store = PictureStore()
    store.open()
    monkeypatch.setattr(os, "pwrite", fail)
    monkeypatch.setattr(os, "pread", fail)
    store.put(0, "a", PICTURE)
    assert store.find(0, "a", SHAPE) is None
    store.close()
    monkeypatch.setattr("tempfile.TemporaryFile", fail)
    unopened = PictureStore()
    unopened.open()
    assert unopened._file is None


def test_every_item_of_the_manifest_has_a_slot_of_its_own() -> None:
    slots = [
        questions._slot(task, first + place, split)
        for split, first in FIRST_SEEDS.items()
        for place in range(BLOCK)
        for task in TASKS
    ]
    assert sorted(map(int, filter(lambda s: s is not None, slots))) == list(  # type: ignore[arg-type]
        range(2 * BLOCK * len(TASKS))
    )
    assert questions._slot("count", 6000, "") is None
    drawn_by_a_host = BLOCK * 123_457
    assert questions._slot("count", drawn_by_a_host, "test") == questions._slot(
        "count", FIRST_SEEDS["test"], "test"
    )


def test_the_picture_of_an_item_is_drawn_once(
    store: PictureStore, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Two simulators share a store, as two evaluations do. Expect one drawing each."""
    monkeypatch.setattr(questions, "PICTURES", store)
    drawn: list[tuple[int, int]] = []

    def draw(_self: Arrangement, width: int, height: int) -> Any:
        drawn.append((width, height))
        return np.full((height, width, 3), len(drawn), np.uint8)

    monkeypatch.setattr(Arrangement, "picture", draw)
    seen = []
    for size in ((160, 120), (160, 120), (80, 60)):
        simulator = questions.QuestionSimulator(size, "fast")
        for split, seed in (("val", 6000), ("test", 7200), ("", 6000)):
            simulator.reset("count", seed, split)
            seen.append(int(simulator.observe().images[CAMERA][0, 0, 0]))
        simulator.close()
    # What is no item of the manifest is drawn each time.
    assert seen == [1, 2, 3, 1, 2, 4, 5, 6, 7]
