"""The pages in this process, over an API that answers for runs in memory.

Its documents are those of the server's own views; what was requested is counted.
"""

import asyncio
from collections import Counter
from collections.abc import AsyncIterator, Awaitable, Callable, Mapping
from contextlib import asynccontextmanager
from typing import Any

import httpx
from starlette.applications import Starlette
from starlette.requests import Request
from starlette.responses import JSONResponse, Response
from starlette.types import Receive, Scope, Send

from reference_server.http.pages.films import FilmSettings
from reference_server.http.pages.page_routes import Pages, TakeToken
from reference_server.rules.runs.run import Result, Run
from reference_server.settings.allowed_hosts import ANY_HOST
from reference_server.views.run_views import episode_view, run_view, score_view
from tests.support.pages.page_reader import fields_of
from tests.support.server.server_parts import calibration_run

ENTRIES_PER_PAGE = 2
RESULT = Result("success", 1.0, 1, 1, True, False, 0.0, 1e9)
FAILURE = Result("failure", 0.0, 1, 1, True, False, 0.0, 1e9)
EMPTY_RANKING: Mapping[str, Any] = {
    "manifest_sha256": "0" * 64,
    "episodes_total": None,
    "ranked": 0,
    "alpha": 0.05,
    "rows": [],
    "next_cursor": None,
}


class PageApi:
    """An ASGI application. runs: by id, with the tokens that may read them. asked: how
    often each path was requested. changed: by token, what its answers about episodes
    have besides. entries: of the leaderboard; one that is withdrawn is in no list.
    before: awaited first by the answer to a path, if it is there. described: what a
    benchmark has besides; without its version it is not that of a run."""

    def __init__(self) -> None:
        self.runs: dict[str, tuple[Run, set[str]]] = {}
        self.asked: Counter[str] = Counter()
        self.changed: dict[str, dict[str, Any]] = {}
        self.entries: list[Mapping[str, Any]] = []
        self.described: dict[str, Any] = {}
        self.before: dict[str, Callable[[], Awaitable[object]]] = {}

    def publish(self, run_id: str, **members: Any) -> dict[str, Any]:
        """The entry of a run, with what of it the pages show."""
        entry = {
            "entry_id": f"entry_{run_id}",
            "run_id": run_id,
            "model_name": "m",
            "is_public": True,
            "state": "published",
            "manifest_sha256": "1" * 64,
            **members,
        }
        self.entries.append(entry)
        return entry

    def add(self, run_id: str, *results: Result | None, tokens: str = "alice") -> Run:
        """A run of `calibration`, completed if each episode has a result."""
        state = "running" if None in results else "completed"
        run = calibration_run(*["score"] * len(results), run_id=run_id, state=state)
        for episode, result in zip(run.episodes, results, strict=True):
            if result is not None:
                run.record_result(episode, result)
        self.runs[run_id] = run, set(tokens.split())
        return run

    async def entry_id_of_run(self, run_id: str) -> str | None:
        ids = (one["entry_id"] for one in self.entries if one["run_id"] == run_id)
        return next(ids, None)

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        request = Request(scope)
        path = request.url.path.removeprefix("/v1/")
        self.asked[path] += 1
        if path in self.before:
            await self.before[path]()
        token = request.headers["authorization"].removeprefix("Bearer ")
        start = int(request.query_params.get("cursor", 0))
        answer = self._answer(path.split("/"), token, start)
        await answer(scope, receive, send)

    def _answer(self, path: list[str], token: str, start: int) -> Response:
        match path:
            case ["runs"]:
                of_token = [run for run, may in self.runs.values() if token in may]
                shown = [run_view(run, "http://server", None) for run in of_token]
                return JSONResponse({"runs": shown, "next_cursor": None})
            case ["entries" | "benchmarks", *_]:
                return self._about_board(path, start)
            case ["runs", run_id, *rest] if token in self.runs.get(run_id, ("", ()))[1]:
                return self._about(self.runs[run_id][0], rest, token)
        problem = {"code": "not_found", "detail": "There is no such thing."}
        return JSONResponse(problem, 404)

    def _about_board(self, path: list[str], start: int) -> Response:
        match path:
            case ["entries"]:
                listed = [one for one in self.entries if not _is_withdrawn(one)]
                end = start + ENTRIES_PER_PAGE
                following = str(end) if listed[end:] else None
                page = listed[start:end]
                return JSONResponse({"entries": page, "next_cursor": following})
            case ["entries", entry_id]:
                (entry,) = (e for e in self.entries if e["entry_id"] == entry_id)
                return JSONResponse(entry)
            case ["benchmarks", benchmark_id]:
                named = {"benchmark_id": benchmark_id, "title": benchmark_id}
                return JSONResponse(named | {"control_rate_hz": 10.0} | self.described)
            case ["benchmarks", _, "ranking"]:
                return JSONResponse(EMPTY_RANKING)
        raise AssertionError(f"no page needs {path}")

    def _about(self, run: Run, rest: list[str], token: str) -> Response:
        match rest:
            case []:
                return JSONResponse(run_view(run, "http://server", None))
            case ["score"]:
                return JSONResponse(score_view(run, run.episodes))
            case ["episodes"]:
                more = self.changed.get(token, {})
                shown = [episode_view(one) | more for one in run.episodes]
                return JSONResponse({"episodes": shown, "next_cursor": None})
        return Response(b"a recording")


def _is_withdrawn(entry: Mapping[str, Any]) -> bool:
    return bool(entry["state"] == "withdrawn")


def client_of(
    api: PageApi,
    *,
    films: FilmSettings | None = None,
    take_token: TakeToken | None = None,
    url: str = "http://server",
) -> httpx.AsyncClient:
    """A browser without scripts, of pages over this API."""
    found = api.entry_id_of_run
    pages = Pages(
        api, ANY_HOST, account_of=str, find_entry_id=found, films=films,
        url_of=lambda _request: url, take_token=take_token,
    )  # fmt: skip
    app = Starlette(routes=pages.routes())
    transport = httpx.ASGITransport(app)
    return httpx.AsyncClient(transport=transport, base_url=url)


async def sign_in(client: httpx.AsyncClient, token: str) -> None:
    client.cookies.clear()
    form = fields_of((await client.get("/pages/login")).text) | {"token": token}
    answer = await client.post("/pages/login", data=form)
    assert answer.status_code == 303, answer.text


class Gate:
    """Holds calls until it is opened."""

    def __init__(self) -> None:
        self.reached, self._opened = asyncio.Event(), asyncio.Event()

    async def __call__(self) -> None:
        self.reached.set()
        await self._opened.wait()

    def open(self) -> None:
        self._opened.set()


@asynccontextmanager
async def signed_in() -> AsyncIterator[tuple[PageApi, httpx.AsyncClient]]:
    """With a reader whose token is `alice`."""
    api = PageApi()
    async with client_of(api) as client:
        await sign_in(client, "alice")
        yield api, client


async def text_of(client: httpx.AsyncClient, path: str) -> str:
    """The HTML of a page that is there."""
    answer = await client.get(path)
    assert answer.status_code == 200, answer.text
    return answer.text
