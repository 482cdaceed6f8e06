"""`proctor admin`, whose areas are those of two programs."""

from __future__ import annotations

import re
from pathlib import Path

import click
import pytest

from reference_client.command.programs import PLATFORM_AREAS, program_of
from reference_platform.command_line.challenge_command import (
    build_command,
    challenge_areas,
    main,
)
from reference_server.http.tokens import admin_command as server_admin
from tests.support.paths import ROOT

MANUALS = "\n".join(path.read_text() for path in (ROOT / "docs/host").glob("*.md"))
COMMANDS = sorted(
    set(re.findall(r"proctor admin ([a-z]+)(?: ([a-z]+)\b(?!:))?", MANUALS))
)


def test_the_help_has_every_area_under_the_heading_of_its_program(
    capsys: pytest.CaptureFixture[str],
) -> None:
    with pytest.raises(SystemExit, match="0"):
        main(["--help"])
    said = capsys.readouterr().out
    _, of_challenge, of_server = re.split("Of a challenge:|Of a server:", said)
    areas = {
        of_challenge: [area.name for area in challenge_areas()],
        of_server: [*server_admin.build_command().commands],
    }
    for text, names in areas.items():
        assert re.findall(r"^  ([a-z]+)  ", text, re.MULTILINE) == names


def test_the_client_knows_the_areas_of_the_platform() -> None:
    """Or without the platform it could not say what to install."""
    assert set(PLATFORM_AREAS) == {area.name for area in challenge_areas()}
    for words in (["admin"], ["admin", "--help"], ["admin", "token", "list"]):
        assert program_of(words) == ("admin account", words[1:])


@pytest.mark.parametrize("command", COMMANDS, ids=" ".join)
def test_a_command_of_the_manuals_is_there(command: tuple[str, str]) -> None:
    area, name = command
    group = build_command().commands[area]
    if name and isinstance(group, click.Group):
        assert name in group.commands


def test_an_area_of_the_server_is_carried_out(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = ["--file", str(tmp_path / "tokens")]
    assert main(["token", "add", "ada", *file]) == 0
    assert main(["token", "list", *file]) == 0
    assert "ada" in capsys.readouterr().out
    assert main(["acount", "list"]) == 2
    assert "did you mean account?" in capsys.readouterr().err
