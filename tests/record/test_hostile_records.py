"""Records whose author is hostile and signs: refused by name, or read; nothing else.

A corrupted file is signed after the change, so that no digest protects its reader.
"""

import base64
import json
import random
import time
from pathlib import Path
from typing import Any

import pytest

from reference_record.broken import BrokenRecord
from reference_record.formats.envelope import sign_envelope
from reference_record.formats.names import EPISODES, MANIFEST, STATEMENT
from reference_record.formats.strict_json import read_json
from reference_record.verification import verify
from tests.support.record.broken_records import pack
from tests.support.record.hostile_records import resigned
from tests.support.record.sample_records import (
    HOST_KEY,
    Sample,
    contents_of,
    make_archive,
    open_archive,
)

ODD_VALUES: tuple[Any, ...] = (
    *(None, True, -1, 0, 2**53, 2**64, 1.5, 1e308, "", "x" * 2000, [], {}, [[]]),
    *({"a": 1}, "\x1b[31m", "../../x", [None]),
)


def is_refused_or_read(archive: bytes, folder: Path) -> bool:
    try:
        verify(open_archive(archive, folder))
    except BrokenRecord:
        return True
    return False


def corrupt(data: bytes, chance: random.Random) -> bytes:
    changed = bytearray(data)
    for _ in range(chance.randint(1, 3)):
        at = chance.randrange(len(changed))
        match chance.randrange(3):
            case 0:
                changed[at] = chance.randrange(256)
            case 1:
                changed[at : at + 8] = b"\xff" * 8
            case 2:
                del changed[at : at + chance.randint(1, 20)]
    return bytes(changed)


@pytest.mark.parametrize("seed", range(3))
def test_signed_corruptions_of_a_recording(seed: int, tmp_path: Path) -> None:
    chance = random.Random(seed)

    def change(index: int, data: bytes) -> bytes:
        return data if index else corrupt(data, chance)

    refused = 0
    for _ in range(40):
        archive = make_archive(Sample(change_recording=change))
        refused += is_refused_or_read(archive, tmp_path)
    assert refused > 12  # what is left changed an index that is not read


def paths_in(value: Any, before: tuple[Any, ...] = ()) -> list[tuple[Any, ...]]:
    """Where each value stands, the root left out."""
    items: list[tuple[Any, Any]] = []
    if isinstance(value, dict):
        items = list(value.items())
    elif isinstance(value, list):
        items = list(enumerate(value))
    found = []
    for key, inside in items:
        found += [(*before, key), *paths_in(inside, (*before, key))]
    return found


def with_value(text: bytes, path: tuple[Any, ...], odd: Any) -> bytes:
    root = json.loads(text)
    inside = root
    for key in path[:-1]:
        inside = inside[key]
    inside[path[-1]] = odd
    return json.dumps(root).encode()


def test_odd_values_in_a_signed_statement(tmp_path: Path) -> None:
    contents = contents_of(make_archive())
    payload = base64.b64decode(json.loads(contents[STATEMENT])["payload"])
    chance = random.Random(1)
    for path in paths_in(json.loads(payload)):
        changed = with_value(payload, path, chance.choice(ODD_VALUES))
        archive = pack(contents | {STATEMENT: sign_envelope(changed, HOST_KEY)})
        is_refused_or_read(archive, tmp_path)


@pytest.mark.parametrize("name", [MANIFEST, EPISODES])
def test_odd_values_in_a_signed_file(name: str, tmp_path: Path) -> None:
    """The statement has the digest of the changed file."""
    contents = contents_of(make_archive())
    first, _, rest = contents[name].partition(b"\n")
    chance = random.Random(2)
    for path in paths_in(json.loads(first)):
        changed = with_value(first, path, chance.choice(ODD_VALUES))
        data = changed + contents[name][len(first) : len(first) + 1] + rest
        is_refused_or_read(resigned(contents, name, data), tmp_path)


def test_many_members_of_which_the_last_stand_twice() -> None:
    members = [f'"{number}":0' for number in range(40_000)]
    text = "{" + ",".join([*members, members[-1]]) + "}"
    started = time.process_time()
    with pytest.raises(BrokenRecord, match="stands twice"):
        read_json(MANIFEST, text.encode(), dict)
    assert time.process_time() - started < 2  # tens of seconds if each is searched


@pytest.mark.parametrize("text", [b"[" * 100_000, b'{"a":' * 100_000, b"\xff", b""])
def test_texts_that_are_no_json(text: bytes, tmp_path: Path) -> None:
    contents = contents_of(make_archive())
    assert is_refused_or_read(resigned(contents, MANIFEST, text), tmp_path)
    assert is_refused_or_read(resigned(contents, EPISODES, text + b"\n"), tmp_path)
    changed = sign_envelope(text, HOST_KEY) if text else b""
    assert is_refused_or_read(pack(contents | {STATEMENT: changed}), tmp_path)
