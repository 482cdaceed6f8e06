"""Pages of the leaderboard: how much of it they read, and what a run's page offers."""

from __future__ import annotations

import msgspec
import pytest

from reference_record.pages.page_templates import render_page
from reference_server.http.pages.entry_pages import shown_leaf
from reference_server.http.pages.page_links import ServerLinks
from tests.support.pages.page_api import ENTRIES_PER_PAGE, RESULT, signed_in, text_of
from tests.support.pages.page_reader import commands_of

LEADERBOARD = "/pages/benchmarks/calibration/leaderboard"
UNKNOWN = f"{LEADERBOARD}?manifest={'f' * 64}"
PUBLISH, WITHDRAW = "/runs/done/publish", "/runs/done/withdraw"
MANY = 10 * ENTRIES_PER_PAGE


async def test_a_manifest_without_entries_reads_one_page_of_them() -> None:
    """Of many. Expect the manifests of the newest, and that these are not all."""
    async with signed_in() as (api, client):
        for number in range(MANY):
            api.publish(f"run{number}", manifest_sha256=f"{number:064}")
        shown = await text_of(client, UNKNOWN)
        assert api.asked["entries"] == 1
        linked = [f"{LEADERBOARD}?manifest={number:064}" in shown for number in (0, 2)]
        assert linked == [True, False]
        assert "counted are the newest" in shown


async def test_an_old_entry_is_found_among_many_others() -> None:
    """Expect the page to offer its change, and no list of entries to be read."""
    async with signed_in() as (api, client):
        api.add("done", RESULT)
        for number in range(MANY):
            api.publish(f"other{number}")
        api.publish("done")
        shown = await text_of(client, "/pages/runs/done")
        assert "Published as" in shown
        assert "Change the entry" in shown
        assert WITHDRAW in shown
        assert api.asked["entries"] == 0


async def test_a_withdrawn_entry_is_not_published_again() -> None:
    """The API refuses that (BRD-006). Expect the page to say so, and no form."""
    async with signed_in() as (api, client):
        api.add("done", RESULT)
        shown = await text_of(client, "/pages/runs/done")
        assert PUBLISH in shown
        assert WITHDRAW not in shown
        api.publish("done", state="withdrawn")
        shown = await text_of(client, "/pages/runs/done")
        assert "cannot be published again" in shown
        assert "signed history" in shown
        assert PUBLISH not in shown
        assert WITHDRAW not in shown
        api.entries.clear()
        api.publish("done", state="withdrawn", is_public=False)
        shown = await text_of(client, "/pages/runs/done")
        assert "cannot be published again" in shown
        assert "signed history" not in shown, "which never had it"


@pytest.mark.parametrize("level", ["signed", "reported"])
@pytest.mark.parametrize("is_readable", [True, False])
def test_an_entry_says_how_a_reader_gets_and_checks_its_record(
    level: str, is_readable: bool
) -> None:
    interval = {"low": 0.0, "high": 1.0}
    score = {"success_rate": 1.0, "success_interval": interval, "score": 1.0}
    entry = {
        "level": level,
        "entry_id": "entry_1",
        "run_id": "run_1",
        "benchmark_id": "calibration",
        "manifest_sha256": "1" * 64,
        "policy": {"name": "p"},
        "score": score | {"counts": {"success": 1, "total": 1}},
        **dict.fromkeys(("published_at", "changed_at"), "2026-11-30T00:00:00Z"),
    }
    page = render_page(
        "board/entry",
        ServerLinks("../../", server_url="https://e.org"),
        entry=entry, leaves=[],
        record_file="run_1.proctor", run_is_readable=is_readable,
    )  # fmt: skip
    is_signed = level == "signed"
    assert (
        "proctor verify run_1.proctor --server https://e.org" in commands_of(page)
    ) is is_signed
    assert ("Ask the submitter" in page) is (is_signed and not is_readable)


@pytest.mark.parametrize(
    ("members", "sentence"),
    [
        ({"kind": "seal", "key_sha256": "fa42"}, "was sealed: SHA-256 fa42"),
        ({"kind": "commit", "digest": "c0de"}, "committed to the policy c0de"),
        ({"kind": "draw"}, "The seeds of the draw letters/test were drawn"),
        ({"kind": "open", "key": "0a0b"}, "was opened: 0a0b"),
        ({"kind": "of a later version"}, "of a later version"),
    ],
)
@pytest.mark.parametrize("is_public", [True, False])
def test_the_history_says_each_step_of_a_draw(
    members: dict[str, str], sentence: str, is_public: bool
) -> None:
    """Expect JSON of an unknown kind alone, and who may check all that."""
    leaf = {"at_ms": 1796047107814, "draw_id": "letters/test", **members}
    text = msgspec.json.encode(leaf).decode()
    shown = render_page(
        "board/history", ServerLinks(""), csrf="", is_public=is_public, is_first=True,
        checkpoint={"tree_size": 1}, leaves=[shown_leaf({"index": 0, "leaf": text})],
    )  # fmt: skip
    assert sentence in shown
    assert ("at_ms" in shown) is (members["kind"] == "of a later version")
    assert ("needs the key of an account" in shown) is not is_public
