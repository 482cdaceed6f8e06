"""The short report in Markdown: what it says, and that no server can format it."""

from __future__ import annotations

import html
from pathlib import Path

import pytest

from conformance.cli.main import main
from conformance.reports.summary import append_summary, summary
from conformance.run_settings import Settings
from conformance.specification.document import spec_name
from conformance.specification.ledger import load_ledger
from conformance.verdicts.result import Result
from conformance.verdicts.verdict import Outcome, Verdict
from tests.support.kit.concluded_results import concluded

MARKUP = "a|b\n| x | <img src=//h> [t](http://h) `c` *d* __e__ @team #1 www.h.org"


def result(*verdicts: Verdict, known: str = "") -> Result:
    service = {"name": "a server", "version": "1", "profiles": []}
    settings = Settings(profiles=["core"], seed=7, service=service)
    return concluded(settings, *verdicts, known=[known])


def failed(id_: str, observed: str) -> Verdict:
    return Verdict(id_, Outcome.FAILED, expected="status 409", observed=observed)


def test_it_says_verdict_server_and_specification() -> None:
    lines = html.unescape(summary(result(failed("PRED-004", "status 200")))).split("\n")
    assert lines[0] == "## Proctor: NOT conformant (selected rules)"
    assert lines[2] == f"a server 1 · specification {spec_name()} · seed 7"
    assert " 1 violated," in lines[4]
    assert "| PRED-004 (MUST) | status 409 | status 200 |" in lines


def test_texts_of_a_server_are_no_markup() -> None:
    text = summary(result(failed("PRED-004", MARKUP)))
    (row,) = [line for line in text.split("\n") if line.startswith("| PRED-004")]
    assert row.count("|") == 4
    observed = row.split("|")[3]
    assert not set("<>[]`*_@\\./") & set(observed)
    assert " #1" not in observed
    assert html.unescape(observed).strip() == MARKUP.replace("\n", " ")


def test_it_is_short_however_much_is_wrong() -> None:
    """Each core rule violated in its own words. Expect 20 rows and the rest counted."""
    core = [row.id for row in load_ledger().values() if row.profile == "core"]
    text = summary(result(*(failed(id_, f"{id_} {'x' * 5000}") for id_ in core)))
    rows = [line for line in text.split("\n") if line.startswith("| ")]
    assert len(rows) == 22
    assert "more causes, in the report" in rows[-1]
    assert len(text) < 12_000


def test_a_known_failure_and_a_kit_error_are_named() -> None:
    broken = Verdict("SVC-001", Outcome.KIT_ERROR, "ValueError")
    text = summary(result(failed("PRED-004", "x"), broken, known="PRED-004"))
    assert "| PRED-004 (MUST, known failure) |" in text
    assert "| SVC-001 (MUST, kit error) |  | ValueError |" in text


def test_what_was_not_verified_has_its_reason() -> None:
    open_row = Verdict("PRED-004", Outcome.NOT_VERIFIED, "a token is missing")
    assert "- not verified, a token is missing: PRED-004" in summary(result(open_row))


def test_it_is_appended(tmp_path: Path) -> None:
    """A file of the job that has a text already. Expect both."""
    made = result()
    append_summary(made)  # no file is named
    made.settings.summary = str(tmp_path / "summary.md")
    (tmp_path / "summary.md").write_text("before\n")
    append_summary(made)
    assert (tmp_path / "summary.md").read_text() == "before\n" + summary(made)


@pytest.mark.parametrize("given", [["--url", "ftp://h"], ["--no-such-option"]])
def test_a_wrong_command_line_has_a_summary(
    given: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Expect exit code 2 and the reason on the page of the job."""
    file = tmp_path / "summary.md"
    reports = ["--report", str(tmp_path / "report"), f"--summary={file}"]
    assert main([*given, *reports]) == 2
    assert file.read_text().startswith("## Proctor: not decided")
    capsys.readouterr()


def test_the_kit_names_its_version(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit, match="0"):
        main(["--version"])
    out = capsys.readouterr().out
    assert out.startswith("proctor-conformance ")
    assert out.endswith(f"specification {spec_name()}\n")


def test_a_summary_that_cannot_be_written_is_refused_at_once(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """A folder that is not there. Expect exit code 2 before any server is started."""
    path, started = tmp_path / "missing" / "summary.md", tmp_path / "started"
    start = ["--start-cmd", f"touch {started}", "--report", str(tmp_path / "report")]
    assert main([*start, "--summary", str(path)]) == 2
    output = " ".join("".join(capsys.readouterr()).split())
    assert "No such file or directory (see --help)" in output
    assert "could not be written" not in output
    assert not started.exists()
