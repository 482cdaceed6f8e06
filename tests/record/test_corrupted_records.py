"""No changed record passes: every byte flipped, cut everywhere, corrupted at random.

The archive is the good vector with a verdict. The long forms are left to a release.
"""

import random
from pathlib import Path

import pytest

from reference_record.broken import BrokenRecord
from reference_record.formats.archive import read_entries
from reference_record.formats.bundle import open_bundle
from reference_record.verification import verify
from tests.support.paths import ROOT

GOOD = ROOT / "spec" / "vectors" / "record" / "good_replayed.proctor"
ARCHIVE = GOOD.read_bytes()
CORRUPTIONS = 1000
SAID_OF_A_CUT = ("end", "cut", "empty", "no zip", "directory")


def refused(archive: bytes, path: Path) -> BrokenRecord:
    path.write_bytes(archive)
    with pytest.raises(BrokenRecord) as broken:
        verify(open_bundle(path))
    return broken.value


def owner_of(position: int) -> str:
    """The file whose content has the byte; the archive for headers."""
    with GOOD.open("rb") as file:
        for entry in read_entries(file, len(ARCHIVE)):
            if 0 <= position - entry.data_offset < entry.size:
                return entry.name
    return "archive"


EACH = pytest.mark.release("every byte of a record flipped or cut; each 89th is")
EACH_OR_SOME = pytest.mark.parametrize("step", [89, pytest.param(1, marks=EACH)])


@EACH_OR_SOME
def test_a_flipped_byte_is_named(step: int, tmp_path: Path) -> None:
    path = tmp_path / "run.proctor"
    for position in range(0, len(ARCHIVE), step):
        changed = bytearray(ARCHIVE)
        changed[position] ^= 1 << (position % 8)
        broken = refused(bytes(changed), path)
        owner = owner_of(position)
        assert owner in (broken.file, "archive"), f"byte {position}: {broken}"


@EACH_OR_SOME
def test_a_cut_record_is_refused(step: int, tmp_path: Path) -> None:
    path = tmp_path / "run.proctor"
    for length in range(0, len(ARCHIVE), step):
        broken = refused(ARCHIVE[:length], path)
        assert broken.rule == "REC-002"
        assert any(word in broken.detail for word in SAID_OF_A_CUT), length


def corrupt(chance: random.Random) -> bytes:
    """One to four changes: bytes overwritten, taken out, put in, moved, repeated."""
    data = bytearray(ARCHIVE)
    for _ in range(chance.randint(1, 4)):
        at = chance.randrange(len(data))
        length = chance.choice((1, 2, 8, 100, 3000))
        piece = data[at : at + length]
        match chance.randrange(5):
            case 0:
                data[at : at + length] = chance.randbytes(len(piece))
            case 1:
                del data[at : at + length]
            case 2:
                data[at:at] = chance.randbytes(length)
            case 3:
                del data[at : at + length]
                to = chance.randrange(len(data) or 1)
                data[to:to] = piece
            case 4:
                data[at:at] = piece
    return bytes(data)


@pytest.mark.parametrize("seed", range(4))
def test_no_corruption_passes(seed: int, tmp_path: Path) -> None:
    chance = random.Random(seed)
    done = 0
    while done < CORRUPTIONS // 4:
        corrupted = corrupt(chance)
        if corrupted != ARCHIVE:
            refused(corrupted, tmp_path / "run.proctor")
            done += 1
