"""Mapping files that are wrong: each is refused before anything is called.

A refusal names the file, the place in it and what is right there; no words of Python.
"""

import tomllib
from pathlib import Path

import numpy as np
import pytest

from reference_client import Observation
from reference_client.policies import BadMapping, PolicyMapping
from reference_client.policies.error_origin import (
    describe_policy_error,
    errors_of_policy,
)
from tests.support.client.direct_client import DirectClient

COLUMNS = (
    'is "first:last", such as "0:7", the first below the last, or a list of whole '
    "numbers from 0; not "
)
SIZE = "is [height, width], two whole numbers above 0, each at most 8192; not "
FACTOR = "is a finite number, or a list with one for each column; not "
BOUNDS = "is [low, high], two numbers, the first below the second; not "
FLAG = "is true or false; not "
SOURCE = (
    "is state.NAME or a list of such, images.NAME, tensors.NAME, instruction, "
    "episode_id, step, first_step, attempt_id; not "
)
NO_DTYPE = "; float32, float16, int64 and uint8 are some that it has"
# How the refusal of entries goes on after their place, and the entries.
WRONG_KEYS_OF_A_REQUEST = {
    " is missing or not a table": ["1", "[]"],
    " needs either `from` or `value`": [
        "{}",
        "{ from = [] }",
        "{ take = [1] }",
        "{ from = 'step', value = 1 }",
    ],
    f": from {SOURCE}": ["{ from = 1 }", "{ from = 'x.y' }", "{ from = [1] }"],
    ": only states can be joined": ["{ from = ['step', 'step'] }"],
    ": unknown key a; there is dtype, ": ["{ a = 1 }"],
    ": unknown key tak; did you mean take": ["{ from = 'state.a', tak = [1] }"],
    f": take {COLUMNS}": [
        f"{{ from = 'state.a', take = {take} }}"
        for take in ("7", "'7'", "'-1:'", "'3:3'", "'8:7'", "[]", "[-1]", "[true]")
    ],
    f": scale {FACTOR}": [
        f"{{ from = 'state.a', scale = {scale} }}"
        for scale in ("nan", "inf", "[1, -inf]", "[[1]]", "'1'", "true")
    ],
    f": offset {FACTOR}": ["{ from = 'state.a', offset = nan }"],
    ": scale of step is one finite number": ["{ from = 'step', scale = [1] }"],
    f": resize {SIZE}": [
        f"{{ from = 'images.a', resize = {size} }}"
        for size in ("[64]", "[0, 64]", "['64', 64]", "[9, 2.5]", "[9, 9999]", "64")
    ],
    f": pad {FLAG}": ["{ from = 'images.a', pad = 1 }"],
    f": unit {FLAG}": ["{ from = 'images.a', unit = 'true' }"],
    ': layout is "hwc" or "chw"; not ': ["{ from = 'images.a', layout = 'bgr' }"],
    ": leading is a whole number from 0 to 8; not ": [
        f"{{ from = 'state.a', leading = {count} }}"
        for count in ("-1", "true", "1.0", "9")
    ],
    ": unit makes numbers from 0 to 1, of which dtype uint8 leaves": [
        "{ from = 'images.a', unit = true, dtype = 'uint8' }"
    ],
    ": dtype is a text; not ": ["{ from = 'state.a', dtype = 1 }"],
    f": numpy has no numbers of dtype object{NO_DTYPE}": [
        "{ from = 'state.a', dtype = 'object' }"
    ],
    f": numpy has no numbers of dtype bfloat16{NO_DTYPE}": [
        "{ from = 'state.a', dtype = 'bfloat16' }"
    ],
    f": numpy has no numbers of dtype (2{NO_DTYPE}": [
        "{ from = 'state.a', dtype = '(2' }"
    ],
    ': encode is "json", "json-numpy", "jpeg" or "png"; not ': [
        "{ from = 'images.a', encode = 'gif' }"
    ],
    ": encode png is for images alone, as uint8": [
        "{ from = 'state.a', encode = 'png' }",
        "{ from = 'images.a', encode = 'png', unit = true }",
        "{ from = 'images.a', encode = 'png', dtype = 'float32' }",
    ],
    ": scale is not for an entry from images.a, which may have dtype, encode, la": [
        "{ from = 'images.a', scale = 2 }"
    ],
    ": resize is not for an entry from state.a, which may have": [
        "{ from = 'state.a', resize = [9, 9] }"
    ],
    ": dtype is not for an entry with `value`, which may have encode": [
        "{ value = 1, dtype = 'int8' }"
    ],
}
WRONG_VECTORS = {
    " is missing or not a table": ["1"],
    ": from is a place in the answer as text, or a list of places; not ": [
        "{ from = 1 }"
    ],
    f": columns {COLUMNS}": [
        f"{{ columns = {columns} }}" for columns in ("7", "'8:7'", "[0, -1]")
    ],
    ": threshold is a finite number; not ": [
        "{ threshold = '0.5' }",
        "{ threshold = [1] }",
        "{ threshold = nan }",
    ],
    f": scale {FACTOR}": ["{ scale = nan }"],
    f": offset {FACTOR}": ["{ offset = [0, inf] }"],
    f": cumulate {FLAG}": ["{ cumulate = 1 }"],
    ": relative_to is state.NAME; not ": [
        "{ relative_to = 'images.a' }",
        "{ relative_to = 1 }",
    ],
    f": clip {BOUNDS}": ["{ clip = [1, 0] }", "{ clip = [nan, 1] }", "{ clip = 1 }"],
    f": value {FACTOR}": ["{ value = 'a' }"],
    ": scale is not for an entry with `value`": ["{ value = 1, scale = 2 }"],
}
WRONG_TABLES = {
    "action: execute is a whole number above 0; not ": [
        f"action = {{ execute = {count}, values.a = {{}} }}"
        for count in ("0", "-3", "2.5", "'8'", "true")
    ],
    "action: leading is a whole number from 0 to 8; not ": [
        "action = { leading = -1, values.a = {} }"
    ],
    "action: from is a place in the answer, as text; not ": [
        "action = { from = 1, values.a = {} }"
    ],
    "action: values is a table; not ": ["action = { values = 1 }"],
    "action is missing": ["observation.k.value = 1"],
    "observation is missing": ["action.values.a = {}"],
    "reset is missing or not a table": ["reset = {}"],
    "assumes is a table; not ": ["assumes = 1"],
    "server is a table; not ": ["server = [1]"],
    'observation.k.value is "2026-11-30", which no member takes': [
        "observation.k.value = 2026-11-30"
    ],
    "observation.k.value.0.a is NaN, which no": ["observation.k.value = [{ a = nan }]"],
    "server.answer_s is NaN, which no member takes": ["server.answer_s = nan"],
    "unknown key x; there is action, assumes, observation": ["x = 1"],
    "it is not valid TOML": ["["],
}
WHOLE = {"observation": "observation.k.value = 1", "action": "action.values.a = {}"}


def wrong_files() -> list[tuple[str, str]]:
    """Each text of a file, and how its refusal goes on after the file's name."""
    entries = [
        (f"observation.k = {entry}\n{WHOLE['action']}", f'observation."k"{fault}')
        for fault, entries in WRONG_KEYS_OF_A_REQUEST.items()
        for entry in entries
    ]
    vectors = [
        (f"{WHOLE['observation']}\naction.values.k = {it}", f'action.values."k"{fault}')
        for fault, vectors in WRONG_VECTORS.items()
        for it in vectors
    ]
    tables = [
        ("\n".join([text, *_rest(text, fault)]), fault)
        for fault, texts in WRONG_TABLES.items()
        for text in texts
    ]
    return [*entries, *vectors, *tables]


def _rest(text: str, fault: str) -> list[str]:
    """The tables that the text does not have, unless one of them is to be missing."""
    if fault.endswith("is missing"):
        return []
    return [whole for table, whole in WHOLE.items() if not text.startswith(table)]


@pytest.mark.parametrize(("text", "fault"), wrong_files())
def test_a_wrong_file_is_refused_by_its_name_the_place_and_the_member(
    tmp_path: Path, text: str, fault: str
) -> None:
    file = tmp_path / "m.toml"
    file.write_text(text)
    with pytest.raises(BadMapping) as caught:
        PolicyMapping.read(file)
    assert str(caught.value).startswith(f"{file}: {fault}")


def test_the_value_that_is_refused_is_shown_as_the_file_has_it(tmp_path: Path) -> None:
    file = tmp_path / "m.toml"
    entry = '{ from = "images.a", resize = ["64", 64] }'
    file.write_text(f'observation."a" = {entry}\naction.values.a = {{}}')
    with pytest.raises(BadMapping) as caught:
        PolicyMapping.read(file)
    assert str(caught.value) == f'{file}: observation."a": resize {SIZE}["64", 64]'


KEY = "k = { value = 1 }"
ARM = "joint_position = { columns = '0:7' }"
GRIPPER = "gripper = { columns = '7:8' }"


@pytest.mark.parametrize(
    ("entry", "fault"),
    [
        ("from = 'state.no'", " is from state.no; tabletop has images.front, "),
        (
            "from = ['state.gripper', 'state.gripper'], take = '0:3'",
            ': take is "0:3"; it chooses from 2 numbers',
        ),
        (
            "from = 'state.joint_position', take = [7]",
            ": take is [7]; it chooses from 7 numbers",
        ),
        (
            "from = 'state.joint_position', scale = [1, 2]",
            ": scale has 2 numbers, for 7 numbers",
        ),
        (
            "from = 'state.joint_position', take = '0:2', offset = [1]",
            ": offset has 1 number, for 2 numbers",
        ),
    ],
)
def test_a_request_for_another_benchmark_is_refused(
    direct: DirectClient, entry: str, fault: str
) -> None:
    refusal = refusal_of(direct, f"k = {{ {entry} }}", ARM, GRIPPER)
    assert refusal.startswith(f'm.toml: observation."k"{fault}')


@pytest.mark.parametrize(
    ("vector", "fault"),
    [
        ("columns = '7:9'", ": columns makes 2 numbers, and gripper of tabletop has 1"),
        ("columns = '7:8', scale = [1, 2]", ": scale has 2 numbers, for 1 number"),
        ("scale = [1, 2]", ": scale makes 2 numbers, and gripper of tabletop has 1"),
        ("offset = [1, 2]", ": offset makes 2 numbers, and gripper of tabletop has 1"),
        ("value = [1, 2]", ": value makes 2 numbers, and gripper of tabletop has 1"),
        (
            "relative_to = 'state.joint_position'",
            ": relative_to is state.joint_position, of 7 numbers, for 1",
        ),
        ("relative_to = 'state.no'", " is from state.no; tabletop has images.front, "),
    ],
)
def test_a_vector_for_another_benchmark_is_refused(
    direct: DirectClient, vector: str, fault: str
) -> None:
    """Expect the entry, before anything is called: the policy is not the cause."""
    refusal = refusal_of(direct, KEY, ARM, f"gripper = {{ {vector} }}")
    assert refusal.startswith(f'm.toml: action.values."gripper"{fault}')


def test_vectors_of_other_names_are_refused(direct: DirectClient) -> None:
    refusal = refusal_of(direct, KEY, ARM, "grip = {}")
    names = "grip, joint_position; an action of tabletop has gripper, joint_position"
    assert refusal == f"m.toml: action.values has {names}"


def refusal_of(direct: DirectClient, entry: str, *vectors: str) -> str:
    """The refusal of a mapping for the benchmark `tabletop`."""
    text = "\n".join(["[observation]", entry, "[action.values]", *vectors])
    mapping = PolicyMapping.of(tomllib.loads(text), "m.toml")
    with pytest.raises(BadMapping) as caught:
        mapping.check(direct.control.get_benchmark("tabletop"))
    return str(caught.value)


def test_pictures_of_other_channels_are_refused(direct: DirectClient) -> None:
    benchmark = direct.control.get_benchmark("tabletop")
    benchmark.observation_space.images["front"].channels = 4
    entry = '{ from = "images.front", encode = "jpeg" }'
    values = "joint_position = {}\ngripper = {}"
    text = f"observation.k = {entry}\n[action.values]\n{values}"
    with pytest.raises(BadMapping, match="encode jpeg is for 1 or 3 channels; the"):
        PolicyMapping.of(tomllib.loads(text)).check(benchmark)


@pytest.mark.parametrize("entry", ["take = '0:9'", "scale = [1, 2]"])
def test_a_width_is_checked_where_no_benchmark_was(entry: str) -> None:
    """As in `serve-policy`, which is given the benchmark by its caller."""
    text = f"observation.k = {{ from = 'state.a', {entry} }}\naction.values.a = {{}}"
    mapping = PolicyMapping.of(tomllib.loads(text), "m.toml")
    seen = Observation({"a": np.zeros(3)}, {}, {}, "Lift.", "e1", 0)
    with pytest.raises(BadMapping) as caught, errors_of_policy():
        mapping.request(seen)
    assert describe_policy_error(caught.value).startswith('m.toml: observation."k": ')
