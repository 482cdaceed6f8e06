"""Build the wheels of the project into dist/: `make dist`.

Beside each wheel: its lock with hashes, its bill of materials (CycloneDX); with
--clients, an archive of each proven client that is not committed; and
SHA256SUMS over all; those of an earlier build are removed. The time in them is
SOURCE_DATE_EPOCH, or that of the commit: the same commit gives the same bytes in any
folder, with the setuptools that is locked and the same Python image, as zlib decides
the compressed bytes. Nothing is fetched.
"""

import hashlib
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from tools.distributions.bill_of_materials import write_bill
from tools.distributions.client_archives import LANGUAGES, write_archive
from tools.distributions.staging import (
    DISTRIBUTIONS,
    ROOT,
    CannotBuild,
    Distribution,
    copy_sources,
)
from tools.locks.complete import complete_lock

_BUILD = "import sys, setuptools.build_meta as b; b.build_wheel(sys.argv[1])"


def build_all(to: Path, *, clients: bool = False) -> list[Path]:
    """Build wheels and archives of clients, give their paths. Raises CannotBuild."""
    to.mkdir(parents=True, exist_ok=True)
    _remove_older(to)
    epoch = _read_epoch()
    written = [_build(distribution, to, epoch) for distribution in DISTRIBUTIONS]
    archives = [write_archive(name, to, epoch) for name in LANGUAGES if clients]
    names = sorted([*archives, *(path for paths in written for path in paths)])
    sums = "".join(f"{_sha256(path)}  {path.name}\n" for path in names)
    (to / "SHA256SUMS").write_text(sums, encoding="utf-8")
    return [*(wheel for wheel, *_ in written), *archives]


def _remove_older(folder: Path) -> None:
    """Wheels, locks, bills, archives and sums of any version; no other file."""
    (folder / "SHA256SUMS").unlink(missing_ok=True)
    for old in folder.glob("proctor-client-*.tar.gz"):
        old.unlink()
    for distribution in DISTRIBUTIONS:
        name = distribution.name.replace("-", "_")
        for ending in ("-py3-none-any.whl", "-requirements.txt", ".cdx.json"):
            for old in folder.glob(f"{name}-*{ending}"):
                old.unlink()


def _build(distribution: Distribution, to: Path, epoch: int) -> tuple[Path, ...]:
    """Write a wheel, its lock and its bill of materials, give their paths."""
    stem = distribution.file_stem
    wheel = to / f"{stem}-py3-none-any.whl"
    with tempfile.TemporaryDirectory(prefix="proctor-dist-") as directory:
        source, built = Path(directory) / "source", Path(directory) / "built"
        copy_sources(distribution, source)
        built.mkdir()
        done = subprocess.run(
            [sys.executable, "-c", _BUILD, str(built)],
            cwd=source,
            env=os.environ | {"SOURCE_DATE_EPOCH": str(epoch)},
            umask=0o022,  # modes of the metadata
            capture_output=True,
            text=True,
            check=False,
        )
        if done.returncode != 0:
            raise CannotBuild(f"{distribution.name}:\n{done.stdout}{done.stderr}")
        shutil.copyfile(built / wheel.name, wheel)
    lock, bill = to / f"{stem}-requirements.txt", to / f"{stem}.cdx.json"
    lock.write_text(complete_lock(distribution.lock), encoding="utf-8")
    write_bill(distribution, wheel, _sha256(wheel), epoch, bill)
    return wheel, lock, bill


def _read_epoch() -> int:
    """Seconds since 1970 that every file of a wheel gets."""
    given = os.environ.get("SOURCE_DATE_EPOCH")
    if given is None:
        command = ["git", "log", "-1", "--format=%ct"]
        return int(subprocess.check_output(command, cwd=ROOT))
    return int(given)


def _sha256(path: Path) -> str:
    return hashlib.sha256(path.read_bytes()).hexdigest()


def main(*, folder: Path, clients: bool) -> int:
    """The exit code: 2 when a wheel or an archive was not built."""
    try:
        built = build_all(folder, clients=clients)
    except CannotBuild as error:
        print(error, file=sys.stderr)
        return 2
    print(f"in {folder}, with locks, bills of materials and SHA256SUMS:")
    for path in built:
        size = f"{path.stat().st_size / 1e6:.2f} MB"
        print(f"{_sha256(path)[:12]}  {size}  {path.name}")
    return 0
