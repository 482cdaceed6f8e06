"""Resolves requirements/*.in into locks for every platform: `make lock`.

requirements/NAME.txt gets the pins of an environment, and requirements/hashes.txt the
hashes of all pins. Versions and hashes that are locked stay; --upgrade takes the newest
of both. A lock names no index, no path and no machine.
"""

import os
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path

from tools.locks.complete import HASHES, PIN, REQUIREMENTS, read_hashes
from tools.locks.wheel_files import read_pylock

# The versions of `dev`, where the tests of these packages run.
_AS_DEV = ("--constraints", "dev.txt")
_MUJOCO_3 = ("--overrides", "mujoco3-overrides.txt")
# The options of uv for each environment, in the order in which they are resolved.
LOCKS: dict[str, tuple[str, ...]] = {
    "dev": (),
    "kit": _AS_DEV,
    "client": _AS_DEV,
    "server": _AS_DEV,
    # The platform runs beside a server of its own machine.
    "platform": ("server.in", *_AS_DEV),
    "generate": _AS_DEV,
    "cluster": _AS_DEV,
    "metaworld": _MUJOCO_3,
    "aloha": _MUJOCO_3,
    "robosuite": _MUJOCO_3,
    "libero": (*_MUJOCO_3, "--excludes", "libero-excludes.txt"),
    # torch, and the peers of a benchmark, need other versions than ours.
    "lerobot": ("--excludes", "lerobot-excludes.txt"),
    "bench": (),
}
# The bills of materials say by which package another one is required.
PUBLISHED = ("kit", "client", "server", "platform")


def resolve(name: str, arguments: list[str]) -> list[str]:
    """Write the lock of an environment, give its pins."""
    published = name in PUBLISHED
    origins = ("--annotation-style", "line") if published else ("--no-annotate",)
    options = [*LOCKS[name], *origins, *arguments]
    _compile(f"{name}.in", "--output-file", f"{name}.txt", *options)
    lines = (REQUIREMENTS / f"{name}.txt").read_text(encoding="utf-8").splitlines()
    pins = [pin[0] for line in lines if (pin := PIN.match(line))]
    print(f"requirements/{name}.txt: {len(pins)} packages")
    return pins


def fetch_hashes(name: str) -> dict[str, list[str]]:
    """Ask the index for the wheels of a lock, give the hashes of each pin."""
    with tempfile.TemporaryDirectory() as folder:
        pylock = Path(folder) / "pylock.toml"
        listed = ("--format", "pylock.toml", "--output-file", str(pylock))
        _compile(f"{name}.txt", "--no-deps", *listed)
        return read_pylock(pylock)


def write_hashes(hashes: dict[str, list[str]]) -> None:
    """Write the hashes of every pin, sorted, a pin a line."""
    text = "".join(" ".join([pin, *hashes[pin]]) + "\n" for pin in sorted(hashes))
    (REQUIREMENTS / HASHES).write_text(text, encoding="utf-8")


def _compile(*arguments: str) -> None:
    # A machine's own index or folder of wheels must not decide what is locked.
    environment = {k: v for k, v in os.environ.items() if not k.startswith("UV_")}
    # No compiler is needed to install: a package without wheels is an error.
    common = ("--universal", "--python-version", "3.11", "--only-binary", ":all:")
    unnamed = ("--no-header", "--no-emit-index-url", "--no-emit-find-links")
    uv = Path(sys.executable).parent / "uv"
    subprocess.run(
        [uv, "pip", "compile", "--quiet", "--no-config", *common, *unnamed, *arguments],
        cwd=REQUIREMENTS,
        env=environment,
        stdout=subprocess.DEVNULL,
        check=True,
    )


def main(*, upgrade: bool, names: Sequence[str]) -> int:
    """Resolve every environment. The exit code: 1 when one cannot be locked.

    upgrade: all packages. names: of packages to upgrade.
    """
    arguments = ["--upgrade"] if upgrade else []
    arguments += [word for name in names for word in ("--upgrade-package", name)]
    hashes = {} if upgrade else read_hashes()
    locked: dict[str, list[str]] = {}
    try:
        for name in LOCKS:
            pins = resolve(name, arguments)
            if not set(pins) <= hashes.keys():
                hashes = fetch_hashes(name) | hashes
            locked |= {pin: hashes[pin] for pin in pins}
    except (subprocess.CalledProcessError, ValueError) as error:
        print(f"lock: {error}", file=sys.stderr)
        return 1
    write_hashes(locked)
    return 0
