"""The kit's own pickles: readers of others read them, and what the kit reads."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from conformance.profiles import pickles
from reference_server.profiles.ebench import pickle_reader
from tests.support.profiles.ebench_client import (
    MaliciousObject,
    dump_pickle,
    load_pickle,
)

PLAIN = {"0": {"action": [1, -1.5, 2**40, None, True, "ü"], "nested": [[], {}]}}


def test_plain_pickles_of_the_kit_are_read_by_every_reader() -> None:
    body = pickles.write(PLAIN)
    assert load_pickle(body) == pickle_reader.read(body) == pickles.read(body) == PLAIN


def test_the_kit_s_arrays_are_numpy_s() -> None:
    numbers = [0.1, -0.0, 5e-324]
    array = load_pickle(pickles.write(pickles.PickledArray(numbers)))
    assert array.dtype == np.float64
    assert array.tobytes() == np.array(numbers).tobytes()
    for core in ("core", "_core"):
        found = pickle_reader.read(pickles.write(pickles.PickledArray(numbers, core)))
        assert found.tobytes() == array.tobytes()


def test_the_kit_s_calls_are_calls() -> None:
    body = pickles.write([pickles.PickledCall("builtins", "len", [[1, 2]])])
    assert load_pickle(body) == [2]


@pytest.mark.parametrize(
    "unsupported", [MaliciousObject(len, [1]), np.zeros(1), {1, 2j}, object()]
)
def test_the_kit_refuses_pickles_that_name_globals(unsupported: Any) -> None:
    with pytest.raises(pickles.GlobalInPickle):
        pickles.read(dump_pickle([unsupported]))


@pytest.mark.parametrize("body", [b"", b"]", b"\xff", b"h\x00.", b"<html>"])
def test_invalid_pickles_are_an_error(body: bytes) -> None:
    with pytest.raises(ValueError, match="no pickle"):
        pickles.read(body)
