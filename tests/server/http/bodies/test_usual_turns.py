"""A turn that is read in one step is the one that the general way reads."""

import json

import msgspec
import pytest
from hypothesis import given
from hypothesis import strategies as st

from reference_server.generated.models import Predict
from reference_server.http import codec
from reference_server.http.bodies.bounded_parsing import read_structure
from reference_server.http.bodies.usual_turns import read_usual_turn
from reference_server.http.codec import JSON, MSGPACK

encode = msgspec.msgpack.encode
ENCODERS = {JSON: msgspec.json.encode, MSGPACK: encode}
BOTH = pytest.mark.parametrize("media_type", ENCODERS)
VECTORS: dict[str, list[float]] = {"arm": [0.5, -0.0], "gripper": []}
TURN = {"session_id": "s", "seq": 1, "actions": [{"values": VECTORS}]}
NUMBERS = st.floats() | st.integers(-2, 2) | st.none() | st.text(max_size=1)
VALUES = st.dictionaries(st.text(max_size=3), st.lists(NUMBERS, max_size=3))
ACTIONS = st.fixed_dictionaries({"values": VALUES}, optional={"more": st.none()})
TURNS = st.fixed_dictionaries(
    {
        "session_id": st.sampled_from(["", "s", "s" * 128, "s" * 129, 1]),
        "seq": st.sampled_from([0, 1, 1.0, 2**53 - 1, 2**53, True, "1"]),
        "actions": st.lists(ACTIONS, max_size=2),
    },
    optional={"observe": st.sampled_from(["last", "all", "first", None])},
)


@BOTH
@given(TURNS)
def test_a_turn_is_read_as_the_general_way_reads_it_or_not_at_all(
    media_type: str, turn: dict[str, object]
) -> None:
    body = ENCODERS[media_type](turn)
    read = read_usual_turn(body, media_type)
    if read is not None:
        general = codec.validate(Predict, read_structure(Predict, body, media_type))
        assert encode(general.model_dump()) == encode(read)


@BOTH
@pytest.mark.parametrize("more", [{}, {"observe": "all"}, {"observe": "last"}])
def test_what_clients_write_is_read_in_one_step(
    media_type: str, more: dict[str, str]
) -> None:
    read = read_usual_turn(ENCODERS[media_type](TURN | more), media_type)
    assert read is not None
    assert [action.values for action in read.actions] == [VECTORS]


@pytest.mark.parametrize(
    "body",
    [
        encode(TURN | {"more": 1}),
        encode(TURN | {"observe": None}),
        encode(TURN | {"actions": [{"values": {"arm": [float("nan")]}}]}),
        encode(TURN | {"actions": [{"values": {"arm": [float("-inf")]}}]}),
        encode(TURN | {"actions": [{"values": {"arm": [1]}}]}),
        encode(TURN).replace(b"\xa3seq\x01", b"\xa3seq\x01\xa3seq\x01", 1),
        b"\x84" + encode(TURN)[1:] + b"\xa3seq\x01",
        encode(TURN)[:-1],
        encode(TURN) + b"\x00",
        b"",
    ],
)
def test_what_needs_another_look_goes_the_general_way(body: bytes) -> None:
    assert read_usual_turn(body, MSGPACK) is None


def test_json_with_spaces_and_whole_numbers_is_read_in_one_step() -> None:
    body = json.dumps(TURN | {"actions": [{"values": {"arm": [1, 2.5]}}]}).encode()
    read = read_usual_turn(body, JSON)
    assert read is not None
    assert read.actions[0].values == {"arm": [1.0, 2.5]}


@pytest.mark.parametrize(
    ("written", "instead"),
    [
        ('"seq":1', '"seq":1,"seq":1'),
        ('"seq":1', '"seq":1,"more":1'),
        ('"arm"', '"arm":[1],"arm"'),
        ('"s"', r'"\u0073"'),
        ("0.5", "-0"),
        ("0.5", "1" + "0" * 309),
        ("0.5", "1e999"),
        ("0.5", "NaN"),
        ("0.5", "true"),
        ("0.5", "null"),
        ("}]}", "}]"),
    ],
)
def test_json_that_needs_another_look_goes_the_general_way(
    written: str, instead: str
) -> None:
    text = msgspec.json.encode(TURN).decode()
    assert written in text
    assert read_usual_turn(text.replace(written, instead, 1).encode(), JSON) is None
