"""Writes all report files: report.json, junit.xml, report.html, and badges.

All carry the same rule ids; all are written after every run.
"""

import json
from pathlib import Path
from xml.etree import ElementTree as ET

from conformance.client.connections.transport.replaced_file import replace_file
from conformance.reports.badge import badge, level_badge
from conformance.reports.failure_card import card
from conformance.reports.html import page
from conformance.specification.document import load_spec, spec_sha256
from conformance.specification.ledger import LEVELS, load_ledger
from conformance.verdicts.result import Result, as_plain
from conformance.verdicts.verdict import Outcome, Verdict

_NOT_IN_XML = dict.fromkeys(
    [*range(9), 11, 12, *range(14, 32), 0xFFFE, 0xFFFF, *range(0xD800, 0xE000)], "�"
)


def write_reports(result: Result) -> None:
    """Write every report into the directory --report."""
    directory = Path(result.settings.report)
    directory.mkdir(parents=True, exist_ok=True)
    plain = json.dumps(as_plain(result), indent=1, ensure_ascii=False)
    replace_file(directory / "report.json", plain)
    replace_file(directory / "junit.xml", junit(result))
    replace_file(directory / "report.html", page(result))
    replace_file(directory / "badge.svg", badge(result))
    # The folder may have badges of an earlier report, of something else.
    for level in LEVELS:
        (directory / f"badge-{level}.svg").unlink(missing_ok=True)
    for verdict in result.levels():
        replace_file(directory / f"badge-{verdict.name}.svg", level_badge(verdict))


def junit(result: Result) -> str:
    """Give the result as JUnit XML; the name of a case is the requirement's id."""
    count = result.counts("MUST") + result.counts("SHOULD")
    undecided = (Outcome.KIT_ERROR, Outcome.INCONCLUSIVE)
    errors = sum(count[outcome] for outcome in undecided)
    failures = sum(_fails(verdict) for verdict in result.rows.values())
    skipped = sum(_is_skipped(verdict) for verdict in result.rows.values())
    suite = ET.Element(
        "testsuite",
        name="proctor conformance",
        tests=str(len(result.rows) + (result.problem is not None)),
        failures=str(failures),
        errors=str(errors + (result.problem is not None)),
        skipped=str(skipped),
        time=f"{result.elapsed_s:.3f}",
        timestamp=result.started_at,
    )
    _add_properties(suite, result)
    if result.problem is not None:
        case = ET.SubElement(
            suite, "testcase", name="preflight", classname="conformance"
        )
        _child(case, "error", result.problem, result.problem)
    for verdict in result.rows.values():
        _add_case(suite, verdict, result)
    suites = ET.Element("testsuites")
    suites.append(suite)
    ET.indent(suites)
    return ET.tostring(suites, encoding="unicode", xml_declaration=True)


def _add_properties(suite: ET.Element, result: Result) -> None:
    properties = ET.SubElement(suite, "properties")
    for name, value in {
        "spec_version": load_spec().version,
        "spec_sha256": spec_sha256(),
        "url": result.settings.url,
        "seed": str(result.settings.seed),
        "conclusion": result.conclusion(),
    }.items():
        printable = value.translate(_NOT_IN_XML)
        ET.SubElement(properties, "property", name=name, value=printable)


def _fails(verdict: Verdict) -> bool:
    is_must = load_ledger()[verdict.requirement_id].level == "MUST"
    return (
        verdict.outcome == Outcome.FAILED and is_must and not verdict.is_known_failure
    )


def _is_skipped(verdict: Verdict) -> bool:
    skipped = (Outcome.NOT_VERIFIED, Outcome.NOT_APPLICABLE)
    is_excused = verdict.outcome == Outcome.FAILED and not _fails(verdict)
    return verdict.outcome in skipped or is_excused


def _add_case(suite: ET.Element, verdict: Verdict, result: Result) -> None:
    row = load_ledger()[verdict.requirement_id]
    case = ET.SubElement(
        suite,
        "testcase",
        name=row.id,
        classname=f"conformance.{row.area}",
        time=f"{verdict.elapsed_s:.3f}",
    )
    reason = verdict.reason or verdict.observed
    if _fails(verdict):
        _child(case, "failure", verdict.observed, "\n".join(card(verdict, result)))
    elif _is_skipped(verdict):
        _child(case, "skipped", f"{verdict.outcome.value}: {reason}")
    elif verdict.outcome != Outcome.PASSED:
        text = "\n".join(card(verdict, result))
        _child(case, "error", f"{verdict.outcome.value}: {reason}", text)


def _child(case: ET.Element, tag: str, message: str, text: str = "") -> None:
    child = ET.SubElement(case, tag, message=message.translate(_NOT_IN_XML))
    child.text = text.translate(_NOT_IN_XML)
