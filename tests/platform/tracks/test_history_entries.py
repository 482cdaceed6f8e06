"""Entries of results: flags, which exclude them (HST-044), and their leaderboards."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Any

import httpx
import msgspec
import pytest

from reference_platform.pages.form_calls import COOKIE
from reference_platform.parts import Parts
from reference_platform.tracks.history_entries import HistoryLeaf
from reference_platform.tracks.results import Ranking
from reference_platform.tracks.track_rules import Phase, Ranks, Track, TrackRun
from reference_server.rules.refusal import Refused
from tests.support.platform.approved_accounts import approved
from tests.support.platform.read_runs import ShownRuns

PHASE = Phase("test", "calibration", 0.0, 1.0)
TRACK = Track("letters", "Letters", (PHASE,))


async def make_results(parts: Parts, **scores: float) -> ShownRuns:
    """A run of each account, which has the entry `entry_ACCOUNT`."""
    parts.tracks.put(TRACK, "a test")
    reader = ShownRuns()
    for at, (account, score) in enumerate(scores.items()):
        await approved(parts, account)
        run = TrackRun(
            f"run_{account}", "letters", account, at, "completed", score, "test", ""
        )
        parts.database.insert("track_runs", run)
        add_leaf(reader, "publish", account, run_id=run.run_id, manifest_sha256="m")
    await parts.results.entries.refresh(reader)
    return reader


def add_leaf(reader: ShownRuns, kind: str, account: str, **members: str) -> None:
    leaf: dict[str, Any] = {"kind": kind, "entry_id": f"entry_{account}", **members}
    reader.leaves.append(msgspec.json.encode(leaf).decode())


def ranking(parts: Parts) -> Ranking:
    return parts.results.ranking(TRACK, PHASE, [])


def order(parts: Parts) -> list[tuple[str, str | None]]:
    rows = [one.stored for one in ranking(parts).leading]
    return [(row.owner, row.excluded) for row in rows]


async def test_a_flagged_result_is_behind_the_others_until_it_is_unflagged(
    parts: Parts,
) -> None:
    reader = await make_results(parts, ada=0.25, eve=0.75)
    add_leaf(reader, "draw", "nothing")
    add_leaf(reader, "flag", "eve", reason="trained on it")
    await parts.results.entries.refresh(reader)
    assert order(parts) == [("ada", None), ("eve", "flagged")]
    assert ranking(parts).leading[1].stored.flag == "trained on it"
    for kind in ("hide", "publish", "withdraw"):  # they leave a flag as it is
        add_leaf(reader, kind, "eve", run_id="run_eve", manifest_sha256="m")
        await parts.results.entries.refresh(reader)
        assert order(parts)[1] == ("eve", "flagged")
    add_leaf(reader, "unflag", "eve", reason="")
    await parts.results.entries.refresh(reader)
    assert order(parts) == [("ada", None), ("eve", "withdrawn")]


@pytest.mark.parametrize(("ranks", "stands"), [("best", None), ("last", "withdrawn")])
async def test_a_withdrawn_result_yields_to_others_but_not_to_earlier_ones(
    parts: Parts, ranks: Ranks, stands: str | None
) -> None:
    """With `last`, a withdrawal would choose the best of several. Expect no rank."""
    reader = await make_results(parts, eve=0.75, ada=0.5)
    other = TrackRun("run_2", "letters", "eve", -1, "completed", 0.6, "test", "")
    parts.database.insert("track_runs", other)
    add_leaf(reader, "withdraw", "eve")
    await parts.results.entries.refresh(reader)
    phase = msgspec.structs.replace(PHASE, ranks=ranks)
    rows = parts.results.ranking(TRACK, phase, []).leading
    excluded = {one.stored.owner: one.stored.excluded for one in rows}
    assert excluded == {"ada": None, "eve": stands}


async def test_the_results_of_a_suspended_account_have_no_rank_until_it_is_back(
    parts: Parts,
) -> None:
    await make_results(parts, ada=0.25, eve=0.75)
    parts.accounts.decide("eve", "suspend", "a reason", "host")
    assert order(parts) == [("ada", None), ("eve", "suspended")]
    parts.accounts.decide("eve", "reinstate", "", "host")
    assert order(parts) == [("eve", None), ("ada", None)]


async def test_another_result_of_the_entrant_comes_before_a_flagged_one(
    parts: Parts,
) -> None:
    reader = await make_results(parts, eve=0.75, ada=0.5)
    other = TrackRun("run_2", "letters", "eve", 9, "completed", 0.25, "test", "")
    parts.database.insert("track_runs", other)
    add_leaf(reader, "flag", "eve", reason="trained on it")
    await parts.results.entries.refresh(reader)
    assert order(parts) == [("ada", None), ("eve", None)]
    (flagged,) = ranking(parts).others
    assert (flagged.stored.result_id, flagged.stored.excluded) == ("run_eve", "flagged")


async def test_a_server_that_was_restored_has_another_history(parts: Parts) -> None:
    """The flag was set after the backup. Expect what the history says now."""
    reader = await make_results(parts, eve=0.75)
    add_leaf(reader, "flag", "eve", reason="trained on it")
    await parts.results.entries.refresh(reader)
    del reader.leaves[1:]
    for leaves, excluded in (([], None), (["flag"], "flagged")):
        for kind in leaves:
            add_leaf(reader, kind, "eve", reason="something else")
        await parts.results.entries.refresh(reader)
        assert order(parts) == [("eve", excluded)]
    (board,) = parts.results.entries.boards_of("letters", "test")
    assert (board.manifest_sha256, board.entries) == ("m", 1)
    reader.leaves.clear()
    await parts.results.entries.refresh(reader)
    assert parts.results.entries.boards_of("letters", "test") == []


class LostServer(ShownRuns):
    """The server is lost at a page of its history. parts: what it shows until then."""

    def __init__(self, parts: Parts, leaves: list[str], lost_at: int) -> None:
        super().__init__()
        self.parts, self.leaves, self.lost_at = parts, leaves, lost_at
        self.orders: list[list[tuple[str, str | None]]] = []

    async def read_leaves(self, start: int) -> Sequence[HistoryLeaf] | None:
        self.orders.append(order(self.parts))
        if len(self.orders) == self.lost_at:
            raise Refused("unavailable", "The server is lost.")
        return await super().read_leaves(start)


async def test_a_flag_stays_until_another_history_was_read_to_its_end(
    parts: Parts,
) -> None:
    """The server without the flag is lost at each page in turn, and at last not."""
    reader = await make_results(parts, ada=0.25, eve=0.75)
    add_leaf(reader, "flag", "eve", reason="trained on it")
    await parts.results.entries.refresh(reader)
    add_leaf(reader, "draw", "nothing")
    del reader.leaves[2]
    flagged = [("ada", None), ("eve", "flagged")]
    for lost_at in (1, 2, 3, 4):
        lost = LostServer(parts, reader.leaves, lost_at)
        with pytest.raises(Refused):
            await parts.results.entries.refresh(lost)
        assert lost.orders == [flagged] * lost_at
        assert order(parts) == flagged
    await parts.results.entries.refresh(reader)
    assert order(parts) == [("eve", None), ("ada", None)]


async def test_a_flag_stays_while_the_server_has_no_leaderboard(parts: Parts) -> None:
    """Expect what was noted, and the leaves that came meanwhile when it is back."""
    reader = await make_results(parts, ada=0.25, eve=0.75)
    add_leaf(reader, "flag", "eve", reason="trained on it")
    await parts.results.entries.refresh(reader)
    reader.has_leaderboard = False
    add_leaf(reader, "unflag", "eve", reason="")
    await parts.results.entries.refresh(reader)
    assert order(parts) == [("ada", None), ("eve", "flagged")]
    reader.has_leaderboard = True
    await parts.results.entries.refresh(reader)
    assert order(parts) == [("eve", None), ("ada", None)]


async def test_a_phase_leads_to_the_leaderboards_of_its_entries(
    parts: Parts, client: httpx.AsyncClient
) -> None:
    """One of two entries is withdrawn; then a third has another manifest."""
    reader = await make_results(parts, ada=0.25, eve=0.75)
    client.cookies.set(COOKIE.name, parts.sessions.begin("ada", parts.clock()))

    async def shown() -> list[tuple[str, str]]:
        page = (await client.get("/hosting/tracks/letters")).text
        link = r'calibration/leaderboard\?manifest=(\w+)">([^<]+)</a>([^<]*)'
        return [(sha256, f"{a}{b}") for sha256, a, b in re.findall(link, page)]

    assert await shown() == [("m", "2 entries")]
    add_leaf(reader, "withdraw", "eve")
    await parts.results.entries.refresh(reader)
    assert await shown() == [("m", "1 entry")]
    run = TrackRun("run_2", "letters", "eve", 9, "completed", 0.25, "test", "")
    parts.database.insert("track_runs", run)
    add_leaf(reader, "publish", "kim", run_id="run_2", manifest_sha256="n")
    await parts.results.entries.refresh(reader)
    assert await shown() == [("m", "1 entry, "), ("n", "1 entry of another manifest")]
    add_leaf(reader, "hide", "kim")
    add_leaf(reader, "withdraw", "ada")
    await parts.results.entries.refresh(reader)
    assert await shown() == []


async def test_the_page_says_why_a_result_has_no_rank(
    parts: Parts, client: httpx.AsyncClient
) -> None:
    reader = await make_results(parts, ada=0.25, eve=0.75, lee=0.6, kim=0.5)
    add_leaf(reader, "flag", "eve", reason="<b>trained</b>")
    add_leaf(reader, "withdraw", "lee")
    await parts.results.entries.refresh(reader)
    parts.accounts.decide("kim", "suspend", "a reason", "host")
    client.cookies.set(COOKIE.name, parts.sessions.begin("ada", parts.clock()))
    page = (await client.get("/hosting/tracks/letters")).text
    results = page.partition('id="results"')[2]
    places = [
        results.index(text)
        for text in (
            ">ada<",
            "no rank, flagged: &lt;b&gt;trained&lt;/b&gt;",
            "no rank: withdrawn from the leaderboard",
            "no rank: the account is suspended",
            "Results without a rank stand behind the others.",
        )
    ]
    assert places == sorted(places)
    assert "a reason" not in results
