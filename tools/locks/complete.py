"""Writes a lock with its hashes: `python tools/locks/complete.py kit > kit.txt`.

requirements/NAME.txt pins every package of an environment, and requirements/hashes.txt
has the hashes of the files of every pin, once for all environments, a pin a line. pip
and uv need both in one file. A machine runs this before anything is installed, so it
imports nothing but the standard library.
"""

import re
import sys
from pathlib import Path

REQUIREMENTS = Path(__file__).resolve().parents[2] / "requirements"
HASHES = "hashes.txt"
PIN = re.compile(r"[A-Za-z0-9][\w.-]*==[^\s;]+")
# uv names behind a pin what requires it; a published lock does so in a line below.
ORIGINS = re.compile(r" +(?=# via )")


def complete_lock(name: str, folder: Path = REQUIREMENTS) -> str:
    """Give the text of a lock with its hashes. ValueError if a pin has none."""
    hashes = read_hashes(folder)
    lines = []
    for line in (folder / f"{name}.txt").read_text(encoding="utf-8").splitlines():
        pin = PIN.match(line)
        if pin is None:
            lines.append(line)
        elif pin[0] in hashes:
            requirement, *origins = ORIGINS.split(line)
            lines.append(" \\\n    ".join([requirement, *hashes[pin[0]]]))
            lines += [f"    {names}" for names in origins]
        else:
            raise ValueError(f"{HASHES} has no hash of {pin[0]}: run `make lock`")
    return "".join(f"{line}\n" for line in lines)


def read_hashes(folder: Path = REQUIREMENTS) -> dict[str, list[str]]:
    """Give the options `--hash=…` of each pin, as `httpx==0.28.1`."""
    lines = (folder / HASHES).read_text(encoding="utf-8").splitlines()
    return {pin: options for pin, *options in map(str.split, lines)}


if __name__ == "__main__":
    try:
        sys.stdout.write(complete_lock(sys.argv[1]))
    except ValueError as error:
        sys.exit(f"lock {sys.argv[1]}: {error}")
