"""The libraries' comparison in small: what is in our own environment, and the tables.

Who is not installed here is seen when all are measured: their environment is one that
`make test` does not make.
"""

from __future__ import annotations

import dataclasses
import re
import sys
from collections.abc import Callable
from functools import partial
from itertools import groupby
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from benchmarks.libraries import (
    capture,
    interleaved_timing,
    jpeg,
    loopback,
    response_parsing,
    samples,
    tables,
)
from benchmarks.round_trips import interleaved_rounds

FEW = 2  # rounds


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """With what a reference server was asked and answered."""
    made = tmp_path_factory.mktemp("samples")
    capture.write(made)
    return made


@pytest.fixture(scope="module")
def state(folder: Path) -> samples.Sample:
    return samples.read(folder, samples.STATE)


@pytest.fixture(scope="module")
def cameras(folder: Path) -> samples.Sample:
    return samples.read(folder, samples.CAMERAS)


# --- samples ---


def test_a_sample_is_a_request_and_its_answer(state: samples.Sample) -> None:
    sample_request = state.sample_request
    assert sample_request.path.endswith("/workers/w/predict")
    assert sample_request.headers["Content-Type"] == "application/msgpack"
    assert not {"Host", "Content-Length"} & set(sample_request.headers)
    assert state.request.endswith(sample_request.body)
    turn = state.turn()
    assert (turn["seq"], turn["executed_steps"]) == (1, 1)
    assert sum(map(len, turn["observation"]["state"].values())) == 23
    assert [bytes(part) for part in state.parts()] == [state.body]


def test_images_are_separate_segments(cameras: samples.Sample) -> None:
    images = cameras.turn()["observation"]["images"]
    parts = cameras.parts()
    assert len(images) == 4
    assert parts[1::2] == [image["data"] for image in images.values()]
    assert b"".join(parts) == cameras.body


def test_with_pictures_does_not_change_the_turn(
    cameras: samples.Sample,
) -> None:
    turn = cameras.turn()
    measured = samples.with_pictures(turn, len)["observation"]["images"]
    assert {image["data"] for image in measured.values()} == {640 * 480 * 3}
    assert turn == cameras.turn()


def versions_in(lock: str) -> dict[str, str]:
    text = (interleaved_rounds.ROOT / "requirements" / lock).read_text()
    return dict(re.findall(r"^([a-z0-9-]+)==(\S+)", text, re.MULTILINE))


def test_libraries_are_measured_in_the_locked_versions() -> None:
    bench, dev = versions_in("bench.txt"), versions_in("dev.txt")
    ours = {"httptools", "msgspec", "simplejpeg", "uvicorn", "uvloop"}
    assert {name: bench[name] for name in ours} == {name: dev[name] for name in ours}


# --- in turn ---


def test_all_are_measured_in_turn_and_begin_in_turn() -> None:
    worked: list[str] = []
    contenders = [
        interleaved_timing.Contender(name, worked.append, partial(str, name))
        for name in "ab"
    ]
    took = interleaved_timing.medians_ns(contenders, None, FEW)
    assert took.keys() == {"a", "b"}
    assert min(took.values()) > 0
    # Checked, tried out; then a and b, then b and a.
    assert [name for name, _ in groupby(worked)] == ["a", "b", "a", "b", "a", "b", "a"]


def test_only_the_work_is_timed() -> None:
    prepared: list[int] = []

    def prepare() -> int:
        prepared.append(len(prepared))
        return prepared[-1]

    worked: list[int] = []
    one = interleaved_timing.Contender("one", worked.append, prepare)
    interleaved_timing.medians_ns([one], None, 1)
    assert worked == prepared  # each call has an argument of its own


def test_a_wrong_result_is_not_measured() -> None:
    correct = interleaved_timing.Contender("correct", len, lambda: "ab")
    other = interleaved_timing.Contender("other", len, lambda: "abc")
    with pytest.raises(interleaved_timing.WrongResult, match="other made 3 where 2"):
        interleaved_timing.medians_ns([correct, other], 2, FEW)


def test_every_parser_finds_the_same(state: samples.Sample) -> None:
    contenders, expected = response_parsing.contenders(state)
    assert expected[1]["proctor-version"] == "1.0"
    took = interleaved_timing.medians_ns(contenders, expected, FEW)
    assert took.keys() == {"httptools", "h11", "http.client"}


@pytest.mark.parametrize("question", [jpeg.encoded, jpeg.decoded])
def test_every_codec_makes_the_same_pictures(
    question: Callable[..., tuple[list[interleaved_timing.Contender], Any]],
) -> None:
    row, column = np.mgrid[:48, :64]
    picture = np.stack([row * 4, column * 3, row + column], axis=2).astype(np.uint8)
    contenders, expected = question([picture], map)
    took = interleaved_timing.medians_ns(contenders, expected, FEW)
    assert took.keys() == {"simplejpeg", "Pillow"} == set(jpeg.sizes_kb([picture]))


def test_an_encoder_with_wrong_output_is_not_measured(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    black = np.zeros((16, 16, 3), np.uint8)
    correct = jpeg.ENCODERS["Pillow"]
    monkeypatch.setitem(jpeg.ENCODERS, "Pillow", lambda pixels: correct(pixels + 9))
    contenders, expected = jpeg.encoded([black], map)
    with pytest.raises(interleaved_timing.WrongResult, match="Pillow made"):
        interleaved_timing.medians_ns(contenders, expected, FEW)


# --- on loopback ---


def with_this_python(
    contender: interleaved_rounds.Contender,
) -> interleaved_rounds.Contender:
    """By the Python of the tests."""
    return dataclasses.replace(
        contender,
        server=[sys.executable, *contender.server[1:]],
        client=[sys.executable, *contender.client[1:]],
    )


@pytest.mark.parametrize(
    ("client", "sample"),
    [(loopback.OURS, samples.CAMERAS), ("http.client", samples.STATE)],
)
def test_a_client_receives_the_sample(client: str, sample: str, folder: Path) -> None:
    server = loopback.CHOSEN_SERVER
    contender = loopback.contender(client, server, client, folder, sample)
    (turn_times,) = loopback.turn_times([with_this_python(contender)], FEW, 3).values()
    assert len(turn_times.ns) == FEW * 3
    assert turn_times.server_cpu_s > 0
    assert turn_times.client_cpu_s > 0


def test_a_wrong_answer_ends_the_measurement(folder: Path, tmp_path: Path) -> None:
    for name in (samples.STATE, samples.CAMERAS):
        sample = samples.read(folder, name)
        dataclasses.replace(sample, answer=sample.answer + b"!").write(tmp_path, name)
    name = loopback.OURS
    correct = loopback.contender(
        name, loopback.CHOSEN_SERVER, name, folder, samples.STATE
    )
    wrong_contender = dataclasses.replace(
        with_this_python(correct), arguments=[name, str(tmp_path), samples.STATE]
    )
    with pytest.raises(interleaved_rounds.ContenderFailed, match=name):
        loopback.turn_times([wrong_contender], FEW, 3)


# --- tables ---


def test_the_chosen_library_is_first_and_the_reference() -> None:
    question = tables.Question("t", "", "ours", {"encode_us": "", "decode_us": ""})
    figures = {
        "encode_us": {"slow": 30.0, "fast": 5.0, "ours": 10.0},
        "decode_us": {"ours": 4.0, "half": 8.0, "fast": 6.0},
    }
    found = tables.ratios(question, figures)
    assert found == {
        "slow": {"encode_us": 3.0},
        "fast": {"encode_us": 0.5, "decode_us": 1.5},
        "ours": {"encode_us": 1.0, "decode_us": 1.0},
        "half": {"decode_us": 2.0},
    }
    _, _, *rows = tables.table(question, figures).split("\n")
    assert rows == [
        "| **ours** | 10.0 (1.00) | 4.00 (1.00) |",
        "| fast | 5.00 (0.50) | 6.00 (1.50) |",
        "| half |  | 8.00 (2.00) |",
        "| slow | 30.0 (3.00) |  |",
    ]
