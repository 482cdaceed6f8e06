"""Which hand-written Python files the repository has, and what each imports.

Imports are read from the source text; no module is imported to find them.
"""

import ast
import functools
import gc
import re
import subprocess
from collections.abc import Iterator
from pathlib import Path

from tests.support.paths import ROOT

PACKAGES = (
    *("conformance", "reference_client", "reference_record"),
    *("reference_server", "reference_sim"),
)
GENERATED = {
    "generated_clients",
    "conformance/client/connections/transport",  # copied from the clients
    *("reference_client/generated", "reference_record/generated"),
    "reference_server/generated",
}


@functools.cache
def entries_of_git() -> frozenset[str]:
    """The files and folders that the repository has at its top. Files that people write
    beside them, as the README's `evaluate.py`, are not judged."""
    command = ["git", "ls-files", "-z"]
    listed = subprocess.run(command, cwd=ROOT, check=True, capture_output=True)
    return frozenset(
        name.partition("/")[0] for name in listed.stdout.decode().split("\0") if name
    )


def is_ours(path: Path) -> bool:
    parts = path.relative_to(ROOT).parts
    if parts[0].startswith(".") or parts[0] not in entries_of_git():
        return False
    names = {"/".join(parts[:depth]) for depth in range(1, len(parts) + 1)}
    return not names & GENERATED


def _python_files(folder: Path) -> Iterator[Path]:
    """Environments and caches, which have most of the files, are never entered."""
    for path in folder.iterdir():
        if not is_ours(path):
            continue
        if path.is_dir():
            yield from _python_files(path)
        elif path.suffix == ".py":
            yield path


HAND_WRITTEN = sorted(_python_files(ROOT))


def name_of(path: Path) -> str:
    return path.relative_to(ROOT).as_posix()


def module_of(path: Path) -> str:
    return name_of(path).removesuffix(".py").removesuffix("/__init__").replace("/", ".")


@functools.cache
def nodes_of(path: Path) -> tuple[ast.AST, ...]:
    """The syntax of a file; many tests look through all files, each is parsed once."""
    nodes = tuple(ast.walk(ast.parse(path.read_text())))
    # Otherwise each garbage collection while the next file is parsed looks through the
    # nodes of all files before it, which takes four times as long as parsing does.
    gc.freeze()
    return nodes


@functools.cache
def imports(path: Path, module: str) -> frozenset[str]:
    """Every module that a file imports, wherever in it; `a.b` for `from a import b`."""
    found: set[str] = set()
    for node in nodes_of(path):
        if isinstance(node, ast.Import):
            found |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            parent = module.split(".")[: -node.level] if node.level else []
            origin = ".".join([*parent, *filter(None, [node.module])])
            found |= {origin, *(f"{origin}.{alias.name}" for alias in node.names)}
        elif isinstance(node, ast.Call) and node.args:
            called = ast.unparse(node.func).rpartition(".")[2]
            if called in ("import_module", "__import__", "importorskip"):
                found |= {ast.unparse(node.args[0]).strip("'")}
    return frozenset(found)


def tops(path: Path) -> set[str]:
    return {name.partition(".")[0] for name in imports(path, module_of(path))}


def files_of_package(*packages: str) -> Iterator[Path]:
    return (p for p in HAND_WRITTEN if p.relative_to(ROOT).parts[0] in packages)


def importers_of(*forbidden: str, among: Iterator[Path]) -> list[str]:
    # A file without such a word imports none of them and need not be parsed.
    named = re.compile(rf"\b({'|'.join(map(re.escape, forbidden))})\b")
    return [
        name_of(path)
        for path in among
        if named.search(path.read_text())
        if tops(path) & set(forbidden)
    ]
