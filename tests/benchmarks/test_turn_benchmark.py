"""`make bench` in small: raw TCP and our own server, a few turns of each.

That the peers can be measured too is seen when they are: they live in an environment
that `make test` does not make.
"""

from __future__ import annotations

import dataclasses
import sys
from pathlib import Path
from typing import Any
from xml.etree import ElementTree as ET

import numpy as np
import pytest

from benchmarks import performance_page, results
from benchmarks.round_trips import chart, contender_registry, observations, report
from benchmarks.round_trips import measurement as round_trips
from benchmarks.round_trips.contenders.turn_client import TurnClient
from benchmarks.round_trips.interleaved_rounds import (
    ContenderFailed,
    ContenderPair,
    cpu_s,
)

pytestmark = pytest.mark.slow("measures every contender")

NAMES = ("tcp", "ours msgpack", "ours json")
STATE_BYTES = 8 * 23


@pytest.fixture(scope="module")
def section() -> dict[str, Any]:
    body = round_trips.measure({"state": NAMES}, 3, lambda _line: None)
    return {"measured_on": results.machine(), **body}


def test_each_contender_plays_its_turns(section: dict[str, Any]) -> None:
    played = section["scenarios"]["state"]
    assert set(played) == set(NAMES)
    for one in played.values():
        assert one["turns"] >= 3
        assert one["turns"] % 3 == 0  # as many in each round
        assert 0 < one["p50_ms"] <= one["p99_ms"]
        assert one["server_cpu_s"] > 0
        assert one["client_cpu_s"] > 0


def test_raw_tcp_sends_the_fewest_bytes(
    section: dict[str, Any],
) -> None:
    played = section["scenarios"]["state"]
    assert played["tcp"]["up_bytes"] == 8 * 16
    assert played["tcp"]["down_bytes"] == STATE_BYTES
    for name in NAMES[1:]:
        assert played[name]["up_bytes"] > 8 * 16
        assert played[name]["down_bytes"] > STATE_BYTES


def test_targets_are_computed_from_the_measurements() -> None:
    medians = {"tcp": 1.0, "ours msgpack": 3.0, "grpc": 6.0, "ebench": 5.0}
    cameras = {name: {"p50_ms": p50} for name, p50 in medians.items()}
    found = report.targets({"scenarios": {"cameras": cameras}})
    assert [(one.measured, one.is_met) for one in found] == [
        (3.0, False),  # at most twice raw TCP
        (2.0, True),  # gRPC takes at least twice as long
        (pytest.approx(5 / 3), False),
    ]


def test_the_page_and_the_picture_show_every_contender(
    section: dict[str, Any], tmp_path: Path
) -> None:
    page_file = tmp_path / "page.md"
    for text in ("old", report.tables(section)):
        performance_page.put("round_trips", "Round trips", text, page_file)
        performance_page.put("pages", "Pages", "of the server", page_file)
    text = page_file.read_text()
    assert text.startswith(performance_page.HEAD)
    assert text.endswith("of the server\n\n<!-- /pages -->\n")
    assert text.count("## Pages\n") == text.count("## Round trips\n") == 1
    assert "\nold\n" not in text
    words = "".join(ET.fromstring(chart.svg(section)).itertext())  # noqa: S314 - ours
    for name in NAMES:
        assert report.NAMES[name] in text
        assert report.NAMES[name].replace("*", "").replace("`", "") in words


class FaultyConnections:
    """What may go wrong between a server and a client."""

    def __init__(self) -> None:
        self.world = observations.ScenarioPlayer("camera")

    def correct(self, action: list[float]) -> Any:
        return self.world.turn(action)

    def ignoring_actions(self, _action: list[float]) -> Any:
        return self.world.turn([0.5])

    def stale(self, action: list[float]) -> Any:
        state, images = self.world.turn(action)
        return state, {name: np.roll(image, 1) for name, image in images.items()}

    def without_images(self, action: list[float]) -> Any:
        return self.world.turn(action)[0], {}


def test_correct_observations_are_measured() -> None:
    took, computed = TurnClient(FaultyConnections().correct, "camera").play(
        3, whole=True
    )
    assert len(took) == 3
    assert computed > 0


@pytest.mark.parametrize("wire", ["ignoring_actions", "stale", "without_images"])
def test_wrong_observations_are_not_measured(wire: str) -> None:
    with pytest.raises(AssertionError):
        TurnClient(getattr(FaultyConnections(), wire), "camera").play(1)


def test_an_ended_process_has_no_cpu_time() -> None:
    assert cpu_s(2**22 + 1) == 0.0  # no Linux has so many


def test_a_contender_that_breaks_is_named(tmp_path: Path) -> None:
    """And nothing waits for it, nor is left behind."""
    sound = contender_registry.contender("tcp", "state", tmp_path)
    broken = dataclasses.replace(sound, client=[sys.executable, "-c", ""])
    with pytest.raises(ContenderFailed, match="tcp: "), ContenderPair(broken):
        raise AssertionError("it cannot have begun")
