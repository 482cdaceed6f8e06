"""Whether this is a checkout, whose advice is `make …`, or packages from wheels."""

from pathlib import Path


def in_checkout() -> bool:
    """Whether this is the repository, which has `make`, and not an installed wheel."""
    return (Path(__file__).parents[2] / "Makefile").is_file()


def how_to_install(requirement: str) -> str:
    """The command that adds a package beside those of this project."""
    if in_checkout():
        return f"make add PACKAGE={requirement}"
    return f"pip install {requirement}"
