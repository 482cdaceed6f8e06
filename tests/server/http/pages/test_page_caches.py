"""What pages keep of runs: computed once, as old as the run, no other reader's."""

from __future__ import annotations

import asyncio
import re
from typing import Any

import httpx
import pytest

from reference_record.pages.recorded_episode import CameraPicture, RecordedEpisode
from reference_record.pages.run_page import RunFigures
from reference_server.http.pages import page_handlers
from reference_server.http.pages.page_handlers import LISTS_KEPT, RECORDINGS_KEPT
from tests.support.pages import page_api
from tests.support.pages.page_api import FAILURE, RESULT, Gate, sign_in, signed_in

PICTURE = CameraPicture("front", 0, b"a picture", "png")


@pytest.fixture
def recordings(monkeypatch: pytest.MonkeyPatch) -> None:
    """Each episode has one picture, whatever its file has."""
    read = "read_recorded_episode"
    monkeypatch.setattr(
        page_handlers, read, lambda *_: RecordedEpisode(pictures=[PICTURE])
    )


async def text_of(client: httpx.AsyncClient, run_id: str, query: str = "") -> str:
    return await page_api.text_of(client, f"/pages/runs/{run_id}{query}")


def rows_of(page: str) -> dict[str, int]:
    """How many episodes the page lists, by their outcome or status."""
    names = ("failure", "success", "pending")
    return {name: page.count(f'<tr data-outcome="{name}"') for name in names}


async def test_figures_of_a_completed_run_are_computed_once(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Its page with each filter. Expect one list of episodes read, counted once."""
    computed: list[int] = []
    right = RunFigures.of

    def note(episodes: Any) -> RunFigures:
        computed.append(len(episodes))
        return right(episodes)

    monkeypatch.setattr(RunFigures, "of", note)
    async with signed_in() as (api, client):
        api.add("done", RESULT, FAILURE, RESULT)
        for query in ("", "?outcome=success", "?task=score", ""):
            await text_of(client, "done", query)
        assert computed == [3]
        assert api.asked["runs/done/episodes"] == 1


async def test_a_late_episode_is_on_the_page() -> None:
    """It ends while its run is looked at, in one millisecond. Expect it counted."""
    async with signed_in() as (api, client):
        run = api.add("played", RESULT, None, None)
        assert rows_of(await text_of(client, "played"))["failure"] == 0
        run.record_result(run.episodes[1], FAILURE)
        page = await text_of(client, "played")
        assert rows_of(page) == {"failure": 1, "success": 1, "pending": 1}
        assert "<b>1/2</b>" in page, "the table of tasks counts it, too"
        run.record_result(run.episodes[2], FAILURE)
        run.state = "completed"
        page = await text_of(client, "played")
        assert rows_of(page) == {"failure": 2, "success": 1, "pending": 0}
        assert "<b>1/3</b>" in page


async def test_a_changed_run_is_counted_again() -> None:
    """A host scores it anew: what its page lists and counts is the new result."""
    async with signed_in() as (api, client):
        run = api.add("done", RESULT, RESULT)
        assert "<b>2/2</b>" in await text_of(client, "done")
        run.episodes[0].result = FAILURE
        run.updated_at_wall += 1.0
        page = await text_of(client, "done")
        assert rows_of(page) == {"failure": 1, "success": 1, "pending": 0}
        assert "<b>1/2</b>" in page


async def test_no_reader_sees_what_another_one_was_shown() -> None:
    """Two tokens that may read a run and are shown more or less of it; one may not."""
    async with signed_in() as (api, client):
        api.add("done", FAILURE, tokens="alice host")
        api.changed["alice"] = {"policy_fault": "for alice alone"}
        assert "for alice alone" in await text_of(client, "done")
        await sign_in(client, "host")
        assert "for alice alone" not in await text_of(client, "done")
        await sign_in(client, "bob")
        assert (await client.get("/pages/runs/done")).status_code == 404


@pytest.mark.usefixtures("recordings")
async def test_a_run_that_may_no_more_be_read_is_not_shown() -> None:
    """Deleted after its page and a picture of it were opened. Expect neither."""
    async with signed_in() as (api, client):
        api.add("done", FAILURE)
        paths = ("/pages/runs/done", "/pages/runs/done/episodes/e0000/pictures/0")
        assert [(await client.get(path)).status_code for path in paths] == [200, 200]
        del api.runs["done"]
        assert [(await client.get(path)).status_code for path in paths] == [404, 404]


async def test_a_flag_is_shown_at_once() -> None:
    """The figures are kept, and the entry is not."""
    async with signed_in() as (api, client):
        api.add("done", RESULT)
        entry = api.publish("done")
        assert "Flagged" not in await text_of(client, "done")
        api.entries[0] = entry | {"flag": {"reason": "it saw the test seeds"}}
        assert "it saw the test seeds" in await text_of(client, "done")
        api.entries.clear()
        assert "Published as" not in await text_of(client, "done")


async def test_few_lists_are_kept() -> None:
    """Memory: the list of the run that was looked at longest ago goes."""
    async with signed_in() as (api, client):
        names = [f"run{number}" for number in range(LISTS_KEPT + 1)]
        for name in names:
            api.add(name, RESULT)
            await text_of(client, name)
            await text_of(client, names[0])  # this one is used all the time
        for name in names:
            await text_of(client, name)
        read = {name: api.asked[f"runs/{name}/episodes"] for name in names}
        assert read.pop("run0") == 1
        assert read.pop("run1") == 2, "the one that had to go"
        assert sum(read.values()) <= 2 * len(read)


@pytest.mark.usefixtures("recordings")
async def test_a_recording_is_shown_although_it_makes_room_meanwhile() -> None:
    """Others are opened while it is checked that a kept one may still be shown."""
    async with signed_in() as (api, client):
        api.add("done", *[RESULT] * (RECORDINGS_KEPT + 1))
        pictures = [
            f"/pages/runs/done/episodes/e{number:04d}/pictures/0"
            for number in range(RECORDINGS_KEPT + 1)
        ]
        assert (await client.get(pictures[0])).status_code == 200
        gate = api.before["runs/done"] = Gate()
        waiting = asyncio.create_task(client.get(pictures[0]))
        await gate.reached.wait()
        del api.before["runs/done"]
        for path in pictures[1:]:
            assert (await client.get(path)).status_code == 200
        gate.open()
        answer = await waiting
        assert (answer.status_code, answer.content) == (200, b"a picture")


async def test_each_list_of_runs_has_their_scores() -> None:
    """One complete, one in play, one that nothing was played of, one just deleted."""
    async with signed_in() as (api, client):
        api.add("done", RESULT, FAILURE, RESULT, FAILURE)
        api.add("playing", RESULT, None)
        api.add("new", None)
        api.add("gone", RESULT)

        async def delete() -> None:
            del api.runs["gone"]

        api.before["runs/gone/score"] = delete
        page = await page_api.text_of(client, "/pages/runs")
        shown = re.findall(r'<td class="number lead">(.*?)</td>', page)
        assert shown == ["mix 0.500", "(mix 1.000)", "–", "–"]
        assert api.asked["runs/new/score"] == 0
        assert (
            "A mix is the mean over several splits: quote that of each split instead. "
            "A score in parentheses is the mean of the episodes scored so far." in page
        )
