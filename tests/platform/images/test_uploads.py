"""Uploads: in parts, within limits, complete only by their digest."""

from __future__ import annotations

import asyncio
import errno
import math
import os
import time
from collections.abc import AsyncIterator, Iterable
from pathlib import Path

import pytest

from reference_platform.images.upload_folder import Upload, UploadFolder
from reference_server.rules.refusal import Refused
from tests.support.platform.archives import digest_of

CONTENT = bytes(range(256)) * 100
DIGEST = digest_of(CONTENT)
SIZE = len(CONTENT)


async def parts(*contents: bytes, fails: bool = False) -> AsyncIterator[bytes]:
    for content in contents:
        yield content
    if fails:
        raise Refused("malformed_body", "cut off")


@pytest.fixture
def uploads(tmp_path: Path) -> UploadFolder:
    return UploadFolder(tmp_path / "uploads", max_bytes=10 * SIZE)


async def append(
    uploads: UploadFolder, offset: int, sent: Iterable[bytes], account: str = "ada"
) -> Upload:
    return await uploads.append(account, DIGEST, SIZE, offset, parts(*sent))


async def test_parts_become_the_file(uploads: UploadFolder) -> None:
    assert await append(uploads, 0, [CONTENT[:10], CONTENT[10:500]]) == Upload(
        500, is_complete=False
    )
    with pytest.raises(KeyError):
        uploads.path_of("ada", DIGEST)
    done = Upload(SIZE, is_complete=True)
    assert await append(uploads, 500, [CONTENT[500:]]) == done
    assert uploads.path_of("ada", DIGEST).read_bytes() == CONTENT
    # A repeated request changes nothing.
    assert await append(uploads, 500, [CONTENT[500:]]) == done
    assert uploads.state("ada", DIGEST) == done


async def test_more_than_its_size_is_refused(uploads: UploadFolder) -> None:
    with pytest.raises(Refused, match="more than"):
        await append(uploads, 0, [CONTENT[:300], CONTENT])
    assert (await append(uploads, 300, [CONTENT[300:]])).is_complete


async def test_an_account_has_room_for_so_much(tmp_path: Path) -> None:
    uploads = UploadFolder(tmp_path / "uploads", account_bytes=SIZE + 10)
    assert (await append(uploads, 0, [CONTENT])).is_complete
    other = digest_of(b"other")
    with pytest.raises(Refused, match="at most"):
        await uploads.append("ada", other, 11, 0, parts(b"x" * 11))
    assert (await uploads.append("bea", other, 5, 0, parts(b"other"))).is_complete
    ended_at = time.time()
    assert uploads.state("ada", DIGEST).is_complete  # it is to be used again
    uploads.remove("ada", DIGEST, before=ended_at)
    assert uploads.state("ada", DIGEST).is_complete
    uploads.remove("ada", DIGEST, before=math.inf)
    assert (await uploads.append("ada", other, 5, 0, parts(b"other"))).is_complete


async def test_a_disk_that_fills_meanwhile_is_no_defect(
    uploads: UploadFolder, monkeypatch: pytest.MonkeyPatch
) -> None:
    """There was room when it was looked for. Expect a refusal that may be repeated."""

    def no_room(_fd: int) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    with monkeypatch.context() as full:
        full.setattr(os, "fsync", no_room)
        with pytest.raises(Refused, match="disk of the platform is full") as caught:
            await append(uploads, 0, [CONTENT])
        assert caught.value.code == "unavailable"
    offset = uploads.state("ada", DIGEST).offset
    assert (await append(uploads, offset, [CONTENT[offset:]])).is_complete


async def test_a_file_that_is_removed_meanwhile_is_no_defect(
    uploads: UploadFolder, monkeypatch: pytest.MonkeyPatch
) -> None:
    """An earlier submission of the account has just ended, and its files go."""
    gone = uploads._folder / "ada" / "gone"
    list_files = Path.iterdir
    monkeypatch.setattr(Path, "iterdir", lambda at: [*list_files(at), gone])
    assert (await append(uploads, 0, [CONTENT])).is_complete


async def test_one_request_at_a_time(uploads: UploadFolder) -> None:
    go_on = asyncio.Event()

    async def slow() -> AsyncIterator[bytes]:
        yield CONTENT[:100]
        await go_on.wait()

    first = asyncio.create_task(uploads.append("ada", DIGEST, SIZE, 0, slow()))
    await asyncio.sleep(0)
    with pytest.raises(Refused, match="Another request"):
        await append(uploads, 0, [CONTENT])
    go_on.set()
    assert (await first).offset == 100


@pytest.mark.parametrize(
    ("digest", "size"),
    [
        ("sha256:../../x", SIZE),
        ("md5:0", SIZE),
        (DIGEST.upper(), SIZE),
        (DIGEST, 0),
        (DIGEST, 10 * SIZE + 1),
    ],
)
def test_what_cannot_be_uploaded(uploads: UploadFolder, digest: str, size: int) -> None:
    with pytest.raises(Refused):
        uploads.check(digest, size)


@pytest.mark.parametrize("account", ["", "..", "../ada", "a/b", "Ada"])
def test_no_account_is_a_path(uploads: UploadFolder, account: str) -> None:
    with pytest.raises(Refused):
        uploads.state(account, DIGEST)
