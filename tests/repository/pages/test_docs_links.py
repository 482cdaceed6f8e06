"""Documents hold together: no dead link, no dead anchor, no page that nothing links to.

Read are README.md, examples/README.md and docs/, as GitHub shows them. Paths of docs/
in the text of other files are checked as well, for they are read by people.
"""

import re
from functools import cache
from pathlib import Path
from urllib.parse import unquote

import pytest

from tests.support.paths import ROOT
from tests.support.processes import run_program

DOCS = ROOT / "docs"
PAGES = [
    *(ROOT / "README.md", ROOT / "examples" / "README.md"),
    *(ROOT / "clients" / "README.md", ROOT / "generated_clients" / "README.md"),
    *(ROOT / "clients").glob("*/README.md"),
    *DOCS.rglob("*.md"),
    *(ROOT / "spec").rglob("*.md"),
    *(ROOT / "spec").rglob("*.yaml"),
]
LINK = re.compile(r"\]\(<?([^)>\s]+)>?(?: \"[^\"]*\")?\)")
FENCE = re.compile(r"^(```|~~~).*?^\1", re.MULTILINE | re.DOTALL)
CODE = re.compile(r"`[^`\n]*`")
HEADING = re.compile(r"^#{1,6} +(.+?) *#*$", re.MULTILINE)
LINE = re.compile(r"L(\d+)")
MENTION = re.compile(r"(?<![\w/.])docs/[\w./-]+\.(?:md|svg|png)")
MENTIONING = (
    *("*.py", "*.md", "*.toml", "*.yaml", "*.mustache", "Makefile"),
    *("clients/*", "generated_clients/*/example", "generated_clients/*/interop"),
)
ENTRY_LIMIT = 14  # thirteen pages of hosts; elsewhere a dozen and an index


def name_of(path: Path) -> str:
    return path.relative_to(ROOT).as_posix()


def links(page: Path) -> list[str]:
    text = CODE.sub("", FENCE.sub("", page.read_text()))
    return [link for link in LINK.findall(text) if not re.match(r"[a-z]+:", link)]


@cache
def anchors(page: Path) -> frozenset[str]:
    """The anchors that GitHub gives to a page's headings."""
    found: dict[str, int] = {}
    for heading in HEADING.findall(FENCE.sub("", page.read_text())):
        text = re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", heading)
        anchor = re.sub(r"[^\w\- ]", "", text.lower()).replace(" ", "-")
        count = found.get(anchor, 0)
        found[anchor] = count + 1
        if count:
            found[f"{anchor}-{count}"] = 1
    return frozenset(found)


def fault_of(page: Path, link: str) -> str | None:
    """Why a link is dead; None if it is not."""
    path, _, anchor = unquote(link).partition("#")
    target = (page.parent / path).resolve() if path else page
    if not target.is_relative_to(ROOT) or not target.exists():
        return "there is no such file"
    if line := LINE.fullmatch(anchor):
        lines = len(target.read_text().splitlines())
        return None if int(line[1]) <= lines else f"it has {lines} lines"
    if anchor and anchor not in anchors(target):
        return "there is no such heading"
    return None


@pytest.mark.parametrize("page", PAGES, ids=name_of)
def test_links_lead_somewhere(page: Path) -> None:
    faults = {link: fault_of(page, link) for link in links(page)}
    assert {link: fault for link, fault in faults.items() if fault} == {}


def test_every_page_is_reached_from_the_index() -> None:
    """Expect docs/README.md to lead to every page, directly or over others."""
    reached, left = set[Path](), [DOCS / "README.md"]
    while left:
        page = left.pop()
        if page in reached:
            continue
        reached.add(page)
        targets = [page.parent / link.partition("#")[0] for link in links(page)]
        left += [t.resolve() for t in targets if t.suffix == ".md" and t.exists()]
    assert {name_of(page) for page in set(DOCS.rglob("*.md")) - reached} == set()


def test_paths_of_pages_in_other_files_exist() -> None:
    command = ["git", "ls-files", "-z", "--", *MENTIONING]
    tracked = run_program(command, cwd=ROOT, check=True).stdout.split("\0")
    mentions = {
        (name, path)
        for name in tracked
        if name and (ROOT / name).is_file()
        for path in MENTION.findall((ROOT / name).read_text(errors="replace"))
    }
    assert len(mentions) > 10
    assert {m for m in mentions if not (ROOT / m[1]).exists()} == set()


def test_folders_are_taken_in_at_a_glance() -> None:
    for folder in [DOCS, *(path for path in DOCS.rglob("*") if path.is_dir())]:
        assert len(list(folder.iterdir())) <= ENTRY_LIMIT, name_of(folder)


def test_dead_links_are_found(tmp_path: Path) -> None:
    page = DOCS / "README.md"
    assert fault_of(page, "no-such-page.md") == "there is no such file"
    assert fault_of(page, "../README.md#no-such-heading") == "there is no such heading"
    assert fault_of(page, "../README.md#L9999")
    assert fault_of(page, str(tmp_path)) == "there is no such file"


PATH = re.compile(
    r"`((?:spec|conformance|tests|docs|tools|examples|reference_\w+|clients|generated_clients)"
    r"/[\w./-]*)`"
)
TEST_FILE = re.compile(r"`(?:tests/(?:\w+/)*)?(test_\w+\.py)`")


@pytest.mark.parametrize("page", PAGES, ids=name_of)
def test_paths_in_the_text_exist(page: Path) -> None:
    """Parts in capitals stand for a name of the reader's own."""
    text = page.read_text()
    paths = {path for path in PATH.findall(text) if not re.search("[A-Z]{4}", path)}
    dead = {path for path in paths if not (ROOT / path).exists()}
    assert dead == set()
    files = {path.name for path in (ROOT / "tests").rglob("test_*.py")}
    assert set(TEST_FILE.findall(text)) - files == set()


@pytest.mark.parametrize("page", sorted(DOCS.glob("contribute/add-*.md")), ids=name_of)
def test_constants_that_a_guide_names_exist(page: Path) -> None:
    names = set(re.findall(r"`([A-Z]+_[A-Z_]+|[A-Z]{5,})`", page.read_text()))
    sources = "\n".join(
        path.read_text()
        for folder in ("reference_server", "reference_sim", "conformance", "tests")
        for path in (ROOT / folder).rglob("*.py")
    )
    assert {n for n in names if not re.search(rf"(?m)^{n}\b", sources)} == set()


def test_make_knows_the_commands_of_every_page() -> None:
    makefile = (ROOT / "Makefile").read_text()
    targets = set(re.findall(r"^([a-z-]+):", makefile, re.MULTILINE))
    apart = re.findall(r"^([a-z]+): \.venv-\1/ready", makefile, re.MULTILINE)
    targets |= {f"{name}-check" for name in apart}  # by a rule for all of them
    called = re.compile(r"(?m)(?:^ +|`)make ([a-z][a-z-]+)(?![\w-])")
    named = {name for page in PAGES for name in called.findall(page.read_text())}
    assert len(named) > 10
    assert named - targets == set()


def test_pages_install_the_checkout_before_names_of_an_index() -> None:
    """Nothing is published yet: such a name may be taken by others."""
    install = re.compile(r"pipx? install [\"']?proctor-")
    for page in PAGES:
        for paragraph in re.split(r"\n\s*\n", page.read_text(encoding="utf-8")):
            if found := install.search(paragraph):
                before = paragraph[: found.start()]
                assert "From the first release on" in before, f"{page}: {paragraph}"
