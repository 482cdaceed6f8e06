"""The kit on our own server with EBench's door open, and the kit's own pickles."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from conformance.profiles import pickles
from conformance.specification.ledger import load_ledger
from reference_server.profiles.ebench import pickle_reader
from tests.ebench_client import Trap, pickled, unpickled

ROOT = Path(__file__).resolve().parent.parent
HOUSE = f"{sys.executable} -m reference_server --profiles ebench"


def test_our_own_door_obeys_its_rules(tmp_path: Path) -> None:
    kit = [sys.executable, "-m", "conformance", "--start-cmd", HOUSE, "--only", "EBE"]
    done = subprocess.run(
        [*kit, "--report", str(tmp_path)],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stdout[-3000:]
    rows = json.loads((tmp_path / "report.json").read_text())["rows"]
    outcomes = {row["requirement_id"]: row["outcome"] for row in rows}
    assert outcomes == {
        row.id: "passed" for row in load_ledger().values() if row.profile == "ebench"
    }


PLAIN = {"0": {"action": [1, -1.5, 2**40, None, True, "ü"], "nested": [[], {}]}}


def test_the_kit_s_plain_pickles_are_read_by_everybody() -> None:
    body = pickles.write(PLAIN)
    assert unpickled(body) == pickle_reader.read(body) == pickles.read(body) == PLAIN


def test_the_kit_s_arrays_are_numpy_s() -> None:
    numbers = [0.1, -0.0, 5e-324]
    array = unpickled(pickles.write(pickles.PickledArray(numbers)))
    assert array.dtype == np.float64
    assert array.tobytes() == np.array(numbers).tobytes()
    for core in ("core", "_core"):
        found = pickle_reader.read(pickles.write(pickles.PickledArray(numbers, core)))
        assert found.tobytes() == array.tobytes()


def test_the_kit_s_calls_are_calls() -> None:
    body = pickles.write([pickles.PickledCall("builtins", "len", [[1, 2]])])
    assert unpickled(body) == [2]


@pytest.mark.parametrize("stranger", [Trap(len, [1]), np.zeros(1), {1, 2j}, object()])
def test_the_kit_reads_no_pickle_that_names_anything(stranger: Any) -> None:
    with pytest.raises(pickles.GlobalInPickle):
        pickles.read(pickled([stranger]))


@pytest.mark.parametrize("body", [b"", b"]", b"\xff", b"h\x00.", b"<html>"])
def test_what_is_no_pickle_is_said_to_be_none(body: bytes) -> None:
    with pytest.raises(ValueError, match="no pickle"):
        pickles.read(body)
