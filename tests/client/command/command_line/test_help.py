"""The help of every command: it fits the terminal, and every code page shows it."""

import io
import sys

import pytest

from reference_client.command.command_line.aliases import PASS_THROUGH_COMMANDS
from reference_client.command.command_line.arguments import COMMANDS
from reference_client.command.main import main
from reference_record.command_line.spelling import unknown

HELPS = [["--help"]]
HELPS += [[name, "-h"] for name in COMMANDS if name not in PASS_THROUGH_COMMANDS]


@pytest.mark.parametrize("columns", [40, 80])
@pytest.mark.parametrize("arguments", HELPS, ids=" ".join)
def test_it_fits_the_terminal_and_has_no_colours(
    arguments: list[str],
    columns: int,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.setenv("COLUMNS", str(columns))
    monkeypatch.setenv("FORCE_COLOR", "1")
    with pytest.raises(SystemExit, match="0"):
        main(arguments)
    text = capsys.readouterr().out
    assert max(map(len, text.splitlines())) <= columns
    assert "\x1b" not in text


@pytest.mark.parametrize("encoding", ["ascii", "cp437", "cp932", "cp1252"])
def test_any_code_page_shows_it(encoding: str, monkeypatch: pytest.MonkeyPatch) -> None:
    written = io.BytesIO()
    monkeypatch.setattr(sys, "stdout", io.TextIOWrapper(written, encoding=encoding))
    with pytest.raises(SystemExit, match="0"):
        main(["report", "--help"])
    sys.stdout.flush()
    assert b"RUN|FILE" in written.getvalue()


@pytest.mark.parametrize(
    ("word", "text"),
    [
        ("max_step", "unknown key max_step; did you mean max_steps? There is a, max_s"),
        ("zzz", "unknown key zzz; there is a, max_steps"),
        ("", "unknown key ; there is a, max_steps"),
    ],
)
def test_an_unknown_name_is_answered_with_those_there_are(word: str, text: str) -> None:
    assert unknown("key", word, ["a", "max_steps"]).startswith(text)
