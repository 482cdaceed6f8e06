"""Whether this is a checkout, whose advice is `make …`, or packages from wheels.

This module must not import what may be missing.
"""

import importlib.metadata
import json
import shlex
from pathlib import Path
from urllib.parse import unquote, urlsplit

_PACKAGE = "proctor-eval"
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


def install_command(extra: str) -> str:
    """`pip install …` with an extra of the project, such as `server,video`."""
    return f"pip install {shlex.quote(f'{_source()}[{extra}]')}"


def _source() -> str:
    """The folder or file that this was installed from; else the name of the package."""
    if in_checkout():
        return str(_ROOT)
    try:
        text = importlib.metadata.distribution(_PACKAGE).read_text("direct_url.json")
    except importlib.metadata.PackageNotFoundError:
        text = None
    address = urlsplit(json.loads(text)["url"] if text else "")
    return unquote(address.path) if address.scheme == "file" else _PACKAGE
