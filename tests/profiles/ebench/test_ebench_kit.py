"""The kit on our server with the profile `ebench`, and the kit's own pickles."""

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
from tests.support.paths import ROOT
from tests.support.profiles.ebench_client import (
    MaliciousObject,
    dump_pickle,
    load_pickle,
)

pytestmark = pytest.mark.slow("starts servers and kits")

SERVER_COMMAND = f"{sys.executable} -m reference_server --profiles ebench"


def test_the_reference_server_passes_the_ebench_rules(tmp_path: Path) -> None:
    kit = [
        sys.executable,
        "-m",
        "conformance",
        "--start-cmd",
        SERVER_COMMAND,
        "--only",
        "EBE",
    ]
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
        row.id: "passed" if row.is_observable else "not_verified"
        for row in load_ledger().values()
        if row.profile == "ebench"
    }


PLAIN = {"0": {"action": [1, -1.5, 2**40, None, True, "ü"], "nested": [[], {}]}}


def test_plain_pickles_of_the_kit_are_read_by_every_reader() -> None:
    body = pickles.write(PLAIN)
    assert load_pickle(body) == pickle_reader.read(body) == pickles.read(body) == PLAIN


def test_the_kit_s_arrays_are_numpy_s() -> None:
    numbers = [0.1, -0.0, 5e-324]
    array = load_pickle(pickles.write(pickles.PickledArray(numbers)))
    assert array.dtype == np.float64
    assert array.tobytes() == np.array(numbers).tobytes()
    for core in ("core", "_core"):
        found = pickle_reader.read(pickles.write(pickles.PickledArray(numbers, core)))
        assert found.tobytes() == array.tobytes()


def test_the_kit_s_calls_are_calls() -> None:
    body = pickles.write([pickles.PickledCall("builtins", "len", [[1, 2]])])
    assert load_pickle(body) == [2]


@pytest.mark.parametrize(
    "unsupported", [MaliciousObject(len, [1]), np.zeros(1), {1, 2j}, object()]
)
def test_the_kit_refuses_pickles_that_name_globals(unsupported: Any) -> None:
    with pytest.raises(pickles.GlobalInPickle):
        pickles.read(dump_pickle([unsupported]))


@pytest.mark.parametrize("body", [b"", b"]", b"\xff", b"h\x00.", b"<html>"])
def test_invalid_pickles_are_an_error(body: bytes) -> None:
    with pytest.raises(ValueError, match="no pickle"):
        pickles.read(body)
