"""Makes a preset of the Python that runs this program, with some of its packages.

The interpreter, its library and the packages are copied: a user of sandboxes can read
them, wherever this Python is. Nothing is downloaded, so a preset has the versions that
this environment has.
"""

from __future__ import annotations

import shutil
import sys
from collections.abc import Iterable, Sequence
from importlib import metadata
from pathlib import Path
from typing import Final

from reference_platform.images.presets import FILES_PATH

DEFAULT: Final = ("numpy",)
_VERSION: Final = f"python{sys.version_info.major}.{sys.version_info.minor}"
# Parts of the library that a policy does not need, and caches.
_LEFT_OUT: Final = shutil.ignore_patterns(
    *("__pycache__", "site-packages", "dist-packages", "test", "tests", "idlelib"),
    *("tkinter", "ensurepip", "lib2to3", "turtledemo", "config-*", "*.a"),
)
_LIBRARIES: Final = ("/lib", "/lib64", "/usr/lib", "/usr/lib64")


class CannotMake(Exception):
    """The text says why."""


def make_python_preset(presets: Path, name: str, packages: Sequence[str]) -> Path:
    """Make or replace the preset of a name; the path of its file. Raises CannotMake."""
    presets.mkdir(mode=0o711, parents=True, exist_ok=True)
    presets.chmod(0o711)
    folder, new = presets / name, presets / f".new-{name}"
    shutil.rmtree(new, ignore_errors=True)
    home = Path(sys.base_prefix)
    library = new / "lib" / _VERSION
    shutil.copytree(home / "lib" / _VERSION, library, ignore=_LEFT_OUT)
    for shared in (home / "lib").glob("libpython3*.so*"):
        shutil.copy2(shared, new / "lib")
    (new / "bin").mkdir()
    interpreter = Path(sys.executable).resolve()
    shutil.copy2(interpreter, new / "bin" / "python3")
    for package in packages:
        _copy_package(package, library / "site-packages")
    _let_all_read([new, *new.rglob("*")])
    shutil.rmtree(folder, ignore_errors=True)
    new.rename(folder)
    file = presets / f"{name}.toml"
    file.write_text(_text_of(name))
    return file


def _copy_package(package: str, target: Path) -> None:
    try:
        files = metadata.files(package)
    except metadata.PackageNotFoundError as error:
        text = f"{package} is not installed in the environment of this program"
        raise CannotMake(text) from error
    for file in files or ():
        if ".." in file.parts or "__pycache__" in file.parts or "tests" in file.parts:
            continue
        place = target / file
        place.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(str(file.locate()), place)


def _let_all_read(paths: Iterable[Path]) -> None:
    for path in paths:
        if not path.is_symlink():
            is_program = path.is_dir() or path.stat().st_mode & 0o100
            path.chmod(0o755 if is_program else 0o644)


def _text_of(name: str) -> str:
    binds = ", ".join(f'"{path}"' for path in _LIBRARIES if Path(path).exists())
    variables = {
        "PYTHONHOME": FILES_PATH,
        "LD_LIBRARY_PATH": f"{FILES_PATH}/lib",
        "PYTHONUNBUFFERED": "1",
        "PYTHONDONTWRITEBYTECODE": "1",
        "OPENBLAS_NUM_THREADS": "2",  # of the processors that a sandbox has
        "OMP_NUM_THREADS": "2",
    }
    environment = ", ".join(f'{key} = "{value}"' for key, value in variables.items())
    return (
        f'command = ["{FILES_PATH}/bin/python3", "main.py"]\n'
        f"binds = [{binds}]\n"
        f'files = "{name}"\n'
        f"environment = {{{environment}}}\n"
    )
