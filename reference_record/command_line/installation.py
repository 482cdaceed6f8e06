"""Whether this is a checkout, whose advice is `make …`, or packages from wheels."""

import shlex
from pathlib import Path

_ROOT = Path(__file__).resolve().parents[2]


def in_checkout() -> bool:
    """Whether this is the repository, which has `make`, and not an installed wheel."""
    return (_ROOT / "Makefile").is_file()


def make_here() -> str:
    """`make`, with the folder of its Makefile for who stands in another one."""
    if Path.cwd() == _ROOT:
        return "make"
    return f"make -C {shlex.quote(str(_ROOT))}"


def how_to_install(requirement: str) -> str:
    """The command that adds a package beside those of this project."""
    if in_checkout():
        return f"{make_here()} add PACKAGE={requirement}"
    return f"pip install {requirement}"
