"""Mutants that break behind the tenth or the hundredth of anything: lists and sums."""

from __future__ import annotations

import json
import math
from typing import Any

from starlette.responses import Response

from reference_server.http import handlers
from reference_server.http.dispatch import OperationCall
from reference_server.http.handlers import Handlers
from reference_server.rules import comparison, scoring
from reference_server.rules.run import Episode, Run
from reference_server.runs import benchmarks
from reference_server.storage.store import Store
from reference_server.views import run_views
from tests.mutants import mutant, put


@mutant("RUN-025")
def lists_everything_without_a_limit() -> None:
    """A page that shows the newest runs loads all of them."""
    put(handlers, "PAGE", 1000)


@mutant("RUN-009")
def names_no_page_for_the_last_run() -> None:
    """The oldest run is missing in every list that is read page by page."""
    right = Handlers.list_runs

    async def wrong(self: Handlers, call: OperationCall) -> Response:
        response = await right(self, call)
        page = json.loads(bytes(response.body))
        if page["next_cursor"] is not None:
            before = int(page["next_cursor"])
            rest = await self.service.list_runs(call.reader, before, 2, "")
            if len(rest) == 1:
                return call.answer(page | {"next_cursor": None})
        return response

    put(Handlers, "list_runs", wrong)


def _end_pages_with(cursor: str, operation: str) -> None:
    right = getattr(Handlers, operation)

    async def wrong(self: Handlers, call: OperationCall) -> Response:
        page = json.loads(bytes((await right(self, call)).body))
        return call.answer(page | {"next_cursor": page["next_cursor"] or cursor})

    put(Handlers, operation, wrong)


@mutant("RUN-009")
def never_ends_the_pages_of_runs() -> None:
    """A script that reads all pages reads empty ones for ever."""
    _end_pages_with("0", "list_runs")


@mutant("SVC-003", "RUN-009")
def ends_the_pages_of_runs_with_an_empty_cursor() -> None:
    """A script that reads until null asks for a page with no cursor: the first one."""
    _end_pages_with("", "list_runs")


@mutant("EPI-006")
def never_ends_the_pages_of_episodes() -> None:
    """A script that reads all pages reads empty ones for ever."""
    _end_pages_with("1000000", "list_episodes")


@mutant("EPI-006")
def sorts_episodes_as_text() -> None:
    """In a run of more than a hundred episodes the hundredth is listed as the third."""
    right = Run.window

    def wrong(self: Run, start: int, end: int | None, scored: bool) -> list[Episode]:
        if scored or len(self.episodes) < 100:
            return right(self, start, end, scored)
        return sorted(self.episodes, key=lambda e: str(e.index))[start:end]

    put(Run, "window", wrong)


@mutant("EPI-001")
def hands_episodes_out_as_text_sorts_them() -> None:
    """Partial scores of two servers cover different episodes."""

    def wrong(self: Run) -> Episode | None:
        if not self.pending:
            return None
        index = min(self.pending, key=str)
        self.pending.remove(index)
        episode = self.episodes[index]
        episode.in_progress = True
        return episode

    put(Run, "take_pending", wrong)


@mutant("RUN-024")
def numbers_episodes_with_two_digits() -> None:
    """Results of two episodes are filed under one id."""
    put(Episode, "episode_id", property(lambda self: f"e{self.index % 100:02d}"))


@mutant("SCORE-006", "SCORE-008", "SCORE-011")
def scores_the_first_page() -> None:
    """The last eighty of a hundred and eighty episodes count for nothing."""
    put(run_views, "score_of", lambda episodes: scoring.score_of(episodes[:100]))


@mutant("BEN-005")
def hashes_the_first_hundred_episodes() -> None:
    """Runs of different episodes are compared as if they were the same."""
    right = benchmarks.digest

    def wrong(manifest: Any) -> str:
        episodes = manifest["episodes"]
        if len(episodes) <= 100:
            return right(manifest)
        hashed = {**manifest, "episodes": episodes[:100], "total": len(episodes)}
        return right(hashed)

    put(benchmarks, "digest", wrong)


@mutant("SCORE-012", "SCORE-013")
def approximates_intervals_of_many_episodes() -> None:
    """The interval of a long run is narrower than it may be."""
    right = scoring.wilson

    def wrong(rate: float | None, n: int) -> dict[str, float]:
        if rate is None or n <= 30:
            return right(rate, n)
        half = 1.96 * math.sqrt(rate * (1 - rate) / n)
        return {"low": max(0.0, rate - half), "high": min(1.0, rate + half)}

    put(scoring, "wilson", wrong)


@mutant("RUN-009")
def lists_the_run_that_changed_last_first() -> None:
    """A run that changes between two pages is missing from the list."""
    import sqlalchemy as sa

    from reference_server.storage import store
    from reference_server.storage.database_tables import runs

    async def wrong(
        self: Store, account: str, before: int | None, limit: int
    ) -> list[tuple[int, str]]:
        query = sa.select(runs.c.number, runs.c.run_id)
        query = query.where(store._IS_THERE, runs.c.account == account)
        if before is not None:
            query = query.where(runs.c.number < before)
        query = query.order_by(runs.c.updated_at_wall.desc()).limit(limit)
        return await self.read(lambda found: [(n, r) for n, r in found.execute(query)])

    put(Store, "page", wrong)


@mutant("CMP-007")
def computes_the_p_value_with_factorials() -> None:
    """Two policies that differ in two hundred episodes seem to be equal."""

    def wrong(wins: int, losses: int) -> float:
        n, fewer = wins + losses, min(wins, losses)
        try:
            ways = [
                math.gamma(n + 1) / math.gamma(k + 1) / math.gamma(n - k + 1)
                for k in range(fewer + 1)
            ]
        except OverflowError:
            return 1.0
        return min(1.0, 2 * sum(ways) / 2.0**n)

    put(comparison, "mcnemar", wrong)


@mutant("CMP-005", "CMP-006", "CMP-007")
def pairs_episodes_in_the_order_of_scoring() -> None:
    """With two workers, episodes are compared with others than themselves."""

    def wrong(episodes: Any) -> Any:
        return right(sorted(episodes, key=lambda e: e.place or math.inf))

    right = run_views.scored_episodes
    put(run_views, "scored_episodes", wrong)


@mutant("RUN-009")
def leaves_out_a_run_behind_a_long_page() -> None:
    """A script that reads long pages misses a run at the end of each."""
    right = Handlers.list_runs

    async def wrong(self: Handlers, call: OperationCall) -> Response:
        page = json.loads(bytes((await right(self, call)).body))
        if page["next_cursor"] is not None and 50 <= len(page["runs"]) < 100:
            number = int(page["next_cursor"])
            found = await self.service.list_runs(call.reader, number, 1, "")
            page["next_cursor"] = str(found[0][0])
        return call.answer(page)

    put(Handlers, "list_runs", wrong)
