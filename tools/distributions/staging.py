"""Copies the files of each wheel into a folder that setuptools can build.

Files that git ignores are left out, and no module stands in two wheels. Modes are
written anew, so that a wheel does not depend on the umask of a machine.
"""

import shutil
import subprocess
import tomllib
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
HERE = Path(__file__).resolve().parent
VERSION: str = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"][
    "version"
]
_MODE = 0o644
# The files of spec/ that an installed kit reads; only authors of servers need vectors.
_SPECIFICATION = (
    *("*.md", "*.yaml", "profiles/*.md", "profiles/*.yaml"),
    *("registry/*.md", "registry/*.yaml"),
)


class CannotBuild(Exception):
    """A wheel or an archive was not built; the text has the reason."""


@dataclass(frozen=True)
class Distribution:
    """One wheel: its folders by their place in it, its lock, what it requires.

    `lock` is the name of a lock of requirements/, without `.txt`. `requires` and
    `extras` hold names of requirements/*.in, and names of other distributions, which
    are required in the same version.
    """

    name: str
    folders: dict[str, str]
    lock: str
    requires: tuple[str, ...]
    extras: dict[str, tuple[str, ...]]

    @property
    def file_stem(self) -> str:
        """How the names of its files begin."""
        return f"{self.name.replace('-', '_')}-{VERSION}"


_OF_SERVERS: dict[str, tuple[str, ...]] = {
    "postgresql": ("postgresql.in",),
    "ray": ("ray.in",),
    "storage": ("storage.in",),
    "traces": ("traces.in",),
}
DISTRIBUTIONS = (
    Distribution(
        "proctor-conformance",
        {"conformance": "conformance", "spec": "conformance/specification/files"},
        "kit",
        ("kit.in",),
        {},
    ),
    Distribution(
        "proctor-eval",
        {
            "generated_clients/python/proctor_client": "proctor_client",
            "reference_client": "reference_client",
            "reference_record": "reference_record",
            "reference_sim": "reference_sim",
        },
        "client",
        ("client.in",),
        {
            "client": (),
            "kit": ("proctor-conformance",),
            "parquet": ("parquet.in",),
            "platform": ("proctor-host",),
            "server": ("proctor-server",),
            "video": ("video.in",),
            **_OF_SERVERS,
        },
    ),
    Distribution(
        "proctor-server",
        {"reference_server": "reference_server"},
        "server",
        ("server.in", "proctor-eval"),
        _OF_SERVERS,
    ),
    Distribution(
        "proctor-host",
        {"reference_platform": "reference_platform"},
        "platform",
        ("platform.in", "proctor-server"),
        _OF_SERVERS,
    ),
)


def copy_sources(distribution: Distribution, to: Path) -> None:
    """Fill an empty folder with a project that builds this one wheel."""
    for folder, place in distribution.folders.items():
        for path in _files(ROOT / folder):
            _copy(path, to / place / path.relative_to(ROOT / folder))
    _copy(ROOT / "LICENSE", to / "LICENSE")
    for name in ("pyproject.toml", "README.md"):
        _copy(HERE / distribution.name / name, to / name)
    _write(to / "VERSION", VERSION + "\n")
    _write(to / "requirements.in", _requirements(distribution.requires))
    for extra, requires in distribution.extras.items():
        _write(to / "extras" / f"{extra}.in", _requirements(requires))


def _files(folder: Path) -> list[Path]:
    """Files of a folder that git knows or would add."""
    command = ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"]
    done = subprocess.run(
        [*command, "."], cwd=folder, capture_output=True, text=True, check=True
    )
    paths = sorted({folder / name for name in done.stdout.split("\0") if name})
    if folder == ROOT / "spec":
        paths = [
            path
            for path in paths
            if any(path.match(f"spec/{pattern}") for pattern in _SPECIFICATION)
        ]
    return [path for path in paths if path.is_file()]


def _requirements(names: tuple[str, ...]) -> str:
    texts = []
    for name in names:
        if name.endswith(".in"):
            texts.append((ROOT / "requirements" / name).read_text(encoding="utf-8"))
        else:
            texts.append(f"{name}=={VERSION}\n")
    return "".join(texts)


def _write(path: Path, text: str) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")
    path.chmod(_MODE)


def _copy(path: Path, to: Path) -> None:
    to.parent.mkdir(parents=True, exist_ok=True)
    shutil.copyfile(path, to)
    to.chmod(_MODE)
