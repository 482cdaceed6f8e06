"""Records that the kit makes of one that it fetched: changed, and signed again or not.

By spec/profiles/record.md: the form of the archive, DSSE, and MCAP by its library.
"""

import base64
import copy
import hashlib
import io
import json
import struct
import zlib
from collections.abc import Callable, Mapping
from typing import Any

from cryptography.hazmat.primitives.asymmetric.ed25519 import Ed25519PrivateKey
from mcap.records import Channel, Schema
from mcap.records import Message as McapMessage
from mcap.stream_reader import StreamReader
from mcap.writer import Writer

from conformance.profiles.record_files import (
    EPISODES,
    MANIFEST,
    PAYLOAD_TYPE,
    STATEMENT,
    RecordFiles,
    keyid_of,
    signed_bytes,
)

Files = Mapping[str, bytes]
Change = Callable[[dict[str, Any]], object]
# A key of the kit, which no server trusts.
KEY = Ed25519PrivateKey.from_private_bytes(bytes(range(100, 132)))


def pack(files: Files) -> bytes:
    """Give the archive of these files, in their order (REC-002)."""
    contents = directory = b""
    for name, data in files.items():
        sizes = zlib.crc32(data), len(data), len(data), len(name), 0
        entry = struct.pack("<HHHHHIIIHH", 10, 0, 0, 0, 33, *sizes)
        place = struct.pack("<HHHII", 0, 0, 0, 0, len(contents))
        directory += b"PK\1\2\n\0" + entry + place + name.encode()
        contents += b"PK\3\4" + entry + name.encode() + data
    count = len(files)
    sizes_of_all = count, count, len(directory), len(contents), 0
    return (
        contents + directory + b"PK\5\6" + struct.pack("<HHHHIIH", 0, 0, *sizes_of_all)
    )


def signed_again(
    record: RecordFiles, changed: Files, change: Change = lambda _: None
) -> dict[str, bytes]:
    """Give the files with some changed, and a statement that fits, by the kit's key.

    `change` may spoil the predicate.
    """
    files = {**without_verdicts(record.files), **changed}
    statement = copy.deepcopy(record.statement)
    statement["subject"] = [
        {"name": name, "digest": {"sha256": hashlib.sha256(data).hexdigest()}}
        for name, data in files.items()
        if name != STATEMENT
    ]
    _sign_as(statement["predicate"]["host"])
    change(statement["predicate"])
    files[STATEMENT] = _envelope(statement)
    return files


def verdict_by_kit(verdict: Mapping[str, Any]) -> bytes:
    """Give a verdict again, as one of the kit's key."""
    statement = copy.deepcopy(dict(verdict))
    verifier = statement["predicate"]["verifier"]
    _sign_as(verifier)
    verifier |= {"id": f"urn:proctor:key:{verifier['keyid']}", "name": "kit"}
    return _envelope(statement)


def _sign_as(signer: dict[str, Any]) -> None:
    """Name the kit's key as that of a host or a verifier."""
    public_key = KEY.public_key().public_bytes_raw()
    signer["keyid"] = keyid_of(public_key)
    signer["public_key"] = base64.b64encode(public_key).decode()


def _envelope(statement: dict[str, Any]) -> bytes:
    """Sign a statement by the kit's key."""
    payload = json.dumps(statement).encode()
    envelope = {
        "payload": base64.b64encode(payload).decode(),
        "payloadType": PAYLOAD_TYPE,
        "signatures": [
            {
                "keyid": keyid_of(KEY.public_key().public_bytes_raw()),
                "sig": base64.b64encode(KEY.sign(signed_bytes(payload))).decode(),
            }
        ],
    }
    return json.dumps(envelope, separators=(",", ":")).encode()


def without_verdicts(files: Files) -> dict[str, bytes]:
    """Give the files that the host signed."""
    return {n: data for n, data in files.items() if not n.startswith("verdicts/")}


def with_changed_turn(
    record: RecordFiles,
    index: int,
    seq: int,
    change: Callable[[dict[str, Any]], object],
) -> dict[str, bytes]:
    """Give a record, signed again, in which a turn of an episode was changed."""
    line = copy.deepcopy(dict(record.lines[index]))
    name = line["recording"]["path"]

    def change_turn(topic: str, message: dict[str, Any]) -> None:
        if topic == "/turn" and message["seq"] == seq:
            change(message)

    data = _rewritten(record.files[name], change_turn)
    line["recording"] |= {
        "sha256": hashlib.sha256(data).hexdigest(),
        "bytes": len(data),
    }
    lines = [*record.lines[:index], line, *record.lines[index + 1 :]]
    return signed_again(record, {name: data, EPISODES: lines_file(lines)})


def lines_file(lines: list[dict[str, Any]]) -> bytes:
    """Give the bytes of episodes.jsonl."""
    return b"".join(json.dumps(line).encode() + b"\n" for line in lines)


def _rewritten(
    recording: bytes, change: Callable[[str, dict[str, Any]], None]
) -> bytes:
    """Give an MCAP file with the messages of another one, each of them changed."""
    output = io.BytesIO()
    writer = Writer(output)
    writer.start()
    schemas, channels, topics = {0: 0}, dict[int, int](), dict[int, str]()
    for record in StreamReader(io.BytesIO(recording)).records:
        if isinstance(record, Schema) and record.id not in schemas:
            schemas[record.id] = writer.register_schema(
                record.name, record.encoding, record.data
            )
        elif isinstance(record, Channel) and record.id not in channels:
            channels[record.id] = writer.register_channel(
                record.topic, record.message_encoding, schemas[record.schema_id]
            )
            topics[record.id] = record.topic
        elif isinstance(record, McapMessage):
            message = json.loads(record.data)
            change(topics[record.channel_id], message)
            writer.add_message(
                channels[record.channel_id],
                record.log_time,
                json.dumps(message).encode(),
                record.publish_time,
            )
    writer.finish()  # type: ignore[no-untyped-call]  # of the library
    return output.getvalue()


def broken_archives(record: RecordFiles) -> dict[str, tuple[bytes, str, str]]:
    """Give archives that break one rule each: what is wrong → bytes, file, rule."""
    files = without_verdicts(record.files)
    good = pack(files)
    name = record.lines[0]["recording"]["path"]
    size_at = good.index(b"PK\3\4", 4) + 18
    huge = struct.pack("<II", 2**32 - 1, 2**32 - 1)

    def raise_score(predicate: dict[str, Any]) -> None:
        predicate["score"]["mean"] = predicate["score"]["score"] = 1.0

    two_lines = {EPISODES: lines_file(record.lines[:-1])}
    changed = {name: _flipped(files[name]), MANIFEST: _flipped(files[MANIFEST])}
    outside = "episodes/../../outside"
    of_4_gib = good[:size_at] + huge + good[size_at + 8 :]
    manifest = pack(files | {MANIFEST: changed[MANIFEST]})
    less = pack(signed_again(record, two_lines))
    raised = pack(signed_again(record, {}, raise_score))
    bare = pack(_with_bytes_as_recording(record, name))
    return {
        "no archive": (b"{}", "archive", "REC-002"),
        "a byte behind it": (good + b"\0", "archive", "REC-002"),
        "cut in its directory": (good[:-1], "archive", "REC-002"),
        "an unknown file": (pack(files | {"notes": b"x"}), "notes", "REC-001"),
        "a path that leads out": (pack(files | {outside: b"x"}), outside, "REC-001"),
        "no manifest": (pack(_without(files, MANIFEST)), MANIFEST, "REC-001"),
        "a size of 4 GiB": (of_4_gib, MANIFEST, "REC-030"),
        "a wrong signature": (_with_bit_of_signature(files), STATEMENT, "REC-006"),
        "a byte of the manifest": (manifest, MANIFEST, "REC-008"),
        "a byte of a recording": (pack(files | {name: changed[name]}), name, "REC-008"),
        "an episode left out": (less, EPISODES, "REC-009"),
        "no recording inside": (bare, name, "REC-012"),
        "a raised score": (raised, STATEMENT, "REC-013"),
    }


def _without(files: Files, name: str) -> dict[str, bytes]:
    return {file: data for file, data in files.items() if file != name}


def _flipped(data: bytes) -> bytes:
    """Give bytes of which the one in the middle is another one."""
    middle = len(data) // 2
    return data[:middle] + bytes([data[middle] ^ 1]) + data[middle + 1 :]


def _with_bit_of_signature(files: Files) -> bytes:
    envelope = json.loads(files[STATEMENT])
    signature = base64.b64decode(envelope["signatures"][0]["sig"])
    envelope["signatures"][0]["sig"] = base64.b64encode(_flipped(signature)).decode()
    statement = json.dumps(envelope, separators=(",", ":")).encode()
    return pack({**files, STATEMENT: statement})


def _with_bytes_as_recording(record: RecordFiles, name: str) -> dict[str, bytes]:
    """Give a record, signed again, with text where a recording should be."""
    data = b"no MCAP"
    lines = copy.deepcopy(list(record.lines))
    for line in lines:
        if line["recording"]["path"] == name:
            digest = hashlib.sha256(data).hexdigest()
            line["recording"] |= {"sha256": digest, "bytes": len(data)}
    return signed_again(record, {name: data, EPISODES: lines_file(lines)})
