"""`python -m reference_server.records.verify_process TASK FILE`: reads a record.

A process of its own, with low priority and bounds of its memory and its time, for files
that may be hostile: no other part of the server parses their content. Its output is
small, and depends on no keys but those in the file.

    examine    one JSON value, Found
    replay     one JSON value in a line, Replayable; then a RecordedResult in each line
"""

from __future__ import annotations

import contextlib
import os
import sys
from collections.abc import Iterator
from pathlib import Path

import msgspec

from reference_record.broken import ARCHIVE, BrokenRecord
from reference_record.contents.statement import read_lines
from reference_record.formats.bundle import Bundle, open_bundle
from reference_record.formats.names import EPISODES, MANIFEST, STATEMENT
from reference_record.verification import Report, read_statement, verify
from reference_sim.replay.foreign_manifest import BenchmarkChoice, read_choice

# Twice what the worst file takes that the bounds of REC-030 allow.
MEMORY_BYTES_MAX = 2**30
# A record of 4 GiB is read through in a fifth of it.
CPU_S_MAX = 300
NICENESS = 15
# Options that the schema of a submission allows have a tenth of it.
CHOICE_BYTES_MAX = 2**15
DETAIL_CHARS_MAX = 1000


class RecordFacts(msgspec.Struct, frozen=True):
    """Facts of a whole record, from its statement. score: None until all are scored."""

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
    """A fault of a record: the file in it, the rule that it breaks, a sentence."""

    file: str
    rule: str
    detail: str

    @classmethod
    def of(cls, broken: BrokenRecord) -> BrokenPart:
        return cls(broken.file, broken.rule, broken.detail[:DETAIL_CHARS_MAX])


class Found(msgspec.Struct, frozen=True):
    """The output of `examine`: one of the two members is there."""

    facts: RecordFacts | None = None
    broken: BrokenPart | None = None


class Replayable(msgspec.Struct, frozen=True):
    """The benchmark of a record that can be replayed, or why it cannot be."""

    choice: BenchmarkChoice | None = None
    broken: BrokenPart | None = None


def examine(path: Path) -> Found:
    """REC-029, REC-030: what a file says, or what is wrong with it. Raises OSError."""
    try:
        return Found(facts=_facts_of(verify(open_bundle(path))))
    except BrokenRecord as broken:
        return Found(broken=BrokenPart.of(broken))
    except MemoryError:
        return Found(broken=BrokenPart.of(takes_too_much()))


def takes_too_much() -> BrokenRecord:
    detail = "it takes more memory or time than a verifier has for it"
    return BrokenRecord(ARCHIVE, "REC-030", detail)


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


def describe_replay(path: Path) -> Iterator[bytes]:
    """The lines of the task `replay`, of a record that was verified. Raises OSError."""
    try:
        bundle = open_bundle(path)
        choice = _choice_of(bundle)
        yield msgspec.json.encode(Replayable(choice=choice)) + b"\n"
    except BrokenRecord as broken:
        yield msgspec.json.encode(Replayable(broken=BrokenPart.of(broken))) + b"\n"
        return
    for line in read_lines(bundle.blocks(EPISODES)):
        if line.recording is not None:
            yield msgspec.json.encode(line.result) + b"\n"


def _choice_of(bundle: Bundle) -> BenchmarkChoice:
    statement, _ = read_statement(bundle.read(STATEMENT))
    choice = read_choice(statement.predicate, bundle.read(MANIFEST))
    if len(msgspec.json.encode(choice)) > CHOICE_BYTES_MAX:
        detail = "no benchmark has options of this length"
        raise BrokenRecord(STATEMENT, "REC-030", detail)
    return choice


def _bound_this_process() -> None:
    with contextlib.suppress(ImportError, AttributeError):  # not on every system
        import resource

        for bound, most in (
            (resource.RLIMIT_AS, MEMORY_BYTES_MAX),
            (resource.RLIMIT_CORE, 0),
            (resource.RLIMIT_FSIZE, 0),  # it writes to a pipe alone
        ):
            resource.setrlimit(bound, (most, most))
        # The first ends it by a signal of its own, which says that it was this bound.
        resource.setrlimit(resource.RLIMIT_CPU, (CPU_S_MAX, CPU_S_MAX + 1))
        os.nice(NICENESS)


def main(task: str, path: str) -> None:
    _bound_this_process()
    if task == "examine":
        sys.stdout.buffer.write(msgspec.json.encode(examine(Path(path))))
    else:
        sys.stdout.buffer.writelines(describe_replay(Path(path)))


if __name__ == "__main__":
    main(*sys.argv[1:])
