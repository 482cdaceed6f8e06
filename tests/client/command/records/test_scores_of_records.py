"""`proctor results` and `proctor compare` of records: no server is there."""

import json
from pathlib import Path

import pytest

from reference_client.command.main import main
from tests.support.paths import ROOT
from tests.support.record.played_records import save_calibration_record

VECTORS = ROOT / "spec" / "vectors" / "record"
GOOD = str(VECTORS / "good_replayed.proctor")
BROKEN = str(VECTORS / "score_raised.proctor")


@pytest.fixture(autouse=True)
def _without_a_server(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PROCTOR_URL", "http://127.0.0.1:1")


@pytest.fixture(scope="module")
def other(tmp_path_factory: pytest.TempPathFactory) -> str:
    """A record of another manifest."""
    folder = tmp_path_factory.mktemp("record")
    return str(save_calibration_record(folder / "run-1.proctor", folder))


def test_the_tables_are_those_of_a_run(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["results", GOOD, "--episodes"]) == 0
    shown = capsys.readouterr()
    facts = dict(
        line.split(maxsplit=1) for line in shown.out.partition("\n\n")[0].splitlines()
    )
    assert (facts["run"], facts["score"]) == ("r-1", "0.5625")
    assert "\ne-3 " in shown.out
    assert "lease" not in shown.out, "a record does not say why one is abandoned"
    assert shown.err.startswith(f"{GOOD}: Level: reported.")


def test_a_result_is_saved_with_what_the_record_says_alone(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["results", GOOD, "--json", "--save", str(tmp_path)]) == 0
    printed = json.loads(capsys.readouterr().out)
    saved = json.loads((tmp_path / "result.json").read_text())
    assert saved["score"]["score"] == printed["score"] == 0.5625
    assert "think_s" not in saved["episodes"][0]["result"]
    assert "endpoint" not in saved["run"]
    rows = (tmp_path / "episodes.csv").read_text().splitlines()
    assert [row.split(",")[:2] for row in rows[1:]] == [
        ["r-1", f"e-{index}"] for index in range(4)
    ]


@pytest.mark.parametrize("form", ["text", "markdown", "latex"])
def test_records_are_compared(form: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["compare", GOOD, GOOD, GOOD, "--format", form]) == 0
    said = capsys.readouterr().out
    assert ("yes: no difference exceeds 0.05" in said) == (form == "text")
    assert ("[" in said) == (form != "text")


@pytest.mark.parametrize(
    ("words", "code", "said"),
    [
        ("results BROKEN", 1, "do not trust it"),
        ("compare GOOD BROKEN", 1, "do not trust it"),
        ("compare GOOD OTHER", 2, "it has another manifest"),
        ("results missing.proctor", 2, "there is no record of this name either"),
        ("compare GOOD no:run", 2, "'no:run' is no id of a run"),
    ],
)
def test_a_record_that_cannot_be_shown_is_named(
    words: str, code: int, said: str, other: str, capsys: pytest.CaptureFixture[str]
) -> None:
    names = {"GOOD": GOOD, "BROKEN": BROKEN, "OTHER": other}
    given = [names.get(word, word) for word in words.split()]
    assert main(given) == code
    shown = capsys.readouterr()
    assert said in shown.err
    assert shown.out == ""
