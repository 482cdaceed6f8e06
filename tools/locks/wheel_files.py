"""The files of a pinned package that may be installed, by their hashes.

Only wheels are installed, so a source archive has no hash in a lock. A wheel has one
when CPython can install it on Linux with glibc, macOS or Windows, on a processor of 64
bits: on every other platform some package of the kit, the client and the server has no
wheel, and so have they for free-threaded Python.
"""

import re
import tomllib
from pathlib import Path
from typing import Any
from urllib.parse import unquote

from packaging.utils import parse_wheel_filename

_PLATFORM = re.compile(r"any|(many)?linux\w*_(x86_64|aarch64)|macosx_\w+|win_amd64")


def is_supported(file: str) -> bool:
    """Whether a supported Python on a supported platform can install a wheel."""
    *_, tags = parse_wheel_filename(file)
    return any(
        tag.interpreter.startswith(("py", "cp"))
        and not tag.abi.endswith("t")  # free-threaded: cp314t, abi3t
        and _PLATFORM.fullmatch(tag.platform)
        for tag in tags
    )


def read_pylock(path: Path) -> dict[str, list[str]]:
    """Give the options `--hash=…` of each pin in a file of uv, a pylock.toml.

    uv lists there only wheels that suit a Python from 3.11 on. ValueError if a package
    has no supported wheel.
    """
    packages = tomllib.loads(path.read_text(encoding="utf-8"))["packages"]
    hashes = {f"{one['name']}=={one['version']}": _options(one) for one in packages}
    for pin, options in hashes.items():
        if not options:
            raise ValueError(f"{pin} has no wheel for a supported platform")
    return hashes


def _options(package: dict[str, Any]) -> list[str]:
    return sorted(
        f"--hash=sha256:{wheel['hashes']['sha256']}"
        for wheel in package.get("wheels", [])
        if is_supported(unquote(wheel["url"].rpartition("/")[2]))
    )
