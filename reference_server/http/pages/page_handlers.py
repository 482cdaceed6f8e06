"""The pages of a server: one handler each, which fetches documents and renders them.

Each runs with the token of the reader's session. A refusal of the API is shown as a
page: the runs of other accounts are not found.
"""

from __future__ import annotations

import asyncio
import contextlib
import io
from collections import OrderedDict
from collections.abc import Awaitable, Callable, Mapping, Sequence
from contextlib import aclosing
from functools import cached_property
from http import HTTPStatus
from typing import Any
from urllib.parse import urlencode

from starlette.responses import (
    FileResponse,
    RedirectResponse,
    Response,
    StreamingResponse,
)

from reference_record.broken import BrokenRecord
from reference_record.formats.names import record_file_name
from reference_record.pages import page_contents, run_page
from reference_record.pages.comparison_page import KINDS, LETTERS, pair_episodes
from reference_record.pages.page_contents import (
    Neighbours,
    ShownVideo,
    Side,
    Window,
    played_view,
)
from reference_record.pages.page_templates import render_page
from reference_record.pages.recorded_episode import (
    RecordedEpisode,
    read_recorded_episode,
)
from reference_record.pages.run_page import (
    NO_FILMS,
    Document,
    RunFigures,
    RunFilms,
    snapshot,
    status_of,
)
from reference_server.http.pages.api_documents import Problem
from reference_server.http.pages.board_pages import (
    FindEntryId,
    find_entry,
    has_leaderboard,
    level_of,
)
from reference_server.http.pages.entry_pages import offered_pages
from reference_server.http.pages.films import Film, Films, FilmSettings
from reference_server.http.pages.live_runs import LiveRuns
from reference_server.http.pages.page_calls import PageCall
from reference_server.http.pages.page_links import ServerLinks
from reference_server.rules.refusal import Refused
from reference_server.storage.runs.run_store import StoreFailed

ROWS = 100
EPISODES_PER_CALL = 1000  # the most that the API gives at once
RUNS_SEARCHED_MAX = 1000
LATEST_RUNS = 20
LISTS_KEPT = 4
RECORDINGS_KEPT = 4


# The options of a run, by its id.
FindOptions = Callable[[str], Awaitable[Mapping[str, Any] | None]]


class _EpisodeList:
    """All episodes of a run, in the order of the manifest."""

    def __init__(self, episodes: list[Document]) -> None:
        self.all = episodes

    @cached_property
    def figures(self) -> RunFigures:
        """Computed once: pages of a long run differ in the rows that they list."""
        return RunFigures.of(self.all)


class PageHandlers:
    """Every page but the sign-in. Handlers raise Problem.

    find_entry_id: None if there is no leaderboard. films: None if none are drawn.
    """

    def __init__(
        self,
        find_entry_id: FindEntryId | None = None,
        films: FilmSettings | None = None,
        find_options: FindOptions | None = None,
    ) -> None:
        self._find_options = find_options
        self._find_entry_id = find_entry_id
        self._films = None if films is None else Films(films)
        self._live = LiveRuns(ServerLinks.of("/pages/runs/RUN"))
        self._lists: OrderedDict[tuple[str, str, str], _EpisodeList] = OrderedDict()
        self._recordings: OrderedDict[tuple[str, str, str], RecordedEpisode] = (
            OrderedDict()
        )

    async def show_index(self, call: PageCall) -> str:
        benchmarks = await call.api.get("benchmarks")
        runs = await call.api.get("runs", limit=LATEST_RUNS)
        return render_page(
            "index", call.links, csrf=call.csrf, title="Benchmarks and runs",
            runs=runs["runs"], scores=await _scores(call, runs["runs"]),
            benchmarks=benchmarks["benchmarks"],
            more=await offered_pages(call),
        )  # fmt: skip

    async def show_benchmark(self, call: PageCall) -> str:
        benchmark = await call.api.get("benchmarks", call.path("benchmark_id"))
        return render_page(
            "benchmark", call.links, csrf=call.csrf, benchmark=benchmark,
            has_leaderboard=await has_leaderboard(call.api, benchmark["benchmark_id"]),
        )  # fmt: skip

    async def show_runs(self, call: PageCall) -> str:
        """The runs that fit, and from where the next page goes on."""
        selected = {name: call.query(name) for name in ("benchmark", "policy", "state")}
        start = {"cursor": cursor} if (cursor := call.query("cursor")) else {}
        runs: list[Document] = []
        searched, following = 0, ""
        async for page in call.api.pages("runs", limit=ROWS, **start):
            searched += len(page["runs"])
            runs += [run for run in page["runs"] if _fits(run, selected)]
            if len(runs) >= ROWS or searched >= RUNS_SEARCHED_MAX:
                if cursor := page["next_cursor"]:
                    following = f"?{urlencode(selected | {'cursor': cursor})}"
                break
        return render_page(
            "runs", call.links, csrf=call.csrf, runs=runs, selected=selected,
            scores=await _scores(call, runs),
            states=("queued", "ready", "running", "stopping", "stopped", "failed",
                    "completed"),
            searched=searched if any(selected.values()) else 0, following=following,
        )  # fmt: skip

    async def show_run(self, call: PageCall) -> str:
        run_id = call.path("run_id")
        run = await call.api.get("runs", run_id)
        can_change = run["state"] not in ("completed", "failed")
        listed = await self._episodes(call, run)
        figures = listed.figures
        if can_change:
            run, score = snapshot(run, listed.all)
        else:
            score = await call.api.get("runs", run_id, "score")
        fitting, selected = _selected(call, figures)
        window = _window(call, fitting, selected, "#episodes")
        described = await _benchmark_of(call, run)
        if run_page.is_of_another_manifest(run, described):
            run = {**run, **await self._options_of(run_id)}
        runs = await call.api.get("runs", limit=ROWS)
        others = [
            candidate
            for candidate in runs["runs"]
            if candidate["manifest_sha256"] == run["manifest_sha256"]
            and candidate["run_id"] != run_id
            and candidate["progress"]["episodes_scored"]
        ]
        may_publish, entry = await find_entry(call.api, run, self._find_entry_id)
        return page_contents.run_html(
            call.links, run, score, figures, window, csrf=call.csrf, others=others,
            may_publish=may_publish, entry=entry,
            live=call.links.live(run_id) if can_change else "",
            described=described,
            films=self._films_of(call, run, listed.all, described),
            level=page_contents.LEVELS[await level_of(call.api, score, entry)],
        )  # fmt: skip

    async def _options_of(self, run_id: str) -> Mapping[str, Any]:
        """Options of a run that was just read for the same reader, as its member."""
        if self._find_options is None:
            return {}
        try:
            return {"options": await self._find_options(run_id)}
        except (Refused, StoreFailed):  # the page is shown without them
            return {}

    async def stream_run(self, call: PageCall, is_allowed: Any) -> Response:
        """Changes of a run, for the page of it that is open."""
        run_id = call.path("run_id")
        await call.api.get("runs", run_id)  # refused before the stream begins
        account = call.session.account
        if self._live.is_full(account):
            raise Problem(503, "unavailable", "Too many pages are open.")
        return StreamingResponse(
            self._live.updates(call.api, account, run_id, is_allowed),
            media_type="text/event-stream",
            headers={"X-Accel-Buffering": "no"},
        )

    async def fetch_record(self, call: PageCall) -> Response:
        run_id = call.path("run_id")
        parts = call.api.stream("runs", run_id, "record")
        first = await anext(parts, b"")  # a refusal is a page

        async def body() -> Any:
            async with aclosing(parts):
                yield first
                async for part in parts:
                    yield part

        name = f'attachment; filename="{record_file_name(run_id)}"'
        return StreamingResponse(
            body(),
            media_type="application/zip",
            headers={"Content-Disposition": name},
        )

    async def show_episode(self, call: PageCall) -> str:
        run_id = call.path("run_id")
        run = await call.api.get("runs", run_id)
        listed = await self._episodes(call, run)
        episode = listed.all[_place(listed.all, call.path("episode_id"))]
        recorded, problem = await self._recorded(call, run_id, episode)
        benchmark = await _benchmark_of(call, run)
        fitting, selected = _selected(call, listed.figures)
        query = Window((), 0, selected=selected).query
        around = Neighbours.of(
            run_page.around(fitting, episode["episode_id"]),
            lambda one: call.links.episode(run_id, one) + query,
        )
        view = None
        if recorded is not None:
            view = self._view(call, run, episode, recorded, benchmark)
        return page_contents.episode_html(
            call.links, run, episode, recorded, view,
            control_rate_hz=benchmark["control_rate_hz"] if benchmark else None,
            described=benchmark, film=self._film_of(run, episode, benchmark),
            problem=problem, neighbours=around, query=query, csrf=call.csrf,
        )  # fmt: skip

    async def fetch_picture(self, call: PageCall) -> Response:
        """The picture of a camera, by its number in the recording."""
        run_id, number = call.path("run_id"), call.path("number")
        episode = {"episode_id": call.path("episode_id"), "result": True}
        recorded, problem = await self._recorded(call, run_id, episode)
        pictures = () if recorded is None else recorded.pictures
        numbered = {str(index): picture for index, picture in enumerate(pictures)}
        if number not in numbered:
            raise Problem(404, "not_found", problem or "There is no such picture.")
        picture = numbered[number]
        kind = "jpeg" if picture.extension == "jpg" else picture.extension
        return Response(picture.data, media_type=f"image/{kind}")

    def _film_of(
        self, run: Document, episode: Document, described: Document | None
    ) -> Film | None:
        """None where none can be drawn: no record, no camera, no setting, or a robot.

        A record has no sealed seed: its episode is drawn where the host is its reader.
        """
        if self._films is None or not run_page.may_be_drawn(run, described):
            return None
        is_sealed = "seed" not in (episode.get("result") or {})
        if is_sealed and not self._films.settings.seed_secret():
            return None
        key = run["run_id"], episode["episode_id"]
        return self._films.find(key) or Film("", "none")

    async def draw_film(self, call: PageCall, _form: Mapping[str, str]) -> Response:
        run_id, episode_id = call.path("run_id"), call.path("episode_id")
        run = await call.api.get("runs", run_id)
        episodes = (await self._episodes(call, run)).all
        episode = episodes[_place(episodes, episode_id)]
        self._draw(call, run, episode, await _benchmark_of(call, run))
        address = call.links.episode(run_id, episode)
        query = call.request.url.query
        return RedirectResponse(
            f"{address}?{query}" if query else address, HTTPStatus.SEE_OTHER
        )

    def _films_of(
        self,
        call: PageCall,
        run: Document,
        episodes: Sequence[Document],
        described: Document | None,
    ) -> RunFilms:
        if self._films is None:
            return NO_FILMS
        states = {
            episode["episode_id"]: film.state
            for episode in episodes
            if (film := self._film_of(run, episode, described))
        }
        places = self._films.places_of(call.session.account)
        return RunFilms.of(states, episodes, places)

    async def draw_failures(self, call: PageCall, _form: Mapping[str, str]) -> Response:
        """Begin films of failures, as many as may wait now."""
        run_id = call.path("run_id")
        run = await call.api.get("runs", run_id)
        described = await _benchmark_of(call, run)
        episodes = (await self._episodes(call, run)).all
        films = self._films_of(call, run, episodes, described)
        for episode_id in films.undrawn[: films.drawable]:
            episode = episodes[_place(episodes, episode_id)]
            self._draw(call, run, episode, described)
        address = f"{call.links.run(run_id)}#episodes"
        return RedirectResponse(address, HTTPStatus.SEE_OTHER)

    async def draw_pair(self, call: PageCall, _form: Mapping[str, str]) -> Response:
        """The films of both sides."""
        runs = await self._runs_of_pair(call)
        for run in runs:
            episodes = (await self._episodes(call, run)).all
            episode = episodes[_place(episodes, call.query_id("episode"))]
            self._draw(call, run, episode, await _benchmark_of(call, run))
        address, _, _ = call.links.pair("", "", {"episode_id": ""}).partition("?")
        return RedirectResponse(
            f"{address}?{call.request.url.query}", HTTPStatus.SEE_OTHER
        )

    def _draw(
        self,
        call: PageCall,
        run: Document,
        episode: Document,
        described: Document | None,
    ) -> None:
        if self._films is None or self._film_of(run, episode, described) is None:
            raise Problem(404, "not_found", "Films of it are not drawn here.")
        self._films.start(
            (run["run_id"], episode["episode_id"]),
            call.session.account,
            call.api.stream("runs", run["run_id"], "record"),
            episode["index"],
            described,
        )

    async def fetch_film(self, call: PageCall) -> Response:
        """The video of a camera, by its number."""
        run_id, number = call.path("run_id"), call.path("number")
        await call.api.get("runs", run_id)  # still allowed
        key = run_id, call.path("episode_id")
        film = self._films.find(key) if self._films is not None else None
        files = film.files if film is not None else ()
        numbered = {str(index): path for index, (_, path) in enumerate(files)}
        if number not in numbered:
            text = "Such a film is not kept here. The page of the episode draws it."
            raise Problem(404, "not_found", text)
        headers = {"Cache-Control": "private, max-age=3600"}
        return FileResponse(numbered[number], media_type="video/mp4", headers=headers)

    async def show_comparison(self, call: PageCall) -> str:
        ids = (call.query_id("baseline"), call.query_id("run"))
        numbers = await call.api.get("comparisons", baseline=ids[0], runs=ids[1])
        baseline, run = [await call.api.get("runs", run_id) for run_id in ids]
        pairs = pair_episodes(
            (await self._episodes(call, baseline)).all,
            (await self._episodes(call, run)).all,
        )
        kind = call.query("kind")
        shown = [p for p in pairs if kind in ("", p.kind)] if kind in KINDS else pairs
        chosen = {"baseline": ids[0], "run": ids[1], "kind": kind}
        return page_contents.comparison_html(
            call.links, baseline, run, pairs, _window(call, shown, chosen),
            numbers=numbers["runs"][0], csrf=call.csrf,
        )  # fmt: skip

    async def show_several(self, call: PageCall) -> str:
        """Runs of one manifest, of which the address names two at least."""
        ids = list(dict.fromkeys(call.query_ids("run")))
        if not 2 <= len(ids) <= len(LETTERS):
            raise Problem(404, "not_found", f"Choose 2 to {len(LETTERS)} runs.")
        runs = []
        for run_id in ids:
            run = await call.api.get("runs", run_id)
            runs.append((run, (await self._episodes(call, run)).all))
        await _require_same_episodes(call, [run for run, _ in runs])
        return page_contents.several_html(call.links, runs, csrf=call.csrf)

    async def show_pair(self, call: PageCall) -> str:
        runs = await self._runs_of_pair(call)
        ids = runs[0]["run_id"], runs[1]["run_id"]
        sides, problems, lists = [], [], []
        for run in runs:
            lists.append((await self._episodes(call, run)).all)
            episode = lists[-1][_place(lists[-1], call.query_id("episode"))]
            recorded, problem = await self._recorded(call, run["run_id"], episode)
            recorded = recorded or RecordedEpisode()
            benchmark = await _benchmark_of(call, run)
            view = self._view(call, run, episode, recorded, benchmark)
            film = self._film_of(run, episode, benchmark)
            sides.append(Side(run, episode, recorded, view, film))
            problems += [problem] if problem else []
        kind = kind if (kind := call.query("kind")) in KINDS else ""
        query = f"&kind={kind}" if kind else ""
        closed = [p for p in pair_episodes(*lists) if p.kind != "open"]
        walked = [pair.run for pair in closed if kind in ("", pair.kind)]
        episode = sides[1].episode
        return page_contents.pair_html(
            call.links, sides, problem=" ".join(problems), csrf=call.csrf,
            neighbours=Neighbours.of(
                run_page.around(walked, episode["episode_id"]),
                lambda one: call.links.pair(*ids, one) + query,
            ),
            drawing=call.links.pair_films(*ids, episode) + query
            if any(side.film and side.film.state in ("none", "failed")
                   for side in sides)
            and all(side.film for side in sides)
            else "",
        )  # fmt: skip

    async def _runs_of_pair(self, call: PageCall) -> list[Document]:
        names = ("baseline", "run")
        runs = [await call.api.get("runs", call.query_id(name)) for name in names]
        await _require_same_episodes(call, runs)
        return runs

    def _view(
        self,
        call: PageCall,
        run: Document,
        episode: Document,
        recorded: RecordedEpisode,
        benchmark: Document | None,
    ) -> page_contents.PlayedView:
        run_id = run["run_id"]
        addresses = [
            call.links.picture(run_id, episode, number)
            for number in range(len(recorded.pictures))
        ]
        key = run_id, episode["episode_id"]
        film = self._films.find(key) if self._films is not None else None
        address = call.links.film(run_id, episode)
        videos = [
            ShownVideo(camera, f"{address}/{number}")
            for number, (camera, _) in enumerate(film.files if film else ())
        ]
        return played_view(recorded, addresses, videos, benchmark=benchmark)

    async def _episodes(self, call: PageCall, run: Document) -> _EpisodeList:
        """All episodes of a run. Those of a completed run are kept for a while.

        The run was just read with the same token, so it may be shown.
        """
        key = (call.session.token, run["run_id"], run["updated_at"])
        if (kept := self._lists.get(key)) is not None:
            self._lists.move_to_end(key)
            return kept
        episodes: list[Document] = []
        path = ("runs", run["run_id"], "episodes")
        async for page in call.api.pages(*path, limit=EPISODES_PER_CALL):
            episodes += page["episodes"]
        listed = _EpisodeList(episodes)
        if run["state"] == "completed":
            _keep(self._lists, key, listed, LISTS_KEPT)
        return listed

    async def _recorded(
        self, call: PageCall, run_id: str, episode: Mapping[str, Any]
    ) -> tuple[RecordedEpisode | None, str]:
        """The recording, or None and why there is none to show."""
        if not episode.get("result"):
            return None, "It is recorded, and shown here when it has a result."
        episode_id = episode["episode_id"]
        key = (call.session.token, run_id, episode_id)
        if (kept := self._recordings.get(key)) is not None:
            await call.api.get("runs", run_id)  # still allowed
            return kept, ""
        try:
            path = ("runs", run_id, "episodes", episode_id, "recording")
            data = await call.api.read(*path)
            recorded = await asyncio.to_thread(
                read_recorded_episode, io.BytesIO(data), len(data), episode_id
            )
        except Problem as problem:
            return None, f"The recording cannot be shown: {problem.detail}"
        except BrokenRecord as broken:
            return None, f"The recording cannot be read: {broken.detail}"
        _keep(self._recordings, key, recorded, RECORDINGS_KEPT)
        return recorded, ""


def _keep(cache: OrderedDict[Any, Any], key: Any, value: Any, most: int) -> None:
    cache[key] = value
    while len(cache) > most:
        cache.popitem(last=False)


def _fits(run: Document, selected: Mapping[str, str]) -> bool:
    return (
        selected["benchmark"] in run["benchmark_id"]
        and selected["policy"].lower() in run["policy"]["name"].lower()
        and selected["state"] in ("", run["state"])
    )


def _selected(
    call: PageCall, figures: RunFigures
) -> tuple[list[Document], dict[str, str]]:
    """The episodes that the address selects, failures first, and by which values."""
    selected = {name: call.query(name) for name in ("outcome", "task", "split")}
    fitting = [
        episode
        for episode in figures.ordered
        if selected["outcome"] in ("", status_of(episode))
        and selected["task"] in ("", episode["task"])
        and selected["split"] in ("", episode["split"])
    ]
    return fitting, selected


def _window(
    call: PageCall, rows: Sequence[Any], selected: Mapping[str, str], anchor: str = ""
) -> Window:
    pages = max(1, -(-len(rows) // ROWS))
    if call.page > pages:
        raise Problem(404, "not_found", "There is no such page.")
    start = (call.page - 1) * ROWS
    addresses = [
        (number, f"?{urlencode({**selected, 'page': number})}{anchor}")
        for number in _near(call.page, pages)
    ]
    part = rows[start : start + ROWS]
    return Window(part, len(rows), call.page, addresses, selected=selected)


async def _scores(call: PageCall, runs: Sequence[Document]) -> dict[str, Document]:
    """By run id, of the runs that have a result; one that is deleted has none."""
    scores = {}
    for run in runs:
        if run["progress"]["episodes_scored"]:
            with contextlib.suppress(Problem):
                scores[run["run_id"]] = await call.api.get(
                    "runs", run["run_id"], "score"
                )
            await asyncio.sleep(0)  # turns are played between two runs
    return scores


async def _require_same_episodes(call: PageCall, runs: Sequence[Document]) -> None:
    """The refusal of the API says in which members the manifests differ."""
    baseline, *others = runs
    for run in others:
        if run["manifest_sha256"] != baseline["manifest_sha256"]:
            ids = {"baseline": baseline["run_id"], "runs": run["run_id"]}
            await call.api.get("comparisons", **ids)
            raise Problem(409, "not_comparable", "The runs have different manifests.")


def _near(page: int, pages: int) -> list[int]:
    """The first and the last, and some around this one."""
    near = {1, pages, *range(page - 3, page + 4)}
    return sorted(number for number in near if 1 <= number <= pages)


def _place(episodes: Sequence[Document], episode_id: str) -> int:
    for place, episode in enumerate(episodes):
        if episode["episode_id"] == episode_id:
            return place
    raise Problem(404, "not_found", "The run has no such episode.")


async def _benchmark_of(call: PageCall, run: Document) -> Document | None:
    """The benchmark of the run in its version; None if it is no longer offered."""
    try:
        benchmark: Document = await call.api.get("benchmarks", run["benchmark_id"])
    except Problem:
        return None
    return benchmark if benchmark.get("version") == run["benchmark_version"] else None
