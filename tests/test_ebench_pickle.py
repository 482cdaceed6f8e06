"""What we pickle is a pickle to everybody, and names nothing."""

from __future__ import annotations

import pickletools
from typing import Any

import numpy as np
import pytest
from hypothesis import given

from reference_server.profiles.ebench.pickle_reader import read
from reference_server.profiles.ebench.pickle_writer import write
from tests.ebench_client import unpickled
from tests.test_ebench_unpickle import PLAIN


@given(PLAIN)
def test_what_is_written_is_a_pickle(value: Any) -> None:
    assert unpickled(write(value)) == value
    assert read(write(value)) == value


def test_what_is_written_names_nothing() -> None:
    value: Any = {
        "0": {"obs": {"a": [1, 2.5, None, True, "x", b"text"]}, "n": -(2**70)}
    }
    body = write(value)
    names = {opcode.name for opcode, _, _ in pickletools.genops(body)}
    assert not names & {"GLOBAL", "STACK_GLOBAL", "REDUCE", "BUILD", "INST", "OBJ"}
    value["0"]["obs"]["a"][-1] = "text"
    assert unpickled(body) == value


@pytest.mark.parametrize("stranger", [object(), {1}, np.zeros(1), 1j])
def test_only_plain_data_is_written(stranger: object) -> None:
    with pytest.raises(TypeError, match="plain"):
        write({"x": stranger})
