"""The site: it shows what the kit recorded, and its links lead somewhere."""

import re
from html import unescape
from pathlib import Path
from typing import Any
from urllib.parse import unquote

import pytest

from conformance.specification.ledger import load_ledger
from tools import npm_package
from tools.site import build_site as site
from tools.site import kit_reports
from tools.site.exchanges import worked_exchanges
from tools.site.kit_reports import KitReports, judge, summarize
from tools.site.markdown import convert
from tools.site.rule_pages import since

FILES = {"guide/a.md", "spec/b.md"}
RULES = {"PRED-002"}
# A few whose checks are quick.
RECORDED_RULES = [
    *("ATT-001", "ATT-002", "BEN-001", "CAL-002", "DET-001"),
    *("PRED-002", "PRED-003", "RUN-001", "STOP-001", "SVC-001"),
]
HREF = re.compile(r'(?:href|src)="([^"]+)"')
ANCHOR = re.compile(r'\bid="([^"]+)"')


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        ("see [b](../spec/b.md#x)", "see [b](/spec/b.md#x)"),
        ("see [code](../tools/x.py)", "see code (`tools/x.py`)"),
        ("see [`x.py`](../tools/x.py)", "see `x.py`"),
        ("see [out](https://example.org)", "see [out](https://example.org)"),
        (
            "by PRED-002, not PRED-999",
            "by [PRED-002](/rules/PRED-002.md), not PRED-999",
        ),
        ("`PRED-002`", "`PRED-002`"),
        ("# PRED-002\n", "# PRED-002\n"),
        ("```\nPRED-002 [a](b.md)\n```", "```\nPRED-002 [a](b.md)\n```"),
        ("[PRED-002](a.md)", "[PRED-002](/guide/a.md)"),
    ],
)
def test_pages_are_converted(text: str, wanted: str) -> None:
    assert convert(text, "guide/a.md", FILES, RULES) == wanted


@pytest.fixture(scope="module")
def report() -> dict[str, Any]:
    """A report of the kit on a few rules of the reference server."""
    return judge(RECORDED_RULES, quick=True)


@pytest.fixture(scope="module")
def reports(report: dict[str, Any]) -> KitReports:
    whole = report | {"only": [], "quick": False}
    return KitReports(worked_exchanges(report), {"A server": summarize("a", whole)})


@pytest.mark.slow("runs the kit on the reference server")
def test_rules_have_worked_exchanges(reports: KitReports) -> None:
    assert reports.exchanges.keys() == set(RECORDED_RULES)


@pytest.mark.slow("runs the kit on the reference server")
def test_a_refusal_is_shown_beside_its_counterpart(reports: KitReports) -> None:
    refused, accepted = reports.exchanges["PRED-003"]
    assert refused["answer_body"]["code"] == "seq_conflict"
    assert accepted["status"] == 200
    assert refused["operation"] == accepted["operation"] == "predict"


@pytest.mark.slow("runs the kit on the reference server")
def test_only_whole_runs_are_verdicts_on_a_server(report: dict[str, Any]) -> None:
    with pytest.raises(ValueError, match="a whole run"):
        summarize("a", report)


def test_a_report_is_kept_until_the_code_changes(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    digests = iter("aab")
    judged: list[dict[str, Any]] = []

    def judge_again() -> dict[str, Any]:
        judged.append({"number": len(judged)})
        return judged[-1]

    monkeypatch.setattr(kit_reports, "REPORT", tmp_path / "build" / "report.json")
    monkeypatch.setattr(kit_reports, "_digest", lambda: next(digests))
    monkeypatch.setattr(kit_reports, "judge", judge_again)
    reports = [kit_reports._reference_report() for _ in range(3)]
    assert reports == [{"number": 0}, {"number": 0}, {"number": 1}]


def test_a_rule_has_the_version_that_names_it() -> None:
    assert since("PRED-001").startswith("1.0.0")


def dead_links(html: Path) -> list[str]:
    """Links of all pages to files or anchors that are not there, read from the HTML."""
    texts = {path: path.read_text() for path in html.rglob("*.html")}
    anchors = {path: set(ANCHOR.findall(text)) for path, text in texts.items()}
    dead = set()
    for page, text in texts.items():
        for link in set(HREF.findall(text)):
            if re.match(r"[a-z]+:|//", link):
                continue
            path, _, anchor = unquote(unescape(link)).partition("#")
            target = (page.parent / path.partition("?")[0]).resolve() if path else page
            is_there = target.exists()
            if not is_there or (anchor and anchor not in anchors.get(target, {anchor})):
                dead.add(f"{page.relative_to(html)}: {link}")
    return sorted(dead)


@pytest.mark.slow("builds the whole site")
def test_site_has_no_dead_link_and_needs_no_network(
    tmp_path: Path, reports: KitReports
) -> None:
    measured = tmp_path / "measured"
    measured.mkdir()
    (measured / "attack.md").write_text("# Attack\n\n[rules](../spec/scoring.md)\n")
    html = site.build(tmp_path, reports, measured)
    pages = {path.relative_to(html).as_posix() for path in html.rglob("*.html")}
    assert {f"rules/{id_}.html" for id_ in load_ledger()} <= pages
    assert "build/attack.html" in pages
    assert dead_links(html) == []
    loaded = re.compile(r'(?:src|<link[^>]+href)="(?:https?:)?//')
    assert {p for p in pages if loaded.search((html / p).read_text())} == set()
    index = (html / "searchindex.js").read_text()
    assert "seq_out_of_ord" in index


def test_a_package_that_cannot_be_fetched_is_named(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """As without a network: npm says why, and no traceback follows."""
    monkeypatch.setattr(npm_package, "NODE", "false")
    target = tmp_path / "library.js"
    with pytest.raises(SystemExit, match=r"mermaid@\S+ could not be fetched"):
        npm_package.provide_file("site-npm.txt", "dist/mermaid.min.js", target)
    assert not target.exists()
