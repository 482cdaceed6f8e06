"""Pickles from outside: plain data is read as written, and nothing is executed.

Attacks are made with `pickle` itself or opcode by opcode. Each would create a file if
any part of it were executed.
"""

from __future__ import annotations

import importlib
import io
import itertools
import operator
import os
import subprocess
import time
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from reference_server.profiles.ebench.pickle_reader import (
    DEPTH_MAX,
    OPCODES_MAX,
    VALUES_MAX,
    VALUES_OF_ANY,
    VALUES_PER_BYTE,
    BadPickle,
    read,
)
from tests.support.profiles.ebench_client import (
    MaliciousObject,
    dump_pickle,
    load_pickle,
)
from tests.support.profiles.plain_data import PLAIN_DATA

PROTOCOLS = range(6)
DTYPES = ("?", "i1", "<i2", ">i4", "<i8", "u1", ">u2", "<u4", "u8", "<f2", ">f4", "<f8")


def refusal(body: bytes) -> str:
    with pytest.raises(BadPickle) as caught:
        read(body)
    assert str(caught.value).isascii()
    return str(caught.value)


# --- what is read ---


@given(value=PLAIN_DATA, protocol=st.sampled_from(PROTOCOLS))
def test_plain_data_is_read_as_it_was(value: Any, protocol: int) -> None:
    assert read(dump_pickle(value, protocol)) == value


@pytest.mark.parametrize("protocol", PROTOCOLS)
@pytest.mark.parametrize("dtype", DTYPES)
def test_arrays_are_read_bit_by_bit(dtype: str, protocol: int) -> None:
    bits = np.random.default_rng(7).bytes(24 * np.dtype(dtype).itemsize)
    array = np.frombuffer(bits, dtype).reshape(2, 3, 4)
    if dtype == "?":
        array = array.astype(bool)
    for kind in (array, array.copy("F"), array[:, ::2], array.T, array[0, 0]):
        found = read(dump_pickle([kind, kind], protocol))
        assert [one.tobytes() for one in found] == [
            kind.astype(kind.dtype.newbyteorder("=")).tobytes()
        ] * 2
        assert found[0].dtype == kind.dtype.newbyteorder("=")


@pytest.mark.parametrize("protocol", PROTOCOLS)
def test_an_action_is_read_in_every_form_it_takes(protocol: int) -> None:
    action = {
        "action": [np.float32(0.5), np.int64(-3), 1.5, 2],
        "base_motion": np.zeros(3),
        "ee": (([1.0, 2.0], (3, 4)), np.arange(2)),
        "control_type": "joint_position",
        "is_rel": np.bool_(True),
    }
    first, second = read(dump_pickle([{"0": action, 1: action}] * 2, protocol))
    assert list(first) == ["0", 1]
    found = second[1]
    assert found["action"] == [0.5, -3, 1.5, 2]
    assert found["ee"][0] == [[1.0, 2.0], [3, 4]]
    assert found["ee"][1].tolist() == [0, 1]
    assert (found["control_type"], found["is_rel"]) == ("joint_position", True)


@pytest.mark.parametrize("protocol", PROTOCOLS)
def test_numpy_1_is_read_like_numpy_2(protocol: int) -> None:
    """Version 1 says `numpy.core` where version 2 says `numpy._core`."""
    array = np.arange(4.0)[::2]
    for made in (dump_pickle(array, protocol), dump_pickle(np.arange(2.0), protocol)):
        old = made.replace(b"numpy._core", b"numpy.core")
        if protocol >= 4:  # lengths stand before names and in the frame
            for module in (b"numpy.core.multiarray", b"numpy.core.numeric"):
                new_length, old_length = bytes([len(module) + 1]), bytes([len(module)])
                old = old.replace(
                    b"\x8c" + new_length + module, b"\x8c" + old_length + module
                )
        assert read(old).shape == (2,)


@pytest.mark.parametrize("protocol", PROTOCOLS)
def test_large_actions_are_within_the_limits(protocol: int) -> None:
    """Sixteen workers whose actions share what they can, and large arrays."""
    action = {"action": np.arange(16.0), "control_type": "joint_position"}
    steps = [dict.fromkeys("0123456789abcdef", action)] * 64
    arrays = [np.full(50_000, number, ">f8") for number in (0.1, -0.3, 1e300)]
    found = read(dump_pickle([steps, arrays], protocol))
    assert len(found[0]) == 64
    assert [one.tolist() for one in found[1]] == [one.tolist() for one in arrays]


def test_no_opcode_of_a_client_is_missing() -> None:
    values: list[Any] = [
        [0, 2**9, 2**17, -1, 2**40, 1.5, "x", "y" * 300, None, True, {}, (), []]
    ]
    values += [(1,), (1, 2), (1, 2, 3), (1, 2, 3, 4), {"a": 1}, {"a": 1, "b": 2}]
    for protocol in PROTOCOLS:
        for value in values:
            assert read(dump_pickle(value, protocol)) == tuples_to_lists(value)


def tuples_to_lists(value: Any) -> Any:
    """Tuples as lists."""
    if isinstance(value, list | tuple):
        return [tuples_to_lists(item) for item in value]
    return value


# --- what is refused ---


CALLS: dict[str, Callable[[Path], MaliciousObject]] = {
    "os.system": lambda p: MaliciousObject(os.system, f"touch {p}"),
    "subprocess": lambda p: MaliciousObject(subprocess.Popen, ["touch", str(p)]),
    "open": lambda p: MaliciousObject(open, str(p), "w"),
    "exec": lambda p: MaliciousObject(exec, f"open({str(p)!r}, 'w')"),
    "eval": lambda p: MaliciousObject(eval, f"open({str(p)!r}, 'w')"),
    "compile": lambda p: MaliciousObject(compile, f"open({str(p)!r}, 'w')", "", "exec"),
    "getattr": lambda p: MaliciousObject(getattr, os.system, "__call__"),  # noqa: ARG005
    "import": lambda p: MaliciousObject(importlib.import_module, "os"),  # noqa: ARG005
    "partial": lambda p: MaliciousObject(partial, os.mkdir, str(p)),
    "methodcaller": lambda p: MaliciousObject(operator.methodcaller, "touch", str(p)),
    "path": lambda p: MaliciousObject(Path, str(p)),
    "mkdir": lambda p: MaliciousObject(os.mkdir, str(p)),
    "bytes": lambda p: MaliciousObject(io.BytesIO, b"x"),  # noqa: ARG005
    "numpy.save": lambda p: MaliciousObject(np.save, str(p), np.zeros(1)),
    "tofile": lambda p: MaliciousObject(np.ndarray.tofile, np.zeros(1), str(p)),
    "frompyfunc": lambda p: MaliciousObject(np.frompyfunc, open, 1, 1),  # noqa: ARG005
    "state": lambda p: MaliciousObject(np.dtype, "f8", False, True, s={"x": str(p)}),
    "list items": lambda p: MaliciousObject(list, state=None, items=iter([str(p)])),
    "dict items": lambda p: MaliciousObject(
        dict, s=None, i=None, d=iter([("x", str(p))])
    ),
}


@pytest.mark.parametrize("protocol", PROTOCOLS)
@pytest.mark.parametrize("name", sorted(CALLS))
def test_a_call_is_refused_and_not_made(
    tmp_path: Path, name: str, protocol: int
) -> None:
    made = tmp_path / "made"
    body = dump_pickle({"0": {"action": CALLS[name](made)}}, protocol)
    assert refusal(body)
    assert not made.exists()


@pytest.mark.parametrize("protocol", PROTOCOLS)
def test_objects_that_are_not_plain_are_refused(protocol: int) -> None:
    unsupported_values: list[Any] = [
        object(),
        {1, 2},
        frozenset((1,)),
        1j,
        b"bytes",
        Path(),
    ]
    unsupported_values += [
        bytearray(b"x"),
        np.dtype("f8"),
        np.ndarray,
        len,
        range(3),
        slice(1),
    ]
    unsupported_values += [np.array([{}, 1]), np.array(["text"]), np.zeros(2, "M8[s]")]
    unsupported_values += [
        np.zeros(2, [("a", "f8")]),
        np.zeros(2, "c16"),
        np.str_("text"),
    ]
    unsupported_values += [
        2**64,
        -(2**70),
        {(1, 2): 3},
        {None: 1},
        {1.5: 2},
        {2**40: 1},
    ]
    for unsupported in unsupported_values:
        assert refusal(dump_pickle([unsupported], protocol)), unsupported


def test_the_malicious_pickles_work_with_pickle(tmp_path: Path) -> None:
    """Python's own reader falls into them."""
    made = tmp_path / "made"
    for name in ("os.system", "subprocess", "mkdir"):
        done = load_pickle(dump_pickle(CALLS[name](made)))
        if isinstance(done, subprocess.Popen):
            done.wait()
        assert made.exists(), name
        made.rmdir() if made.is_dir() else made.unlink()


# Opcode by opcode; N.B. that every one of them is no pickle of any client.
PROGRAMS: dict[str, bytes] = {
    "empty": b"",
    "no end": b"\x80\x04]",
    "nothing": b".",
    "two values": b"NN.",
    "a mark left": b"(N.",
    "a mark too few": b"t.",
    "pop nothing": b"\x85.",
    "append to a dict": b"}Na.",
    "append to a tuple": b")Na.",
    "append to a number": b"K\x01Na.",
    "set in a list": b"]NNs.",
    "odd items": b"(Nd.",
    "a list as a key": b"}]Ns.",
    "a tuple as a key": b"})Ns.",
    "a dict in itself": b"}q\x00X\x01\x00\x00\x00ah\x00s.",
    "a list in itself": b"]q\x00h\x00a.",
    "a tuple of itself": b"]q\x00h\x00\x85a.",
    "memo of nothing": b"h\x07.",
    "memo far away": b"Np999999999\ng99999999\n.",
    "a global": b"cos\nsystem\n.",
    "a global alone": b"cnumpy\nndarray\n.",
    "dotted": b"\x80\x04\x8c\x05numpy\x8c\x0fndarray.tofile\x93.",
    "a name that is a list": b"\x80\x04]\x8c\x05dtype\x93.",
    "a module that is a number": b"\x80\x04K\x01\x8c\x05dtype\x93.",
    "inst": b"(S'touch /tmp/x'\nios\nsystem\n.",
    "obj": b"(cos\nsystem\nS'x'\no.",
    "newobj": b"\x80\x02cnumpy\nndarray\n)\x81.",
    "newobj_ex": b"\x80\x04cnumpy\nndarray\n)}\x92.",
    "extension": b"\x82\x01.",
    "persistent": b"Pname\n.",
    "persistent of the stack": b"NQ.",
    "out of band": b"\x80\x05\x97.",
    "call a number": b"K\x01)R.",
    "call an array": b"cnumpy\nndarray\n)R.",
    "call with a list": b"cnumpy\ndtype\n]R.",
    "call with too little": b"cnumpy\ndtype\n)R.",
    "state of a dict": b"}}b.",
    "state of a list": b"])b.",
    "another codec": b"c_codecs\nencode\n(VX\nVbz2\ntR.",
    "an encoding of nothing": b"c_codecs\nencode\n(NVlatin1\ntR.",
    "beyond latin": b"c_codecs\nencode\n(V\\u0100\nVlatin1\ntR.",
    "no text": b"X\x03\x00\x00\x00\xff\xfe\xfd.",
    "a lone surrogate": b"X\x03\x00\x00\x00\xed\xa0\x80.",
    "a surrogate in a name": b"\x80\x04\x8c\x03\xed\xa0\x80\x8c\x05dtype\x93.",
    "too long a text": b"X\xff\xff\xff\x7fx.",
    "too long bytes": b"\x8e\xff\xff\xff\xff\xff\xff\xff\x7fx.",
    "a number that is none": b"Ix\n.",
    "too long a number": b"L" + b"9" * 5000 + b"L\n.",
    "a huge number": b"\x8b\x00\x01\x00\x00" + b"\x7f" * 256 + b".",
    "an unknown opcode": b"\xff.",
    "a duplicate": b"N2.",
    "a pop": b"NN0.",
}


@pytest.mark.parametrize("name", sorted(PROGRAMS))
def test_a_program_is_refused(name: str) -> None:
    assert refusal(PROGRAMS[name])


DTYPE = b"cnumpy\ndtype\n(Vf8\nI00\nI01\ntR(I3\nV<\nNNNI-1\nI-1\nI0\ntb"
ARRAY = b"cnumpy._core.multiarray\n_reconstruct\n(cnumpy\nndarray\n(I0\ntC\x01btR"


def filled(shape: bytes = b"(I1\nt", dtype: bytes = DTYPE, more: bytes = b"") -> bytes:
    return (
        ARRAY
        + b"(I1\n"
        + shape
        + dtype
        + b"I00\nC\x08\x00\x00\x00\x00\x00\x00\xf0?tb"
        + more
    )


def test_the_pattern_of_an_array_is_read() -> None:
    assert read(filled() + b".").tolist() == [1.0]


@pytest.mark.parametrize(
    "body",
    [
        ARRAY,
        filled(b"(I2\nt"),
        filled(b"(I-1\nt"),
        filled(b"(I01\nt"),
        filled(b"(F1\nt"),
        filled(b"]"),
        filled(b"(" + b"I1\n" * 9 + b"t"),
        filled(b"(I0\nI99999999999\nt"),
        filled(more=b"(I1\n(I1\nt" + DTYPE + b"I00\nC\x01xtb"),
        filled(more=b")b"),
        filled(dtype=b"Vf8\n"),
        filled(dtype=DTYPE.replace(b"Vf8", b"VO")),
        filled(dtype=DTYPE.replace(b"Vf8", b"Vf8,f8")),
        filled(dtype=DTYPE.replace(b"V<", b"V?")),
        filled(dtype=DTYPE.replace(b"I3", b"I4")),
        filled(dtype=DTYPE.replace(b"NNN", b"N}N")),
        filled(dtype=DTYPE.replace(b"I0\ntb", b"I1\ntb")),
        filled(dtype=DTYPE.replace(b"I0\ntb", b"tb")),
        filled(dtype=DTYPE.replace(b"I00", b"I7")),
        filled(dtype=DTYPE + b"(I3\nV<\nNNNI-1\nI-1\nI0\ntb"),
        filled(dtype=DTYPE.partition(b"(I3")[0]),
        filled().replace(b"(I0\nt", b"(I5\nt"),
        filled().replace(b"cnumpy\nndarray\n(", b"cnumpy\ndtype\n("),
    ],
    ids=itertools.count(),
)
def test_an_array_in_another_pattern_is_refused(body: bytes) -> None:
    assert refusal(body + b".")


# --- bombs ---


def nested(levels: int, width: int) -> Any:
    """A list of lists, each `width` times the one before: small, and huge inside."""
    inside: list[Any] = []
    for _ in range(levels):
        inside = [inside] * width
    return inside


MEGABYTE = b"\x00\x00\x10\x00" + b"\x01" * 2**20  # its length, and as many bytes
LATIN = b"c_codecs\nencode\nq\x00X" + MEGABYTE + b"q\x01Vlatin1\nq\x02\x86q\x03"
BUFFER = b"cnumpy._core.numeric\n_frombuffer\nq\x00B" + MEGABYTE + b"q\x01"
BUFFER += DTYPE.replace(b"V<", b"V>") + b"q\x02](I131072\n\x85q\x03"
COLLIDING = b"".join(b"p%d\n" % (k * (2**61 - 1)) for k in range(20_000))
# name → (the pickle, what the refusal says)
BOMBS: dict[str, tuple[bytes, str]] = {
    "lists of lists": (dump_pickle(nested(10, 50)), "values"),
    "one array often": (dump_pickle([np.zeros(1000)] * (VALUES_MAX // 999)), "values"),
    "lists in lists": (b"]" * 1000 + b"a" * 999 + b".", "deep"),
    "tuples in tuples": (b")" + b"\x85" * 200_000 + b".", "deep"),
    "a deep name": (b"\x80\x04)" + b"\x85" * 200_000 + b"\x8c\x05dtype\x93.", "name"),
    "opcodes": (b"(" + b"N" * (OPCODES_MAX + 1) + b"l.", "opcodes"),
    "marks": (b"(" * (OPCODES_MAX + 1) + b".", "opcodes"),
    "empty arrays": (dump_pickle([[np.zeros(0)] * 2000] * 2000), "values"),
    "one text often": (b"](X" + MEGABYTE + b"q\x00" + b"h\x00" * 99 + b"e.", "text"),
    "one buffer": (BUFFER + b"h\x00(h\x01h\x02h\x03VC\ntR" * 99 + b"e.", "expands"),
    "a shape": (filled(b"(\x8b" + MEGABYTE + b"q\x00h\x00h\x00t") + b".", "shape"),
    "a memo": (b"N" + COLLIDING + b".", "memo index"),
    "bytes of one text": (LATIN + b"](" + b"h\x00h\x03R" * 1000 + b"e.", "expands"),
}


def test_a_short_pickle_stands_for_few_values() -> None:
    """Shared parts count as often as they are named; bytes sent permit more."""
    shared = [[0.5] * 8] * 4_100
    body = dump_pickle(shared, 4)
    assert f"more than {VALUES_OF_ANY + VALUES_PER_BYTE * 184} values" in refusal(
        dump_pickle(nested(5, 16), 4).ljust(184, b"\0")
    )
    assert len(body) < VALUES_OF_ANY
    assert read(body) == shared


@pytest.mark.parametrize("name", sorted(BOMBS))
def test_a_bomb_is_refused_before_it_bursts(name: str) -> None:
    body, about = BOMBS[name]
    started = time.process_time()
    assert about in refusal(body)
    assert time.process_time() - started < 5


def test_depth_is_bounded_at_depth_max() -> None:
    inside: Any = 1
    for _ in range(DEPTH_MAX):
        inside = [inside]
    assert read(dump_pickle(inside)) == inside
    assert "deeply" in refusal(dump_pickle([inside]))


# --- anything at all ---

SEEDS = [
    dump_pickle({"0": {"action": np.arange(16.0), "is_rel": False}}, protocol)
    for protocol in PROTOCOLS
] + [dump_pickle({"worker_ids": ["0", "1"]}), filled() + b".", *PROGRAMS.values()]


@st.composite
def damaged(draw: st.DrawFn) -> bytes:
    """A pickle with some bytes replaced, cut out, or put in."""
    body = bytearray(draw(st.sampled_from(SEEDS)))
    for _ in range(draw(st.integers(1, 6))):
        at = draw(st.integers(0, len(body)))
        till = min(len(body), at + draw(st.integers(0, 3)))
        body[at:till] = draw(st.binary(max_size=3))
    return bytes(body)


def outcome(body: bytes) -> bool:
    """Whether it was read; anything but a value or BadPickle fails the test."""
    try:
        read(body)
    except BadPickle:
        return False
    return True


@settings(max_examples=600)
@given(damaged())
def test_damaged_pickles_are_read_or_refused(body: bytes) -> None:
    assert outcome(body) in (True, False)


@settings(max_examples=150)
@given(st.binary(max_size=200))
def test_noise_is_read_or_refused(body: bytes) -> None:
    assert outcome(body) in (True, False)
