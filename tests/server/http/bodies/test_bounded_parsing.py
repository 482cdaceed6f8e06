"""Large bodies: wrong ones cost no more than a look at them, right ones pass."""

import asyncio
import time
import tracemalloc
from collections.abc import Callable
from functools import partial, reduce
from typing import Any

import msgspec
import pytest
from hypothesis import given
from hypothesis import strategies as st
from pydantic import BaseModel

from reference_server.generated import models
from reference_server.http import codec
from reference_server.http.bodies import bounded_parsing
from reference_server.http.bodies.bounded_parsing import (
    ENTRIES_MAX,
    INLINE_BYTES_MAX,
    VALUES_MAX,
    WHOLE_BYTES_MAX,
    read_message,
    read_structure,
)
from reference_server.http.codec import JSON, MSGPACK
from reference_server.http.handlers import Handlers
from reference_server.profiles.ebench.task_handlers import EbenchHandlers
from reference_server.profiles.ebench.task_requests import Workers
from reference_server.profiles.flageval.evaluation_handlers import FlagevalHandlers
from reference_server.push.chat_calls import _Completion as Completion
from reference_server.rules.refusal import ERROR_CHARS_MAX, ERRORS_MAX, Refused
from reference_server.settings import Settings

SIZE = 2**19
NOTHING: Any = None
HANDLERS = Handlers(Settings(), NOTHING)
TABLES = (
    HANDLERS.table(),
    EbenchHandlers(HANDLERS).table(),
    FlagevalHandlers(HANDLERS).table(),
)
MODELS = {
    operation.body.__name__: operation.body
    for table in TABLES
    for operations in table.values()
    for operation in operations.values()
    if operation.body is not None
}
PREDICT: dict[str, Any] = {"session_id": "s", "seq": 1, "actions": []}
# Where a flood may stand: a path of names and positions from the root.
INNER_PLACES: dict[str, list[tuple[str | int, ...]]] = {
    "Predict": [
        ("actions", 0),
        ("actions", 0, "values"),
        ("actions", 0, "values", "a"),
        ("actions", 0, "values", "a", 0),
    ],
    "AttachWorker": [
        ("assumes", "action"),
        ("assumes", "state", "a"),
        ("assumes", "action", "a", "unit"),
        ("assumes", "action", "a", "parts"),
        ("assumes", "action", "a", "parts", "b", "unit"),
    ],
    "SubmitRun": [
        ("options", "tasks"),
        ("policy", "name"),
        ("policy_server", "generation"),
        ("policy_server", "generation", "a"),
    ],
    "EvaluationRequest": [("eval_infos", 0), ("eval_infos", 0, "model")],
    "Workers": [("data", "worker_ids"), ("data", "worker_ids", 0)],
}
FLOODS: dict[str, Callable[[], Any]] = {
    "zeros": lambda: [0] * (SIZE // 2),
    "numbers": lambda: [0.5] * (SIZE // 9),
    "objects": lambda: [{}] * (SIZE // 3),
    "names": lambda: {str(number): 0 for number in range(SIZE // 10)},
    "actions": lambda: [{"values": {}}] * (SIZE // 14),
    "vectors": lambda: {"values": {str(n): [0] * (SIZE // 128) for n in range(64)}},
    "one text": lambda: "a" * SIZE,
}
PLACES = [
    (name, place)
    for name, model in MODELS.items()
    for place in (
        (),
        ("unknown",),
        *[(field,) for field in model.model_fields],
        *INNER_PLACES.get(name, []),
    )
]


def put_at(place: tuple[str | int, ...], flood: Any) -> Any:
    return reduce(
        lambda inner, step: [inner] if step == 0 else {step: inner}, place[::-1], flood
    )


def read(model: type[BaseModel], body: bytes, media_type: str) -> Refused | None:
    try:
        asyncio.run(read_message(model, body, media_type))
    except Refused as refused:
        return refused
    return None


def read_open(model: type[BaseModel], body: bytes) -> Refused | None:
    """As an answer of a policy server, which may have members of its own."""
    try:
        read_structure(model, body, JSON, closed=False)
    except Refused as refused:
        return refused
    return None


def seconds(work: Callable[[], Any]) -> float:
    began = time.process_time()
    work()
    return time.process_time() - began


@pytest.fixture(scope="module")
def look_s() -> float:
    """To count to three million: about 0.1 s, more where everything takes longer."""
    return min(seconds(lambda: sum(1 for _ in range(3_000_000))) for _ in range(3))


def collision_keys(count: int) -> bytes:
    """A MessagePack map whose keys are pairs of integers with few hashes."""
    pairs = (
        b"\x92\xcf" + (number * (2**61 - 1) % 2**64).to_bytes(8, "big") + b"\x01\x00"
        for number in range(count)
    )
    return b"\xdf" + count.to_bytes(4, "big") + b"".join(pairs)


@pytest.mark.slow("builds a thousand large bodies")
@pytest.mark.parametrize("media_type", [JSON, MSGPACK])
@pytest.mark.parametrize(("name", "place"), PLACES, ids=str)
def test_no_flood_costs_more_than_parsing_it(
    name: str, place: tuple[str | int, ...], media_type: str, look_s: float
) -> None:
    """Each wrong shape in each place: processor time and memory are bounded."""
    is_json = media_type == JSON
    encode = msgspec.json.encode if is_json else msgspec.msgpack.encode
    parse = msgspec.json.decode if is_json else msgspec.msgpack.decode
    for kind, make in FLOODS.items():
        body = encode(put_at(place, make()))
        parsing_s = seconds(partial(parse, body))
        work = partial(read, MODELS[name], body, media_type)
        bound_s = 10 * parsing_s + look_s
        # Collecting what other tests left may fall into one of them, not into each.
        reading_s = seconds(work)
        if reading_s >= bound_s:
            reading_s = min(seconds(work) for _ in range(3))
        assert reading_s < bound_s, (kind, reading_s, parsing_s)
        tracemalloc.start()
        refused = work()
        _, peak = tracemalloc.get_traced_memory()
        tracemalloc.stop()
        # The bounds of a message hold some megabytes, whatever the size of the body.
        assert peak < 4 * len(body) + 2**24, (kind, peak, len(body))
        if refused is not None:
            assert len(refused.errors) <= ERRORS_MAX
            text = sum(len(at) + len(detail) for at, detail in refused.errors)
            assert text <= max(ERROR_CHARS_MAX, 3 * len(body))


@pytest.mark.parametrize("inside", [False, True])
def test_keys_that_collide_are_refused_before_a_map_is_built(inside: bool) -> None:
    count = 20_000
    keys = collision_keys(count)
    body = keys
    if inside:
        around = msgspec.msgpack.encode(PREDICT | {"actions": [{"values": {}}]})
        body = around[:-1] + keys
    refused = read(models.Predict, body, MSGPACK)
    assert refused is not None
    assert refused.code == "invalid_request"
    small = collision_keys(WHOLE_BYTES_MAX // 13)  # these are built, and are few
    assert len(small) <= WHOLE_BYTES_MAX
    assert seconds(lambda: read(models.Predict, small, MSGPACK)) < 0.5


def padded(structure: Any, media_type: str = JSON) -> bytes:
    if media_type == JSON:
        return msgspec.json.encode(structure) + b" " * WHOLE_BYTES_MAX
    return msgspec.msgpack.encode(structure)


def test_one_fault_of_a_large_body_is_reported_with_its_place() -> None:
    action = {"values": {"a/b": [0.5]}}
    cases: list[tuple[Any, str, str]] = [
        (PREDICT | {"actions": [action, 1]}, "/actions/1", "invalid_request"),
        (
            PREDICT | {"actions": [action, {"values": {"a/b": [1, "x"]}}]},
            "/actions/1/values/a~1b/1",
            "invalid_request",
        ),
        (PREDICT | {"x`y": 1}, "/x`y", "invalid_request"),
        (PREDICT | {"seq": "1"}, "/seq", "invalid_request"),
        (PREDICT | {"actions": [action | {"n": 1}]}, "/actions/0/n", "invalid_request"),
        ([], "", "invalid_request"),
        (PREDICT, "/actions", "invalid_request"),  # by its schema: none is too few
    ]
    for structure, at, code in cases:
        refused = read(models.Predict, padded(structure), JSON)
        assert refused is not None
        assert (refused.code, refused.errors[0][0]) == (code, at)


@pytest.mark.parametrize(
    "body",
    [
        b'{"seq":' + b"[" * 10**6,
        b"[" * 10**6 + b"]" * 10**6,
        b'{"seq": NaN' + b" " * WHOLE_BYTES_MAX + b"}",
        b'{"seq": 1e999' + b" " * WHOLE_BYTES_MAX + b"}",
        b'{"seq": "1", "actions": [' + b" " * WHOLE_BYTES_MAX,
        b'{"session_id": "\xff"' + b" " * WHOLE_BYTES_MAX + b"}",
        b'{"session_id": "\\ud800"' + b" " * WHOLE_BYTES_MAX + b"}",
    ],
)
def test_a_large_malformed_body_is_that(body: bytes) -> None:
    refused = read(models.Predict, body, JSON)
    assert refused is not None
    assert refused.code == "malformed_body"


def test_a_large_body_with_an_extension_is_malformed() -> None:
    vector = [0.5] * 4000
    timestamp = msgspec.msgpack.Ext(-1, b"\0" * 4)
    for wrong in (
        PREDICT | {"seq": timestamp, "actions": [{"values": {"a": vector}}]},
        PREDICT | {"actions": [{"values": {"a": [timestamp, *vector]}}]},
    ):
        refused = read(models.Predict, msgspec.msgpack.encode(wrong), MSGPACK)
        assert refused is not None
        assert refused.code == "malformed_body"


@pytest.mark.parametrize("media_type", [JSON, MSGPACK])
@pytest.mark.parametrize("numbers", [4096, 20 * 4096])
def test_a_large_right_body_is_read_as_it_is(media_type: str, numbers: int) -> None:
    vectors = [[0.1 + n / 7 for n in range(4096)] for _ in range(numbers // 4096)]
    structure = PREDICT | {"actions": [{"values": {"a": v, "b": [1]}} for v in vectors]}
    body = padded(structure, media_type)
    assert len(body) > (INLINE_BYTES_MAX if numbers > 4096 else WHOLE_BYTES_MAX)
    message = asyncio.run(read_message(models.Predict, body, media_type))
    assert message.model_dump() == structure


def test_integers_of_a_large_body_are_read_as_those_of_a_small_one() -> None:
    text = b'{"session_id":"s","seq":2e0,"actions":[{"values":{"a":[-0]}}]}'
    message = asyncio.run(
        read_message(models.Predict, text + b" " * WHOLE_BYTES_MAX, JSON)
    )
    assert message.seq == 2
    assert str(message.actions[0].values["a"][0]) == "-0.0"
    huge = b'{"session_id":"s","seq":1' + b"0" * 400 + b"}" + b" " * WHOLE_BYTES_MAX
    refused = read(models.Predict, huge, JSON)
    assert refused is not None
    assert refused.code == "malformed_body"


@pytest.mark.parametrize("media_type", [JSON, MSGPACK])
def test_null_in_a_large_body_is_what_it_is_in_a_small_one(media_type: str) -> None:
    """FLE-018: absent, where a model has it so. Elsewhere it is refused."""
    text = {"eval_model": "m", "model": "m", "eval_url": "http://127.0.0.1:1/v1"}
    encode = (msgspec.json if media_type == JSON else msgspec.msgpack).encode
    evaluation = MODELS["EvaluationRequest"]
    for size in (0, WHOLE_BYTES_MAX):
        info = text | {"tokenizer": None, "num_concurrent": None, "unknown": "x" * size}
        body = {"domain": "NLP", "mode": None, "user_id": None, "eval_infos": [info]}
        assert read(evaluation, encode(body), media_type) is None, size
        wrong = encode(PREDICT | {"session_id": None, "observe": "l" * size})
        refused = read(models.Predict, wrong, media_type)
        assert refused is not None
        assert refused.code == "invalid_request"


@pytest.mark.parametrize("text", ["{", '\\"{', "\\\\", '{"', "[,:{}"])
def test_marks_in_strings_are_no_entries(text: str) -> None:
    """Of answers and names: a string may have any number of brackets and quotes."""
    answer = {"choices": [{"message": {"content": text * SIZE}}]}
    body = msgspec.json.encode(answer)
    assert read_structure(Completion, body, JSON, closed=False) == answer


@pytest.mark.parametrize("text", ['"{"', '"\\"{"', '"\\\\"', '""'])
def test_entries_between_strings_are_counted(text: str) -> None:
    """Each string is followed by an entry more; they cost no more than parsing them."""
    entry = b'{"message":{"content":%b}}' % text.encode()
    for entries, is_refused in ((ENTRIES_MAX, False), (SIZE, True)):
        body = b'{"choices":[%b]}' % b",".join([entry] * entries)
        refused = read_open(Completion, body)
        assert (refused is not None) == is_refused


def test_values_are_counted() -> None:
    vectors = {str(n): [0] * 4096 for n in range(64)}
    actions = [{"values": vectors}] * (VALUES_MAX // (64 * 4096) + 1)
    refused = read(
        models.Predict, msgspec.msgpack.encode(PREDICT | {"actions": actions}), MSGPACK
    )
    assert refused is not None
    assert refused.errors[0][0] == ""


def test_an_open_answer_is_read_without_its_unknown_members() -> None:
    ready = {"session_id": "s", "episode_id": "e", "attempt": 1}
    large = ready | {"more": [0] * SIZE}
    found = read_structure(
        models.PolicyReset, msgspec.json.encode(large), JSON, closed=False
    )
    assert found == ready


# --- small bodies ---

ODD: list[Any] = [2.0, -2.0, 1e300, 0.5, True, None, "a", [2.0], {"a": 2.0}, [[]], {}]
ODD += [10**30, b"a"]


@pytest.mark.parametrize(("name", "place"), PLACES, ids=str)
def test_an_odd_value_anywhere_is_read_or_refused(
    name: str, place: tuple[str | int, ...]
) -> None:
    """Every union and every number of every message."""
    for value in ODD:
        structure = put_at(place, value)
        try:
            codec.validate(MODELS[name], structure)
        except Refused as refused:
            for at, _ in refused.errors:
                assert is_place(structure, at), (value, at)


def is_place(structure: Any, at: str) -> bool:
    """Whether a pointer leads to something, or to a member that an object lacks."""
    for step in at.split("/")[1:]:
        if isinstance(structure, list):
            structure = structure[int(step)]
        elif isinstance(structure, dict):
            structure = structure.get(step)
        else:
            return False
    return True


def test_a_whole_number_in_a_union_is_an_integer() -> None:
    read_ids = codec.validate(Workers, {"data": {"worker_ids": [2.0, "a", 3]}})
    assert read_ids.data.worker_ids == [2, "a", 3]


# --- what a schema permits passes ---

SCALARS = st.one_of(
    st.none(), st.booleans(), st.integers(), st.floats(), st.text(max_size=5)
)
VALUES = st.dictionaries(
    st.text(max_size=3), st.lists(st.floats() | st.integers(), max_size=4), max_size=3
)
NEARLY_PREDICT = st.fixed_dictionaries(
    {
        "session_id": st.text(max_size=3) | SCALARS,
        "seq": st.integers(0, 9) | SCALARS,
        "actions": st.lists(
            st.fixed_dictionaries({"values": VALUES | SCALARS}), max_size=3
        )
        | SCALARS,
    },
    optional={"observe": st.sampled_from(["last", "all", 1]), "x": SCALARS},
)
ASSUMED = st.dictionaries(
    st.text(max_size=3),
    st.fixed_dictionaries(
        {},
        optional={
            "size": SCALARS | st.integers(1, 9),
            "unit": SCALARS,
            "relative_to": SCALARS,
            "gripper_open": SCALARS,
            "parts": st.dictionaries(
                st.text(max_size=3),
                st.fixed_dictionaries({}, optional={"start": SCALARS, "x": SCALARS}),
                max_size=2,
            ),
        },
    ),
    max_size=3,
)
NEARLY_ATTACH = st.fixed_dictionaries(
    {"attach_key": st.text(max_size=3)},
    optional={
        "takeover": SCALARS,
        "assumes": st.fixed_dictionaries(
            {}, optional={"control_rate_hz": SCALARS, "action": ASSUMED}
        ),
    },
)


@given(
    st.one_of(
        NEARLY_PREDICT.map(lambda made: (models.Predict, made)),
        NEARLY_ATTACH.map(lambda made: (models.AttachWorker, made)),
    ),
    st.sampled_from([JSON, MSGPACK]),
)
def test_a_large_body_passes_if_it_would_as_a_small_one(
    made: tuple[type[BaseModel], Any], media_type: str
) -> None:
    model, structure = made
    encode = msgspec.json.encode if media_type == JSON else msgspec.msgpack.encode
    try:
        body = encode(structure)
    except (OverflowError, UnicodeEncodeError, msgspec.MsgspecError):
        return
    small = read(model, body, media_type)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(bounded_parsing, "WHOLE_BYTES_MAX", 0)
        large = read(model, body, media_type)
    assert (small and small.code) == (large and large.code)
    if small is None:
        assert repr(
            codec.validate(model, read_structure(model, body, media_type))
        ) == repr(codec.validate(model, codec.decode(body, media_type)))


def test_errors_are_bounded() -> None:
    many = Refused("invalid_request", "No.", errors=(("/a", "b") for _ in range(99)))
    assert len(many.errors) == ERRORS_MAX
    long = Refused("invalid_request", "No.", errors=[("/" + "a" * 2**15, "b")] * 3)
    assert len(long.errors) == 1
