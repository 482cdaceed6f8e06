"""Records that are broken in one way each, with the file and rule to be named.

tools/record_vectors.py writes them to spec/vectors/record/.
"""

import base64
import io
import struct
import zipfile
import zlib
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

import msgspec
import zstandard

from reference_record.contents.statement import EpisodeLine
from reference_record.formats.archive import stream_archive
from reference_record.formats.envelope import sign_envelope, signed_bytes
from reference_record.formats.names import EPISODES, MANIFEST, STATEMENT, recording_name
from reference_record.recordings.recording import (
    MAGIC,
    EpisodeResult,
    Message,
    record,
    text,
)
from tests.support.record.sample_records import (
    HOST_KEY,
    OTHER_KEY,
    Messages,
    Sample,
    content_of,
    contents_of,
    failure,
    good_replay,
    make_archive,
    make_verdict,
    success,
    turn,
)

FIRST = recording_name(0)
VERDICT = "verdicts/another-lab.dsse.json"


@dataclass(frozen=True)
class Broken:
    """An archive, and what a verifier says of it."""

    archive: bytes
    file: str
    rule: str
    description: str


def pack(contents: Mapping[str, bytes]) -> bytes:
    """An archive of these files, whatever their names."""
    packed = {n: content_of(data, zlib.crc32(data)) for n, data in contents.items()}
    return b"".join(stream_archive(packed.items()))


def good_archive_with_verdict() -> bytes:
    good = make_archive()
    return pack(contents_of(good) | {VERDICT: make_verdict(good)})


def broken_records() -> dict[str, Broken]:
    """Name → record, sorted by name."""
    cases = {**_broken_archives(), **_broken_signatures(), **_broken_files()}
    cases |= {**_broken_contents(), **_broken_verdicts()}
    cases |= {**_broken_recordings(), **_broken_mcap_files()}
    return dict(sorted(cases.items()))


def _broken_archives() -> dict[str, Broken]:
    good = make_archive()
    contents = contents_of(good)
    first = good.index(b"PK\x03\x04", 4)
    second = good.index(b"PK\x03\x04", first + 4)
    evil = "episodes/../../outside"
    return {
        "bytes_before": Broken(
            b"\0" + good, "archive", "REC-002", "A byte stands before the archive."
        ),
        "bytes_behind": Broken(
            good + b"\0", "archive", "REC-002", "A byte stands behind the archive."
        ),
        "cut": Broken(
            good[: len(good) // 2],
            recording_name(1),
            "REC-002",
            "The second half is missing.",
        ),
        "directory_disagrees": Broken(
            good[:-70] + good[-70:].replace(b"00003", b"00002"),
            "archive",
            "REC-002",
            "The directory at the end gives a file another name.",
        ),
        "file_twice": Broken(
            good[:second] + good[first:second] + good[second:],
            MANIFEST,
            "REC-002",
            "A file stands twice.",
        ),
        "compressed": Broken(
            _deflated(contents), STATEMENT, "REC-002", "The files are compressed."
        ),
        "outside_path": Broken(
            pack(contents | {evil: b"x"}),
            evil,
            "REC-001",
            "The name of a file leads out of the record.",
        ),
        "file_unknown": Broken(
            pack(contents | {"notes.txt": b"x"}),
            "notes.txt",
            "REC-001",
            "A record has no such file.",
        ),
        "no_manifest": Broken(
            pack({n: d for n, d in contents.items() if n != MANIFEST}),
            MANIFEST,
            "REC-001",
            "The manifest is missing.",
        ),
        "size_of_4_gib": Broken(
            good[:first] + _with_size(good[first:], 2**32 - 1),
            MANIFEST,
            "REC-030",
            "A header announces 4 GiB.",
        ),
    }


def _deflated(contents: Mapping[str, bytes]) -> bytes:
    file = io.BytesIO()
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, data in contents.items():
            archive.writestr(zipfile.ZipInfo(name), data, zipfile.ZIP_DEFLATED)
    return file.getvalue()


def _with_size(archive: bytes, size: int) -> bytes:
    return archive[:18] + struct.pack("<II", size, size) + archive[26:]


def _broken_signatures() -> dict[str, Broken]:
    contents = contents_of(make_archive())
    envelope = msgspec.json.decode(contents[STATEMENT])
    payload = base64.b64decode(envelope["payload"])
    better = payload.replace(b'"success_rate":0.5', b'"success_rate":1.0')
    assert better != payload
    by_other = OTHER_KEY.sign(signed_bytes(payload))

    def signed(payload: bytes, signature: bytes | None = None) -> bytes:
        changed = sign_envelope(payload, HOST_KEY)
        kept = base64.b64decode(envelope["signatures"][0]["sig"])
        wanted = base64.b64encode(signature or kept)
        made = base64.b64encode(HOST_KEY.sign(signed_bytes(payload)))
        return changed.replace(made, wanted)

    spaced = contents[STATEMENT].replace(b'","payloadType"', b'", "payloadType"')
    texts = {
        "payload_changed": (
            signed(better),
            "REC-006",
            "The score was raised and not signed again.",
        ),
        "signed_by_another_key": (
            signed(payload, by_other),
            "REC-006",
            "The signature is that of another key.",
        ),
        "keyid_of_another_key": (
            sign_envelope(payload, OTHER_KEY),
            "REC-006",
            "The keyid is not that of the key in the statement.",
        ),
        "envelope_with_a_space": (
            spaced,
            "REC-005",
            "The envelope has another form of the same JSON.",
        ),
    }
    return {
        name: Broken(pack(contents | {STATEMENT: data}), STATEMENT, rule, description)
        for name, (data, rule, description) in texts.items()
    }


def _broken_files() -> dict[str, Broken]:
    contents = contents_of(make_archive())
    better = contents[EPISODES].replace(b'"score":0.25', b'"score":0.75')
    changed = bytearray(contents[FIRST])
    changed[len(changed) // 2] ^= 1
    extra = recording_name(4)
    return {
        "episodes_changed": Broken(
            pack(contents | {EPISODES: better}),
            EPISODES,
            "REC-008",
            "The score of an episode was raised.",
        ),
        "recording_changed": Broken(
            pack(contents | {FIRST: bytes(changed)}),
            FIRST,
            "REC-008",
            "One bit of a recording differs.",
        ),
        "recording_missing": Broken(
            pack({n: d for n, d in contents.items() if n != FIRST}),
            FIRST,
            "REC-007",
            "A recording is missing.",
        ),
        "recording_not_listed": Broken(
            pack(contents | {extra: contents[FIRST]}),
            extra,
            "REC-007",
            "A recording is not listed in the statement.",
        ),
        "manifest_of_another_run": Broken(
            _with_manifest_digest("0" * 64),
            MANIFEST,
            "REC-008",
            "The manifest is not that of the run.",
        ),
    }


def _with_manifest_digest(sha256: str) -> bytes:
    """Signed by the host, with another manifest_sha256."""
    contents = contents_of(make_archive())
    payload = base64.b64decode(msgspec.json.decode(contents[STATEMENT])["payload"])
    said = msgspec.json.decode(payload)
    said["predicate"]["manifest_sha256"] = sha256
    said["predicate"]["score"]["manifest_sha256"] = sha256
    statement = sign_envelope(msgspec.json.encode(said), HOST_KEY)
    return pack(contents | {STATEMENT: statement})


Lines = list[EpisodeLine]


def _broken_contents() -> dict[str, Broken]:
    good = Sample()

    def of_lines(change: Callable[[Lines], Lines]) -> bytes:
        return make_archive(Sample(change_lines=change))

    def first(line: EpisodeLine, **changes: object) -> EpisodeLine:
        return msgspec.structs.replace(line, **changes)

    twice = good.manifest.replace(b'"version"', b'"version":"1","version"')
    return {
        "member_twice": Broken(
            make_archive(Sample(manifest=twice)),
            MANIFEST,
            "REC-004",
            "A member of the manifest stands twice.",
        ),
        "episode_missing": Broken(
            make_archive(replace(good, episodes=good.episodes[:3])),
            EPISODES,
            "REC-009",
            "The last episode of the manifest is missing.",
        ),
        "episode_twice": Broken(
            of_lines(lambda lines: [lines[0], lines[0], *lines[2:]]),
            EPISODES,
            "REC-009",
            "An episode stands twice, and another not at all.",
        ),
        "episode_of_another_task": Broken(
            of_lines(lambda lines: [first(lines[0], task="stack"), *lines[1:]]),
            EPISODES,
            "REC-009",
            "The manifest has another task.",
        ),
        "success_with_score_null": Broken(
            of_lines(lambda lines: [first(lines[0], score=None), *lines[1:]]),
            EPISODES,
            "REC-009",
            "A success has no score.",
        ),
        "result_disagrees": Broken(
            of_lines(lambda lines: [lines[0], first(lines[1], score=0.75), *lines[2:]]),
            recording_name(1),
            "REC-010",
            "A line has a better score than the recording.",
        ),
        "digests_disagree": Broken(
            of_lines(lambda lines: [_with_digest(lines[0]), *lines[1:]]),
            FIRST,
            "REC-010",
            "A line has another last state digest than the recording.",
        ),
        "score_raised": Broken(
            make_archive(Sample(change_score={"score": 0.75})),
            STATEMENT,
            "REC-013",
            "The score is not the mean of the episodes.",
        ),
        "counts_raised": Broken(
            make_archive(Sample(change_score={"by_split": {}})),
            STATEMENT,
            "REC-013",
            "A split of the score is missing.",
        ),
    }


def _with_digest(line: EpisodeLine) -> EpisodeLine:
    assert line.recording is not None
    facts = msgspec.structs.replace(line.recording, last_digest="00")
    return msgspec.structs.replace(line, recording=facts)


def _broken_recordings() -> dict[str, Broken]:
    def of_first(messages: Messages) -> bytes:
        return make_archive(Sample(episodes=[messages, *Sample().episodes[1:]]))

    start, one, two, end, scored = success(0)
    better = "/result", EpisodeResult("success", True, 1.0, 2, 1, "")
    cases = {
        "score_without_turns": (
            of_first([*failure(0)[:-1], better]),
            "REC-011",
            "The last turn is no success, and the result is.",
        ),
        "steps_left_out": (
            of_first([start, two, end, scored]),
            "REC-011",
            "A turn was taken out: the steps do not add up.",
        ),
        "episode_not_ended": (
            of_first([start, one, turn(1, 2, 0, score=1.0), end, scored]),
            "REC-011",
            "The last turn did not end the episode, and a result follows.",
        ),
        "steps_without_actions": (
            of_first([start, _with_steps(one, 1), _with_steps(two, 3), end, scored]),
            "REC-012",
            "A turn has more actions than steps, the next one fewer.",
        ),
        "turn_behind_the_result": (
            of_first([start, one, two, end, scored, turn(1, 3, 0, score=1.0)]),
            "REC-012",
            "A turn stands behind the result.",
        ),
        "attempts_go_back": (
            of_first([_attempt_2(start), start, one, two, end, scored]),
            "REC-012",
            "The first attempt begins behind the second.",
        ),
    }
    return {
        name: Broken(archive, FIRST, rule, description)
        for name, (archive, rule, description) in cases.items()
    }


def _broken_mcap_files() -> dict[str, Broken]:
    def of_bytes(data: bytes) -> bytes:
        sample = Sample(change_recording=lambda index, kept: kept if index else data)
        return make_archive(sample)

    cases = {
        "recording_is_no_mcap": (of_bytes(b"x" * 99), "REC-012", "It is no MCAP."),
        "recording_cut": (
            of_bytes(_recording(_chunk(b"", 0))[:-1]),
            "REC-012",
            "The recording was cut before it was signed.",
        ),
        "chunk_of_1_tib": (
            of_bytes(_recording(_chunk(b"", 2**40))),
            "REC-030",
            "A chunk announces 1 TiB.",
        ),
        "zip_bomb": (
            of_bytes(_recording(_bomb() * 3)),
            "REC-030",
            "Chunks of zeros, each within the bound, expand too far.",
        ),
        "records_without_end": (
            of_bytes(_recording(_empty_records() * 3)),
            "REC-030",
            "Chunks of empty records: few bytes, and far too many records.",
        ),
        "index_in_a_chunk": (
            of_bytes(_recording(_chunk(record(0x07, b""), 9))),
            "REC-012",
            "A chunk holds a record that is no schema, channel or message.",
        ),
        "frame_says_more": (
            of_bytes(_recording(_chunk(b"\0" * 2**20, 10))),
            "REC-012",
            "A compressed chunk is larger than it says.",
        ),
    }
    return {
        name: Broken(archive, FIRST, rule, description)
        for name, (archive, rule, description) in cases.items()
    }


def _attempt_2(start: tuple[str, Message]) -> tuple[str, Message]:
    topic, event = start
    return topic, msgspec.structs.replace(event, attempt=2)


def _with_steps(entry: tuple[str, Message], steps: int) -> tuple[str, Message]:
    topic, said = entry
    return topic, msgspec.structs.replace(said, steps=steps)


def _recording(records: bytes) -> bytes:
    footer = record(2, struct.pack("<QQI", 0, 0, 0))
    return MAGIC + record(1, text("") + text("")) + records + footer + MAGIC


def _chunk(data: bytes, announced: int) -> bytes:
    packed = zstandard.ZstdCompressor().compress(data)
    head = struct.pack("<QQQI", 0, 0, announced, 0) + text("zstd")
    return record(6, head + struct.pack("<Q", len(packed)) + packed)


def _bomb() -> bytes:
    """32 MiB in 1 kB: a schema of zeros, which is skipped."""
    size = 2**25
    return _chunk(struct.pack("<BQ", 0x03, size - 9) + bytes(size - 9), size)


def _empty_records() -> bytes:
    """4 MiB of empty schemas."""
    records = record(0x03, b"") * (2**22 // 9)
    return _chunk(records, len(records))


def _broken_verdicts() -> dict[str, Broken]:
    good = make_archive()
    contents = contents_of(good)
    verdict = make_verdict(good)
    foreign = make_verdict(good, statement_sha256="0" * 64)
    five = msgspec.structs.replace(good_replay(), episodes=5, exact=5)
    too_many = make_verdict(good, five)
    changed = bytearray(verdict)
    changed[20] = ord("B") if changed[20] == ord("A") else ord("A")
    cases = {
        "verdict_on_more_episodes": (too_many, "REC-014", "It counts 5 episodes of 4."),
        "verdict_on_another_record": (
            foreign,
            "REC-014",
            "It is about another record.",
        ),
        "verdict_changed": (bytes(changed), "REC-006", "One character differs."),
    }
    return {
        name: Broken(pack(contents | {VERDICT: data}), VERDICT, rule, description)
        for name, (data, rule, description) in cases.items()
    }
