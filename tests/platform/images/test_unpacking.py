"""Images and code are unpacked as they are meant, and hostile ones do no harm."""

from __future__ import annotations

import io
import stat
import tarfile
import zipfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
import zstandard

from reference_platform.images.bounded_archives import (
    Budget,
    InvalidArchive,
    archive_errors,
)
from reference_platform.images.code_archive import unpack_code
from reference_platform.images.oci_archive import (
    MOUNT_POINTS,
    read_program,
    unpack_image,
)
from reference_platform.images.unpacked_roots import UnpackedRoots
from tests.support.platform.archives import (
    entry,
    folder,
    gzipped,
    link,
    tar_of,
    write_image,
)

BUDGET = 4 * 2**20


def unpack(kind: str, archive: Path, budget: int = BUDGET) -> Path:
    target, scratch = archive.with_suffix(".root"), archive.with_suffix(".scratch")
    scratch.mkdir()
    with archive_errors():
        if kind == "image":
            unpack_image(archive, target, scratch, Budget(budget, 1000))
        else:
            unpack_code(archive, target, scratch, Budget(budget, 1000))
    return target


def contents(root: Path) -> dict[str, str]:
    """Path → the content of a file, or `→` and the target of a link."""
    files = {}
    for path in sorted(root.rglob("*")):
        name = path.relative_to(root).as_posix()
        if path.is_symlink():
            files[name] = f"→ {path.readlink()}"
        elif path.is_file():
            files[name] = path.read_text()
    return files


LOWER = [
    folder("usr/lib"),
    link("lib", "usr/lib"),
    entry("usr/lib/a", b"a"),
    entry("usr/lib/b", b"b"),
    entry("etc/removed", b"removed"),
    entry("opt/old/file", b"old"),
    entry("program", b"program", mode=0o4755),
    entry("proc/fake", b"fake"),
    link("tmp", "/etc"),
]
UPPER = [
    entry("lib/c", b"c"),
    entry("./usr/lib/a", b"changed"),
    entry("etc/.wh.removed"),
    entry("opt/old/.wh..wh..opq"),
    entry("opt/old/new", b"new"),
    link("usr/lib/hard", "lib/c", is_hard=True),
]


@pytest.mark.parametrize(
    "packed", [bytes, gzipped, zstandard.compress], ids=["tar", "gzip", "zstd"]
)
def test_layers_are_applied(tmp_path: Path, packed: Callable[[bytes], bytes]) -> None:
    archive = tmp_path / "image.tar"
    write_image(archive, packed(tar_of(LOWER)), packed(tar_of(UPPER)))
    root = unpack("image", archive)
    assert contents(root) == {
        "lib": "→ usr/lib",
        "usr/lib/a": "changed",
        "usr/lib/b": "b",
        "usr/lib/c": "c",
        "usr/lib/hard": "c",
        "opt/old/new": "new",
        "program": "program",
    }
    assert stat.S_IMODE((root / "program").stat().st_mode) == 0o755
    assert all((root / name).is_dir() for name in MOUNT_POINTS)
    assert (root / "usr/lib/hard").stat().st_nlink == 2


HOSTILE_ENTRIES: dict[str, tuple[list[tuple[Any, bytes]], str]] = {
    "parent folder": ([entry("../outside", b"x")], "leaves its folder"),
    "parent folder inside": ([entry("a/../../outside", b"x")], "leaves its folder"),
    "hard link to the host": (
        [link("hard", "../../../etc/passwd", is_hard=True)],
        "leaves its folder",
    ),
    "hard link to a file that is not there": (
        [link("hard", "etc/passwd", is_hard=True)],
        "no file",
    ),
    "links in a circle": ([link("a", "b"), link("b", "a"), entry("a/x")], "loop"),
    "deep folders": ([entry("a/" * 200 + "x")], "too deep"),
    "long name": ([entry("a" * 300)], "too long"),
    "long path": ([entry("/".join(["a" * 200] * 30))], "too long"),
    "large header": (
        [entry("x", pax_headers={"comment": "x" * (2 * 2**20)})],
        "header that is too large",
    ),
    "large file": ([entry("x", bytes(BUDGET + 1))], "unpacks to more than"),
    "many files": ([entry(str(i)) for i in range(1001)], "more than 1000 files"),
}


@pytest.mark.parametrize("kind", ["image", "code"])
@pytest.mark.parametrize("name", HOSTILE_ENTRIES)
def test_a_hostile_entry_is_refused(tmp_path: Path, kind: str, name: str) -> None:
    entries, text = HOSTILE_ENTRIES[name]
    archive = tmp_path / "archive.tar"
    if kind == "image":
        write_image(archive, gzipped(tar_of(entries)))
    else:
        archive.write_bytes(gzipped(tar_of(entries)))
    with pytest.raises(InvalidArchive, match=text):
        unpack(kind, archive)
    assert not (tmp_path / "archive.root").exists()


@pytest.mark.parametrize("target", ["/etc", "../../../../../../etc", "/proc/1/root"])
def test_no_entry_is_written_through_a_link(tmp_path: Path, target: str) -> None:
    """A file behind a link is one of the image, at what the link names in the image."""
    archive = tmp_path / "image.tar"
    layer = tar_of([link("out", target), entry("out/written-by-test", b"x")])
    write_image(archive, layer)
    root = unpack("image", archive)
    inside = root / target.replace("../", "").strip("/") / "written-by-test"
    assert inside.is_file() or target.startswith("/proc")
    assert not (Path("/etc") / "written-by-test").exists()


@pytest.mark.parametrize("kind", ["image", "code"])
def test_devices_are_left_out(tmp_path: Path, kind: str) -> None:
    entries = [
        entry("disk", type=tarfile.BLKTYPE, devmajor=8),
        entry("memory", type=tarfile.CHRTYPE, devmajor=1, devminor=1),
        entry("pipe", type=tarfile.FIFOTYPE),
        entry("kept", b"kept"),
    ]
    archive = tmp_path / "archive.tar"
    if kind == "image":
        write_image(archive, tar_of(entries))
    else:
        archive.write_bytes(tar_of(entries))
    assert contents(unpack(kind, archive)) == {"kept": "kept"}


def raw_header(size: bytes) -> bytes:
    """A tar header with such a size; the checksum is right."""
    header = bytearray(tar_of([entry("x")])[:512])
    header[124:136] = size
    header[148:156] = b" " * 8
    header[148:156] = b"%06o\0 " % sum(header)
    return bytes(header)


HOSTILE_LAYERS = {
    "bomb": gzipped(tar_of([entry("x", bytes(BUDGET + 1))])),
    "wide window": zstandard.ZstdCompressor(
        compression_params=zstandard.ZstdCompressionParameters(window_log=30)
    ).compress(bytes(100)),
    "no tar": b"this is no tar file",
    "cut off": tar_of([entry("x", b"y" * 5000)])[:2000],
    "cut gzip": gzipped(tar_of([entry("x", b"y" * 5000)]))[:30],
    "negative size": raw_header(b"\xff" * 12),
    "huge size": raw_header(b"\x80" + b"\xff" * 11),
    "size that is no number": raw_header(b"x" * 12),
}


@pytest.mark.parametrize("name", HOSTILE_LAYERS)
def test_a_hostile_layer_is_refused(tmp_path: Path, name: str) -> None:
    archive = tmp_path / "image.tar"
    write_image(archive, HOSTILE_LAYERS[name])
    with pytest.raises(InvalidArchive):
        unpack("image", archive)


LAYER = tar_of([entry("policy", b"x", mode=0o755)])
HOSTILE_IMAGES: dict[str, tuple[dict[str, Any], str]] = {
    "blob with another content": (
        {"blobs": {"sha256:" + "0" * 64: tar_of([entry("x")])}}
        | {"manifest": {"layers": [{"digest": "sha256:" + "0" * 64}]}},
        "another content",
    ),
    "missing layer": (
        {"manifest": {"layers": [{"digest": "sha256:" + "1" * 64}]}},
        "not in the archive",
    ),
    "digest that is a path": (
        {"manifest": {"layers": [{"digest": "sha256:../../etc/passwd"}]}},
        "not in the archive",
    ),
    "no layers": ({"manifest": {"layers": None}}, "not as OCI says"),
    "too many layers": (
        {"manifest": {"layers": [{"digest": "sha256:" + "1" * 64}] * 300}},
        "256 layers",
    ),
    "another machine": ({"architecture": "s390x"}, "--platform linux/"),
    "no command": ({"command": []}, "neither ENTRYPOINT nor CMD"),
    "no manifest": ({"index": {"manifests": []}}, "no image for linux/"),
}


@pytest.mark.parametrize("name", HOSTILE_IMAGES)
def test_a_broken_image_is_refused(tmp_path: Path, name: str) -> None:
    changes, text = HOSTILE_IMAGES[name]
    archive = tmp_path / "image.tar"
    write_image(archive, LAYER, **changes)
    with pytest.raises(InvalidArchive, match=text):
        unpack("image", archive)
    if text != "another content":  # which only a reader of its layers sees
        with pytest.raises(InvalidArchive, match=text):
            read_program(archive)


NO_IMAGES: dict[str, tuple[Callable[[bytes], bytes], str]] = {
    "of docker save": (
        lambda _: tar_of([entry("manifest.json", b"[]")]),
        "`docker save`.*docker buildx build --output type=oci",
    ),
    "gzip": (gzipped, "compressed with gzip.*`gunzip`"),
    "zstd": (zstandard.ZstdCompressor().compress, "compressed with zstd.*`unzstd`"),
    "zip": (lambda image: zip_of({"image.tar": image}), "with zip.*`unzip`"),
    "cut": (lambda image: image[:2000], "ends early.*Write it anew"),
    "text": (lambda _: b"hello", "no tar file.*docker buildx build"),
    "long text": (lambda _: b"hello " * 200, "no tar file.*docker buildx build"),
}


@pytest.mark.parametrize("name", NO_IMAGES)
async def test_what_is_no_image_is_refused_with_the_way_out(
    tmp_path: Path, name: str
) -> None:
    """Without unpacking it, so that no person is asked to review it."""
    change, text = NO_IMAGES[name]
    archive = tmp_path / "image.tar"
    write_image(archive, LAYER)
    roots = UnpackedRoots(tmp_path / "roots")
    await roots.check_image(archive)
    archive.write_bytes(change(archive.read_bytes()))
    with pytest.raises(InvalidArchive, match=text):
        await roots.check_image(archive)
    assert not list((tmp_path / "roots").iterdir())


def zip_of(entries: dict[str, bytes], mode: int = 0o100644) -> bytes:
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in entries.items():
            info = zipfile.ZipInfo(name)
            info.external_attr = mode << 16
            info.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(info, content)
    return buffer.getvalue()


def test_code_in_a_zip_is_unpacked(tmp_path: Path) -> None:
    archive = tmp_path / "code.zip"
    archive.write_bytes(zip_of({"main.py": b"code", "package/part.py": b"part"}))
    assert contents(unpack("code", archive)) == {
        "main.py": "code",
        "package/part.py": "part",
    }


@pytest.mark.parametrize(
    ("content", "text"),
    [
        (zip_of({"../outside": b"x"}), "leaves its folder"),
        (zip_of({"bomb": bytes(BUDGET + 1)}), "unpacks to more than"),
        (zip_of({str(i): b"" for i in range(1001)}), "more than 1000 files"),
        (zip_of({"a": b"b", "b": b"a", "a/x": b""}, 0o120777), "loop|no path"),
        (zip_of({"x": b"x"})[:-30], "cannot be read"),
        (zip_of({}), "no file"),
        (b"", "cannot be read|no file"),
    ],
    ids=["path", "bomb", "many", "links", "cut off", "empty zip", "empty"],
)
def test_a_hostile_zip_is_refused(tmp_path: Path, content: bytes, text: str) -> None:
    archive = tmp_path / "code.zip"
    archive.write_bytes(content)
    with pytest.raises(InvalidArchive, match=text):
        unpack("code", archive)


async def test_an_archive_is_unpacked_once_and_a_refused_one_leaves_nothing(
    tmp_path: Path,
) -> None:
    good, bad = tmp_path / "good.tar", tmp_path / "bad.tar"
    layer = tar_of([entry("policy", b"x", mode=0o6755)])
    digest = write_image(good, layer, environment=["A=b=c"])
    refused = write_image(bad, tar_of([entry("../x")]))
    (tmp_path / "roots" / ".new-left").mkdir(parents=True)
    roots = UnpackedRoots(tmp_path / "roots")
    unpacked = await roots.get("image", digest, good)
    assert unpacked.program.command == ["/policy"]
    assert unpacked.program.environment == {"A": "b=c"}
    assert len(unpacked.program.remarks) == 1
    good.unlink()
    assert await roots.get("image", digest, good) == unpacked
    with pytest.raises(InvalidArchive, match="leaves its folder"):
        await roots.get("image", refused, bad)
    assert [p.name for p in (tmp_path / "roots").iterdir()] == [
        digest.replace(":", "-")
    ]
    roots.remove(digest)
    assert not list((tmp_path / "roots").iterdir())
