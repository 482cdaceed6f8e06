"""Compares the record of a completed run with what its players were answered."""

from __future__ import annotations

import contextlib
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from reference_record.broken import BrokenRecord
from reference_record.contents.statement import EpisodeLine, read_lines
from reference_record.formats.bundle import Bundle, open_bundle
from reference_record.formats.names import EPISODES
from reference_record.verification import Report as Verified
from reference_record.verification import verify
from tests.campaigns.players.raw_client import RawClient


class WrongRecord(Exception):
    """A record that is missing, or that does not verify."""


@dataclass(frozen=True)
class Record:
    path: Path
    bundle: Bundle
    verified: Verified
    lines: Sequence[EpisodeLine]


@contextlib.contextmanager
def verified_record(
    client: RawClient, run_id: str, directory: Path
) -> Iterator[Record]:
    """The record of a run, in a file that is removed at the end."""
    answer = client.request("GET", f"/v1/runs/{run_id}/record")
    if answer.status != 200:
        raise WrongRecord(f"{answer.status} {answer.code}")
    path = directory / f"{run_id}.proctor"
    path.write_bytes(answer.body)
    try:
        bundle = open_bundle(path)
        verified = verify(bundle)
        lines = list(read_lines(bundle.blocks(EPISODES)))
        yield Record(path, bundle, verified, lines)
    except BrokenRecord as broken:
        raise WrongRecord(str(broken)) from broken
    finally:
        path.unlink()


def missing_results(
    lines: Sequence[EpisodeLine], acknowledged: Mapping[int, Mapping[str, Any]]
) -> Iterator[str]:
    """Sentences about results that were acknowledged and are recorded differently."""
    for index, result in acknowledged.items():
        line = lines[index]
        recorded = (line.outcome, line.score, line.steps, line.attempts)
        names = ("outcome", "score", "steps", "attempt")
        sent = tuple(result[name] for name in names)
        if recorded != sent:
            yield f"episode {index} was acknowledged as {sent} and is {recorded}"


def missing_turns(
    recorded: Mapping[float, int], answered: Iterable[float]
) -> Iterator[str]:
    """Sentences about turns that were answered and are not recorded once.

    recorded: number of an action → how often it is recorded.
    """
    for number in answered:
        if (times := recorded.get(number, 0)) != 1:
            yield f"the answered turn of {number:.0f} is recorded {times} times"
