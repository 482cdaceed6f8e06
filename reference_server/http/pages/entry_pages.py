"""The pages of one entry, of the history of all of them, and of imported records.

They show what the API answers: an entry that its reader may not see is not found.
"""

from __future__ import annotations

from typing import Any
from urllib.parse import urlencode

import msgspec

from reference_record.formats.names import record_file_name
from reference_record.pages.page_templates import render_page
from reference_record.pages.run_page import Document
from reference_record.texts.timestamps import timestamp
from reference_server.http.pages.api_documents import ApiDocuments, Problem
from reference_server.http.pages.page_calls import PageCall

LEAVES = 100
IMPORTS = 100
# The leaves that are searched for those of one entry.
LEAVES_SEARCHED_MAX = 5000
LEAVES_PER_CALL = 1000
# The kind of a leaf of a draw of seeds → the sentence that says what it has.
_DRAW_SENTENCES = {
    "seal": "The key of the draw {draw_id} was sealed: SHA-256 {key_sha256}",
    "commit": "For the draw {draw_id} the host committed to the policy {digest}",
    "draw": "The seeds of the draw {draw_id} were drawn",
    "open": "The key of the draw {draw_id} was opened: {key}",
}


async def show_entry(call: PageCall) -> str:
    entry = await call.api.get("entries", call.path("entry_id"))
    leaves: list[Document] = []
    searched = 0
    if entry["is_public"] or entry["state"] == "withdrawn":
        async for page in call.api.pages("history", limit=LEAVES_PER_CALL):
            searched += len(page["leaves"])
            leaves += [
                leaf
                for leaf in map(shown_leaf, page["leaves"])
                if leaf.get("entry_id") == entry["entry_id"]
            ]
            if searched >= LEAVES_SEARCHED_MAX:
                break
    return render_page(
        "board/entry", call.links, csrf=call.csrf, entry=entry, leaves=leaves,
        is_part=searched >= LEAVES_SEARCHED_MAX,
        record_file=record_file_name(entry["run_id"]),
        run_is_readable=await _is_readable(call.api, entry["run_id"]),
    )  # fmt: skip


async def show_history(call: PageCall) -> str:
    start = {"cursor": cursor} if (cursor := call.query("cursor")) else {}
    page = await call.api.get("history", limit=LEAVES, **start)
    checkpoint = await call.api.get("history", "checkpoint")
    following = ""
    if (cursor := page["next_cursor"]) is not None:
        following = f"?{urlencode({'cursor': cursor})}"
    is_public = "public_board" in (await call.api.get())["profiles"]
    return render_page(
        "board/history", call.links, csrf=call.csrf, is_public=is_public,
        leaves=list(map(shown_leaf, page["leaves"])),
        checkpoint=checkpoint, following=following, is_first=not start,
    )  # fmt: skip


async def show_imports(call: PageCall) -> str:
    start = {"cursor": cursor} if (cursor := call.query("cursor")) else {}
    page = await call.api.get("records", limit=IMPORTS, **start)
    following = ""
    if (cursor := page["next_cursor"]) is not None:
        following = f"?{urlencode({'cursor': cursor})}"
    return render_page(
        "imports/imports",
        call.links,
        csrf=call.csrf,
        imports=page["imports"],
        following=following,
    )


async def show_import(call: PageCall) -> str:
    shown = await call.api.get("records", call.path("import_id"))
    return render_page("imports/import", call.links, csrf=call.csrf, shown=shown)


async def offered_pages(call: PageCall) -> dict[str, str]:
    """Title and address of the pages that come with profiles of the server."""
    try:
        profiles = (await call.api.get())["profiles"]
    except Problem:
        return {}
    pages = {
        "board": ("History of the leaderboards", call.links.history()),
        "record_import": ("Imported records", call.links.imports()),
    }
    return dict(pages[profile] for profile in pages if profile in profiles)


def shown_leaf(listed: Document) -> dict[str, Any]:
    """The members of a leaf, its place in the tree, its text, sentence and time."""
    try:
        leaf = msgspec.json.decode(listed["leaf"], type=dict[str, Any])
        at = timestamp(leaf["at_ms"] / 1000)
        sentence = _DRAW_SENTENCES.get(leaf["kind"], "").format_map(leaf)
    except (msgspec.MsgspecError, KeyError, TypeError, ValueError, OverflowError):
        leaf, sentence, at = {}, "", ""
    text = listed["leaf"]
    shown = {"index": listed["index"], "text": text, "sentence": sentence, "at": at}
    return leaf | shown


async def _is_readable(api: ApiDocuments, run_id: str) -> bool:
    if not api.token:
        return False
    try:
        await api.get("runs", run_id)
    except Problem:
        return False
    return True
