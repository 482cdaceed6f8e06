"""Commands that a message prints, to be typed as they stand."""

from __future__ import annotations

import shlex
import shutil
import sys
from pathlib import Path


def command_to_copy(*words: str) -> str:
    """A command of `proctor`, which a shell finds."""
    return shlex.join([_program(), *words])


def _program() -> str:
    """`proctor`; or its path, where a shell would not find it by that name.

    That is as it was called, or beside the Python of another program.
    """
    called = sys.argv[0]
    if Path(called).name != "proctor":
        called = str(Path(sys.executable).with_name("proctor"))
    if not Path(called).exists():
        return "proctor"
    installed = shutil.which("proctor")
    is_found = installed is not None and Path(called).samefile(installed)
    return "proctor" if is_found else called
