"""The benchmarks that the server of this host had at its last start, with their splits.

A track may be put while the host is down, so they are kept in the database. A track
names benchmarks, splits and options of another program: each name is checked here.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from typing import Final

import msgspec
from pydantic import ValidationError

from reference_platform.storage.platform_database import Database
from reference_platform.tracks.track_rules import Phase, Track
from reference_record.command_line.spelling import reason_of, unknown
from reference_server.generated.models import CalibrationOptions
from reference_server.rules.refusal import Refused

# The one benchmark whose submitter gives options, see `CalibrationOptions`.
_WITH_OPTIONS: Final = "calibration"
_ACT: Final = "Correct it, or start proctor-host with that benchmark first."


class _Served(msgspec.Struct):
    """splits: their names, as JSON."""

    benchmark_id: str
    splits: str


def note_served(
    database: Database, splits_of_benchmarks: Mapping[str, Collection[str]]
) -> None:
    with database.transaction():
        database.execute("DELETE FROM benchmarks_of_server")
        for benchmark_id, splits in sorted(splits_of_benchmarks.items()):
            names = msgspec.json.encode([*splits]).decode()
            database.insert("benchmarks_of_server", _Served(benchmark_id, names))


def served(database: Database) -> Mapping[str, Collection[str]]:
    """The splits of each benchmark; none if no server has started yet."""
    statement = "SELECT * FROM benchmarks_of_server ORDER BY benchmark_id"
    rows = database.rows(_Served, statement)
    return {row.benchmark_id: msgspec.json.decode(row.splits) for row in rows}


def check_served(database: Database, track: Track, before: Collection[Phase]) -> None:
    """Raises Refused for a phase of which no run can be made.

    before: the phases of the track as it is, which may be put again.
    """
    benchmarks = served(database)
    kept = [_names(phase) for phase in before]
    faults = [
        f"The phase {phase.phase_id} has an {fault}."
        for phase in track.phases
        if _names(phase) not in kept
        for fault in _faults(phase, benchmarks)
    ]
    if faults:
        raise Refused("invalid_request", " ".join(faults), act=_ACT)


def _names(phase: Phase) -> tuple[object, ...]:
    """All that a phase takes from its benchmark."""
    return phase.benchmark_id, phase.splits, phase.options


def _faults(phase: Phase, benchmarks: Mapping[str, Collection[str]]) -> Iterator[str]:
    """Phrases that follow "has an". No name is known before the first start."""
    if benchmarks and phase.benchmark_id not in benchmarks:
        yield unknown("benchmark", phase.benchmark_id, benchmarks)
    elif benchmarks:
        splits = benchmarks[phase.benchmark_id]
        for name in phase.splits:
            if name not in splits:
                yield unknown(f"split of {phase.benchmark_id}:", name, splits)
    yield from _option_faults(phase)


def _option_faults(phase: Phase) -> Iterator[str]:
    if phase.options and phase.benchmark_id != _WITH_OPTIONS:
        names = ", ".join(phase.options)
        yield f"option that its benchmark does not take: {names}"
        return
    try:
        CalibrationOptions.model_validate(phase.options or {})
    except ValidationError as error:
        for fault in error.errors():
            at = "/".join(str(step) for step in fault["loc"])
            if fault["type"] == "extra_forbidden":
                yield unknown("option", at, CalibrationOptions.model_fields)
            else:
                yield f"option with a wrong value, {at}: {reason_of(fault)}"
