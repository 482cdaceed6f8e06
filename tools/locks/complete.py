"""Writes a lock with its hashes: `python tools/locks/complete.py kit > kit.txt`.

requirements/NAME.txt pins every package of an environment, and requirements/hashes.txt
has the hashes of the files of every pin, once for all environments. pip and uv need
both in one file. A machine runs this before anything is installed, so it imports
nothing but the standard library.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Sequence
from pathlib import Path

REQUIREMENTS = Path(__file__).resolve().parents[2] / "requirements"
HASHES = "hashes.txt"
PIN = re.compile(r"[A-Za-z0-9][\w.-]*==[^\s;]+")
_OPTION = re.compile(r"--hash=\S+")


def complete_lock(name: str, folder: Path = REQUIREMENTS) -> str:
    """Give the text of a lock with its hashes. ValueError if a pin has none."""
    hashes = read_hashes(folder)
    lines = []
    for line in (folder / f"{name}.txt").read_text(encoding="utf-8").splitlines():
        pin = PIN.match(line)
        if pin is None:
            lines.append(line)
        elif pin[0] in hashes:
            lines.append(format_requirement(line, hashes[pin[0]]))
        else:
            raise ValueError(f"{HASHES} has no hash of {pin[0]}: run `make lock`")
    return "".join(f"{line}\n" for line in lines)


def read_hashes(folder: Path = REQUIREMENTS) -> dict[str, list[str]]:
    """Give the options `--hash=…` of each pin, as `httpx==0.28.1`."""
    hashes: dict[str, list[str]] = {}
    options: list[str] = []
    for line in (folder / HASHES).read_text(encoding="utf-8").splitlines():
        if pin := PIN.match(line):
            options = hashes[pin[0]] = []
        options += _OPTION.findall(line)
    return hashes


def format_requirement(requirement: str, options: Sequence[str]) -> str:
    """Give a requirement and its options, one a line."""
    return " \\\n    ".join([requirement, *options])


if __name__ == "__main__":
    try:
        sys.stdout.write(complete_lock(sys.argv[1]))
    except ValueError as error:
        sys.exit(f"lock {sys.argv[1]}: {error}")
