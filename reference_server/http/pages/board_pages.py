"""The leaderboard of a benchmark, and the forms that publish a run and withdraw it.

It shows `get_ranking` as it is: who is ranked, and where, is decided elsewhere.
"""

from __future__ import annotations

import csv
import io
from collections import Counter
from collections.abc import Awaitable, Callable, Mapping, Sequence
from http import HTTPStatus
from typing import Any

import msgspec
from starlette.responses import RedirectResponse, Response

from reference_record.generated import answers
from reference_record.pages.page_contents import LEVELS
from reference_record.pages.page_templates import render_page
from reference_record.pages.run_page import Document
from reference_record.pages.spreadsheet_cells import as_cell
from reference_server.http.pages.api_documents import ApiDocuments, Problem
from reference_server.http.pages.page_calls import PageCall
from reference_server.storage.runs.run_store import StoreFailed

# The id of a run's entry, withdrawn or not; None: it has none.
FindEntryId = Callable[[str], Awaitable[str | None]]
ROWS_MAX = 1000
MANIFESTS_MAX = 20
_TEXTS = (
    *("model_name", "model_type", "organisation"),
    *("homepage", "code_url", "notes"),
)
# Name → what rows are sorted by; the ranking's own order is that of the first.
_SORTS: Mapping[str, Callable[[Mapping[str, Any]], Any]] = {
    "rank": lambda _row: 0,
    "success": lambda row: -row["entry"]["score"]["success_rate"],
    "model": lambda row: row["entry"]["model_name"].lower(),
    "submitter": lambda row: row["entry"]["submitter"].lower(),
    "runs": lambda row: row["entry"]["attempts"],
    "newest": lambda row: _reversed(row["entry"]["published_at"]),
}
# Parts of a score, and what a column of a spreadsheet calls one of them.
_GROUPS = {"by_task": "task", "by_split": "split"}


def _reversed(text: str) -> list[int]:
    """Sorts times the newest first: RFC 3339 in UTC, all of one length."""
    return [-ord(letter) for letter in text]


async def show_leaderboard(call: PageCall) -> str:
    benchmark, ranking = await _ranking(call)
    selected = {name: call.query(name) for name in ("text", "sort", "manifest")}
    if selected["sort"] not in _SORTS:
        selected["sort"] = "rank"
    rows = [row for row in ranking["rows"] if _has(row["entry"], selected["text"])]
    rows.sort(key=_SORTS[selected["sort"]])
    others: list[tuple[str, int]] = []
    is_part = False
    if not ranking["rows"]:
        others, is_part = await _other_manifests(call)
    return render_page(
        "board/leaderboard", call.links, csrf=call.csrf, benchmark=benchmark,
        ranking=ranking,
        rows=rows, selected=selected, sorts=list(_SORTS),
        others=others, newest=ROWS_MAX if is_part else None,
        groups={kind: names for kind in _GROUPS if (names := _names(rows, kind))[1:]},
    )  # fmt: skip


async def send_leaderboard(call: PageCall) -> Response:
    """The same as JSON or CSV."""
    benchmark, ranking = await _ranking(call)
    form = call.request.path_params["form"]
    name = f'attachment; filename="{benchmark["benchmark_id"]}.{form}"'
    headers = {"Content-Disposition": name}
    if form == "json":
        body = msgspec.json.encode(ranking)
        return Response(body, media_type="application/json", headers=headers)
    if form != "csv":
        raise Problem(404, "not_found", "There is no such page.")
    return Response(_csv(ranking), media_type="text/csv", headers=headers)


async def _ranking(call: PageCall) -> tuple[Document, answers.Ranking]:
    benchmark_id = call.path("benchmark_id")
    chosen: dict[str, object] = {"limit": ROWS_MAX}
    if manifest := call.query("manifest"):
        chosen["manifest_sha256"] = manifest
    ranking = await call.api.get("benchmarks", benchmark_id, "ranking", **chosen)
    try:
        benchmark = await call.api.get("benchmarks", benchmark_id)
    except Problem as problem:
        # A public leaderboard is read without a token, a benchmark is not.
        if problem.status != HTTPStatus.UNAUTHORIZED:
            raise
        benchmark = {"benchmark_id": benchmark_id, "title": benchmark_id}
    return benchmark, ranking


async def _other_manifests(call: PageCall) -> tuple[list[tuple[str, int]], bool]:
    """Manifests of the benchmark that have public entries, and how many each has.

    Counted are the newest entries, one page of them; also returned is whether there are
    more. Any reader may ask for any manifest, so a large leaderboard is not read whole.
    """
    benchmark_id = call.path("benchmark_id")
    page = await call.api.get("entries", benchmark_id=benchmark_id, limit=ROWS_MAX)
    public = [
        entry["manifest_sha256"] for entry in page["entries"] if entry["is_public"]
    ]
    return Counter(public).most_common(MANIFESTS_MAX), page["next_cursor"] is not None


def _names(rows: Sequence[Mapping[str, Any]], kind: str) -> list[str]:
    """The tasks or splits of the entries; entries of older servers have none."""
    shown = (row["entry"]["score"].get(kind, {}) for row in rows)
    return list(dict.fromkeys(name for scores in shown for name in scores))


def _has(entry: Mapping[str, Any], text: str) -> bool:
    names = ("model_name", "model_type", "organisation", "submitter", "level")
    return any(text.lower() in str(entry.get(name, "")).lower() for name in names)


def _csv(ranking: Mapping[str, Any]) -> str:
    out = io.StringIO()
    writer = csv.writer(out)
    rows = ranking["rows"]
    groups = [(kind, name) for kind in _GROUPS for name in _names(rows, kind)]
    columns = [f"success_rate {_GROUPS[kind]} {name}" for kind, name in groups]
    names = ("submitter", "model_name", "model_type", "organisation", "level")
    more = (
        *("attempts", "published_at", "homepage", "code_url"),
        *("run_id", "manifest_sha256"),
    )
    writer.writerow(
        ["rank_low", "rank_high", "letters", "score", "success_rate", "success_low",
         "success_high", "episodes", *names, *more, "flag", *map(as_cell, columns)]
    )  # fmt: skip
    for row in rows:
        entry, rank = row["entry"], row.get("rank") or {}
        score = entry["score"]
        interval = score["success_interval"]
        values = [
            rank.get("low"), rank.get("high"), " ".join(row["letters"]),
            score["score"], score["success_rate"], interval["low"], interval["high"],
            score["counts"]["total"], *(entry.get(name) for name in (*names, *more)),
            (entry.get("flag") or {}).get("reason"),
            *(
                score.get(kind, {}).get(name, {}).get("success_rate")
                for kind, name in groups
            ),
        ]  # fmt: skip
        writer.writerow([as_cell(value) for value in values])
    return out.getvalue()


async def has_leaderboard(api: ApiDocuments, benchmark_id: str) -> bool:
    """Whether its page links to one; calibration ranks no policies for people."""
    if benchmark_id == "calibration":
        return False
    try:
        await api.get("benchmarks", benchmark_id, "ranking", limit=1)
    except Problem:
        return False
    return True


async def find_entry(
    api: ApiDocuments, run: Mapping[str, Any], find_entry_id: FindEntryId | None
) -> tuple[bool, Mapping[str, Any] | None]:
    """Whether the run may have an entry here, and the one that it has, or had.

    No list has an entry that was withdrawn; whether this reader may see it, the API
    decides. find_entry_id: None if there is no leaderboard.
    """
    if find_entry_id is None or run["state"] != "completed":
        return False, None
    try:
        entry_id = await find_entry_id(run["run_id"])
        return True, None if entry_id is None else await api.get("entries", entry_id)
    except (Problem, StoreFailed):  # the page is shown without it
        return False, None


async def level_of(
    api: ApiDocuments, score: Mapping[str, Any], entry: Mapping[str, Any] | None
) -> str:
    """The level of the score of a run, as its entry says it or would say it."""
    if entry is not None and entry.get("level") in LEVELS:
        return str(entry["level"])
    try:
        profiles = (await api.get())["profiles"]
    except Problem:
        profiles = ()
    return "signed" if score["complete"] and "record" in profiles else "reported"


async def publish(call: PageCall, form: Mapping[str, str]) -> Response:
    """Publish the entry of the form on the page of a run; the API checks it."""
    run_id = call.path("run_id")
    body: dict[str, object] = {
        name: value.strip() for name in _TEXTS if (value := form.get(name, "")).strip()
    }
    body["is_public"] = form.get("is_public") == "yes"
    await call.api.send("PUT", "runs", run_id, "entry", body=body)
    return _back(call, run_id)


async def withdraw(call: PageCall, form: Mapping[str, str]) -> Response:
    run_id = call.path("run_id")
    if form.get("sure") != "yes":
        raise Problem(400, "invalid_request", "Say that you are sure.")
    await call.api.send("DELETE", "runs", run_id, "entry")
    return _back(call, run_id)


def _back(call: PageCall, run_id: str) -> Response:
    return RedirectResponse(f"{call.links.run(run_id)}#entry", HTTPStatus.SEE_OTHER)
