"""Reads the recordings and records of the profile `record`, by spec/profiles/record.md.

The kit reads them without the server's code: MCAP with its public library, zip with
Python's, the signature by its definition. A file that cannot be read violates the rule
under test.
"""

import base64
import hashlib
import io
import zipfile
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any

import msgspec
from cryptography.exceptions import InvalidSignature
from cryptography.hazmat.primitives.asymmetric.ed25519 import Ed25519PublicKey
from mcap.exceptions import McapError
from mcap.records import Channel
from mcap.records import Message as McapMessage
from mcap.stream_reader import StreamReader

from conformance.exchanges.answer import Answer, file_of
from conformance.verdicts import expect

STATEMENT, MANIFEST, EPISODES = "statement.dsse.json", "manifest.json", "episodes.jsonl"
PAYLOAD_TYPE = "application/vnd.in-toto+json"
_STARTED = "started"


@dataclass(frozen=True)
class RecordingMessages:
    """The messages of a recording, in the order of the file: topic and members."""

    data: bytes
    messages: list[tuple[str, dict[str, Any]]]

    def of(self, topic: str) -> list[dict[str, Any]]:
        """Give the messages of a topic."""
        return [message for name, message in self.messages if name == topic]

    @property
    def started(self) -> list[dict[str, Any]]:
        """Give the starts of attempts, also those after a fault."""
        return [m for m in self.of("/attempt") if m.get("event") == _STARTED]

    @property
    def turns(self) -> list[dict[str, Any]]:
        """Give the turns that executed anything and were not lost by a fault."""
        broken = {(m.get("attempt"), m.get("seq")) for m in self.of("/fault")}
        return [
            turn
            for turn in self.of("/turn")
            if turn.get("steps")
            and (turn.get("attempt"), turn.get("seq")) not in broken
        ]

    @property
    def result(self) -> dict[str, Any]:
        """Give the result, which is the last message and the only one."""
        results = self.of("/result")
        expect.equal(len(results), 1, "number of results in the recording")
        expect.equal(self.messages[-1][0], "/result", "topic of the last message")
        return results[0]


@dataclass(frozen=True)
class RecordFiles:
    """A record: its bytes, its files by name, its statement, its lines."""

    data: bytes
    files: Mapping[str, bytes]
    statement: dict[str, Any]
    lines: list[dict[str, Any]] = field(default_factory=list)

    @property
    def predicate(self) -> dict[str, Any]:
        """Give the predicate of the host's statement on the run."""
        predicate = self.statement.get("predicate")
        expect.true(isinstance(predicate, dict), "a predicate", predicate)
        assert isinstance(predicate, dict)
        return predicate

    def recording(self, index: int) -> RecordingMessages:
        name = self.lines[index]["recording"]["path"]
        return read_recording(self.files[name])


def fetched_recording(answer: Answer) -> RecordingMessages:
    """Read the answer to `fetch_recording`."""
    expect.ok(answer)
    return read_recording(file_of(answer))


def fetched_record(answer: Answer) -> RecordFiles:
    """Read the answer to `fetch_record`, and check what makes it one."""
    expect.ok(answer)
    data = file_of(answer)
    files = dict(_files_of(data))
    expect.true({STATEMENT, MANIFEST, EPISODES} <= files.keys(), "files", list(files))
    statement = _statement_of(files[STATEMENT])
    lines = [_object(line) for line in files[EPISODES].splitlines()]
    _check_subjects(files, statement)
    return RecordFiles(data, files, statement, lines)


def read_recording(data: bytes) -> RecordingMessages:
    """Read an MCAP file, with its checksums."""
    topics: dict[int, str] = {}
    messages = []
    try:
        for record in StreamReader(io.BytesIO(data), validate_crcs=True).records:
            if isinstance(record, Channel):
                topics[record.id] = record.topic
            elif isinstance(record, McapMessage):
                topic = topics[record.channel_id]
                if not topic.startswith("/camera/"):
                    messages.append((topic, _object(record.data)))
    except (McapError, EOFError, KeyError, ValueError) as error:
        raise expect.Violation("a recording in MCAP", repr(error)) from error
    return RecordingMessages(data, messages)


def _files_of(data: bytes) -> Iterator[tuple[str, bytes]]:
    try:
        with zipfile.ZipFile(io.BytesIO(data)) as archive:
            names = [entry.filename for entry in archive.infolist()]
            expect.equal(len(set(names)), len(names), "number of different names")
            for entry in archive.infolist():
                expect.equal(entry.compress_type, zipfile.ZIP_STORED, "compression")
                yield entry.filename, archive.read(entry)
    except (zipfile.BadZipFile, NotImplementedError, EOFError) as error:
        raise expect.Violation("a record", repr(error)) from error


def verdicts_of(record: RecordFiles) -> list[dict[str, Any]]:
    """Read the verdicts in a record, each signed by the key that it names."""
    names = [name for name in record.files if name.startswith("verdicts/")]
    return [_statement_of(record.files[name], "verifier") for name in names]


def signed_bytes(payload: bytes) -> bytes:
    """Give the bytes that DSSE signs."""
    kind = PAYLOAD_TYPE.encode()
    return b"DSSEv1 %d %s %d %s" % (len(kind), kind, len(payload), payload)


def _statement_of(envelope_bytes: bytes, by: str = "host") -> dict[str, Any]:
    """Read the payload, whose signature is that of the key it names; `by` has it."""
    envelope = _object(envelope_bytes)
    expect.equal(envelope.get("payloadType"), PAYLOAD_TYPE, "payloadType")
    payload = base64.b64decode(envelope["payload"])
    statement = _object(payload)
    host = statement["predicate"][by]
    (signature,) = envelope["signatures"]
    expect.equal(signature["keyid"], host["keyid"], "keyid of the signature")
    public_key = base64.b64decode(host["public_key"])
    expect.equal(keyid_of(public_key), host["keyid"], "keyid")
    try:
        key = Ed25519PublicKey.from_public_bytes(public_key)
        key.verify(base64.b64decode(signature["sig"]), signed_bytes(payload))
    except (InvalidSignature, ValueError) as error:
        raise expect.Violation("the signature of its key", "another one") from error
    return statement


def keyid_of(public_key: bytes) -> str:
    return f"SHA256:{hashlib.sha256(public_key).hexdigest()}"


def _check_subjects(files: Mapping[str, bytes], statement: dict[str, Any]) -> None:
    said = {s["name"]: s["digest"]["sha256"] for s in statement["subject"]}
    digests = {
        name: hashlib.sha256(data).hexdigest()
        for name, data in files.items()
        if name != STATEMENT and not name.startswith("verdicts/")
    }
    expect.equal(said, digests, "digests of the files")


def _object(data: bytes) -> dict[str, Any]:
    try:
        decoded = msgspec.json.decode(data)
    except (msgspec.DecodeError, UnicodeDecodeError) as error:
        raise expect.Violation("JSON", f"{data[:80]!r}") from error
    expect.true(isinstance(decoded, dict), "an object", decoded)
    return expect.ExpectedBody(decoded)
