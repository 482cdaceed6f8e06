"""The benchmarks that the server of this host had at its last start, by their ids.

A track may be put while the host is down, so they are kept in the database.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence

import msgspec

from reference_platform.storage.platform_database import Database
from reference_platform.tracks.track_rules import Track
from reference_record.command_line.spelling import unknown
from reference_server.rules.refusal import Refused


class _Served(msgspec.Struct):
    benchmark_id: str


def note_served(database: Database, benchmark_ids: Collection[str]) -> None:
    with database.transaction():
        database.execute("DELETE FROM served_benchmarks")
        for benchmark_id in sorted(set(benchmark_ids)):
            database.insert("served_benchmarks", _Served(benchmark_id))


def served(database: Database) -> Sequence[str]:
    """In their order; none if no server has started yet."""
    statement = "SELECT benchmark_id FROM served_benchmarks ORDER BY benchmark_id"
    return [row.benchmark_id for row in database.rows(_Served, statement)]


def check_served(database: Database, track: Track, before: Collection[str]) -> None:
    """Raises Refused for a benchmark that no run can be made of.

    before: what the track has already, which may be put again.
    """
    names = served(database)
    for phase in track.phases:
        wanted = phase.benchmark_id
        if names and wanted not in {*names, *before}:
            why = unknown("benchmark", wanted, names)
            text = f"The phase {phase.phase_id} has an {why}."
            act = "Correct it, or start proctor-host with that benchmark first."
            raise Refused("invalid_request", text, act=act)
