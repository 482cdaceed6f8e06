"""Resolve requirements/*.in into hashed locks, for every platform at once.

All inputs are resolved together first and each lock is cut from that one
answer, so a package has the same version in every lock. Run by `make lock`
inside the generator environment (it needs uv). The locks must not name an
index, a file path or a machine; hashes come from the registry's own records.
"""

import os
import subprocess
import sys
import tempfile
from pathlib import Path

REQUIREMENTS = Path(__file__).parent.parent / "requirements"
LOCKS = ("kit", "house", "dev", "generate")
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


def main() -> None:
    with tempfile.TemporaryDirectory() as scratch:
        together = f"{scratch}/together.txt"
        resolve(*(f"{name}.in" for name in LOCKS), "--output-file", together)
        for name in LOCKS:
            cut = Path(scratch, f"{name}.txt")
            resolve(f"{name}.in", "-c", together, "--output-file", str(cut))
            text = without_notes_on(together, cut.read_text())
            (REQUIREMENTS / f"{name}.txt").write_text(text)
            count = sum("==" in line for line in text.splitlines())
            print(f"requirements/{name}.txt: {count} packages")


if __name__ == "__main__":
    main()
