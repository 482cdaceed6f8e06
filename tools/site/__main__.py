"""Builds the site of the standard into build/site/html: `make site`.

The pages are written into build/site/source, from the specification, the kit, the
mutants and the documents of this repository; Sphinx, in an environment of its own,
makes HTML of them. A link that leads nowhere fails the build. The result needs no
server and no network: open index.html.
"""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path

from tools.npm_package import provide_file
from tools.site import operation_pages, overview_pages, rule_pages
from tools.site.markdown import convert
from tools.traceability import ROOT, traces

HERE = Path(__file__).resolve().parent
BUILD = ROOT / "build" / "site"
SPHINX = ROOT / ".venv-generate" / "bin" / "python"
LIBRARY = ROOT / ".venv-generate" / "mermaid.min.js"
COPIED = ("docs", "spec")
FILES = {".md", ".yaml", ".json", ".txt", ".svg", ".png"}
EXAMPLES = "examples/README.md"


def documents() -> dict[str, Path]:
    """Path in the site → file of the repository; pages and what they link to."""
    paths = [path for name in COPIED for path in sorted((ROOT / name).rglob("*"))]
    found = {
        path.relative_to(ROOT).as_posix(): path
        for path in paths
        if path.suffix in FILES
    }
    return found | {EXAMPLES: ROOT / EXAMPLES}


def contents() -> str:
    """docs/README.md lists every page; so does the navigation."""
    listed = [
        name.removeprefix("docs/").removesuffix(".md")
        for name in documents()
        if name.startswith("docs/") and name.endswith(".md") and "README" not in name
    ]
    pages = "\n".join([*listed, f"../{EXAMPLES.removesuffix('.md')}"])
    return f"\n```{{toctree}}\n:hidden:\n\n{pages}\n```\n"


def write_source(directory: Path) -> None:
    """Write every page into a folder."""
    generated = {
        **overview_pages.pages(),
        **rule_pages.pages(),
        **operation_pages.pages(),
    }
    copied = documents()
    files = {*generated, *copied}
    for name, path in copied.items():
        target = directory / name
        target.parent.mkdir(parents=True, exist_ok=True)
        if path.suffix != ".md":
            shutil.copyfile(path, target)
        else:
            text = convert(path.read_text(), name, files, traces())
            target.write_text(text + (contents() if name == "docs/README.md" else ""))
    for name, text in generated.items():
        target = directory / name
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(convert(text, name, files, traces()))


def build(directory: Path = BUILD) -> Path:
    """Build the site; the folder of its pages. SystemExit where a link is dead."""
    source, html = directory / "source", directory / "html"
    shutil.rmtree(source, ignore_errors=True)
    write_source(source)
    provide_file("site-npm.txt", "dist/mermaid.min.js", LIBRARY)
    static = source / "_static"
    shutil.copytree(HERE / "static", static)
    shutil.copyfile(LIBRARY, static / LIBRARY.name)
    sphinx = [str(SPHINX), "-m", "sphinx", "--builder", "html", "--jobs", "auto"]
    sphinx.append(f"--define=html_static_path={static}")
    strict = ["--fail-on-warning", "--keep-going", "--quiet"]
    done = subprocess.run(
        [*sphinx, *strict, "--conf-dir", str(HERE), str(source), str(html)],
        cwd=ROOT,
        check=False,
    )
    if done.returncode:
        sys.exit("site: not built; see above")
    return html


if __name__ == "__main__":
    print(f"site: {build() / 'index.html'}")
