"""Reads an OCI archive: a tar file with an index, a manifest, and layers by digest.

The format is that of the OCI image specification 1.1, as `docker buildx`, `podman
save --format oci-archive` and `skopeo copy` write it. Each blob is checked against its
digest.
"""

from __future__ import annotations

import platform
import re
import sys
import tarfile
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import BinaryIO, TypeVar

import msgspec

from reference_platform.images.bounded_archives import (
    READ_BYTES_MAX,
    Budget,
    DigestReader,
    ForwardReader,
    InvalidArchive,
    decompressed,
    tar_entries,
)
from reference_platform.images.file_tree import FileTree

_BLOBS_MAX = 2000
_LAYERS_MAX = 256
_DIGEST = re.compile(r"sha256:[0-9a-f]{64}")
_INDEX_TYPES = (
    "application/vnd.oci.image.index.v1+json",
    "application/vnd.docker.distribution.manifest.list.v2+json",
)
_HOW = (
    "Write one with `docker buildx build --output type=oci,dest=policy.tar .`, or "
    "`skopeo copy docker-archive:FILE oci-archive:policy.tar`"
)
# How a file begins that must be unpacked first: what it is, and a command that does it.
_BEGIN_BYTES = 6
_COMPRESSIONS = {
    b"\x1f\x8b": ("gzip", "gunzip"),
    b"\x28\xb5\x2f\xfd": ("zstd", "unzstd"),
    b"\xfd7zXZ\x00": ("xz", "unxz"),
    b"BZh": ("bzip2", "bunzip2"),
    b"PK\x03\x04": ("zip", "unzip"),
}
# The folders that a sandbox mounts over an image.
MOUNT_POINTS = ("dev", "policy", "proc", "run", "tmp")

T = TypeVar("T")


class Platform(msgspec.Struct):
    """For which machines a manifest is."""

    architecture: str = ""
    os: str = ""


class Descriptor(msgspec.Struct):
    """Names a blob."""

    digest: str
    media_type: str = msgspec.field(name="mediaType", default="")
    platform: Platform | None = None


class Index(msgspec.Struct):
    """index.json, and an index that it names."""

    manifests: list[Descriptor]


class Manifest(msgspec.Struct):
    """An image: its configuration and its layers, the lowest first."""

    config: Descriptor
    layers: list[Descriptor]


class Process(msgspec.Struct):
    """How the image is started; other members are of no interest here."""

    entrypoint: list[str] | None = msgspec.field(name="Entrypoint", default=None)
    command: list[str] | None = msgspec.field(name="Cmd", default=None)
    environment: list[str] | None = msgspec.field(name="Env", default=None)
    directory: str | None = msgspec.field(name="WorkingDir", default=None)


class ImageConfig(msgspec.Struct):
    """The configuration of an image."""

    architecture: str = ""
    os: str = ""
    config: Process | None = None


class ImageProgram(msgspec.Struct, frozen=True):
    """The program of an unpacked image. remarks: what was left out, for the log."""

    command: list[str]
    environment: dict[str, str]
    directory: str
    remarks: list[str]


@dataclass(frozen=True, slots=True)
class _Blobs:
    """Where each blob is in the file."""

    file: BinaryIO
    places: dict[str, tuple[int, int]]

    def open(self, digest: str) -> DigestReader:
        """Raises InvalidArchive."""
        if not _DIGEST.fullmatch(digest) or digest not in self.places:
            raise InvalidArchive(f"{digest[:80]} is named and is not in the archive.")
        return DigestReader(self.file, *self.places[digest])

    def read(self, digest: str, model: type[T]) -> T:
        """A small blob of JSON. Raises InvalidArchive."""
        reader = self.open(digest)
        if self.places[digest][1] > READ_BYTES_MAX:
            raise InvalidArchive(f"{digest} is too large to be a description.")
        text = b"".join(iter(lambda: reader.read(2**16), b""))
        reader.check(digest)
        return _decoded(text, model, digest)


def unpack_image(
    archive: Path, target: Path, scratch: Path, budget: Budget
) -> ImageProgram:
    """Write the root of an image as a new folder. Raises InvalidArchive."""
    with archive.open("rb") as file:
        blobs, manifest, config = _read_image(file)
        tree = FileTree(scratch)
        for layer in manifest.layers:
            reader = blobs.open(layer.digest)
            for entry, content in tar_entries(decompressed(reader), budget):
                tree.add(entry, content)
            reader.check(layer.digest)
    tree.make_folders(MOUNT_POINTS)
    tree.write(target)
    return _program(config.config or Process(), tree.remarks.texts())


def read_program(archive: Path) -> ImageProgram:
    """The program of an image, whose layers are there and are not unpacked.

    Raises InvalidArchive.
    """
    with archive.open("rb") as file:
        blobs, manifest, config = _read_image(file)
        for layer in manifest.layers:
            blobs.open(layer.digest)
    return _program(config.config or Process(), [])


def _read_image(file: BinaryIO) -> tuple[_Blobs, Manifest, ImageConfig]:
    """All but its layers. Raises InvalidArchive."""
    blobs, index = _read_blobs(file)
    manifest = _manifest(blobs, index)
    config = blobs.read(manifest.config.digest, ImageConfig)
    _check_machine(config.architecture, config.os)
    if len(manifest.layers) > _LAYERS_MAX:
        raise InvalidArchive(f"It has more than {_LAYERS_MAX} layers.")
    return blobs, manifest, config


def _entries(
    file: BinaryIO, budget: Budget
) -> Iterator[tuple[tarfile.TarInfo, ForwardReader]]:
    """Those of the outer archive. Raises InvalidArchive, with the way out."""
    begin = file.read(_BEGIN_BYTES)
    file.seek(0)
    for signature, (format_name, command) in _COMPRESSIONS.items():
        if begin.startswith(signature):
            raise InvalidArchive(
                f"It is compressed with {format_name}, and an OCI archive is a tar "
                f"file that is not: `{command}` it."
            )
    has_entries = False
    try:
        for entry in tar_entries(file, budget):
            has_entries = True
            yield entry
    except tarfile.TarError as error:
        if has_entries:
            raise InvalidArchive(
                "It ends early: the file is a part of an archive. Write it anew."
            ) from error
        raise InvalidArchive(f"It is no tar file. {_HOW}.") from error


def _read_blobs(file: BinaryIO) -> tuple[_Blobs, Index]:
    """One pass over the outer archive, whose contents are skipped by their size."""
    places: dict[str, tuple[int, int]] = {}
    index: Index | None = None
    names = set()
    size = file.seek(0, 2)
    file.seek(0)
    budget = Budget(size, _BLOBS_MAX)
    for entry, reader in _entries(file, budget):
        name = entry.name.removeprefix("./")
        names.add(name)
        if not entry.isreg() or entry.issparse():
            continue
        if name.startswith("blobs/sha256/"):
            digest = "sha256:" + name.removeprefix("blobs/sha256/")
            places[digest] = (reader.position, entry.size)
        elif name == "index.json":
            index = _decoded(reader.read(entry.size), Index, name)
    if index is None:
        what = "an archive of `docker save`" if "manifest.json" in names else "no image"
        raise InvalidArchive(f"It has no index.json: it is {what}. {_HOW}.")
    return _Blobs(file, places), index


def _manifest(blobs: _Blobs, index: Index) -> Manifest:
    """The manifest for this machine; an index may name another one, once."""
    chosen = _chosen(index)
    if chosen.media_type in _INDEX_TYPES:
        chosen = _chosen(blobs.read(chosen.digest, Index))
    return blobs.read(chosen.digest, Manifest)


def _chosen(index: Index) -> Descriptor:
    ours = [
        manifest
        for manifest in index.manifests
        if manifest.platform is None
        or (manifest.platform.os, manifest.platform.architecture) == _machine()
    ]
    if not ours:
        raise InvalidArchive(
            f"It has no image for {'/'.join(_machine())}. Build it with --platform "
            f"{'/'.join(_machine())}."
        )
    return ours[0]


def _check_machine(architecture: str, system: str) -> None:
    if (system, architecture) != _machine():
        raise InvalidArchive(
            f"It is an image for {system[:20]}/{architecture[:20]}, and this platform "
            f"has {'/'.join(_machine())}. Build it with --platform "
            f"{'/'.join(_machine())}."
        )


def _machine() -> tuple[str, str]:
    machine = platform.machine().lower()
    return sys.platform, {"x86_64": "amd64", "aarch64": "arm64"}.get(machine, machine)


def _program(process: Process, remarks: list[str]) -> ImageProgram:
    command = [*(process.entrypoint or []), *(process.command or [])]
    if not command:
        raise InvalidArchive("It has neither ENTRYPOINT nor CMD: nothing would start.")
    environment = dict(
        pair.split("=", 1) for pair in process.environment or [] if "=" in pair
    )
    texts = [*command, *environment, *environment.values(), process.directory or "/"]
    if any("\0" in text for text in texts):
        raise InvalidArchive("Its command or environment has a NUL.")
    return ImageProgram(command, environment, process.directory or "/", remarks)


def _decoded(text: bytes, model: type[T], name: str) -> T:
    try:
        return msgspec.json.decode(text, type=model)
    except msgspec.DecodeError as error:
        raise InvalidArchive(f"{name[:80]} is not as OCI says: {error}.") from error
