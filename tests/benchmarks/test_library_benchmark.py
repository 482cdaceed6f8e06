"""The libraries' comparison in small: what is in our own environment.

A library that is not installed here is judged when all are measured: their environment
is one that `make test` does not make.
"""

from __future__ import annotations

import dataclasses
import re
import sys
from itertools import groupby
from pathlib import Path

import msgspec
import pytest

from benchmarks.libraries import compared_libraries, samples
from benchmarks.libraries.timed_pieces import Piece, WrongResult, rows
from benchmarks.measuring import ROOT
from benchmarks.round_trips.interleaved_rounds import (
    Contender,
    ContenderFailed,
    started,
)

pytestmark = pytest.mark.slow("starts servers")


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A request and its answer, of a reference server."""
    made = tmp_path_factory.mktemp("samples")
    samples.capture(made)
    return made


def versions_in(lock: str) -> dict[str, str]:
    text = (ROOT / "requirements" / lock).read_text()
    return dict(re.findall(r"^([a-z0-9-]+)==(\S+)", text, re.MULTILINE))


def test_libraries_are_measured_in_the_locked_versions() -> None:
    bench, dev = versions_in("bench.txt"), versions_in("dev.txt")
    ours = {"httptools", "msgspec", "simplejpeg", "uvicorn", "uvloop"}
    assert {name: bench[name] for name in ours} == {name: dev[name] for name in ours}


def test_a_sample_is_a_request_and_its_answer(folder: Path) -> None:
    sample = samples.read(folder, samples.STATE)
    assert sample.path.endswith("/workers/w/predict")
    turn = sample.turn()
    assert (turn["seq"], turn["executed_steps"]) == (1, 1)
    assert sum(map(len, turn["observation"]["state"].values())) == 23
    images = samples.read(folder, samples.CAMERAS).turn()["observation"]["images"]
    assert {len(image["data"]) for image in images.values()} == {640 * 480 * 3}


def test_libraries_work_in_turn_and_a_wrong_result_is_not_measured() -> None:
    worked: list[str] = []
    libraries = {"a": lambda _: worked.append("a"), "b": lambda _: worked.append("b")}
    piece = Piece("piece", libraries, None, lambda made: made, None)
    assert [row[:2] for row in rows(piece, 2)] == [["piece", "a"], ["piece", "b"]]
    # Checked, tried out; then a and b, then b and a.
    assert [name for name, _ in groupby(worked)] == ["a", "b", "a", "b", "a", "b", "a"]
    wrong = Piece("piece", {"len": len}, "abc", lambda made: made, 2)
    with pytest.raises(WrongResult, match="piece: len made 3"):
        rows(wrong, 2)


def with_this_python(contender: Contender) -> Contender:
    """By the Python of the tests."""
    return dataclasses.replace(
        contender,
        server=[sys.executable, *contender.server[1:]],
        client=[sys.executable, *contender.client[1:]],
    )


@pytest.mark.parametrize("client", [compared_libraries.OURS, "http.client", "urllib3"])
def test_a_client_receives_the_sample(client: str, folder: Path) -> None:
    server = compared_libraries.CHOSEN_SERVER
    contender = compared_libraries.contender(client, server, client, folder)
    with started([with_this_python(contender)]) as (pair,):
        times = pair.play(3)
    assert len(times.ns) == 3
    assert min(times.server_cpu_s, times.client_cpu_s) > 0


def test_a_wrong_answer_ends_the_measurement(folder: Path, tmp_path: Path) -> None:
    sample = samples.read(folder, samples.STATE)
    sample.answer += b"!"
    (tmp_path / samples.STATE).write_bytes(msgspec.msgpack.encode(sample))
    name = compared_libraries.OURS
    right = compared_libraries.contender(
        name, compared_libraries.CHOSEN_SERVER, name, folder
    )
    wrong = dataclasses.replace(
        with_this_python(right), environment={samples.FOLDER: str(tmp_path)}
    )
    with pytest.raises(ContenderFailed, match=name), started([wrong]):
        raise AssertionError("it cannot have begun")
