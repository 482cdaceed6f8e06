"""`proctor run --view`: the page while a run is played, and who may not see it."""

import base64
import http.client
import io
import json
import re
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

import PIL.Image
import pytest

from tests.support.client.command import options, start_proctor
from tests.support.paths import ROOT
from tests.support.servers import TIMEOUT_S, ReferenceServer
from tests.support.waiting import wait_until

PAGE = ROOT / "reference_client" / "view" / "page.html"
URL = re.compile(r"Live view: (http://127\.0\.0\.1:\d+/)")


def http_get(url: str, path: str, **headers: str) -> tuple[int, bytes, dict[str, str]]:
    place = urlsplit(url).netloc
    connection = http.client.HTTPConnection(place, timeout=TIMEOUT_S)
    try:
        connection.request("GET", path, headers=headers)
        answer = connection.getresponse()
        return answer.status, answer.read(), dict(answer.getheaders())
    finally:
        connection.close()


HELD = """
import pathlib, time, policies


class Held(policies.Graded):
    def act(self, observation):
        is_held = observation.episode_id == "e0002" and observation.step
        while is_held and not pathlib.Path("go").exists():
            time.sleep(0.01)
        return super().act(observation)
"""


@pytest.mark.parametrize("processes", [[], ["--processes"]])
def test_the_page_shows_what_is_played_and_what_has_ended(
    server: ReferenceServer, policy_folder: Path, processes: list[str]
) -> None:
    """A policy held in the second turn of its third episode. Expect its picture and its
    times, the two episodes before in their order, the score so far; and that no other
    site and no other path gets anything."""
    (policy_folder / "held.py").write_text(HELD)
    tasks = options("score", "count", "echo")
    run = ["run", "--policy", "held:Held", *tasks, "--view", *processes]
    images = ["--images", "png:64x48"]
    with start_proctor(policy_folder, server.url, *run, *images) as process:
        errors = policy_folder / "stderr"
        wait_until(lambda: URL.search(errors.read_text()), "there is a page")
        shown_url = URL.search(errors.read_text())
        assert shown_url is not None
        url = shown_url[1]
        states: list[Any] = []

        def shows_the_third_episode() -> bool:
            states.append(json.loads(http_get(url, "/state.json")[1]))
            worker = states[-1]["workers"].get("worker-0", {})
            is_there = (worker.get("episode_id"), worker.get("step")) == ("e0002", 1)
            return is_there and states[-1]["scored"] == 2

        wait_until(shows_the_third_episode, "it shows the third episode")
        state = states[-1]
        assert state["title"] == "Held on calibration"
        assert (state["total"], state["mean"]) == (3, "0.500")
        results = state["results"]
        assert [one["episode_id"] for one in results] == ["e0000", "e0001"]
        assert [one["task"] for one in results] == ["score", "count"]
        assert [one["score"] for one in results] == ["0.000", "1.000"]
        seen = state["workers"]["worker-0"]
        assert seen["instruction"] == "Calibration task echo."
        assert min(seen["think_s"], seen["server_s"], seen["wire_s"]) >= 0
        data = base64.b64decode(seen["images"]["pattern"])
        assert PIL.Image.open(io.BytesIO(data)).size == (64, 48)
        assert seen["values"]["count"] == "0.000"
        assert seen["values"]["action: success"] == "1.000"
        assert (seen["fault"], seen["results"]) == ("", results)

        status, page, headers = http_get(url, "/")
        assert status == 200
        assert "default-src 'none'" in headers["Content-Security-Policy"]
        assert re.findall(rb"(?:src|href)=|url\(|https?:", page) == []
        assert http_get(url, "/", Host="elsewhere.example")[0] == 403
        assert http_get(url, "/../secrets")[0] == 404
        (policy_folder / "go").touch()
        process.communicate(timeout=TIMEOUT_S)
    assert process.returncode == 0
    with pytest.raises(OSError, match="refused"):
        http_get(url, "/")


def contrast(first: str, second: str) -> float:
    """The contrast of two colours `#rrggbb` or `#rgb`, as WCAG 2 has it."""

    def luminance(colour: str) -> float:
        digits = colour[1:]
        if len(digits) == 3:
            digits = "".join(2 * digit for digit in digits)
        shares = [int(digits[i : i + 2], 16) / 255 for i in (0, 2, 4)]
        linear = [
            share / 12.92 if share <= 0.04045 else ((share + 0.055) / 1.055) ** 2.4
            for share in shares
        ]
        return sum(w * c for w, c in zip((0.2126, 0.7152, 0.0722), linear, strict=True))

    low, high = sorted((luminance(first), luminance(second)))
    return (high + 0.05) / (low + 0.05)


def test_texts_can_be_read_on_both_grounds() -> None:
    """Expect 4.5:1 of every colour of a text, in the light and in the dark."""
    page = PAGE.read_text()
    grounds = re.findall(r"--ground: (#\w+)(.*?)}", page, re.DOTALL)
    assert len(grounds) == 2
    for ground, rest in grounds:
        colours = dict(re.findall(r"--(\w+): (#\w+)", rest))
        assert {"text", "soft", "good", "bad", "wait"} <= colours.keys()
        for name, colour in colours.items():
            least = 1.3 if name == "line" else 4.5
            assert contrast(colour, ground) >= least, (name, ground)
