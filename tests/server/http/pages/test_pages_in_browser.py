"""The pages in a real browser: watch a run, open a failure, compare, read a report."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import httpx
import pytest

from reference_client.command.main import main
from tests.support.pages.browser import Browser
from tests.support.pages.page_reader import PageReader
from tests.support.pages.played_runs import submit_and_play
from tests.support.server.http_runs import predict_body, submit
from tests.support.servers import TOKENS, ReferenceServer

pytestmark = pytest.mark.slow("a server and a browser are started")

TASKS = ("score", "score", "count")


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[ReferenceServer]:
    folder = tmp_path_factory.mktemp("pages")
    with ReferenceServer(folder, PROCTOR_RECORD_IMPORTS="on") as server:
        yield server


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    with Browser() as browser:
        yield browser


class Played:
    """A run that is played turn by turn."""

    def __init__(self, client: httpx.Client) -> None:
        self.run_id = submit(client, *TASKS)
        self._client = client
        self._path = f"/v1/runs/{self.run_id}/workers/w"
        self._turn: dict[str, Any] = {}

    def attach(self) -> None:
        body = {"attach_key": "k"}
        self._turn = self._client.put(self._path, json=body).json()

    def leave(self, reason: str) -> None:
        """Say why, and play on."""
        body = {"session_id": self._turn["session_id"], "reason": reason}
        assert self._client.post(f"{self._path}/heartbeat", json=body).is_success

    def play(self, **values: float) -> None:
        """A turn with one action."""
        body = predict_body(self._turn, **values)
        answer = self._client.post(f"{self._path}/predict", json=body)
        assert answer.status_code == 200, answer.text
        self._turn = answer.json() | {"session_id": self._turn["session_id"]}

    def play_to_the_end(self, *scores: float, shift: float = 0.0) -> None:
        """Each episode: three turns, the last one with its score."""
        self.attach()
        for score in scores:
            self.play(vector=0.5)
            self.play(vector=0.25 + shift)
            self.play(score=score, success=score, end=1)


@pytest.fixture(scope="module")
def runs(server: ReferenceServer) -> tuple[str, str]:
    """A baseline that wins the first episode, and a run that wins the second."""
    with server.client() as client:
        first, second = Played(client), Played(client)
        first.play_to_the_end(1, 0, 0)
        second.play_to_the_end(0, 1, 0, shift=0.5)
        return first.run_id, second.run_id


@pytest.fixture(scope="module")
def published(server: ReferenceServer, runs: tuple[str, str]) -> str:
    """The manifest of a leaderboard with both runs."""
    with server.client() as client:
        for run_id in runs:
            entry = {"model_name": "a model", "is_public": True}
            answer = client.put(f"/v1/runs/{run_id}/entry", json=entry)
            assert answer.status_code == 201, answer.text
        return str(client.get(f"/v1/runs/{runs[0]}").json()["manifest_sha256"])


def test_a_run_is_watched_live(server: ReferenceServer, browser: Browser) -> None:
    """Submitted, attached, scored, ended: the page shows each without being loaded."""
    with server.client() as client:
        played = Played(client)
        browser.sign_in(server.url, TOKENS["alice"])
        browser.open(f"{server.url}/pages/runs/{played.run_id}")
        browser.evaluate("window.isSame = true")
        says = "document.querySelector('#summary').innerText.includes('{}')"
        browser.wait_for(says.format("ready"))
        played.attach()
        browser.wait_for(says.format("running"))
        played.leave("<b>no joint 7</b>")
        browser.wait_for(says.format("Left by its worker: e0000. <b>no joint 7</b>"))
        played.play(score=1, success=1, end=1)
        browser.wait_for(says.format("1/3"))
        browser.wait_for(says.format("Latest results"))
        row = "document.querySelector('#row-e000{}').innerText.includes('{}')"
        assert browser.evaluate(row.format(0, "success")), "the list keeps to it"
        assert browser.evaluate(row.format(1, "in progress"))
        assert browser.evaluate("window.isSame"), "the page was loaded again"
        for _ in range(2):
            played.play(end=1)
        browser.wait_for("!window.isSame")  # at the end it has the list of episodes
        browser.wait_for(says.format("completed"))
    assert browser.errors == []


def test_a_failure_is_opened_and_stepped_through(
    server: ReferenceServer, browser: Browser, runs: tuple[str, str]
) -> None:
    browser.sign_in(server.url, TOKENS["alice"])
    browser.open(f"{server.url}/pages/runs/{runs[0]}")
    browser.follow("document.querySelector('.episodes tbody a').click()")
    assert "failure" in browser.text
    browser.wait_for("document.querySelectorAll('.plots .uplot').length > 1")
    browser.press("ArrowRight")
    browser.press("ArrowRight")
    browser.wait_for("location.hash === '#step=2'")
    values = "[...document.querySelectorAll('.plots output')].map(o => o.textContent)"
    assert "0.25" in browser.evaluate(values)
    # In the order of the run's list: the other failure, and not the next index.
    browser.follow("document.querySelector('a[rel=next]').click()")
    assert "e0002" in browser.text
    assert "failure" in browser.text
    browser.follow("document.querySelector('a[rel=prev]').click()")
    assert "e0001" in browser.text
    browser.open(f"{server.url}/pages/runs/{runs[0]}/episodes/e0001#step=3")
    browser.wait_for("document.querySelector('#step').value === '3'")
    browser.press("Home")
    browser.wait_for("document.querySelector('#step').value === '0'")
    assert browser.errors == []


def test_the_films_of_a_run_are_followed(
    server: ReferenceServer, browser: Browser
) -> None:
    """Its two failures are drawn. Expect counts and marks without a second look."""
    run_id = submit_and_play(server, successes=set(), tasks=["echo", "echo"])
    browser.sign_in(server.url, TOKENS["alice"])
    browser.open(f"{server.url}/pages/runs/{run_id}")
    browser.follow("document.querySelector('#films button').click()")
    browser.evaluate("window.isSame = true")
    browser.wait_for("!document.querySelector('#films').matches('[data-pending]')")
    said = browser.evaluate("document.querySelector('#films').innerText")
    assert "Films of failures: 2 drawn." in said
    marks = "[...document.querySelectorAll('[id^=film-]')].map(m => m.textContent)"
    assert browser.evaluate(marks) == ["film", "film"]
    assert browser.evaluate("window.isSame"), "the page was loaded again"
    assert browser.errors == []


def test_an_episode_is_played_to_its_end_and_in_a_loop(
    server: ReferenceServer, browser: Browser, runs: tuple[str, str]
) -> None:
    """Three steps at 10 a second, four times as fast."""
    browser.sign_in(server.url, TOKENS["alice"])
    browser.open(f"{server.url}/pages/runs/{runs[0]}/episodes/e0001")
    assert "proctor video" in browser.text
    play = "document.querySelector('#play')"
    browser.evaluate("document.querySelector('#speed').value = '4'")
    browser.press(" ")
    browser.wait_for(
        f"document.querySelector('#step').value === '3' && {play}.innerText === 'Play'"
    )
    assert browser.evaluate("location.hash") == "#step=3"
    browser.evaluate("document.querySelector('#loop').checked = true")
    browser.evaluate(f"{play}.click()")
    for is_end in ("===", "!==", "==="):
        browser.wait_for(f"document.querySelector('#step').value {is_end} '3'")
    browser.evaluate(f"{play}.click()")
    assert browser.evaluate(f"{play}.innerText") == "Play"
    assert browser.errors == []


def test_two_runs_are_compared(
    server: ReferenceServer, browser: Browser, runs: tuple[str, str]
) -> None:
    """Expect the lost episode first, and the step that differs marked."""
    browser.sign_in(server.url, TOKENS["alice"])
    browser.open(f"{server.url}/pages/runs/{runs[1]}")
    chosen = "document.querySelector('form[action$=\"/pages/compare\"]')"
    browser.evaluate(f"{chosen}.baseline.value = '{runs[0]}'")
    browser.follow(f"{chosen}.requestSubmit()")
    assert "1 episode won, 1 lost" in browser.text
    kinds = "[...document.querySelectorAll('.pairs tbody tr')].map(r => r.dataset.kind)"
    assert browser.evaluate(kinds) == ["lost", "won", "neither"]
    browser.follow("document.querySelector('.pairs tbody a').click()")
    assert "First difference: step 2" in browser.text
    browser.wait_for("document.querySelectorAll('.plots .uplot').length > 1")
    browser.press("End")
    values = "[...cell.querySelectorAll('output')].map(value => value.innerText)"
    both = f"[...document.querySelectorAll('.plots > div')].map(cell => {values})"
    assert browser.evaluate("document.querySelectorAll('.sides .uplot').length") == 0
    assert ["1", "0"] in browser.evaluate(both), "the last score of each"
    for key, rel in (("]", "next"), ("]", "next"), ("[", "prev")):
        walked = browser.evaluate(f"document.querySelector('a[rel={rel}]').href")
        browser.press(key)
        # The script shows the keys when it listens to them.
        ready = "document.querySelector('.keys')?.hidden === false"
        browser.wait_for(f"location.href === '{walked}' && {ready}")
    assert "Draw the films" in browser.text
    assert browser.errors == []


@pytest.fixture(scope="module")
def addresses(
    server: ReferenceServer, runs: tuple[str, str], published: str
) -> list[str]:
    """The addresses of a page of every kind."""
    pair = f"baseline={runs[0]}&run={runs[1]}"
    with server.client() as client:
        played, waiting = Played(client), Played(client)
        played.attach()
        played.play(score=1, success=1, end=1)
        (entry, *_) = client.get("/v1/entries").json()["entries"]
        record = client.get(f"/v1/runs/{runs[0]}/record").content
        kind = {"content-type": "application/zip"}
        imported = client.post("/v1/records", content=record, headers=kind).json()
    paths = (
        *("/history", f"/entries/{entry['entry_id']}", "/imports"),
        f"/imports/{imported['import_id']}",
        *("", "/runs", f"/runs/{runs[0]}", f"/runs/{runs[0]}/episodes/e0001"),
        *("/benchmarks/tabletop", f"/compare?{pair}", "/login", "/nothing"),
        f"/benchmarks/calibration/leaderboard?manifest={published}",
        f"/compare/episode?{pair}&episode=e0000",
        f"/compare/several?run={runs[0]}&run={runs[1]}",
        *(f"/runs/{one.run_id}" for one in (played, waiting)),
        *("/runs?state=failed", "/benchmarks/calibration/leaderboard"),
    )
    return [f"{server.url}/pages{path}" for path in paths]


# Each width and each theme once; what they do together is left to a release.
OTHER_PAIR = pytest.mark.release("pages at the other pairs of width and theme")


@pytest.mark.parametrize(
    ("width", "dark"),
    [
        pytest.param(400, False, id="light-400"),
        pytest.param(1280, True, id="dark-1280"),
        pytest.param(1280, False, id="light-1280", marks=OTHER_PAIR),
        pytest.param(400, True, id="dark-400", marks=OTHER_PAIR),
    ],
)
def test_everyone_can_read_the_pages(
    server: ReferenceServer,
    browser: Browser,
    addresses: list[str],
    width: int,
    dark: bool,
) -> None:
    """Contrast, labels, one heading, axe-core; no page is wider than its window."""
    browser.sign_in(server.url, TOKENS["alice"])
    browser.resize(width, dark=dark)
    for address in addresses:
        browser.open(address)
        assert browser.find_faults() == [], address
        if (width == 400) is not dark:  # colours are among the faults above
            assert browser.find_violations() == [], address


def test_without_scripts_each_fact_is_there_and_no_control_is_dead(
    server: ReferenceServer, browser: Browser, runs: tuple[str, str]
) -> None:
    """The slider of the steps needs a script; the table of turns and filters do not."""
    browser.sign_in(server.url, TOKENS["alice"])
    episode = f"{server.url}/pages/runs/{runs[0]}/episodes/e0000"
    slider = "document.querySelector('#step').getClientRects().length"
    browser.open(episode)
    assert browser.evaluate(slider) == 1, "the control"
    browser.call("Emulation.setScriptExecutionDisabled", value=True)
    try:
        browser.open(episode)
        assert browser.evaluate(slider) == 0
        assert "Turns (3)" in browser.text
        browser.open(f"{server.url}/pages/runs/{runs[0]}?outcome=success")
        assert "1 of 1" in browser.text
    finally:
        browser.call("Emulation.setScriptExecutionDisabled", value=False)


def test_a_report_opens_without_a_server(
    server: ReferenceServer,
    browser: Browser,
    runs: tuple[str, str],
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """One run of the server and one record, both in one report."""
    record = tmp_path / "first.proctor"
    reader = PageReader(server.url, "alice")
    record.write_bytes(reader.get(f"/pages/runs/{runs[0]}/record").content)
    order = ["--url", server.url, "--token", TOKENS["alice"]]
    folder = tmp_path / "out"
    command = ["report", str(record), runs[1], "-o", str(folder), *order]
    assert main(command) == 0
    assert str(folder / "index.html") in capsys.readouterr().out
    assert main(command) == 2, "the folder is not empty"

    browser.resize(400)
    comparison = "comparisons/1-2"
    for name in (
        *("index", "runs/1/index", "runs/1/episodes/00000", "benchmarks/1"),
        *(f"{comparison}/index", f"{comparison}/00000"),
    ):
        browser.open(f"file://{folder}/{name}.html")
        assert browser.find_faults() == [], name
        assert browser.find_violations() == [], name
    browser.open(f"file://{folder}/index.html")
    browser.follow("document.querySelectorAll('tbody a')[1].click()")
    browser.evaluate("document.querySelector('[name=outcome]').value = 'success'")
    browser.evaluate("document.forms[0].dispatchEvent(new Event('change'))")
    shown = "document.querySelectorAll('.episodes tbody tr:not([hidden])').length"
    browser.wait_for(f"{shown} === 1")
    browser.follow("document.querySelector('ul a[href*=comparisons]').click()")
    assert "1 episode won, 1 lost" in browser.text
    browser.follow("document.querySelector('.pairs tbody a').click()")
    assert "First difference: step 2" in browser.text
    browser.follow("document.querySelector('.sides a').click()")
    browser.wait_for("document.querySelectorAll('.plots .uplot').length > 1")
    assert browser.evaluate("location.protocol") == "file:"
    assert browser.errors == []
