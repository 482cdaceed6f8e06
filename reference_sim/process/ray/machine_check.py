"""Whether a machine of the cluster simulates what the server would simulate itself."""

from __future__ import annotations

import hashlib
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


def make_check() -> MachineCheck:
    """Make the check that each machine must pass."""
    return MachineCheck(software())


def mismatch(check: MachineCheck) -> str | None:
    """Why this machine may not simulate; None if it may."""
    ours = software()
    for name, wanted in check.software.items():
        if ours.get(name) != wanted:
            return f"has {name} {ours.get(name)}, and the server has {wanted}"
    return None


def _source_digest(folder: Path) -> str:
    digest = hashlib.sha256()
    for path in sorted(folder.rglob("*.py")):
        digest.update(path.relative_to(folder).as_posix().encode())
        digest.update(path.read_bytes())
    return digest.hexdigest()[:16]
