"""Verdicts, exit codes and reports: honest, complete, readable, and the same ids."""

import json
import re
import subprocess
from dataclasses import replace
from pathlib import Path
from xml.etree import ElementTree as ET

import pytest

from conformance.cli.arguments import read_known_failures
from conformance.cli.console import Terminal
from conformance.cli.kit_command import BadArguments
from conformance.exchanges.answer import ParsedAnswer
from conformance.exchanges.curl import script
from conformance.exchanges.exchange import Exchange
from conformance.policy.__main__ import build_command as build_policy_command
from conformance.reports.badge import badge
from conformance.reports.failure_card import card
from conformance.reports.files import junit, write_reports
from conformance.reports.html import page
from conformance.reports.summary import append_summary
from conformance.run_settings import Settings
from conformance.simulator.__main__ import build_command as build_simulator_command
from conformance.specification import ledger
from conformance.specification.document import load_spec
from conformance.verdicts.result import Result, as_plain, conclude
from conformance.verdicts.universal_rules import Breach, Tally
from conformance.verdicts.verdict import Outcome, Verdict
from tests.support.kit.concluded_results import concluded
from tests.support.kit.run_kit import REPORT_SCHEMA
from tests.support.pages.browser import Browser

PROFILES = list(ledger.PROFILES)


def exchange(number: int, method: str, path: str, **fields: object) -> Exchange:
    sent = Exchange(
        number, f"T/{number}", method, f"http://host{path}", "TOKEN", {}, b"", 0
    )
    for name, value in fields.items():
        setattr(sent, name, value)
    return sent


def result(
    *verdicts: Verdict, known: frozenset[str] = frozenset(), only: str = "ATT"
) -> Result:
    settings = Settings(url="http://host", only=[only], profiles=PROFILES)
    settings.service = {"profiles": [*ledger.SERVICE, "msgpack"]}
    return concluded(settings, *verdicts, known=known)


FAILED = Verdict(
    "ATT-003",
    Outcome.FAILED,
    expected="status 409",
    observed="status 200 <&\x00>",
    check="test_att_003",
    story="A story.",
    exchanges=[exchange(1, "GET", "/v1", status=200)],
)


def failed() -> Verdict:
    return Verdict.from_plain(FAILED.as_plain())


@pytest.mark.parametrize(
    ("verdict", "code", "says"),
    [
        (Verdict("ATT-003", Outcome.PASSED), 0, "conformant (selected rules)"),
        (FAILED, 1, "NOT conformant (selected rules)"),
        (Verdict("ATT-003", Outcome.INCONCLUSIVE), 2, "not decided"),
        (Verdict("ATT-003", Outcome.KIT_ERROR, check="x"), 2, "not decided"),
        (Verdict("ATT-003", Outcome.NOT_APPLICABLE), 0, "conformant (selected rules)"),
        (Verdict("ATT-003", Outcome.NOT_VERIFIED), 2, "not decided"),
        (
            Verdict("ATT-003", Outcome.NOT_VERIFIED, "", True),
            0,
            "conformant (selected rules)",
        ),
    ],
)
def test_exit_code(verdict: Verdict, code: int, says: str) -> None:
    judged = result(Verdict.from_plain(verdict.as_plain()))
    assert judged.exit_code == code
    assert judged.conclusion().startswith(says)


def test_known_failure_is_reported_and_excused() -> None:
    judged = result(failed(), known=frozenset({"ATT-003"}))
    assert judged.rows["ATT-003"].is_known_failure
    assert judged.exit_code == 0
    assert "1 violated" in judged.headline()
    assert "<failure" not in junit(judged)


@pytest.mark.parametrize("only", ["", "ATT"])
def test_no_report_says_that_a_server_with_a_known_failure_conforms(
    only: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Expect it in no word of terminal, page, JSON, JUnit, summary, and in no badge."""
    judged = result(failed(), known=frozenset({"ATT-003"}), only=only)
    judged.settings.report = str(tmp_path)
    judged.settings.summary = str(tmp_path / "summary.md")
    Terminal().report(judged)
    write_reports(judged)
    append_summary(judged)
    texts = {path.name: path.read_text() for path in tmp_path.iterdir()}
    texts["terminal"] = capsys.readouterr().out
    for name, text in texts.items():
        assert "onformant" not in text.replace("NOT conformant", ""), name
    assert "a known failure (ATT-003)" in texts["terminal"]
    badges = [name for name in texts if name.endswith(".svg")]
    assert len(badges) > 1
    for name in badges:
        assert "#1f7a38" not in texts[name], name


@pytest.mark.parametrize(
    ("verdict", "says"),
    [
        (Verdict("ATT-003", Outcome.PASSED), "ATT-003 passes now: take the line out"),
        (FAILED, "NOT conformant (selected rules): ATT-001 passes now: take"),
    ],
)
def test_known_failure_that_does_not_fail_is_stale(verdict: Verdict, says: str) -> None:
    stale = "ATT-003" if verdict.outcome == Outcome.PASSED else "ATT-001"
    judged = result(Verdict.from_plain(verdict.as_plain()), known=frozenset({stale}))
    assert judged.stale == [stale]
    assert judged.exit_code == 1
    assert judged.conclusion().startswith(says)


def test_known_failures_need_an_id_and_a_reason(tmp_path: Path) -> None:
    file = tmp_path / "known"
    file.write_text("# why we have them\n\nATT-003 # our ticket 7\n")
    assert read_known_failures(str(file)) == {"ATT-003"}
    for wrong in ("ATT-003", "ATT-999 # no such rule"):
        file.write_text(wrong)
        with pytest.raises(BadArguments):
            read_known_failures(str(file))


def test_reports_agree(tmp_path: Path) -> None:
    judged = result(failed())
    judged.settings.report = str(tmp_path)
    write_reports(judged)
    plain = json.loads((tmp_path / "report.json").read_text())
    REPORT_SCHEMA.validate(plain)
    ids = [row["requirement_id"] for row in plain["rows"]]
    cases = ET.fromstring((tmp_path / "junit.xml").read_text()).iter("testcase")  # noqa: S314
    assert [case.get("name") for case in cases] == ids
    html = (tmp_path / "report.html").read_text()
    assert all(f'id="{requirement_id}"' in html for requirement_id in ids)
    assert "http://" not in html.replace("http://host", "")
    assert plain["conclusion"] in html
    sha256 = plain["spec"]["sha256"]
    assert sha256 in html
    assert sha256 in (tmp_path / "junit.xml").read_text()


def test_a_folder_has_one_report(tmp_path: Path) -> None:
    """A report of a server, then one of a policy server, and a file of neither."""
    of_server, of_policy = result(failed()), result(failed())
    of_policy.settings.profiles = [ledger.POLICY]
    for judged in (of_server, of_policy):
        judged.settings.report = str(tmp_path)
    (tmp_path / "badge-mine.svg").touch()
    reports = {"report.json", "report.html", "junit.xml", "badge.svg", "badge-mine.svg"}
    levels = {"badge-core.svg", "badge-service.svg"}
    for judged, names in ((of_server, reports | levels), (of_policy, reports)):
        write_reports(judged)
        assert {path.name for path in tmp_path.iterdir()} == names
    commands = [build_policy_command(), build_simulator_command()]
    defaults = [{p.name: p.default for p in one.params}["report"] for one in commands]
    assert defaults == ["report/policy", "report/simulator"]


def test_junit_has_a_real_failure() -> None:
    suites = ET.fromstring(junit(result(failed())))  # noqa: S314
    failures = suites.findall(".//failure")
    assert len(failures) == 1
    assert "curl" in (failures[0].text or "")
    (suite,) = suites
    assert (suite.get("failures"), suite.get("errors")) == ("1", "0")


def test_problem_is_an_error_in_every_report() -> None:
    judged = Result(Settings(profiles=PROFILES), problem="no response")
    conclude(judged, {}, Tally(load_spec()), set())
    assert judged.exit_code == 2
    assert 'message="no response"' in junit(judged)
    assert "no response" in page(judged)
    REPORT_SCHEMA.validate(as_plain(judged))


def test_failures_of_one_cause_share_a_card() -> None:
    same = failed()
    same.requirement_id = "ATT-004"
    other = failed()
    other.requirement_id, other.observed = "ATT-005", "status 500"
    judged = result(failed(), same, other)
    causes = judged.causes(Outcome.FAILED)
    ids = [[verdict.requirement_id for verdict in cause] for cause in causes]
    assert ids == [["ATT-003", "ATT-004"], ["ATT-005"]]
    html = page(judged)
    assert html.count('<article class="card') == 2
    assert html.count('<a href="#card-ATT-003">') == 2
    assert "ATT-004" in "\n".join(card(causes[0][0], judged, causes[0][1:]))


def test_failures_without_a_word_share_none() -> None:
    verdicts = [Verdict(f"ATT-00{n}", Outcome.FAILED) for n in (3, 4)]
    assert len(result(*verdicts).causes(Outcome.FAILED)) == 2


def test_each_profile_and_what_is_not_green_are_named(
    capsys: pytest.CaptureFixture[str],
) -> None:
    judged = result(failed(), Verdict("ATT-004", Outcome.INCONCLUSIVE, "slow"), only="")
    judged.settings.only = []
    rules = [rule for rule in judged.rows if ledger.load_ledger()[rule].level == "MUST"]
    core = [rule for rule in rules if ledger.load_ledger()[rule].profile == "core"]
    passed = sum(judged.rows[rule].outcome == Outcome.PASSED for rule in core)
    profiles = judged.profiles()
    assert profiles["core"] == f"{passed}/{len(core)}"
    packed = sum(ledger.load_ledger()[rule].profile == "msgpack" for rule in rules)
    assert profiles["msgpack"] == f"{packed}/{packed}"
    assert profiles["events"] == "not announced"
    whys = list(judged.open_rules().items())
    assert whys[:2] == [("violated", ["ATT-003"]), ("inconclusive, slow", ["ATT-004"])]
    Terminal().report(judged)
    printed = capsys.readouterr().out
    assert not re.search(r"^EVT-", printed, re.MULTILINE)  # counted, not listed
    mark = "inconclusive, slow: ATT-004\n"
    end = mark + printed.partition(mark)[2]
    assert "ATT-003: expected " in end
    assert end.splitlines()[-1].startswith("NOT conformant")
    assert f"msgpack {packed}/{packed}" in end
    assert "profiles not announced" in " ".join(end.replace("\xa0", " ").split())
    lines = end.partition(" MUST: ")[0].splitlines()
    assert all(len(line) <= 80 for line in lines)


def test_card_says_everything() -> None:
    text = "\n".join(card(failed(), result(failed())))
    for part in ("ATT-003 FAILED (MUST", "worker_busy", "A story.", "status 409"):
        assert part in text
    assert 'curl -sS "$URL/v1" -H "Authorization: Bearer $TOKEN"' in text
    assert "seed" in text
    fields = text.partition("    : ")[0]
    assert all(len(line) <= 80 for line in fields.splitlines())


def test_script_catches_ids_and_keeps_pauses() -> None:
    lines = script(
        [
            exchange(
                1,
                "POST",
                "/v1/runs",
                request_body=b'{"note": "it\'s"}',
                request_size=16,
                request_headers={"Content-Type": "application/json"},
                status=201,
                answer_body=b'{"run_id": "run-abc"}',
                started_at=1.0,
            ),
            exchange(
                2,
                "PUT",
                "/v1/runs/run-abc/workers/w",
                request_body=b'{"run": "run-abc"}',
                request_size=18,
                status=409,
                answer_body=b'{"code": "worker_busy"}',
                started_at=3.0,
            ),
            exchange(3, "GET", "/v1", error="ReadTimeout: slow", started_at=3.0),
        ],
        "http://host",
    )
    assert lines[0] == (
        ': "${URL:?base URL of the server}" '
        '"${TOKEN:?a token with the scopes read and run}"'
    )
    start = next(i for i, line in enumerate(lines) if line.startswith("RUN_1="))
    assert [line.split("(")[0] for line in lines[1:start]] == ["curl", "keep"]
    assert lines[start:] == [
        (
            'RUN_1=$(curl -sS -X POST "$URL/v1/runs" -H "Authorization: Bearer $TOKEN" '
            "-H 'Content-Type: application/json' "
            """--data-binary '{"note": "it'\\''s"}' | keep run_id)"""
        ),
        "# → 201 after 0 ms",
        "sleep 2.0",
        (
            'curl -sS -X PUT "$URL/v1/runs/${RUN_1}/workers/w" '
            '-H "Authorization: Bearer $TOKEN" '
            """--data-binary '{"run": "'"$RUN_1"'"}'"""
        ),
        "# → 409 worker_busy after 0 ms",
        'curl -sS "$URL/v1" -H "Authorization: Bearer $TOKEN"',
        "# → no response: ReadTimeout: slow",
    ]


def test_answer_that_breaks_a_rule_for_all_fails_its_row() -> None:
    tally = Tally(load_spec())
    sent = exchange(1, "GET", "/v1", status=500)
    tally.observe(None, ParsedAnswer(500, {}, "", b"", None, False), sent)
    settings = Settings(url="http://host", only=["ERR-012"], profiles=PROFILES)
    judged = concluded(settings, tally=tally)
    assert judged.rows["ERR-012"].outcome == Outcome.FAILED
    assert judged.rows["ERR-012"].exchanges == [replace(sent, is_judged=True)]


def test_rule_for_all_answers_needs_an_answer() -> None:
    settings = Settings(url="http://host", only=["ERR-012"], profiles=PROFILES)
    judged = concluded(settings, tally=Tally(load_spec()))
    assert judged.rows["ERR-012"].outcome == Outcome.NOT_VERIFIED


def test_page_needs_no_network_and_no_script() -> None:
    html = page(result(failed()))
    for outside in (' src="', "<link", "@import", " url(", "fetch("):
        assert outside not in html
    assert '<div class="filters" hidden>' in html
    for part in ("worker_busy", "status 409", "status 200 &lt;&amp;", "A story."):
        assert part in html.partition("All rules")[0]


def test_the_judged_request_and_the_difference_are_marked() -> None:
    verdict = failed()
    verdict.expected = "status 409 with code `worker_busy`, by ATT-004"
    verdict.observed = "status 404 with code `worker_busy`, by ATT-004"
    verdict.left_out = 7
    verdict.exchanges += [exchange(2, "GET", "/v1/runs", status=200, is_judged=True)]
    html, text = page(result(verdict)), "\n".join(card(verdict, result(verdict)))
    assert "<mark>409</mark>" in html
    assert "<mark>404</mark>" in html
    assert html.count('<li class="judged">') == 1
    assert "judged: the answer to request 2" in html
    assert "7 in the middle are left out" in html
    assert "7 requests in the middle are left out" in text
    assert text.count("← judged") == 1
    rule = ledger.load_ledger()["ATT-004"].text
    assert "ATT-004 decides" in html
    assert f"ATT-004: {rule[:40]}" in text


def test_page_shows_when_each_request_was_sent() -> None:
    slow = exchange(2, "GET", "/v1/runs", status=200, started_at=1.0, elapsed_s=1.0)
    verdict = failed()
    verdict.exchanges += [slow]
    html = page(result(verdict))
    assert '<i style="left:50.0%;width:50.0%">' in html
    assert "2 requests in 2.00 s" in html


@pytest.mark.slow("a browser is started")
def test_everyone_can_read_the_page(tmp_path: Path) -> None:
    """Contrast, labels, axe-core, narrow and wide; a conclusion of each kind."""
    pages = {
        "failed": page(result(failed())),
        "passed": page(result(Verdict("ATT-003", Outcome.PASSED))),
        "open": page(result(Verdict("ATT-003", Outcome.INCONCLUSIVE, "Too busy."))),
    }
    with Browser() as browser:
        for name, text in pages.items():
            path = tmp_path / f"{name}.html"
            path.write_text(text)
            for width, dark in ((400, True), (400, False), (1280, False)):
                browser.resize(width, dark=dark)
                browser.open(f"file://{path}")
                assert browser.find_faults() == [], (name, width)
                assert browser.find_violations() == [], (name, width)
        assert browser.errors == []


@pytest.mark.parametrize(
    ("verdict", "only", "says", "colour"),
    [
        (Verdict("ATT-003", Outcome.PASSED), "", "verified", "#1f7a38"),
        (
            Verdict("ATT-003", Outcome.PASSED),
            "ATT-003",
            "1/1 verified (selection)",
            "#5b6472",
        ),
        (FAILED, "ATT-003", "0/1 verified, 1 violated", "#c62828"),
        (Verdict("ATT-003", Outcome.INCONCLUSIVE), "ATT-003", "not decided", "#96600a"),
    ],
)
def test_badge(verdict: Verdict, only: str, says: str, colour: str) -> None:
    judged = result(Verdict.from_plain(verdict.as_plain()), only=only)
    judged.settings.only = [only] if only else []
    drawn = ET.fromstring(badge(judged))  # noqa: S314 - ours
    assert says in (drawn.get("aria-label") or "")
    assert drawn.findall(".//{*}rect")[-1].get("fill") == colour
    texts = [text.text for text in drawn.findall(".//{*}text")]
    assert texts[0] == "proctor 1.0"


def test_a_row_that_does_not_apply_in_an_announced_profile_has_its_reason() -> None:
    """The rows of other profiles are only counted."""
    why = "server offers no other benchmark"
    judged = result(Verdict("RUN-007", Outcome.NOT_APPLICABLE, why), only="")
    judged.settings.service["profiles"] = ["core"]
    assert "not applicable, server offers no other benchmark" in judged.open_rules()
    names = {row.requirement_id for row in judged.applicable()}
    assert "RUN-007" in names
    assert why in page(judged)


@pytest.mark.parametrize(
    ("profiles", "rule"), [(["core"], "MODEL-003"), (ledger.SERVICE, "MODEL-001")]
)
def test_the_rule_on_all_answers_is_one_that_the_server_has(
    profiles: list[str], rule: str
) -> None:
    settings = Settings(profiles=PROFILES, service={"profiles": profiles})
    reason = "attach_worker: status 500; see MODEL-001"
    refused = Verdict("RUN-014", Outcome.NOT_VERIFIED, reason, breaks="MODEL-001")
    judged = concluded(settings, refused)
    assert judged.rows["RUN-014"].reason.endswith(f"see {rule}")
    assert judged.rows[rule].outcome == Outcome.FAILED


def test_notes_that_differ_by_a_value_are_one() -> None:
    tally = Tally(load_spec())
    for second in (1, 2, 3):
        observed = f"$.server_time: '2026-11-30T19:25:4{second}' is not a 'date-time'"
        seen = exchange(second, "GET", "/v1")
        tally.breaches.append(Breach("SVC-003", "a body of the schema", observed, seen))
    settings = Settings(stage=1, profiles=PROFILES, service={"profiles": ["core"]})
    [note] = concluded(settings, tally=tally).notes
    assert note.startswith("SVC-003: $.server_time: '2026-11-30T19:25:41' is not a")
    assert note.endswith("(and in 2 more)")


def test_a_script_makes_the_long_body_that_was_sent(tmp_path: Path) -> None:
    """A body that was sent in parts, of which the log has the beginning."""
    text = b'{"name": "it\'s"}'
    sent = exchange(1, "POST", "/v1/runs", request_body=text + b" " * 100)
    sent.request_size = 5000
    [line] = [line for line in script([sent], "http://host") if ">body" in line]
    subprocess.run(["/bin/bash", "-c", line], cwd=tmp_path, check=True)
    assert (tmp_path / "body").read_bytes() == text + b" " * (5000 - len(text))
    sent.request_body = text  # its end is unknown
    assert "# create the file `body` first (5000 bytes)" in script([sent], "")
