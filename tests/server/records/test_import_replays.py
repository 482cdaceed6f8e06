"""The replays of imports: what fails in one is no failure of the others."""

from __future__ import annotations

import asyncio
from typing import Any, cast

import pytest

from reference_server.records.import_replays import ImportReplays
from reference_server.rules.imported_record import RecordImport


class OneImport:
    """A store of one import."""

    def __init__(self) -> None:
        texts = ("imp_1", "a", "0", 1, "0", "k", "r", "b", "1", "0", "p", None)
        self.one = RecordImport(1, *texts, None, 1, 0.0)

    async def update(self, one: RecordImport) -> None:
        self.one = one


def test_what_fails_in_a_replay_ends_its_import(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    async def fail(*_: Any) -> None:
        raise TypeError

    store, unused = OneImport(), cast("Any", None)
    replays = ImportReplays(
        cast("Any", store), unused, unused, find=unused, sign=unused, replay_s_max=1.0
    )
    monkeypatch.setattr(replays, "_replay", fail)
    asyncio.run(replays._finish(store.one))
    assert store.one.state == "finished"
    assert store.one.reason == "The replay failed: TypeError."
