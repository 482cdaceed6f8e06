"""A value of JSON in a spelling that http.md does not allow is a fault."""

from __future__ import annotations

from typing import Any

import pytest

from conformance.specification.document import JSON, MSGPACK, load_spec
from tests.support.kit.null_servers import TURN


def faults(media_type: str, data: Any, shape: list[Any], **members: Any) -> list[str]:
    tensor = {"dtype": "uint8", "shape": shape, "data": data}
    observation = {"state": {}, "images": {}, "tensors": {"t": tensor}}
    spec = load_spec()
    turn = TURN | {"observation": observation, **members}
    return spec.response_faults(spec.operations["predict"], 200, media_type, turn)


@pytest.mark.parametrize("data", ["", "AAAA", "AA==", "AAA="])
def test_base64_is_accepted(data: str) -> None:
    assert faults(JSON, data, [1]) == []


@pytest.mark.parametrize("data", ["A", "AA", "AA=", "AAAA\n", "AA\nAA", "A-_A", "é"])
def test_other_alphabets_and_line_breaks_are_not(data: str) -> None:
    assert faults(JSON, data, [1])


@pytest.mark.parametrize("value", [1.0, 0.0, -0.0])
def test_an_integer_has_no_fraction_in_json(value: float) -> None:
    (fault,) = faults(JSON, "AA==", [1, value])
    assert fault.startswith("$.observation.tensors.t.shape[1]: ")
    assert faults(JSON, "AA==", [1], seq=value)
    assert faults(JSON, "AA==", [1], rewards=[value]) == []
    assert faults(MSGPACK, b"\0", [1, value], seq=value) == []
