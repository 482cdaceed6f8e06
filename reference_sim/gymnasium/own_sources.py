"""The files that an environment consists of: its own, which no package versions.

A file is the environment's own when it lies outside the standard library, outside
`site-packages` and outside this project. The import system is observed, so the SHA-256
is that of the bytes that were executed, and no source text is interpreted. The check
records them for the manifest; a simulator process refuses every file that the manifest
does not have. Cached bytecode of own files is not used: it can be older than the file.
"""

from __future__ import annotations

import glob
import hashlib
import os
import sys
import sysconfig
import traceback
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from importlib.machinery import ModuleSpec, PathFinder, SourceFileLoader
from pathlib import Path
from types import CodeType, ModuleType
from typing import Any

from reference_sim.definition import installed_version
from reference_sim.interface import ChangedSource

FILES_MAX = 2000
_PROJECT = Path(__file__).resolve().parents[2]
_OUR_PACKAGES = ("conformance", "generated_clients", "tests", "tools")
_OUR_PREFIX = "reference_"
_INSTALLED = ("site-packages", "dist-packages")
_STDLIB = {
    Path(sysconfig.get_path(name)).resolve() for name in ("stdlib", "platstdlib")
}


@dataclass(frozen=True, slots=True)
class OwnFile:
    """A file that was loaded. name: as the manifest has it, the same on each host."""

    name: str
    sha256: str
    path: Path


class FileStates:
    """Compares files with their SHA-256; reads those alone that may have changed."""

    def __init__(self) -> None:
        self._equal: dict[tuple[Path, str], tuple[int, int, int, int]] = {}

    def is_equal(self, path: Path, sha256: str) -> bool:
        """A file is read again when its times, size or inode change."""
        state = _file_state(path)
        if state is not None and self._equal.get((path, sha256)) == state:
            return True
        self._equal.pop((path, sha256), None)
        try:
            is_equal = sha256_of(path) == sha256
        except OSError:
            return False
        if is_equal and state is not None:
            self._equal[path, sha256] = state
        return is_equal


class OwnSources:
    """Observes the imports of this process; see `record` and `require`.

    loaded: the own files that were executed, by module.
    fault: why what is loaded is not that of the manifest. An environment may catch the
    exception, so its simulator looks here.
    """

    def __init__(self) -> None:
        self.loaded: dict[str, OwnFile] = {}
        self.fault: str | None = None
        self._folders: list[Path] = []
        self._required: dict[str, str] | None = None
        self._states = FileStates()

    def record(self, folder: Path) -> None:
        """From now on, every own file may be loaded."""
        self._required = self.fault = None
        self._observe(folder)
        for module, file in _imported_files():
            if module not in self.loaded and self._is_own(file):
                self._add(module, file, file.read_bytes())

    def require(self, plan: Mapping[str, Any]) -> None:
        """From now on, own files must be those of the plan. Raises ChangedSource."""
        self._observe(Path(plan["made_of"]["folder"]))
        self._required = {**(self._required or {}), **plan["sources"]}
        for module, own in self.loaded.items():
            if plan["sources"].get(module, own.sha256) != own.sha256:
                self._refuse(own.name)
        for module, file in _imported_files():  # before imports were observed
            if module in plan["sources"] and module not in self.loaded:
                self._add(module, file, file.read_bytes())
        for package, version in plan["packages"].items():
            if (present := installed_version(package)) != version:
                raise ChangedSource(
                    f"{package} is {present} here, and was {version} when the server "
                    "started; restart the server"
                )

    def require_unchanged(self, modules: Iterable[str]) -> None:
        """Raises ChangedSource if a file was edited after it was executed."""
        files = [self.loaded[name] for name in modules if name in self.loaded]
        _require_no(
            [
                own.name
                for own in files
                if not self._states.is_equal(own.path, own.sha256)
            ]
        )

    def _observe(self, folder: Path) -> None:
        self.add_folder(folder)
        if self not in sys.meta_path:
            sys.meta_path.insert(0, self)

    def add_folder(self, folder: Path) -> None:
        """Let modules in this folder be imported."""
        folder = folder.resolve()
        if folder not in self._folders:
            self._folders.append(folder)
        if str(folder) not in sys.path:
            sys.path.append(str(folder))

    # Imports

    def find_spec(
        self,
        fullname: str,
        path: Sequence[str] | None = None,
        target: ModuleType | None = None,
    ) -> ModuleSpec | None:
        """As any finder of sys.meta_path; own files get a loader that reads them once.

        A module in a folder of the environment comes before an installed one, as in
        `python FILE.py`, and after the standard library.
        """
        spec = self._neighbour(fullname) if path is None else None
        for finder in sys.meta_path:
            if spec is None and finder is not self and hasattr(finder, "find_spec"):
                spec = finder.find_spec(fullname, path, target)
        if spec is None or not spec.has_location or spec.origin is None:
            return spec
        file = _containing_file(Path(spec.origin))
        if self._is_own(file):
            if type(spec.loader) is SourceFileLoader:
                spec.loader = OwnLoader(fullname, spec.origin)
            else:  # compiled, or in an archive
                self._add(fullname, file, file.read_bytes())
        return spec

    def _neighbour(self, name: str) -> ModuleSpec | None:
        if name in sys.stdlib_module_names or name.startswith(_OUR_PREFIX):
            return None
        spec = PathFinder.find_spec(name, [str(folder) for folder in self._folders])
        # A folder without __init__.py may have the name of an installed package.
        return spec if spec is not None and spec.has_location else None

    def note(self, module: str, file: Path, content: bytes) -> None:
        """The module is executed next. Raises ChangedSource."""
        if self in sys.meta_path and self._is_own(file):
            self._add(module, file, content)

    def _add(self, module: str, file: Path, content: bytes) -> None:
        sha256 = hashlib.sha256(content).hexdigest()
        own = OwnFile(self._name_of(module, file), sha256, file)
        if self._required is not None and self._required.get(module) != own.sha256:
            self._refuse(own.name, is_listed=module in self._required)
        self.loaded[module] = own

    def _refuse(self, name: str, *, is_listed: bool = True) -> None:
        self.fault = (
            str(ChangedSource.of([name]))
            if is_listed
            else f"{name} was not imported when the server checked the benchmark, so "
            "it is not in the manifest; import it at the top of the environment's file "
            "and restart the server"
        )
        raise ChangedSource(self.fault)

    def by_name(self) -> dict[str, str]:
        """The SHA-256 of every own file that was loaded, as the manifest has them."""
        files: dict[str, str] = {}
        for module, own in sorted(self.loaded.items()):
            is_taken = files.get(own.name, own.sha256) != own.sha256
            files[module if is_taken else own.name] = own.sha256
        return files

    # Which files

    def frames_of(self, error: BaseException) -> Sequence[traceback.FrameSummary]:
        """The lines of own files that an error has passed, the innermost one last."""
        return [
            frame
            for frame in traceback.extract_tb(error.__traceback__)
            if not frame.filename.startswith("<") and self._is_own(Path(frame.filename))
        ]

    def _is_own(self, file: Path) -> bool:
        # Debian links files of the standard library to files elsewhere.
        root = _versioned_folder(file.absolute()) or _versioned_folder(file.resolve())
        if root is None:
            return True
        file = file.resolve()
        return any(
            file.is_relative_to(folder) and folder.is_relative_to(root)
            for folder in self._folders
        )

    def _name_of(self, module: str, file: Path) -> str:
        """Its path within the environment's folder, or within the path of imports."""
        file = file.resolve()
        for folder in self._folders:
            if file.is_relative_to(folder):
                return file.relative_to(folder).as_posix()
        above = module.split(".") if file.stem == "__init__" else module.split(".")[:-1]
        return "/".join([*above, file.name])


class OwnLoader(SourceFileLoader):
    """Executes the bytes that are hashed."""

    def get_code(self, fullname: str) -> CodeType:
        """Compiled from the file, never from cached bytecode."""
        path = self.get_filename(fullname)
        content = self.get_data(path)
        OWN_SOURCES.note(fullname, Path(path), content)
        code: CodeType = self.source_to_code(content, path)
        return code


OWN_SOURCES = OwnSources()


def with_place(text: str, error: BaseException) -> str:
    """The text and the innermost line of an own file: `… (environment.py:11)`."""
    frames = OWN_SOURCES.frames_of(error)
    if not frames:
        return text
    return f"{text} ({Path(frames[-1].filename).name}:{frames[-1].lineno})"


def packages_imported_by_own_files() -> set[str]:
    """The top-level names of what stands in the modules of own files."""
    values = [
        value
        for module in OWN_SOURCES.loaded
        for name, value in vars(sys.modules.get(module, object)).items()
        if not name.startswith("__")
    ]
    origins = {
        value.__name__
        if isinstance(value, ModuleType)
        else getattr(value, "__module__", None)
        for value in values
    }
    names = {origin.partition(".")[0] for origin in origins if isinstance(origin, str)}
    return names - {module.partition(".")[0] for module in OWN_SOURCES.loaded}


def _imported_files() -> Iterable[tuple[str, Path]]:
    for name, module in list(sys.modules.items()):
        file = getattr(module, "__file__", None)
        if name != "__main__" and isinstance(file, str) and Path(file).is_absolute():
            yield name, _containing_file(Path(file))


def _containing_file(path: Path) -> Path:
    """The file itself, or the archive that it is in."""
    return next((part for part in (path, *path.parents) if part.is_file()), path)


def _versioned_folder(file: Path) -> Path | None:
    """The folder of installed packages, of Python or of this project; else None."""
    for folder in file.parents:
        if folder.name in _INSTALLED or folder in _STDLIB:
            return folder
        is_ours = folder.name in _OUR_PACKAGES or folder.name.startswith(_OUR_PREFIX)
        if folder.parent == _PROJECT and is_ours:
            return folder
    return None


# Declared files of data


class DeclaredFiles:
    """Files by their path within a folder, each with the SHA-256 of the manifest."""

    def __init__(self, folder: Path, sha256: Mapping[str, str]) -> None:
        self._folder, self._sha256 = folder, sha256
        self._states = FileStates()

    @classmethod
    def present(cls, folder: Path, sha256: Mapping[str, str]) -> DeclaredFiles:
        """Those of the files that are in the folder: a source may lie elsewhere."""
        files = cls(folder, sha256)
        changed = set(files.changed())
        files._sha256 = {n: sha256[n] for n in sha256 if n not in changed}
        return files

    def require_unchanged(self) -> None:
        """Raises ChangedSource."""
        _require_no(self.changed())

    def changed(self) -> list[str]:
        """The files that are not as they were, or are gone."""
        return [
            name
            for name, sha256 in self._sha256.items()
            if not self._states.is_equal(self._folder / name, sha256)
        ]


def _require_no(changed: Sequence[str]) -> None:
    if changed:
        raise ChangedSource.of(changed)


def _file_state(path: Path) -> tuple[int, int, int, int] | None:
    """Times, size and inode of a file; None if it does not exist."""
    try:
        stat = path.stat()
    except (OSError, ValueError):
        return None
    return stat.st_mtime_ns, stat.st_ctime_ns, stat.st_size, stat.st_ino


def hash_files(folder: Path, patterns: Sequence[str]) -> dict[str, str]:
    """The SHA-256 of every file that a pattern matches. Raises ValueError."""
    names: set[str] = set()
    for pattern in patterns:
        if Path(pattern).is_absolute():
            raise ValueError(f"{pattern}: must be relative to the file's folder")
        # Path.glob refuses `..`.
        matches = glob.glob(pattern, root_dir=folder, recursive=True)  # noqa: PTH207
        matches = [name for name in matches if (folder / name).is_file()]
        if not matches:
            raise ValueError(f"{pattern}: no file matches")
        names |= {Path(name).as_posix() for name in matches}
    if len(names) > FILES_MAX:
        raise ValueError(f"{len(names)} files match; at most {FILES_MAX} may")
    return {name: sha256_of(folder / name) for name in sorted(names)}


def sha256_of(path: Path) -> str:
    with path.open("rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()


def observe_reads(folder: Path) -> set[str]:
    """The files in the folder that this process opens to read from now on, by path.

    Files that a library in C opens are not seen. The process observes until it ends.
    """
    opened: set[str] = set()
    folder = folder.resolve()

    def see(event: str, arguments: tuple[Any, ...]) -> None:
        if event != "open" or not isinstance(arguments[0], str):
            return
        if arguments[2] & (os.O_WRONLY | os.O_RDWR):
            return
        path = Path(os.path.normpath(Path.cwd() / arguments[0]))
        if not path.is_file():
            return
        if path.is_relative_to(folder) and _versioned_folder(path) is None:
            name = path.relative_to(folder)
            if not any(part.startswith(".") for part in name.parts):
                opened.add(name.as_posix())

    sys.addaudithook(see)
    return opened
