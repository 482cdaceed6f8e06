"""Builds the site of the standard into build/site/html/VERSION: `make site`.

The pages are written into build/site/source, from the specification, the kit, the
mutants and the documents of this repository; Sphinx, in an environment of its own,
makes HTML of them. Pages that measurements have written into build/ are shown, too. A
link that leads nowhere fails the build. The result needs no server and no network: open
build/site/html/index.html. The folders of other versions are left as they are.
"""

import shutil
import subprocess
import sys
from collections.abc import Iterable
from pathlib import Path

from conformance.specification.document import load_spec
from tools.npm_package import provide_file
from tools.site import operation_pages, overview_pages, rule_pages
from tools.site.kit_reports import KitReports, read_reports
from tools.site.markdown import convert
from tools.traceability import ROOT, traces

HERE = Path(__file__).resolve().parent
BUILD = ROOT / "build" / "site"
SPHINX = ROOT / ".venv-generate" / "bin" / "python"
LIBRARY = ROOT / ".venv-generate" / "mermaid.min.js"
COPIED = ("docs", "spec")
FILES = {".md", ".yaml", ".json", ".txt", ".svg", ".png"}
EXAMPLES = "examples/README.md"
INDEX = "docs/README.md"
MEASURED = "build"


def documents(measured: Path) -> dict[str, Path]:
    """Path in the site → its file: pages and what they link to.

    measured: the folder of pages that measurements have written; they are optional.
    """
    paths = [path for name in COPIED for path in sorted((ROOT / name).rglob("*"))]
    kept = [path for path in paths if path.suffix in FILES]
    pages = {path.relative_to(ROOT).as_posix(): path for path in kept}
    built = {
        f"{MEASURED}/{path.name}": path
        for path in sorted(measured.glob("*"))
        if path.suffix in (".md", ".svg")
    }
    return pages | built | {EXAMPLES: ROOT / EXAMPLES}


def contents(names: Iterable[str]) -> str:
    """docs/README.md lists every page; so does the navigation."""
    listed = [
        f"/{name.removesuffix('.md')}"
        for name in names
        if name.endswith(".md")
        and (name == EXAMPLES or name.startswith(("docs/", f"{MEASURED}/")))
        and name != INDEX
    ]
    pages = "\n".join(listed)
    return f"\n```{{toctree}}\n:hidden:\n\n{pages}\n```\n"


def write_source(directory: Path, reports: KitReports, measured: Path) -> None:
    """Write every page into a folder."""
    generated = {
        **overview_pages.pages(reports),
        **rule_pages.pages(reports),
        **operation_pages.pages(reports),
    }
    copied = documents(measured)
    files = {*generated, *copied}
    for name, path in copied.items():
        target = directory / name
        target.parent.mkdir(parents=True, exist_ok=True)
        if path.suffix != ".md":
            shutil.copyfile(path, target)
        else:
            text = convert(path.read_text(), name, files, traces())
            target.write_text(text + (contents(copied) if name == INDEX else ""))
    for name, text in generated.items():
        target = directory / name
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(convert(text, name, files, traces()))


def build(directory: Path, reports: KitReports, measured: Path) -> Path:
    """Build the site; the folder of its pages. SystemExit where a link is dead."""
    source, html = directory / "source", directory / "html" / load_spec().version
    # A page that is gone from the repository has to go from an earlier site, too.
    for folder in (source, html):
        shutil.rmtree(folder, ignore_errors=True)
    write_source(source, reports, measured)
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
    copy_files_of_specification(html)
    write_entry(html)
    return html


def copy_files_of_specification(html: Path) -> None:
    """Copy its other files to the paths that they have beside its pages."""
    for path in sorted((ROOT / "spec").rglob("*")):
        if path.is_file() and path.suffix in FILES - {".md"}:
            target = html / path.relative_to(ROOT)
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(path, target)


def write_entry(html: Path) -> None:
    """Write the page above all versions, which leads to the one that was built."""
    versions = sorted(path.name for path in html.parent.glob("[0-9]*"))
    links = "".join(f'<li><a href="{v}/index.html">{v}</a></li>' for v in versions)
    html.with_name("index.html").write_text(
        '<!doctype html>\n<html lang="en">\n<meta charset="utf-8">\n'
        f'<meta http-equiv="refresh" content="0; url={html.name}/index.html">\n'
        f"<title>Proctor</title>\n<h1>Proctor</h1>\n<ul>{links}</ul>\n</html>\n"
    )


def main() -> int:
    html = build(BUILD, read_reports(), ROOT / MEASURED)
    print(f"site: {html.with_name('index.html')}")
    return 0
