"""Archives of the generated clients that are not committed, for a release.

Each holds what `make client` writes, and the licence. The same commit gives the same
bytes with the same Python image.
"""

import gzip
import shutil
import subprocess
import tarfile
import tempfile
from pathlib import Path

from tools.distributions.staging import ROOT, VERSION, CannotBuild

_GENERATOR = ROOT / ".venv-generate" / "bin" / "python"
_ON_REQUEST = (ROOT / "tools" / "generators" / "on_request").glob("*.yaml")
# The proven ones have programs of ours.
LANGUAGES = sorted(
    config.stem for config in _ON_REQUEST if (ROOT / "clients" / config.stem).is_dir()
)


def write_archive(language: str, to: Path, epoch: int) -> Path:
    """Generate a client and pack it into a folder. Raises CannotBuild."""
    name = f"proctor-client-{language}-{VERSION}"
    with tempfile.TemporaryDirectory(prefix="proctor-client-") as directory:
        client = Path(directory) / name
        command = (_GENERATOR, "-m", "tools", "generate", "--client", language)
        done = subprocess.run(
            (*command, "--to", client),
            cwd=ROOT,
            capture_output=True,
            text=True,
            check=False,
        )
        if done.returncode != 0:
            raise CannotBuild(f"{name}:\n{done.stdout}{done.stderr}")
        shutil.copyfile(ROOT / "LICENSE", client / "LICENSE")
        archive = to / f"{name}.tar.gz"
        pack(client, archive, epoch)
    return archive


def pack(folder: Path, archive: Path, epoch: int) -> None:
    """Write the files of a folder; times, modes and owners do not depend on it."""
    with (
        archive.open("wb") as file,
        gzip.GzipFile("", "wb", fileobj=file, mtime=epoch) as packed,
        tarfile.open(fileobj=packed, mode="w") as tar,
    ):
        for path in sorted(path for path in folder.rglob("*") if path.is_file()):
            name = path.relative_to(folder.parent).as_posix()
            member = tarfile.TarInfo(name)
            member.size, member.mtime = path.stat().st_size, epoch
            with path.open("rb") as content:
                tar.addfile(member, content)
