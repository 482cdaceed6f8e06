"""Encodings of bodies, numbers, tensors and images (ENC)."""

import base64
import io
import json
import math
import struct
from collections.abc import Iterator
from datetime import datetime
from typing import Any

import msgspec
from PIL import Image

from conformance.checks.support.bodies.msgpack_forms import WIDTHS, Twice, pack
from conformance.checks.support.given_states import submit_and_attach
from conformance.client.check_context import CheckContext
from conformance.client.http_client import NO_ACCEPT
from conformance.client.run_client import WorkerClient
from conformance.exchanges.answer import Answer
from conformance.oracle.calibration_benchmark import TENSORS
from conformance.runner.requirement import each_requirement, requirement
from conformance.specification.document import MSGPACK
from conformance.specification.tensor_formats import TENSOR_FORMATS
from conformance.verdicts import expect
from conformance.verdicts.expect import NotApplicable, SetUpFailed

ACCEPT_BOTH = (
    *("application/json, application/msgpack", "application/msgpack, application/json"),
    *("application/*", "*/*", NO_ACCEPT),
)
# In a turn; each has another length in MessagePack.
STEP_LIMITS = (127, 128, 255, 256, 10000)
LIST_LENGTHS = (15, 16, 17)
# Around the ends of the integers that encodings write in few bytes.
_WHOLE = [-1, -32, -33, -127, -128, -129, -200, -256, 127, 128, 255, 256, -32768]
_WHOLE += [
    -32769,
    32767,
    32768,
    65535,
    65536,
    -(2**31),
    -(2**31) - 1,
    2**31,
    2**32 - 1,
    2**32,
]
# The smallest and the largest number of each, from calibration.md.
_TINY = {"float16": 2.0**-14, "float32": 2.0**-126, "float64": 2.0**-1022}
_HUGE = {
    "float16": 65504.0,
    "float32": (2 - 2.0**-23) * 2.0**127,
    "float64": math.ldexp(2 - 2.0**-52, 1023),
}


def elements(dtype: str) -> list[float]:
    """Give the elements as calibration.md defines them."""
    bits = 8 * struct.calcsize(f"<{TENSOR_FORMATS[dtype]}")
    if dtype == "bool":
        return [0, 1, 0, 1, 0, 1]
    if dtype.startswith("int"):
        return [-2, -1, 0, 1, -(2 ** (bits - 1)), 2 ** (bits - 1) - 1]
    if dtype.startswith("uint"):
        return [0, 1, 2, 3, 4, 2**bits - 1]
    return [-2.0, -0.5, 0.0, 0.5, _TINY[dtype], _HUGE[dtype]]


def tensors() -> Iterator[tuple[str, dict[str, Any]]]:
    """Give every tensor of the task `echo`, with its data as bytes."""
    for name, tensor in TENSORS.items():
        dtype, (rows, _) = tensor["dtype"], tensor["shape"]
        numbers = elements(dtype) if rows else []
        data = struct.pack(f"<{len(numbers)}{TENSOR_FORMATS[dtype]}", *numbers)
        yield name, tensor | {"data": data}


def pattern(width: int, height: int, count: int) -> bytes:
    """Give the image of the task `echo`."""
    return bytes(
        (7 * x + 13 * y + 29 * c + count) % 256
        for y in range(height)
        for x in range(width)
        for c in range(3)
    )


def blob(data: Any) -> bytes:
    """Read binary data as JSON or MessagePack carry it."""
    if isinstance(data, bytes):
        return data
    try:
        return base64.b64decode(data, validate=True)
    except (ValueError, TypeError) as error:
        raise expect.Violation("padded base64", expect.format_value(data)) from error


def echo(context: CheckContext, task: str = "echo", **options: Any) -> WorkerClient:
    """Attach a worker to an episode of a task, whose state returns a vector."""
    return submit_and_attach(context, task, **options)


@requirement("ENC-001")
def test_enc_001_json_is_sent_when_both_are_acceptable(context: CheckContext) -> None:
    """JSON and MessagePack are equally acceptable, in every order, also to the repeat
    of a turn for which MessagePack alone was. Expect JSON."""
    worker = echo(context, "count")
    bodies = [False, True] if context.speaks_msgpack else [False]
    for accept in ACCEPT_BOTH:
        headers = {"Accept": accept}
        for is_msgpack in bodies:
            answer = worker.try_predict(
                context.action(), msgpack=is_msgpack, headers=headers
            )
            expect.ok(answer)
            worker.seq += 1
            what = f"the media type for Accept: {accept or 'absent'}"
            expect.equal(answer.media_type, "application/json", what)
    if context.speaks_msgpack:
        worker = echo(context, "count")
        expect.ok(worker.try_predict(context.action(), headers={"Accept": MSGPACK}))
        worker.seq += 1
        again = worker.try_predict(
            context.action(), seq=worker.seq, headers={"Accept": "*/*"}
        )
        expect.ok(again)
        what = "the media type of a turn that was first sent in MessagePack"
        expect.equal(again.media_type, "application/json", what)


def structure(value: Any) -> Any:
    """Convert base64 and bin to one form, and refuse any other type."""
    if isinstance(value, dict):
        return {k: blob(v) if k == "data" else structure(v) for k, v in value.items()}
    if isinstance(value, list):
        return [structure(item) for item in value]
    is_extension = isinstance(value, msgspec.msgpack.Ext | datetime)
    expect.true(not is_extension, "no extension types", repr(value))
    return value


@requirement("ENC-002")
def test_enc_002_msgpack_has_the_structure_of_json(context: CheckContext) -> None:
    """Turns are read in both encodings, with images, tensors, integers of each size
    that MessagePack has, and lists around the length at which it writes them otherwise.
    Expect the same structure, `data` as bin, and no extension types."""
    for max_steps in STEP_LIMITS:
        worker = echo(context, max_steps=max_steps)
        worker.predict(context.action(vector=[0.1] * 8))
        expect_equal_turns(worker)
    worker = echo(context, max_steps=1000)
    for length in LIST_LENGTHS:
        number = min(length, context.limits["max_chunk"])
        worker.predict(*[context.action(score=0.5)] * number, observe="all")
        expect_equal_turns(worker)


def expect_equal_turns(worker: WorkerClient) -> None:
    """Expect the latest turn to be the same in JSON and in MessagePack."""
    read = [
        worker.try_attach(attach_key=worker.attach_key, headers={"Accept": media_type})
        for media_type in ("application/json", "application/msgpack")
    ]
    plain, packed = (expect.ok(answer) for answer in read)
    expect.equal(read[1].media_type, "application/msgpack", "the media type")
    expect.true(packed is not None, "a body that can be read", read[1].body[:99])
    for tensor in packed["observation"]["tensors"].values():
        expect.true(isinstance(tensor["data"], bytes), "data as bin", tensor["data"])
    for image in packed["observation"]["images"].values():
        expect.true(isinstance(image["data"], bytes), "data as bin", image["data"])
    for name in ("lease", "timing"):
        expect.equal(sorted(packed.pop(name)), sorted(plain.pop(name)), name)
    expect.equal(structure(packed), structure(plain), "the turn")


def doubles(context: CheckContext) -> list[float]:
    """Give doubles that lose bits easily, and random ones."""
    chosen = [0.1, -0.0, 1 / 3, 5e-324, 2.0**-1022, 1.7976931348623157e308]
    chosen += [2.0**53 - 1, -(2.0**63), 1e21, 123456789.123456789, -1e-7, 1.0]
    chosen += map(float, _WHOLE)
    while len(chosen) < 96:
        (number,) = struct.unpack("<d", context.random.randbytes(8))
        if math.isfinite(number):
            chosen.append(number)
    return chosen


@requirement("ENC-003")
def test_enc_003_numbers_come_back_bit_for_bit(context: CheckContext) -> None:
    """Some hundred doubles, eight in every action: tiny, huge, whole, negative zero,
    random. Expect every bit of them in the observation, in every encoding; JSON may
    also write negative zero as `-0`."""
    worker = echo(context, "count", max_steps=1000)
    numbers = doubles(context)
    encodings = [False, True] if context.speaks_msgpack else [False]
    for is_msgpack in encodings:
        for first in range(0, len(numbers), 8):
            sent = numbers[first : first + 8]
            answer = worker.try_predict(context.action(vector=sent), msgpack=is_msgpack)
            observed = expect.ok(answer)["observation"]["state"]["vector"]
            worker.seq += 1
            bits = [struct.pack("<d", number).hex() for number in (*sent, *observed)]
            expect.equal(bits[8:], bits[:8], f"the bits of {sent}")
    body = {"session_id": worker.session_id, "seq": worker.seq + 1}
    body["actions"] = [context.action(vector=[-0.0] * 8)]
    short = json.dumps(body).replace("-0.0", "-0").encode()
    answer = send_predict(worker, short, "application/json")
    observed = expect.ok(answer)["observation"]["state"]["vector"]
    signs = [math.copysign(1, zero) for zero in observed]
    expect.equal(signs, [-1] * 8, "signs of `-0`")


@requirement("ENC-004")
def test_enc_004_tensors_arrive_bit_for_bit(context: CheckContext) -> None:
    """A worker reads the tensors of every dtype, before and after an action. Expect the
    elements of calibration.md, little-endian, in C order."""
    worker = echo(context)
    turns = [worker.turn, worker.predict(context.action())]
    if context.speaks_msgpack:
        turns.append(worker.predict(context.action(), msgpack=True))
    for turn in turns:
        observed = turn["observation"]["tensors"]
        for name, tensor in tensors():
            expect.true(name in observed, f"a tensor `{name}`", sorted(observed))
            for member in ("dtype", "shape"):
                what = f"{member} of `{name}`"
                expect.equal(observed[name][member], tensor[member], what)
            data = blob(observed[name]["data"])
            expect.equal(data.hex(), tensor["data"].hex(), f"data of `{name}`")


def images_of(context: CheckContext, codec: str, size: dict[str, int]) -> Iterator[Any]:
    """Choose a codec and a size; give the images of two turns with their count."""
    if codec not in context.benchmark["image_codecs"]:
        raise NotApplicable(f"the codec {codec} is not offered")
    worker = echo(context, images={"codec": codec, **size})
    for turn in (worker.turn, worker.predict(*[context.action()] * 3)):
        images = turn["observation"]["images"]
        if "pattern" not in images:
            text = f"the task `echo` has no image `pattern`: {[*images]}"
            raise SetUpFailed(text, breaks="CAL-001")
        image = images["pattern"]
        expected = {"codec": codec, "channels": 3, **size}
        expect.members(image, expected, "of the image")
        yield blob(image["data"]), 0 if turn["seq"] == 0 else 3


def decode_image(data: bytes, codec: str) -> Image.Image:
    try:
        image: Image.Image = Image.open(io.BytesIO(data), formats=[codec.upper()])
        image.load()
    except OSError as error:
        raise expect.Violation(
            f"a {codec} image", f"{error} in {data[:40]!r}"
        ) from error
    return image


@each_requirement("codec", {"ENC-005": "raw", "ENC-006": "png"})
def test_enc_005_image_arrives_bit_for_bit(context: CheckContext, codec: str) -> None:
    """Raw and png images of every offered size. Expect them to decode to the pattern of
    calibration.md."""
    for size in context.benchmark["image_sizes"][:3]:
        for data, count in images_of(context, codec, size):
            is_raw = codec == "raw"
            numbers = (
                data if is_raw else decode_image(data, codec).convert("RGB").tobytes()
            )
            expected = pattern(size["width"], size["height"], count)
            what = f"bytes of the {codec} image, {size}, count {count}"
            expect.equal(len(numbers), len(expected), f"number of {what}")
            wrong = [n for n in range(len(expected)) if numbers[n] != expected[n]]
            expect.true(not wrong, f"the {what}", f"wrong at {wrong[:5]}")


@requirement("ENC-007")
def test_enc_007_jpeg_image_decodes_to_its_size(context: CheckContext) -> None:
    """Jpeg images of every offered size. Expect them to decode to that size."""
    for size in context.benchmark["image_sizes"][:3]:
        for data, _ in images_of(context, "jpeg", size):
            decoded = decode_image(data, "jpeg").size
            expect.equal(decoded, (size["width"], size["height"]), "the decoded size")


@requirement("ENC-008")
def test_enc_008_cannot_send_an_extension_type(context: CheckContext) -> None:
    """A MessagePack body with an application-specific extension type, then a timestamp.
    Expect `malformed_body` and nothing executed; without them the body is accepted."""
    worker = submit_and_attach(context, "count")
    for extension in (
        msgspec.msgpack.Ext(5, b"\x00"),
        msgspec.msgpack.Ext(-1, bytes(4)),
    ):
        for action in (
            context.action(score=extension),
            context.action(vector=extension),
        ):
            expect.refused(worker.try_predict(action, msgpack=True), "malformed_body")
    turn = expect.ok(worker.try_predict(context.action(), msgpack=True))
    expect.equal(turn["observation"]["state"]["count"], [1], "count")


def send_predict(worker: WorkerClient, content: bytes, media_type: str) -> Answer:
    """Send the bytes of a body of predict."""
    headers = {"Content-Type": media_type}
    return worker.run.call(
        "predict", worker_id=worker.id, content=content, headers=headers
    )


def next_body(worker: WorkerClient, **values: Any) -> dict[str, Any]:
    """Give the body of the next predict, with one action."""
    body: dict[str, Any] = {"session_id": worker.session_id, "seq": worker.seq + 1}
    return body | {"actions": [worker.run.context.action(**values)]}


@requirement("ENC-013")
def test_enc_013_cannot_send_a_member_twice(context: CheckContext) -> None:
    """A name stands twice in a JSON body: at its top, in an action, with another value
    or the same one, and escaped. Expect `malformed_body`; without the repetition the
    body is accepted."""
    worker = echo(context, "count")
    right = json.dumps(next_body(worker, vector=[0.5] * 8))
    for name, before in (
        *(("seq", '"seq": 77, "seq"'), ("seq", '"seq": 1, "seq"')),
        *(("seq", '"\\u0073eq": 1, "seq"'), ("values", '"values": {}, "values"')),
        ("vector", '"vector": [9, 9, 9, 9, 9, 9, 9, 9], "vector"'),
    ):
        wrong = right.replace(f'"{name}"', before)
        answer = send_predict(worker, wrong.encode(), "application/json")
        expect.refused(answer, "malformed_body")
    turn = expect.ok(send_predict(worker, right.encode(), "application/json"))
    expect.equal(turn["seq"], 1, "seq")


@requirement("ENC-010")
def test_enc_010_too_small_a_number_is_zero(context: CheckContext) -> None:
    """Numbers nearer to zero than any double, beside one that is not. Expect zeros."""
    worker = echo(context, "count")
    text = json.dumps(next_body(worker, vector=[99.0] * 7 + [0.5]))
    small = ("1e-400", "-1e-999", "0.0e-5000", f"0.{'0' * 400}1", "1E-400", "1e-9999")
    for number in (*small, "0.0"):
        text = text.replace("99.0", number, 1)
    turn = expect.ok(send_predict(worker, text.encode(), "application/json"))
    expect.equal(turn["observation"]["state"]["vector"], [0.0] * 7 + [0.5], "vector")


@requirement("ENC-011")
def test_enc_011_cannot_send_a_key_that_is_no_string(context: CheckContext) -> None:
    """MessagePack maps with numbers, nil and booleans as keys, in the body and inside.
    Expect `malformed_body` or `invalid_request`; without them the body is accepted."""
    worker = echo(context)
    right = next_body(worker)
    action = right["actions"][0]
    for key in (1, -1, None, True, 1.5):
        inner = {"values": action["values"] | {key: [0.0]}}
        for wrong in (
            right | {key: 1},
            right | {"actions": [action | {key: 1}]},
            right | {"actions": [inner]},
        ):
            packed = msgspec.msgpack.encode(wrong)
            answer = send_predict(worker, packed, "application/msgpack")
            is_malformed = answer.code == "malformed_body"
            expect.refused(
                answer, "malformed_body" if is_malformed else "invalid_request"
            )
    packed = msgspec.msgpack.encode(right)
    expect.ok(send_predict(worker, packed, "application/msgpack"))


@requirement("ENC-014")
def test_enc_014_cannot_send_a_key_twice(context: CheckContext) -> None:
    """A key stands twice in a MessagePack map: at its top, in an action, in a short and
    in a long map. Expect `malformed_body`; without the repetition the body is accepted.
    """
    worker = echo(context)
    right = next_body(worker)
    for wrong in (
        {**right, Twice("seq"): 77},
        {Twice("seq"): right["seq"], **right},
        right | {"actions": [{Twice("values"): {}, **right["actions"][0]}]},
        right | {"actions": [{"values": {**right["actions"][0]["values"],
                                         Twice("vector"): [9.0] * 8}}]},
    ):  # fmt: skip
        for width in WIDTHS:
            packed = pack(wrong, width, is_signed=False)
            answer = send_predict(worker, packed, "application/msgpack")
            expect.refused(answer, "malformed_body")
    packed = pack(right, WIDTHS[0], is_signed=False)
    expect.ok(send_predict(worker, packed, "application/msgpack"))


@requirement("ENC-012")
def test_enc_012_every_format_of_messagepack_is_read(context: CheckContext) -> None:
    """Bodies with short and long forms of lengths and integers, floats of four bytes,
    the largest and the smallest integer of each form. Expect the same values to be
    executed each time."""
    numbers = [0.5, -0.25, 1.0, 127.0, 0.0, -1.0, 2.0**-100, -32.0]
    for is_signed in (False, True):
        worker = echo(context)
        for width in WIDTHS:
            body = pack(next_body(worker, vector=numbers), width, is_signed)
            turn = expect.ok(send_predict(worker, body, "application/msgpack"))
            expect.equal(turn["observation"]["state"]["vector"], numbers, "vector")
            worker.seq += 1
    worker = echo(context)
    for width in WIDTHS[1:]:
        half = 2.0 ** (8 * width - 1)
        largest = 2 * half - (2**11 if width == WIDTHS[-1] else 1)
        ends = [largest, half, half / 2, -half, 1 - half / 2, 1.0, -1.0, 0.0]
        body = pack(next_body(worker, vector=ends), width, is_signed=False)
        turn = expect.ok(send_predict(worker, body, "application/msgpack"))
        vector = [float(number) for number in turn["observation"]["state"]["vector"]]
        expect.equal(vector, ends, f"the ends of integers of {width} bytes")
        worker.seq += 1
