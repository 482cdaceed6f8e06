"""The pickles that we write can be read by `pickle`, and name nothing."""

from __future__ import annotations

import pickletools
from typing import Any

import numpy as np
import pytest
from hypothesis import given

from reference_server.profiles.ebench.pickle_reader import read
from reference_server.profiles.ebench.pickle_writer import write
from tests.support.profiles.ebench_client import load_pickle
from tests.support.profiles.plain_data import PLAIN_DATA


@given(PLAIN_DATA)
def test_written_pickles_are_read_by_pickle(value: Any) -> None:
    assert load_pickle(write(value)) == value
    assert read(write(value)) == value


def test_written_pickles_name_no_globals() -> None:
    value: Any = {
        "0": {"obs": {"a": [1, 2.5, None, True, "x", b"text"]}, "n": -(2**70)}
    }
    body = write(value)
    names = {opcode.name for opcode, _, _ in pickletools.genops(body)}
    assert not names & {"GLOBAL", "STACK_GLOBAL", "REDUCE", "BUILD", "INST", "OBJ"}
    value["0"]["obs"]["a"][-1] = "text"
    assert load_pickle(body) == value


@pytest.mark.parametrize("unsupported", [object(), {1}, np.zeros(1), 1j])
def test_only_plain_data_is_written(unsupported: object) -> None:
    with pytest.raises(TypeError, match="plain"):
        write({"x": unsupported})
