"""All runs of a database, one after another, for a page of its operator."""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Mapping

from reference_server.rules.runs.run import RunHead
from reference_server.storage.runs.run_store import Store

RUNS_PER_READ = 200


def read_overview(url: str, note: Callable[[RunHead], None]) -> Mapping[str, int]:
    """Call `note` with each run, newest first; returns the bytes of each account.

    The server may use the database meanwhile. Raises StoreFailed.
    """
    return asyncio.run(_read(url, note))


async def _read(url: str, note: Callable[[RunHead], None]) -> Mapping[str, int]:
    store, before = Store(url), None
    try:
        await store.open(upgrade=False)
        _, stored_bytes = await store.sizes_of_accounts()
        while page := await store.page(None, before, RUNS_PER_READ):
            heads = await store.heads([run_id for _, run_id in page])
            for _, run_id in page:
                if run_id in heads:  # it may be deleted meanwhile
                    note(heads[run_id])
            before = page[-1][0]
    finally:
        await store.close()
    return stored_bytes
