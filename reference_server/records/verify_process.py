"""`python -m reference_server.records.verify_process FILE`: examines a record.

A process of its own, with low priority and a bound of its memory, for files that may be
hostile. It writes one JSON value, and knows no key but those in the file.
"""

from __future__ import annotations

import contextlib
import os
import sys
from pathlib import Path

import msgspec

from reference_record.broken import ARCHIVE, BrokenRecord
from reference_record.formats.bundle import open_bundle
from reference_record.verification import Report, verify

# What the bounds of REC-030 allow takes a tenth of it.
MEMORY_BYTES_MAX = 2**31
NICENESS = 15


class RecordFacts(msgspec.Struct, frozen=True):
    """What the statement of a whole record says. score: None: not all are scored."""

    keyid: str
    statement_sha256: str
    run_id: str
    benchmark_id: str
    benchmark_version: str
    manifest_sha256: str
    policy_name: str
    policy_version: str | None
    score: float | None
    episodes: int


class BrokenPart(msgspec.Struct, frozen=True):
    """What is wrong with a record: the file in it, the rule, a sentence."""

    file: str
    rule: str
    detail: str


class Found(msgspec.Struct, frozen=True):
    """One of the two is there."""

    facts: RecordFacts | None = None
    broken: BrokenPart | None = None


def examine(path: Path) -> Found:
    """REC-029, REC-030: what a file says, or what is wrong with it. Raises OSError."""
    try:
        return Found(facts=_facts_of(verify(open_bundle(path))))
    except BrokenRecord as broken:
        return Found(broken=BrokenPart(broken.file, broken.rule, broken.detail))
    except MemoryError:
        detail = "it takes more memory than a verifier has for it"
        return Found(broken=BrokenPart(ARCHIVE, "REC-030", detail))


def _facts_of(report: Report) -> RecordFacts:
    said = report.evaluation
    return RecordFacts(
        keyid=report.keyid,
        statement_sha256=report.statement_sha256,
        run_id=said.run.run_id,
        benchmark_id=said.benchmark.benchmark_id,
        benchmark_version=said.benchmark.version,
        manifest_sha256=said.manifest_sha256,
        policy_name=said.policy.name,
        policy_version=said.policy.version,
        score=said.score["score"],
        episodes=report.episodes,
    )


def _bound_this_process() -> None:
    with contextlib.suppress(ImportError, AttributeError):  # not on every system
        import resource

        most = MEMORY_BYTES_MAX, MEMORY_BYTES_MAX
        resource.setrlimit(resource.RLIMIT_AS, most)
        os.nice(NICENESS)


def main(path: str) -> None:
    _bound_this_process()
    sys.stdout.buffer.write(msgspec.json.encode(examine(Path(path))))


if __name__ == "__main__":
    main(sys.argv[1])
