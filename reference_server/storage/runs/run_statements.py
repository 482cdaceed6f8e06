"""Statements on runs, their manifests and their episodes.

They are made once, so that what they are compiled to is found at once.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import msgspec
import sqlalchemy as sa

from reference_server.rules.runs.run import Run, RunHead
from reference_server.storage.connection.transactions import OwnershipLost
from reference_server.storage.runs import rows
from reference_server.storage.tables.database_tables import episodes as _episodes
from reference_server.storage.tables.database_tables import manifests as _manifests
from reference_server.storage.tables.database_tables import runs as _runs

_COUNT_SCORED = (
    sa.select(sa.func.count(_episodes.c.result))
    .where(_episodes.c.number == _runs.c.number)
    .scalar_subquery()
)
IS_THERE = _runs.c.deleted_at_wall.is_(None)
_NOT_IN_HEADS = ("scored", "stored_bytes", "deleted_at_wall")
HEADS = sa.select(
    *(column for column in _runs.c if column.name not in _NOT_IN_HEADS),
    sa.func.coalesce(_runs.c.scored, _COUNT_SCORED).label("scored"),
).where(IS_THERE, _runs.c.run_id.in_(sa.bindparam("run_ids", expanding=True)))
MANIFEST = sa.select(_manifests.c.manifest).where(
    _manifests.c.manifest_sha256 == sa.bindparam("manifest_sha256")
)
_OF_RUN = sa.select(*(_episodes.c[name] for name in rows.EPISODE_COLUMNS)).where(
    _episodes.c.number == sa.bindparam("number")
)
_start, _end = (sa.bindparam(name, type_=sa.Integer) for name in ("start", "end"))
_EPISODES_IN_RANGE = _OF_RUN.where(
    _episodes.c.index >= _start, _episodes.c.index < _end
)
# One after another as they were scored, like Run.scored_order.
EPISODES_SCORED = (
    _OF_RUN.where(_episodes.c.result.is_not(None))
    .order_by(sa.func.coalesce(_episodes.c.place, 0), _episodes.c.index)
    .offset(_start)
    .limit(_end - _start)
)

NEW_RUN = _runs.insert().returning(_runs.c.number)
_HAS_MANIFEST = sa.select(_manifests.c.manifest_sha256).where(
    _manifests.c.manifest_sha256 == sa.bindparam("manifest_sha256")
)
_OWNED_RUN = _runs.update().where(
    _runs.c.number == sa.bindparam("of_number"),
    sa.func.coalesce(_runs.c.fence, 0) == sa.bindparam("of_fence"),
)
_LAST_ATTEMPT, _LAST_PLAYED = (
    sa.select(sa.func.max(column)).where(
        _runs.c.account == sa.bindparam("account"),
        _runs.c.benchmark_id == sa.bindparam("benchmark_id"),
    )
    for column in (_runs.c.attempts_by_submitter, _runs.c.played_number)
)
_NEW_EPISODE = _episodes.insert()
_OLD_EPISODE = _episodes.delete().where(
    _episodes.c.number == sa.bindparam("of_number"),
    _episodes.c.index == sa.bindparam("of_index"),
)


def is_deleted(connection: sa.Connection, run_id: str) -> bool:
    """Whether the run was deleted, as a transaction of a write sees it."""
    query = sa.select(_runs.c.run_id).where(~IS_THERE, _runs.c.run_id == run_id)
    return connection.scalar(query) is not None


def add_manifest(connection: sa.Connection, run: Run) -> None:
    """Store the manifest of a run, unless another run has it."""
    of_run = {"manifest_sha256": run.manifest_sha256}
    if connection.execute(_HAS_MANIFEST, of_run).first() is None:
        row = of_run | {"manifest": msgspec.json.encode(run.manifest)}
        connection.execute(_manifests.insert(), row)


def update_owned(
    connection: sa.Connection, run: RunHead, row: Mapping[str, Any]
) -> None:
    """Change the row of a run, unless another node has claimed it since it was read."""
    owned = {"of_number": run.number, "of_fence": run.fence}
    if connection.execute(_OWNED_RUN, {**row, **owned}).rowcount == 0:
        raise OwnershipLost(f"another node has claimed {run.run_id}")


def last_attempt(connection: sa.Connection, run: RunHead) -> int:
    """The largest number that a run of this account and benchmark has; 0 if none."""
    return connection.scalar(_LAST_ATTEMPT, _submitter(run)) or 0


def last_played(connection: sa.Connection, run: RunHead) -> int:
    """The largest place among the runs of this account and benchmark; 0 if none."""
    return connection.scalar(_LAST_PLAYED, _submitter(run)) or 0


def _submitter(run: RunHead) -> dict[str, str]:
    return {"account": run.account, "benchmark_id": run.manifest["benchmark_id"]}


def replace_episodes(
    connection: sa.Connection, episodes: Sequence[Mapping[str, Any]]
) -> None:
    """Delete and insert: an upsert that every database speaks."""
    if not episodes:
        return
    old = [{"of_number": row["number"], "of_index": row["index"]} for row in episodes]
    connection.execute(_OLD_EPISODE, old)
    connection.execute(_NEW_EPISODE, episodes)


def stored_episodes(
    connection: sa.Connection,
    number: int,
    start: int = 0,
    end: int = 2**31 - 1,
    query: sa.Select[Any] = _EPISODES_IN_RANGE,
) -> list[rows.EpisodeRow]:
    """The rows of a run's episodes from start to end, counted as the query does."""
    if start == end:
        return []
    window = {"number": number, "start": start, "end": end}
    return [tuple(row) for row in connection.execute(query, window)]
