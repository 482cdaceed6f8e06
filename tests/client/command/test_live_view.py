"""`proctor run --view`: the page while a run is played, and who may not see it."""

from __future__ import annotations

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

from tests.support.client.command import (
    options,
    start_proctor,
)
from tests.support.servers import TIMEOUT_S, ReferenceServer
from tests.support.waiting import wait_until

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


@pytest.mark.parametrize("processes", [[], ["--processes"]])
def test_the_page_shows_the_observations_of_the_workers(
    server: ReferenceServer, policy_folder: Path, processes: list[str]
) -> None:
    """A policy held in its second turn. Expect its picture, its times, the score so
    far; and that no other site and no other path gets anything."""
    (policy_folder / "slow.py").write_text(
        "import pathlib, time, policies\n"
        "class Slow(policies.Graded):\n"
        "    def act(self, observation):\n"
        "        while observation.step > 0 and not pathlib.Path('go').exists():\n"
        "            time.sleep(0.01)\n"
        "        return super().act(observation)\n"
    )
    run = ["run", "--policy", "slow:Slow", *options("echo"), "--view", *processes]
    images = ["--images", "png:64x48"]
    with start_proctor(policy_folder, server.url, *run, *images) as process:
        wait_until(
            lambda: URL.search((policy_folder / "stderr").read_text()),
            "there is a page",
        )
        found = URL.search((policy_folder / "stderr").read_text())
        assert found is not None
        url = found[1]
        states: list[Any] = []

        def shows_a_worker() -> bool:
            states.append(json.loads(http_get(url, "/state.json")[1]))
            return bool(states[-1]["workers"]) and states[-1]["total"] == 1

        wait_until(shows_a_worker, "it shows the worker")
        state = states[-1]
        assert state["title"] == "Slow on calibration"
        assert (state["scored"], state["total"], state["mean"]) == (0, 1, None)
        seen = state["workers"]["worker-0"]
        assert seen["instruction"] == "Calibration task echo."
        assert (seen["step"], seen["episode_id"]) == (1, "e0000")
        assert min(seen["think_s"], seen["server_s"], seen["wire_s"]) >= 0
        data = base64.b64decode(seen["images"]["pattern"])
        assert PIL.Image.open(io.BytesIO(data)).size == (64, 48)

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
