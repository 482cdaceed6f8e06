"""The golden vectors of spec/vectors/wire, against this server's codec and models.

Both encodings of a vector hold one value; it comes through our decoder and models, and
out of our encoder the same; what is marked refused, our server refuses.
"""

from __future__ import annotations

import base64
import json
from typing import Any

import msgspec
import pytest

from reference_record.generated import answers
from reference_server.generated import models
from reference_server.http import codec
from reference_server.rules.refusal import Refused
from reference_server.rules.runs import action_space
from tests.interop.expected_values import values_equal
from tests.support.paths import ROOT

FILES = sorted((ROOT / "spec" / "vectors" / "wire").glob("*.json"))
VECTORS = [
    vector for file in FILES for vector in json.loads(file.read_text())["vectors"]
]
REFUSED = [
    pytest.param(media_type, body, id=f"{vector['id']}-{media_type[-7:]}")
    for vector in VECTORS
    if vector.get("refused")
    for media_type, body in (
        (codec.JSON, vector.get("json", "").encode()),
        (codec.MSGPACK, base64.b64decode(vector.get("msgpack", ""))),
    )
    if body
]
ACCEPTED = [
    pytest.param(vector, id=vector["id"])
    for vector in VECTORS
    if not vector.get("refused")
]
UNBOUNDED = {
    "max_chunk": 4,
    "action_space": {"vector": {"size": 1, "out_of_range": "unbounded"}},
}


def in_json(value: Any) -> Any:
    """The structure of a MessagePack body as JSON has it: bin becomes Base64."""
    if isinstance(value, bytes):
        return base64.b64encode(value).decode()
    if isinstance(value, dict):
        return {name: in_json(item) for name, item in value.items()}
    if isinstance(value, list):
        return [in_json(item) for item in value]
    return value


def execute(media_type: str, body: bytes) -> None:
    """What the server does with a predict before it looks at a session."""
    message = codec.validate(models.Predict, codec.decode(body, media_type))
    actions = [action.values for action in message.actions]
    if breaches := action_space.action_errors(actions, UNBOUNDED):
        raise Refused("invalid_request", "Mismatches.", errors=list(breaches))


def through_types(schema: str, structure: Any) -> Any:
    """The structure as our model of a request, or our type of an answer, has it."""
    if (model := getattr(models, schema, None)) is not None:
        return model.model_validate(structure).model_dump(exclude_unset=True)
    return msgspec.convert(structure, getattr(answers, schema))


def test_there_are_vectors_of_every_kind() -> None:
    assert {file.stem for file in FILES} >= {"images", "problems", "tensors", "turns"}
    assert len({vector["id"] for vector in VECTORS}) == len(VECTORS)
    assert len(REFUSED) >= 12


@pytest.mark.parametrize("vector", ACCEPTED)
def test_models_and_encoder_round_trip_each_vector(vector: dict[str, Any]) -> None:
    """Both encodings of a vector hold one value, and that value comes out again."""
    packed = base64.b64decode(vector["msgpack"])
    structure = codec.decode(packed, codec.MSGPACK)
    assert values_equal(in_json(structure), json.loads(vector["json"]))
    assert msgspec.msgpack.encode(structure) == packed
    for name in vector.get("may_drop", ()):
        del structure[name]  # our models are those of the version that we speak
    again = through_types(vector["schema"], structure)
    assert values_equal(in_json(again), in_json(structure))
    for media_type in (codec.JSON, codec.MSGPACK):
        body = codec.encode_response(again, media_type).body
        assert values_equal(
            in_json(codec.decode(bytes(body), media_type)), in_json(again)
        )


@pytest.mark.parametrize(("media_type", "body"), REFUSED)
def test_vectors_marked_refused_are_refused(media_type: str, body: bytes) -> None:
    with pytest.raises(Refused) as refusal:
        execute(media_type, body)
    assert refusal.value.code in ("malformed_body", "invalid_request")


def test_the_same_with_a_number_is_accepted() -> None:
    """The control: only what is marked in the vectors is refused."""
    sound = {"session_id": "s", "seq": 1, "actions": [{"values": {"vector": [0.5]}}]}
    execute(codec.JSON, json.dumps(sound).encode())
    execute(codec.MSGPACK, msgspec.msgpack.encode(sound))
