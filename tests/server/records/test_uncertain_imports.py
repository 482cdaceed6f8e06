"""An import whose row was stored, or not, by a write that reported no success."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator
from pathlib import Path
from types import SimpleNamespace
from typing import Any, cast

import pytest

from reference_server.records.record_imports import ImportSettings, RecordImports
from reference_server.records.record_verifier import RecordVerifier
from reference_server.records.verify_process import RecordFacts
from reference_server.rules.imported_record import ImportUsage, RecordImport
from reference_server.storage.import_store import ImportStore
from reference_server.storage.runs.run_store import Store, StoreFailed

ARCHIVE = b"the bytes of a record"


class UncertainStore(ImportStore):
    """`add` fails, after or before its row is stored; then `find` may fail, too."""

    is_stored = is_found = True
    failure: BaseException = StoreFailed("the connection was lost")

    async def add(self, one: RecordImport, *check: Any) -> RecordImport | None:
        if self.is_stored:
            await super().add(one, *check)
        raise self.failure

    async def find(self, account: str | None, import_id: str) -> RecordImport | None:
        if not self.is_found:
            raise StoreFailed("there is no connection")
        return await super().find(account, import_id)


async def examine(*_: Any) -> RecordFacts:
    texts = ("k", "s", "run_1", "calibration", "1", "m", "policy")
    return RecordFacts(*texts, None, None, 1)


async def archive() -> AsyncIterator[bytes]:
    yield ARCHIVE


def hand_in(folder: Path, **answers: Any) -> tuple[list[str], list[str]]:
    """Files and rows after a write that failed, then the files after a restart."""
    most = ImportUsage(waiting=2, stored_bytes=1000)
    settings = ImportSettings(folder, most, 1000, 1.0)

    folder.mkdir()

    async def scenario(store: Store) -> tuple[list[str], list[str]]:
        imports = UncertainStore(store)
        for name, value in answers.items():
            setattr(imports, name, value)

        def server() -> RecordImports:
            keys = cast("Any", SimpleNamespace(sign_verdict=None))
            return RecordImports(imports, cast("Any", None), keys, settings)

        with pytest.raises(type(imports.failure)):
            await server().receive("a", len(ARCHIVE), archive())
        before = names(folder)
        server()._files.open(await imports.ids())
        assert len(await imports.ids()) == imports.is_stored
        return before, names(folder)

    async def with_store() -> tuple[list[str], list[str]]:
        store = Store(f"sqlite:///{folder.parent}/database")
        await store.open()
        try:
            return await scenario(store)
        finally:
            await store.close()

    return asyncio.run(with_store())


def names(folder: Path) -> list[str]:
    return sorted(path.suffix for path in folder.iterdir())


@pytest.fixture(autouse=True)
def whole_records(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(RecordVerifier, "examine", examine)


@pytest.mark.parametrize("failure", [StoreFailed("lost"), asyncio.CancelledError()])
def test_what_was_stored_keeps_its_archive(
    tmp_path: Path, failure: BaseException
) -> None:
    found = hand_in(tmp_path / "imports", failure=failure)
    assert found == ([".proctor"], [".proctor"])


def test_what_was_not_stored_leaves_no_file(tmp_path: Path) -> None:
    assert hand_in(tmp_path / "imports", is_stored=False) == ([], [])


@pytest.mark.parametrize("is_stored", [True, False])
def test_a_restart_decides_what_could_not_be_looked_up(
    tmp_path: Path, is_stored: bool
) -> None:
    answers = {"is_stored": is_stored, "is_found": False}
    before, after = hand_in(tmp_path / "imports", **answers)
    assert before == [".pending", ".proctor"]
    assert after == ([".proctor"] if is_stored else [])
