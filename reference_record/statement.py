"""Types of the JSON in a record: the statement, the manifest, the episode lines.

Members that are not named here are read past, as everywhere in the protocol.
"""

from __future__ import annotations

import base64
import binascii
from collections.abc import Iterable, Iterator, Mapping
from typing import Annotated, Any, Final, Generic, Literal, TypeVar

import msgspec
from msgspec import Meta, Struct

from reference_record.broken import BrokenRecord
from reference_record.formats.envelope import Envelope
from reference_record.formats.names import EPISODES, LINE_BYTES_MAX, recording_name
from reference_record.formats.strict_json import UNREADABLE, describe_damage, read_json
from reference_record.generated.answers import Outcome
from reference_record.keys import PUBLIC_KEY_BYTES
from reference_record.score import ScoredLine

STATEMENT_TYPE: Final = "https://in-toto.io/Statement/v1"
PREDICATE_TYPE: Final = "urn:proctor:robot-evaluation:v1"

Sha256 = Annotated[str, Meta(pattern="^[0-9a-f]{64}$")]
Text = Annotated[str, Meta(max_length=1024)]
Count = Annotated[int, Meta(ge=0, le=2**53)]
P = TypeVar("P")


class Digest(Struct):
    sha256: Sha256


class Subject(Struct):
    name: Text
    digest: Digest


class Statement(Struct, Generic[P]):
    """An in-toto Statement, version 1."""

    type_: str = msgspec.field(name="_type")
    subject: list[Subject]
    predicateType: str  # noqa: N815 – in-toto's name
    predicate: P


class Host(Struct):
    """The host that signs. public_key: base64 of its 32 bytes."""

    name: Text
    keyid: Text
    public_key: Text


class RunFacts(Struct):
    """The facts from which a replay resolves the benchmark as the run had it."""

    run_id: Text
    mode: Text
    options: dict[str, Any] | None = None
    images: dict[str, Any] | None = None


class BenchmarkFacts(Struct, omit_defaults=True):
    """shown: what the host showed beside the manifest, as a merge patch of it."""

    benchmark_id: Text
    version: Text
    shown: dict[str, Any] = {}


class PolicyFacts(Struct):
    name: Text
    version: Text | None = None


class SecondJudgement(Struct):
    """The judgement of an episode by a second person, from its recording."""

    episode_id: Text
    judge: Text
    success: bool
    score: Annotated[float, Meta(ge=0, le=1)]
    met: list[Count]
    note: str
    at: Text


class Evaluation(Struct, omit_defaults=True):
    """REC-007: the predicate of a record's statement.

    score: schema Score of openapi.yaml. engine: versions of what computed the episodes.
    """

    run: RunFacts
    benchmark: BenchmarkFacts
    manifest_sha256: Sha256
    policy: PolicyFacts
    score: dict[str, Any]
    engine: dict[str, Any]
    protocol_version: Text
    host: Host
    started_at: Text
    finished_at: Text
    attempts_by_submitter: Count
    previous_statement_sha256: Sha256 | None
    promise: Literal["exact", "outcome", "none"]
    second_judgements: list[SecondJudgement] = []


class BenchmarkEpisode(Struct):
    task: Text
    split: Text


class RecordManifest(Struct):
    benchmark_id: Text
    version: Text
    episodes: list[BenchmarkEpisode]
    sealed_splits: object = None  # no rule of a record is about its form

    @property
    def sealed(self) -> int:
        """How many episodes are of splits whose seeds the host keeps secret."""
        named = self.sealed_splits if isinstance(self.sealed_splits, list) else []
        splits = {name for name in named if isinstance(name, str)}
        return sum(episode.split in splits for episode in self.episodes)


class RecordingFacts(Struct):
    path: Text
    sha256: Sha256
    bytes: Count
    first_digest: Text
    last_digest: Text


class RecordedResult(Struct, frozen=True):
    """The result of a recorded episode, with which a replay is compared."""

    index: Count
    outcome: Outcome | None
    success: bool
    score: Annotated[float, Meta(ge=0, le=1)] | None
    steps: Count

    @property
    def recording(self) -> str:
        """The name of its file in the record (REC-010)."""
        return recording_name(self.index)


class EpisodeLine(Struct, omit_defaults=True):
    """REC-009: one line of episodes.jsonl; outcome None: the episode has no result.

    player: as in the result of the episode; the line omits it if the result does.
    """

    episode_id: Text
    index: Count
    task: Text
    split: Text
    outcome: Outcome | None
    success: bool
    score: Annotated[float, Meta(ge=0, le=1)] | None
    steps: Count
    attempts: Count
    latency: dict[str, Any] | None
    recording: RecordingFacts | None
    player: Any = None

    @property
    def scored(self) -> ScoredLine:
        return ScoredLine(self.task, self.split, self.outcome, self.score)

    @property
    def result(self) -> RecordedResult:
        return RecordedResult(
            self.index, self.outcome, self.success, self.score, self.steps
        )


def decode_key(file: str, text: str) -> bytes:
    """The 32 bytes of a public key in base64; raises BrokenRecord (REC-006)."""
    try:
        key = base64.b64decode(text, validate=True)
    except (binascii.Error, ValueError):
        key = b""
    if len(key) != PUBLIC_KEY_BYTES:
        raise BrokenRecord(file, "REC-006", "it holds no Ed25519 public key")
    return key


class _KeyAlone(Struct):
    """The part of a payload that names the key which its signature is checked with."""

    host: Host | None = None
    verifier: Host | None = None


def public_key_in(envelope: Envelope) -> bytes:
    """The key that the payload itself names; raises BrokenRecord (REC-006).

    It proves that the file is whole, and nothing about whose key it is.
    """
    try:
        statement = msgspec.json.decode(envelope.payload, type=Statement[_KeyAlone])
    except UNREADABLE as error:
        raise BrokenRecord(envelope.file, "REC-006", describe_damage(error)) from error
    signer = statement.predicate.host or statement.predicate.verifier
    if signer is None:
        raise BrokenRecord(envelope.file, "REC-006", "it names no public key")
    return decode_key(envelope.file, signer.public_key)


def check_types(file: str, statement: Statement[Any], predicate_type: str) -> None:
    """REC-007: raise BrokenRecord unless it is a statement of that type."""
    types = (statement.type_, statement.predicateType)
    if types != (STATEMENT_TYPE, predicate_type):
        detail = f"its types are {types[0][:99]} and {types[1][:99]}"
        raise BrokenRecord(file, "REC-007", detail)


def write_statement(
    subjects: Iterable[tuple[str, str]], predicate_type: str, predicate: object
) -> bytes:
    """The payload of an envelope. subjects: name and SHA-256 of each file, in order."""
    subject = [Subject(name, Digest(sha256)) for name, sha256 in subjects]
    statement = Statement(STATEMENT_TYPE, subject, predicate_type, predicate)
    return msgspec.json.encode(statement)


def read_lines(blocks: Iterable[bytes]) -> Iterator[EpisodeLine]:
    """The lines of episodes.jsonl, one at a time; raises BrokenRecord (REC-004)."""
    number, rest = 0, b""
    for block in blocks:
        *lines, rest = (rest + block).split(b"\n")
        for line in lines:
            number += 1
            yield _read_line(number, line)
        if len(rest) > LINE_BYTES_MAX:
            _read_line(number + 1, rest)
    if rest:
        detail = f"line {number + 1} has no end: the file is cut"
        raise BrokenRecord(EPISODES, "REC-004", detail)


def _read_line(number: int, line: bytes) -> EpisodeLine:
    if len(line) > LINE_BYTES_MAX:
        detail = f"line {number} is longer than {LINE_BYTES_MAX} bytes"
        raise BrokenRecord(EPISODES, "REC-030", detail)
    read = read_json(EPISODES, line, EpisodeLine, f"line {number}: ")
    _check_line(number, read)
    return read


def _check_line(number: int, line: EpisodeLine) -> None:
    """Raise BrokenRecord unless score and success fit the outcome (REC-009)."""
    unscored = line.outcome is None
    wrong = (
        line.success != (line.outcome == "success")
        or unscored != (line.score is None)
        or (line.outcome == "abandoned" and line.score != 0)
    )
    if wrong:
        detail = f"line {number}: outcome, success and score contradict each other"
        raise BrokenRecord(EPISODES, "REC-009", detail)
    # An episode that has a result was played, and so was recorded.
    if line.recording is None and not unscored:
        detail = f"line {number}: an episode with a result has no recording"
        raise BrokenRecord(EPISODES, "REC-009", detail)


def digests_by_name(statement: Statement[Any]) -> Mapping[str, str]:
    return {subject.name: subject.digest.sha256 for subject in statement.subject}
