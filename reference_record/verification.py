"""Verifies without a simulator that a record is whole, signed, complete and consistent.

`verify` raises BrokenRecord for the first part that is wrong, and otherwise returns
what is known. Whether the actions came from the policy that is named cannot be known by
reading (REC-031).
"""

from __future__ import annotations

import hashlib
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from reference_record.broken import BrokenRecord
from reference_record.contents.replay_verdict import ReplayVerdict, read_verdict
from reference_record.contents.score import compute_score, first_difference
from reference_record.contents.statement import (
    PREDICATE_TYPE,
    EpisodeLine,
    Evaluation,
    RecordManifest,
    Statement,
    check_types,
    decode_key,
    digests_by_name,
    public_key_in,
    read_lines,
)
from reference_record.formats.bundle import Bundle
from reference_record.formats.envelope import read_envelope
from reference_record.formats.names import (
    EPISODES,
    MANIFEST,
    STATEMENT,
    is_recording,
    is_verdict,
    printable_name,
    recording_name,
)
from reference_record.formats.strict_json import read_json
from reference_record.recordings.recording_check import check_recording


@dataclass(frozen=True, slots=True)
class Report:
    """The facts of a record that has passed every check.

    signer: whose key signed it, None for a key that was not named. replayed_by: (who,
    verdict) of each verdict, who None for a key that was not named. sealed: how many
    episodes are of splits whose seeds the host keeps secret until it opens them.
    """

    evaluation: Evaluation
    keyid: str
    statement_sha256: str
    signer: str | None
    replayed_by: tuple[tuple[str | None, ReplayVerdict], ...]
    episodes: int
    recordings: int
    turns: int
    sealed: int

    @property
    def levels(self) -> list[str]:
        """REC-031: what may be said of the score, never without who says it."""
        if self.signer is None:
            return ["reported"]
        replays = [
            f"replayed by {who} ({verdict.replay.result}, "
            f"{verdict.replay.episodes} of {self.episodes} episodes)"
            for who, verdict in self.replayed_by
            if who is not None and verdict.replay.result != "diverged"
        ]
        return [f"signed by {self.signer}", *replays]


def verify(bundle: Bundle, trusted: Mapping[str, str] | None = None) -> Report:
    """REC-029: raise BrokenRecord for the first part of a record that is wrong.

    trusted: keyid → whose key it is, of the keys that the caller has from elsewhere.
    """
    names = trusted or {}
    data = bundle.read(STATEMENT)
    statement, keyid = read_statement(data)
    evaluation = statement.predicate
    digests = digests_by_name(statement)
    _check_files(bundle, digests, statement)
    if digests[MANIFEST] != evaluation.manifest_sha256:
        detail = "its SHA-256 is not the manifest_sha256 of the run"
        raise BrokenRecord(MANIFEST, "REC-008", detail)
    manifest = read_json(MANIFEST, bundle.read(MANIFEST), RecordManifest)
    _check_benchmark(manifest, evaluation)
    lines = list(_checked_lines(bundle, manifest, digests))
    turns = sum(_check_recordings(bundle, lines))
    _check_score(lines, evaluation)
    sha256 = hashlib.sha256(data).hexdigest()
    verdicts = [
        read_verdict(name, bundle.read(name), sha256, len(lines))
        for name in bundle.sizes
        if is_verdict(name)
    ]
    return Report(
        evaluation=evaluation,
        keyid=keyid,
        statement_sha256=sha256,
        signer=names.get(keyid),
        replayed_by=tuple((names.get(v.keyid), v) for v in verdicts),
        episodes=len(lines),
        recordings=sum(map(is_recording, bundle.sizes)),
        turns=turns,
        sealed=manifest.sealed,
    )


def verify_signer(bundle: Bundle, named: Mapping[str, str]) -> Report:
    """As `verify`, for a caller who names keys: the host's must be one of them.

    named: as `trusted` of `verify`; with none, a record of any host is accepted.
    """
    report = verify(bundle, named)
    if named and report.signer is None:
        detail = f"it is signed by {report.keyid}, which is none of the keys named"
        raise BrokenRecord(STATEMENT, "REC-031", detail)
    return report


def read_statement(data: bytes) -> tuple[Statement[Evaluation], str]:
    """The statement, whose signature fits, and the keyid; raises BrokenRecord."""
    envelope = read_envelope(STATEMENT, data)
    envelope.check_signature(public_key_in(envelope))
    statement = read_json(STATEMENT, envelope.payload, Statement[Evaluation])
    check_types(STATEMENT, statement, PREDICATE_TYPE)
    host = statement.predicate.host
    # The key was looked for leniently; here is the one that the statement names.
    envelope.check_signature(decode_key(STATEMENT, host.public_key))
    if host.keyid != envelope.keyid:
        raise BrokenRecord(STATEMENT, "REC-006", "it names another keyid than it has")
    return statement, envelope.keyid


def _check_files(
    bundle: Bundle, digests: Mapping[str, str], statement: Statement[Any]
) -> None:
    """REC-007, REC-008: every file is listed once, in order, with its digest."""
    listed = [subject.name for subject in statement.subject]
    if len(digests) < len(listed):
        raise BrokenRecord(STATEMENT, "REC-007", "it lists a file twice")
    files = [n for n in bundle.sizes if n != STATEMENT and not is_verdict(n)]
    for name in listed:
        if name not in bundle.sizes or name == STATEMENT or is_verdict(name):
            detail = "the statement lists this file, and the record has none"
            raise BrokenRecord(printable_name(name), "REC-007", detail)
    for name in files:
        if name not in digests:
            raise BrokenRecord(name, "REC-007", "the statement does not list this file")
    if listed != files:
        raise BrokenRecord(STATEMENT, "REC-007", "it lists the files out of order")
    for name in files:
        if bundle.sha256(name) != digests[name]:
            detail = "its SHA-256 is not that in the statement"
            raise BrokenRecord(name, "REC-008", detail)


def _check_benchmark(manifest: RecordManifest, evaluation: Evaluation) -> None:
    benchmark = evaluation.benchmark
    if (manifest.benchmark_id, manifest.version) != (
        benchmark.benchmark_id,
        benchmark.version,
    ):
        raise BrokenRecord(MANIFEST, "REC-008", "it is of another benchmark")
    if not manifest.episodes:
        raise BrokenRecord(MANIFEST, "REC-008", "it has no episode")


def _checked_lines(
    bundle: Bundle, manifest: RecordManifest, digests: Mapping[str, str]
) -> Iterator[EpisodeLine]:
    """REC-009: one line for each episode of the manifest, in its order."""
    ids: set[str] = set()
    total = len(manifest.episodes)
    number = 0
    for line in read_lines(bundle.blocks(EPISODES)):
        _check_place(line, number, manifest)
        if line.episode_id in ids:
            detail = f"line {number + 1}: its episode_id stands twice"
            raise BrokenRecord(EPISODES, "REC-009", detail)
        ids.add(line.episode_id)
        _check_link(line, digests)
        number += 1
        yield line
    if number < total:
        detail = f"episode {number} of the manifest, which has {total}, is missing"
        raise BrokenRecord(EPISODES, "REC-009", detail)


def _check_place(line: EpisodeLine, number: int, manifest: RecordManifest) -> None:
    total = len(manifest.episodes)
    where = f"line {number + 1}"
    if line.index != number:
        what = "stands twice" if line.index < number else "stands here"
        missing = "" if line.index < number else f", episode {number} is missing"
        detail = f"{where}: episode {line.index} {what}{missing}"
        raise BrokenRecord(EPISODES, "REC-009", detail)
    if number >= total:
        detail = f"{where}: the manifest has {total} episodes"
        raise BrokenRecord(EPISODES, "REC-009", detail)
    planned = manifest.episodes[number]
    if (line.task, line.split) != (planned.task, planned.split):
        detail = f"{where}: the manifest has another task or split here"
        raise BrokenRecord(EPISODES, "REC-009", detail)


def _check_link(line: EpisodeLine, digests: Mapping[str, str]) -> None:
    """REC-010: a line names its recording's file and digest."""
    name = recording_name(line.index)
    if line.recording is None:
        if name in digests:
            raise BrokenRecord(
                name, "REC-010", "episodes.jsonl does not name this file"
            )
        return
    if line.recording.path != name or name not in digests:
        detail = f"line {line.index + 1}: it names another file than {name}"
        raise BrokenRecord(EPISODES, "REC-010", detail)
    if line.recording.sha256 != digests[name]:
        detail = f"line {line.index + 1}: its digest of {name} is not the statement's"
        raise BrokenRecord(EPISODES, "REC-010", detail)


def _check_recordings(bundle: Bundle, lines: Iterable[EpisodeLine]) -> Iterator[int]:
    # Every recording that is listed has its line: names follow from the lines' indices.
    expected = {line.recording.path for line in lines if line.recording is not None}
    for name in bundle.sizes:
        if is_recording(name) and name not in expected:
            raise BrokenRecord(name, "REC-010", "no episode has this recording")
    for line in lines:
        if line.recording is not None:
            name = line.recording.path
            with bundle.open(name) as file:
                yield check_recording(file, bundle.sizes[name], line)


def _check_score(lines: list[EpisodeLine], evaluation: Evaluation) -> None:
    """REC-013: the score in the statement follows from the episodes."""
    expected = compute_score([line.scored for line in lines])
    names = {
        "run_id": evaluation.run.run_id,
        "benchmark_id": evaluation.benchmark.benchmark_id,
        "manifest_sha256": evaluation.manifest_sha256,
    }
    for name, value in names.items():
        if evaluation.score.get(name) != value:
            detail = f"its score has another {name}"
            raise BrokenRecord(STATEMENT, "REC-013", detail)
    if difference := first_difference(expected, evaluation.score):
        detail = f"its score does not follow from the episodes: {difference}"
        raise BrokenRecord(STATEMENT, "REC-013", detail)
