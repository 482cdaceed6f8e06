"""Makes the record of a finished run: its files, the signed statement, the stream.

Recordings are read in blocks, twice: once for their digests, once to be sent.
"""

from __future__ import annotations

import base64
import hashlib
import zlib
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import partial
from pathlib import Path

import msgspec

from reference_record.broken import UnusableRecord
from reference_record.command_line.replaced_file import replacing
from reference_record.contents.statement import (
    PREDICATE_TYPE,
    EpisodeLine,
    Evaluation,
    Host,
    write_statement,
)
from reference_record.formats.archive import (
    BLOCK_BYTES,
    Content,
    archive_size,
    stream_archive,
)
from reference_record.formats.bundle import FOLDERS, Bundle
from reference_record.formats.envelope import sign_envelope
from reference_record.formats.names import (
    EPISODES,
    EPISODES_MAX,
    MANIFEST,
    STATEMENT,
    order,
    verdict_name,
)
from reference_record.keys import SigningKey


@dataclass(frozen=True, slots=True)
class Record:
    """A record that can be sent or saved. contents: name → content of the file."""

    contents: Mapping[str, Content]
    statement_sha256: str

    @property
    def size(self) -> int:
        """Bytes of the archive; raises UnusableRecord where there can be none."""
        return archive_size(self.contents.items())

    def stream(self) -> Iterator[bytes]:
        """REC-002: the archive, block by block, in constant memory."""
        return stream_archive(self.contents.items())


@dataclass(frozen=True, slots=True)
class UnsignedRecord:
    """All files of a record but its statement, and their SHA-256, by name."""

    contents: Mapping[str, Content]
    digests: Mapping[str, str]

    def sign(self, evaluation: Evaluation, key: SigningKey) -> Record:
        """Raises UnusableRecord where the evaluation is of another manifest."""
        if self.digests[MANIFEST] != evaluation.manifest_sha256:
            raise UnusableRecord("the manifest has another digest than the run")
        subjects = sorted(self.digests.items(), key=lambda item: order(item[0]))
        payload = write_statement(subjects, PREDICATE_TYPE, evaluation)
        return self.with_statement(sign_envelope(payload, key))

    def with_statement(self, statement: bytes) -> Record:
        """The record that was signed before, from its statement."""
        digest = hashlib.sha256(statement).hexdigest()
        return Record({**self.contents, STATEMENT: _of_bytes(statement)}, digest)


def host_of(name: str, key: SigningKey) -> Host:
    return Host(name, key.keyid, base64.b64encode(key.public_key).decode())


def read_files(
    *, manifest: bytes, lines: Iterable[EpisodeLine], recordings: Mapping[str, Path]
) -> UnsignedRecord:
    """Read every file once, for its digest.

    recordings: name in the record → file on this machine. Raises UnusableRecord if one
    does not have the digest that its line says, and OSError if it cannot be read.
    """
    all_lines = list(lines)
    if len(all_lines) > EPISODES_MAX:
        raise UnusableRecord(f"a record has at most {EPISODES_MAX} episodes")
    encoder = msgspec.json.Encoder()
    episodes = b"".join(encoder.encode(line) + b"\n" for line in all_lines)
    contents = {MANIFEST: _of_bytes(manifest), EPISODES: _of_bytes(episodes)}
    digests = {
        MANIFEST: hashlib.sha256(manifest).hexdigest(),
        EPISODES: hashlib.sha256(episodes).hexdigest(),
    }
    for line in all_lines:
        if line.recording is not None:
            name = line.recording.path
            contents[name], digests[name] = _of_file(recordings[name])
            if digests[name] != line.recording.sha256:
                raise UnusableRecord(f"{name} is not what was recorded")
    return UnsignedRecord(contents, digests)


def add_verdict(bundle: Bundle, path: Path, name: str, verdict: bytes) -> None:
    """Put a verdict into the record at `path`; one of the same name is replaced.

    The record is whole at every moment. Raises OSError.
    """
    file = verdict_name(name)
    if path.is_dir():
        (path / FOLDERS[1]).mkdir(exist_ok=True)
        save_blocks(path / file, [verdict])
        return
    save_blocks(path, stream_archive(with_verdict(bundle, name, verdict).items()))


def with_verdict(
    bundle: Bundle, name: str, verdict: bytes | None
) -> dict[str, Content]:
    """The files of a record and one more verdict, if there is one.

    One of the same name is replaced.
    """
    contents = {file: _of_bundle(bundle, file) for file in bundle.sizes}
    if verdict is not None:
        contents[verdict_name(name)] = _of_bytes(verdict)
    return contents


def save_blocks(path: Path, blocks: Iterable[bytes]) -> None:
    """Write a file that has its name only when it is whole. Raises OSError."""
    with replacing(path) as draft, draft.open("wb") as file:
        file.writelines(blocks)


def _of_bytes(data: bytes) -> Content:
    return Content(len(data), zlib.crc32(data), lambda: [data])


def _of_file(path: Path) -> tuple[Content, str]:
    size, crc, digest = 0, 0, hashlib.sha256()
    for block in blocks_of(path):
        size, crc = size + len(block), zlib.crc32(block, crc)
        digest.update(block)
    return Content(size, crc, partial(blocks_of, path)), digest.hexdigest()


def _of_bundle(bundle: Bundle, name: str) -> Content:
    crc = 0
    for block in bundle.blocks(name):
        crc = zlib.crc32(block, crc)
    return Content(bundle.sizes[name], crc, partial(bundle.blocks, name))


def blocks_of(path: Path) -> Iterator[bytes]:
    """The bytes of a file, a block at a time."""
    with path.open("rb") as file:
        while block := file.read(BLOCK_BYTES):
            yield block
