"""Films of episodes: drawn once, when they are asked for, for readers of the run."""

from __future__ import annotations

import asyncio
import shutil
from collections.abc import AsyncIterator, Sequence
from contextlib import asynccontextmanager
from pathlib import Path
from typing import Any

import httpx
import pytest

from reference_record.pages import page_contents
from reference_record.pages.recorded_episode import RecordedEpisode
from reference_server.http.pages import films, page_handlers
from reference_server.http.pages.films import WAITING_MAX, FilmFailed, FilmSettings
from reference_server.http.pages.page_links import ServerLinks
from reference_server.views.run_views import episode_view, run_view
from tests.support.pages.page_api import (
    FAILURE,
    RESULT,
    PageApi,
    client_of,
    sign_in,
    text_of,
)
from tests.support.pages.page_reader import PageReader, commands_of, fields_of, place_of
from tests.support.pages.played_runs import submit_and_play
from tests.support.servers import ReferenceServer
from tests.support.waiting import wait_until

EPISODE = "/pages/runs/done/episodes/e0000"
BUTTON = "Draw the film"
OWN = FilmSettings("own.toml")


class Drawing:
    """Replaces the export of a job: it waits until it may go on."""

    def __init__(self, folder: Path) -> None:
        self.jobs: list[Any] = []
        self.began, self.may_go_on = asyncio.Event(), asyncio.Event()
        self.reason = ""
        self.path = folder / "0.mp4"

    async def __call__(self, job: Any) -> list[dict[str, Any]]:
        self.jobs.append(job)
        self.began.set()
        await self.may_go_on.wait()
        if self.reason:
            raise FilmFailed(self.reason)
        self.path.write_bytes(b"0123456789")
        return [{"camera": "front", "path": str(self.path)}]


@pytest.fixture
def drawing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Drawing:
    export = Drawing(tmp_path)
    monkeypatch.setattr(films, "_export", export)
    read = "read_recorded_episode"
    monkeypatch.setattr(page_handlers, read, lambda *_: RecordedEpisode())
    return export


@asynccontextmanager
async def reader(
    settings: FilmSettings | None = OWN,
) -> AsyncIterator[tuple[PageApi, httpx.AsyncClient]]:
    api = PageApi()
    async with client_of(api, films=settings) as client:
        await sign_in(client, "alice")
        yield api, client


async def ask(client: httpx.AsyncClient, address: str = EPISODE) -> httpx.Response:
    csrf = fields_of(await text_of(client, "/pages/runs"))["csrf"]
    return await client.post(f"{address}/film", data={"csrf": csrf})


async def settled(client: httpx.AsyncClient, address: str = EPISODE) -> str:
    """The page once nothing is being drawn."""
    for _ in range(1000):
        if "data-reload" not in (page := await text_of(client, address)):
            return page
        await asyncio.sleep(0)
    raise AssertionError("it is drawn for ever")


async def test_a_film_is_drawn_once_and_served_in_parts(drawing: Drawing) -> None:
    async with reader() as (api, client):
        api.add("done", FAILURE)
        assert BUTTON in await text_of(client, EPISODE)
        for _ in range(2):
            answer = await ask(client)
            assert (answer.status_code, place_of(answer)) == (303, EPISODE)
        page = await text_of(client, EPISODE)
        assert "data-reload" in page
        assert BUTTON not in page
        drawing.may_go_on.set()
        page = await settled(client)
        assert f'{EPISODE}/film/0"' in page
        (job,) = drawing.jobs
        assert (job["episodes"], job["benchmarks"]) == ([0], "own.toml")
        part = await client.get(f"{EPISODE}/film/0", headers={"range": "bytes=2-4"})
        assert (part.status_code, part.content) == (206, b"234")
        for wrong in ("1", "x", "-1"):
            assert (await client.get(f"{EPISODE}/film/{wrong}")).status_code == 404
        await sign_in(client, "bob")
        for answer in (await client.get(f"{EPISODE}/film/0"), await ask(client)):
            assert answer.status_code == 404, "the run is not his"


async def test_a_film_that_a_cleaner_has_removed_is_drawn_again(
    drawing: Drawing,
) -> None:
    """Every file of a film, and the temporary folder of all of them."""
    drawing.may_go_on.set()
    async with reader() as (api, client):
        api.add("done", FAILURE)
        for number in (1, 2):
            await ask(client)
            assert f'{EPISODE}/film/0"' in await settled(client)
            assert len(drawing.jobs) == number
            shutil.rmtree(Path(drawing.jobs[-1]["output"]).parent)
            drawing.path.unlink()
            assert (await client.get(f"{EPISODE}/film/0")).status_code == 404
            assert BUTTON in await text_of(client, EPISODE)


async def test_all_failures_of_a_run_are_drawn_from_its_page(drawing: Drawing) -> None:
    """As many as may wait, then the rest. Expect their number and state in each case,
    a mark in each row, and each film on the page of its episode."""
    async with reader() as (api, client):
        api.add("done", *[FAILURE] * (WAITING_MAX + 1), RESULT)
        run = "/pages/runs/done"
        rounds: list[tuple[str, str, str, Sequence[int]]] = [
            ("8 of 9 failures", "9 not drawn", "8 waiting, 1 not", range(WAITING_MAX)),
            ("1 failure", "8 drawn, 1 not drawn", "8 drawn, 1 waiting", [WAITING_MAX]),
        ]
        for count, before, after, indices in rounds:
            drawing.may_go_on.clear()
            page = await text_of(client, run)
            assert f"<button>Draw {count}</button>" in page
            assert f"Films of failures: {before}. " in page
            assert page.index("<button>Draw") < page.index('id="row-e0000"')
            answer = await client.post(
                f"{run}/films", data={"csrf": fields_of(page)["csrf"]}
            )
            assert (answer.status_code, place_of(answer)) == (303, f"{run}#episodes")
            page = await text_of(client, run)
            assert "<button>Draw" not in page
            assert f"Films of failures: {after}" in page
            assert 'id="films" data-pending' in page
            assert "Load the page again to see which are drawn." in page
            assert page.count(">film waits<") + page.count(
                ">film is being drawn<"
            ) == len(indices)
            drawing.may_go_on.set()
            for index in indices:
                await settled(client, f"{run}/episodes/e{index:04d}")
        page = await text_of(client, run)
        assert page.count('">film</span>') == WAITING_MAX + 1
        assert "Films of failures: 9 drawn. " in page
        assert "data-pending" not in page
        assert [job["episodes"] for job in drawing.jobs] == [
            [index] for index in range(WAITING_MAX + 1)
        ]


async def test_the_films_of_two_runs_are_drawn_from_their_page(
    drawing: Drawing,
) -> None:
    """Also from a list of some pairs: the reader comes back to the same walk."""
    async with reader() as (api, client):
        for name in ("done", "other"):
            api.add(name, FAILURE, FAILURE)
        chosen = "baseline=done&run=other&episode=e0000&kind=neither"
        pair = f"/pages/compare/episode?{chosen}"
        page = await text_of(client, pair)
        assert "Draw the films" in page
        assert "until it restarts" in page
        assert "episode=e0001&amp;kind=neither" in page
        csrf = fields_of(page)["csrf"]
        answer = await client.post(
            f"/pages/compare/episode/films?{chosen}", data={"csrf": csrf}
        )
        assert (answer.status_code, place_of(answer)) == (303, pair)
        page = await text_of(client, pair)
        assert page.count("data-reload") == 2
        assert "Draw the films" not in page
        drawing.may_go_on.set()
        page = await settled(client, pair)
        for name in ("done", "other"):
            assert f'runs/{name}/episodes/e0000/film/0"' in page
        await sign_in(client, "bob")
        form = {"csrf": fields_of(await text_of(client, "/pages/runs"))["csrf"]}
        answer = await client.post(f"/pages/compare/episode/films?{chosen}", data=form)
        assert answer.status_code == 404


async def test_a_film_that_failed_says_why_and_can_be_asked_for_again(
    drawing: Drawing,
) -> None:
    async with reader() as (api, client):
        api.add("done", FAILURE)
        drawing.may_go_on.set()
        drawing.reason = "there is no camera"
        await ask(client)
        page = await settled(client)
        assert "could not be drawn: there is no camera" in page
        drawing.reason = ""
        await ask(client)
        assert "<video" in await settled(client)


async def test_only_some_films_wait(drawing: Drawing) -> None:
    """One is drawn at a time. Expect a refusal that says when to come back."""
    async with reader() as (api, client):
        api.add("done", *[FAILURE] * (WAITING_MAX + 1))
        for index in range(WAITING_MAX + 1):
            answer = await ask(client, f"/pages/runs/done/episodes/e{index:04}")
            assert answer.status_code == (303 if index < WAITING_MAX else 503)
        await asyncio.sleep(0)
        assert len(drawing.jobs) <= 1
        drawing.may_go_on.set()


async def test_accounts_share_the_places_of_films(drawing: Drawing) -> None:
    """One account has all places. Expect that another one gets one, and is next."""
    async with reader() as (api, client):
        api.add("many", *[FAILURE] * WAITING_MAX)
        api.add("done", FAILURE, tokens="bob")
        for index in range(WAITING_MAX):
            await ask(client, f"/pages/runs/many/episodes/e{index:04}")
        await drawing.began.wait()
        await sign_in(client, "bob")
        assert (await ask(client)).status_code == 303
        drawing.may_go_on.set()
        assert "<video" in await settled(client)
        assert [job["episodes"] for job in drawing.jobs[:2]] == [[0], [0]]
        await sign_in(client, "alice")
        last = f"/pages/runs/many/episodes/e{WAITING_MAX - 1:04}"
        assert "films of other accounts went first" in await settled(client, last)
        assert (await ask(client, last)).status_code == 303
        assert "<video" in await settled(client, last)


@pytest.mark.parametrize("case", ["played", "sealed", "off", "no camera"])
async def test_what_cannot_be_drawn_has_no_button(case: str) -> None:
    settings = None if case == "off" else FilmSettings()
    async with reader(settings) as (api, client):
        run = api.add("done", FAILURE, *([None] if case == "played" else []))
        if case == "no camera":
            version = run_view(run, "", None)["benchmark_version"]
            api.described = {"version": version, "observation_space": {"images": {}}}
        run.episodes[0].is_sealed = case == "sealed"
        page = await text_of(client, EPISODE)
        assert BUTTON not in page
        assert ("is the secret of the host" in page) == (case == "sealed")
        command = "proctor video done --episode 0 --url http://server"
        assert (command in commands_of(page)) == (case in ("sealed", "off"))
        assert (await ask(client)).status_code == 404


async def test_a_host_draws_what_it_has_sealed(drawing: Drawing) -> None:
    """With the secret of its server, as long as no other account has a token."""
    secrets = ["db.seeds"]
    async with reader(FilmSettings(seed_secret=lambda: secrets[0])) as (api, client):
        api.add("done", FAILURE, FAILURE).episodes[0].is_sealed = True
        page = await text_of(client, EPISODE)
        assert BUTTON in page
        assert "is the secret of the host" not in page
        assert (await ask(client)).status_code == 303
        await drawing.began.wait()
        assert drawing.jobs[0]["secret"] == "db.seeds"
        secrets[0] = ""
        assert (await ask(client)).status_code == 404
        drawing.may_go_on.set()


@pytest.mark.parametrize("goal", ["", "The ball is at its place."])
def test_a_failure_says_its_goal_and_a_player_that_it_is_empty(goal: str) -> None:
    run = PageApi().add("done", FAILURE)
    episode = episode_view(run.episodes[0])
    recorded = RecordedEpisode()
    page = page_contents.episode_html(
        ServerLinks.of(EPISODE), run_view(run, "http://server", None), episode,
        recorded, page_contents.played_view(recorded),
        described={"task_goals": {"score": goal}},
    )  # fmt: skip
    assert "No picture was recorded" in page
    assert ("The goal of score: The ball is at its place." in page) is bool(goal)


def test_one_line_says_how_a_session_ended_and_why_its_worker_left() -> None:
    run = PageApi().add("done", None)
    episode = episode_view(run.episodes[0])
    episode["last_left"] = {"attempt": 1, "reason": "The policy raised."}
    recorded = RecordedEpisode()
    pages = []
    for events in ([(1, "ended", "lease_ended"), (2, "ended", "detached")], []):
        recorded.events[:] = events
        played = page_contents.played_view(recorded)
        view = run_view(run, "http://server", None)
        links = ServerLinks.of(EPISODE)
        pages.append(page_contents.episode_html(links, view, episode, recorded, played))
    for page in pages:
        assert page.count("The policy raised.") == 1
    assert "attempt 1 ended: The policy raised. (its lease ended)<" in pages[0]
    assert "attempt 2 ended: its worker detached<" in pages[0]


@pytest.mark.slow("a server is started, and a film is drawn")
def test_a_server_draws_an_episode(tmp_path: Path) -> None:
    with ReferenceServer(tmp_path) as server:
        run_id = submit_and_play(server, successes={0}, tasks=["echo"])
        alice = PageReader(server.url, "alice")
        page = f"/pages/runs/{run_id}/episodes/e0000"
        form = {"csrf": alice.csrf()}
        assert alice.client.post(f"{page}/film", data=form).status_code == 303
        wait_until(lambda: "data-reload" not in alice.text(page), "it is drawn")
        assert "could not be drawn" not in alice.text(page)
        film = alice.get(f"{page}/film/0")
        assert film.headers["content-type"] == "video/mp4"
        assert film.content[4:8] == b"ftyp"
