"""The archives of generated clients that a release publishes."""

import os
import tarfile
from pathlib import Path

import pytest

from tools.distributions.client_archives import LANGUAGES, pack, write_archive
from tools.distributions.staging import VERSION

EPOCH = 1_700_000_000


def test_the_proven_clients_are_archived() -> None:
    assert LANGUAGES == ["go", "java", "kotlin", "rust"]


def test_the_same_files_give_the_same_bytes(tmp_path: Path) -> None:
    """Expect nothing of the folder's times and modes in the archive."""
    archives = []
    for place, mode in (("here", 0o600), ("there", 0o755)):
        folder = tmp_path / place / "client"
        folder.mkdir(parents=True)
        for name in ("b", "a"):
            (folder / name).write_text(name)
            (folder / name).chmod(mode)
            os.utime(folder / name, (mode, mode))
        archives.append(tmp_path / f"{place}.tar.gz")
        pack(folder, archives[-1], EPOCH)
    first, second = (archive.read_bytes() for archive in archives)
    assert first == second
    with tarfile.open(archives[0]) as tar:
        assert tar.getnames() == ["client/a", "client/b"]


@pytest.mark.release("the archives of clients that are not committed")
@pytest.mark.slow("runs the generator")
@pytest.mark.parametrize("language", LANGUAGES)
def test_archives_hold_client_and_example(language: str, tmp_path: Path) -> None:
    with tarfile.open(write_archive(language, tmp_path, EPOCH)) as tar:
        names = set(tar.getnames())
    top = f"proctor-client-{language}-{VERSION}"
    assert {f"{top}/LICENSE", f"{top}/README.md"} <= names
    assert [name for name in names if name.startswith(f"{top}/example/")]
    assert len(names) > 80
