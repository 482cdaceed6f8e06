"""Whether a machine of the cluster simulates what the server would simulate itself."""

from __future__ import annotations

import hashlib
import os
import secrets
from functools import cache
from pathlib import Path

import reference_record
import reference_sim
from reference_sim.engine import engine_fingerprint
from reference_sim.process.ray.launcher_messages import MachineCheck


@cache
def software() -> dict[str, str]:
    """Versions that decide what is simulated, and a digest of the simulators' code."""
    engine = engine_fingerprint()
    digests = {"python": str(engine["python"]), **engine["packages"]}
    for package in (reference_sim, reference_record):
        digests[package.__name__] = _source_digest(Path(str(package.__file__)).parent)
    return digests


def make_check(recordings: Path | None) -> MachineCheck:
    """Make the check that each machine must pass.

    recordings: the folder that simulators write recordings to; an empty file is made in
    it, which they have to see, until `remove_marker`. Raises OSError.
    """
    if recordings is None:
        return MachineCheck(software())
    folder = recordings.absolute()
    folder.mkdir(mode=0o700, parents=True, exist_ok=True)
    # A name of its own: an earlier one may have been copied to other machines.
    marker = f".seen-by-simulators-{secrets.token_hex(8)}"
    (folder / marker).touch(mode=0o600)
    return MachineCheck(software(), str(folder), marker)


def remove_marker(check: MachineCheck) -> None:
    if check.folder:
        (Path(check.folder) / check.marker).unlink(missing_ok=True)


def mismatch(check: MachineCheck) -> str | None:
    """Why this machine may not simulate; None if it may."""
    ours = software()
    for name, wanted in check.software.items():
        if ours.get(name) != wanted:
            return f"has {name} {ours.get(name)}, and the server has {wanted}"
    if check.folder and not _sees(Path(check.folder), check.marker):
        return (
            f"does not share {check.folder} with the server, or cannot write there: "
            "set records_dir to a folder that all machines share, or recordings to off"
        )
    return None


def _sees(folder: Path, marker: str) -> bool:
    return (folder / marker).exists() and os.access(folder, os.W_OK | os.X_OK)


def _source_digest(folder: Path) -> str:
    digest = hashlib.sha256()
    for path in sorted(folder.rglob("*.py")):
        digest.update(path.relative_to(folder).as_posix().encode())
        digest.update(path.read_bytes())
    return digest.hexdigest()[:16]
