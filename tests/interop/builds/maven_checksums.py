"""Hold what Maven downloads against checksums that are committed.

    python -m tests.interop.builds.maven_checksums check|write REPOSITORY SUMMARY

REPOSITORY is a local repository of Maven that one build alone uses; SUMMARY has a line
for every jar and pom in it, as `sha256sum` writes them. Maven from 3.9 on reads the
same file before it uses what it downloaded (`.mvn/maven.config`). `check` ends with 1
if a file differs or has no line, and writes nothing; `write` adds the lines that are
missing and never changes one: where a file differs, its line is removed by hand.
"""

import hashlib
import sys
from pathlib import Path

SUFFIXES = {".jar", ".pom"}


def checksums(repository: Path) -> dict[str, str]:
    """Path in the repository → SHA-256, of what was downloaded into it."""
    found = {}
    for path in sorted(repository.rglob("*")):
        if path.suffix in SUFFIXES and is_downloaded(path):
            name = path.relative_to(repository).as_posix()
            found[name] = hashlib.sha256(path.read_bytes()).hexdigest()
    return found


def is_downloaded(path: Path) -> bool:
    """Whether it came from elsewhere; what `mvn install` wrote has no origin."""
    origins = path.parent / "_remote.repositories"
    if not origins.exists():
        return True  # put there by hand
    lines = origins.read_text().splitlines()
    return f"{path.name}>=" not in lines


def read_summary(summary: Path) -> dict[str, str]:
    """Path in the repository → SHA-256, as committed."""
    lines = summary.read_text().splitlines() if summary.exists() else []
    return {name: digest for digest, name in (line.split("  ", 1) for line in lines)}


def differences(found: dict[str, str], known: dict[str, str]) -> list[str]:
    """What of the files found is not as the summary says, a line for each."""
    return [
        f"differs: {name}" if name in known else f"no checksum: {name}"
        for name, digest in found.items()
        if known.get(name) != digest
    ]


def main(arguments: list[str]) -> int:
    match arguments:
        case [("check" | "write") as what, repository, summary]:
            found, known = checksums(Path(repository)), read_summary(Path(summary))
        case _:
            sys.stderr.write(f"{__doc__}")
            return 2
    if what == "write":
        wanted = sorted((found | known).items())
        lines = [f"{digest}  {name}\n" for name, digest in wanted]
        Path(summary).parent.mkdir(parents=True, exist_ok=True)
        Path(summary).write_text("".join(lines))
        return 0
    lines = differences(found, known)
    sys.stderr.writelines(f"{line}\n" for line in lines)
    return 1 if lines else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
