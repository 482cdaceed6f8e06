"""Builds OCI archives and tar files, good and hostile ones, without any other tool."""

from __future__ import annotations

import gzip
import hashlib
import io
import json
import platform
import tarfile
from collections.abc import Iterable
from pathlib import Path
from typing import Any

ARCHITECTURES = {"x86_64": "amd64", "aarch64": "arm64"}


def entry(name: str, content: bytes = b"", **changes: Any) -> tuple[Any, bytes]:
    """An entry of a tar file; changes: members of its TarInfo."""
    info = tarfile.TarInfo(name)
    info.size = len(content)
    for key, value in changes.items():
        setattr(info, key, value)
    return info, content


def folder(name: str) -> tuple[Any, bytes]:
    return entry(name, type=tarfile.DIRTYPE)


def link(name: str, target: str, *, is_hard: bool = False) -> tuple[Any, bytes]:
    kind = tarfile.LNKTYPE if is_hard else tarfile.SYMTYPE
    return entry(name, type=kind, linkname=target)


def tar_of(entries: Iterable[tuple[Any, bytes]]) -> bytes:
    buffer = io.BytesIO()
    with tarfile.open(fileobj=buffer, mode="w", format=tarfile.PAX_FORMAT) as archive:
        for info, content in entries:
            archive.addfile(info, io.BytesIO(content))
    return buffer.getvalue()


def digest_of(content: bytes) -> str:
    return f"sha256:{hashlib.sha256(content).hexdigest()}"


def write_image(
    path: Path,
    *layers: bytes,
    command: Iterable[str] = ("/policy",),
    environment: Iterable[str] = (),
    architecture: str | None = None,
    **changes: Any,
) -> str:
    """Write an OCI archive of these layers, and return its digest.

    changes: `index` or `manifest`, members that replace ours.
    """
    machine = platform.machine()
    architecture = architecture or ARCHITECTURES.get(machine, machine)
    config = {
        "architecture": architecture,
        "os": "linux",
        "config": {"Entrypoint": list(command), "Env": list(environment)},
        "rootfs": {"type": "layers", "diff_ids": []},
    }
    blobs: dict[str, bytes] = {}

    def add(content: bytes, media_type: str) -> dict[str, Any]:
        blobs[digest_of(content)] = content
        return {
            "mediaType": f"application/vnd.oci.image.{media_type}",
            "digest": digest_of(content),
            "size": len(content),
        }

    manifest = {
        "schemaVersion": 2,
        "config": add(json.dumps(config).encode(), "config.v1+json"),
        "layers": [add(layer, "layer.v1.tar") for layer in layers],
    } | changes.get("manifest", {})
    index = {
        "schemaVersion": 2,
        "manifests": [add(json.dumps(manifest).encode(), "manifest.v1+json")],
    } | changes.get("index", {})
    blobs |= changes.get("blobs", {})
    files = {
        "oci-layout": b'{"imageLayoutVersion": "1.0.0"}',
        "index.json": json.dumps(index).encode(),
    }
    files |= {f"blobs/{d.replace(':', '/')}": b for d, b in blobs.items()}
    content = tar_of(entry(name, text) for name, text in files.items())
    path.write_bytes(content)
    return digest_of(content)


def gzipped(content: bytes) -> bytes:
    return gzip.compress(content, 1)
