"""Resolve requirements/*.in into hashed locks, for every platform at once.

All inputs are resolved together first and each lock is cut from that one
answer, so a package has the same version in every lock; save `metaworld`, which
overrides some and keeps the rest, and `bench`, which holds strangers only and is
resolved alone. Run by `make lock` inside the generator environment (it needs uv);
`tools/lock.py bench` makes that lock and no other. The locks must not name an index, a
file path or a machine; hashes come from the registry's own records.
"""

import os
import subprocess
import sys
import tempfile
from pathlib import Path

REQUIREMENTS = Path(__file__).parent.parent / "requirements"
LOCKS = ("kit", "house", "dev", "generate")
ALONE = ("bench",)
OVERRIDDEN = {"metaworld": "metaworld-overrides.txt"}
UV = Path(sys.executable).with_name("uv")
COMPILE = (
    *("pip", "compile", "--quiet", "--no-config", "--no-header"),
    *("--universal", "--python-version", "3.11", "--generate-hashes"),
    # No compiler is needed to install: a package without wheels is an error.
    *("--only-binary", ":all:"),
    *("--no-emit-index-url", "--no-emit-find-links"),
)


def resolve(*arguments: str) -> None:
    # A machine's own index or wheel directory must not leak into the hashes.
    clean = {k: v for k, v in os.environ.items() if not k.startswith(("UV_", "PIP_"))}
    subprocess.run([UV, *COMPILE, *arguments], cwd=REQUIREMENTS, env=clean, check=True)


def without_notes_on(constraint: str, lock: str) -> str:
    """Drop the notes that name our temporary constraint file."""
    lines = lock.splitlines(keepends=True)
    return "".join(line for line in lines if f"-c {constraint}" not in line)


def overridden(constraint: str, overrides: Path) -> str:
    """The constraints, without the packages that the overrides are about."""
    lines = overrides.read_text().splitlines()
    names = tuple(line.partition("==")[0] for line in lines if "==" in line)
    kept = [
        line
        for line in Path(constraint).read_text().splitlines()
        if "==" in line and not line.startswith(names)
    ]
    return "\n".join(line.rstrip(" \\") for line in kept)


def lock(name: str, constraint: str = os.devnull, *options: str) -> None:
    """Cut one lock from what was resolved together; without a constraint, alone."""
    with tempfile.TemporaryDirectory() as scratch:
        cut = Path(scratch, f"{name}.txt")
        arguments = (f"{name}.in", "-c", constraint, "--output-file", str(cut))
        resolve(*arguments, *options)
        text = without_notes_on(constraint, cut.read_text())
    (REQUIREMENTS / f"{name}.txt").write_text(text)
    count = sum("==" in line for line in text.splitlines())
    print(f"requirements/{name}.txt: {count} packages")


def main() -> None:
    for name in ALONE:
        lock(name)
    if sys.argv[1:] == list(ALONE):
        return
    with tempfile.TemporaryDirectory() as scratch:
        together = f"{scratch}/together.txt"
        resolve(*(f"{name}.in" for name in LOCKS), "--output-file", together)
        for name in LOCKS:
            lock(name, together)
        for name, overrides in OVERRIDDEN.items():
            rest = Path(scratch, f"{name}-rest.txt")
            rest.write_text(overridden(together, REQUIREMENTS / overrides))
            lock(name, str(rest), "--override", overrides)


if __name__ == "__main__":
    main()
