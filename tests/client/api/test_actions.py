"""Actions of a policy become the chunk of a predict."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from reference_client import ProctorError
from reference_client.api.policy import Vector, chunk_of


def test_numpy_vectors_become_a_chunk() -> None:
    actions: list[dict[str, Vector]] = [
        {"a": np.array([0.5, 1.0], np.float32), "b": [1, 2.5]},
        {"a": (0.0,), "b": []},
    ]
    values = [action["values"] for action in chunk_of(actions)]
    assert values == [{"a": [0.5, 1.0], "b": [1.0, 2.5]}, {"a": [0.0], "b": []}]


@pytest.mark.parametrize(
    ("actions", "pointer", "text"),
    [
        ({"a": [1.0]}, "/actions", "a dict, not a list"),
        ([], "/actions", "is empty"),
        ([[1.0]], "/actions/0/values", "not a dict of vectors"),
        ([{"a": 1.0}], "/actions/0/values/a", "has 0 dimensions"),
        ([{"a": ["one"]}], "/actions/0/values/a", "no number"),
        ([{"a": [1.0, np.nan]}], "/actions/0/values/a/1", "not finite"),
        ([{"a/b~": [np.inf]}], "/actions/0/values/a~1b~0/0", "not finite"),
    ],
)
def test_an_invalid_action_is_refused_with_its_pointer(
    actions: Any, pointer: str, text: str
) -> None:
    with pytest.raises(ProctorError, match=text) as caught:
        chunk_of(actions)
    assert (caught.value.code, caught.value.side_effects) == ("invalid_request", "none")
    assert [at for at, _ in caught.value.errors] == [pointer]
