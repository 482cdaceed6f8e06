"""Pages that commands write into build/; `make site` shows those that are there."""

from pathlib import Path

BUILD = Path(__file__).resolve().parents[1] / "build"


def write_page(name: str, text: str) -> None:
    """Write the page `name`, such as `attack.md`, and print where it is."""
    BUILD.mkdir(exist_ok=True)
    page = BUILD / name
    page.write_text(text)
    print(f"page: {page}")
