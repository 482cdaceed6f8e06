"""Options of `proctor-host` that are of the first start alone."""

from __future__ import annotations

import pytest

from reference_platform.command_line.challenge_command import main
from reference_platform.command_line.host_command import build_command, ignored_options
from reference_platform.parts import Parts
from reference_record.command_line.click_commands import WrongUsage, parse_options
from tests.support.platform.approved_accounts import approved

ADDRESS = "you@example.org"
IGNORED = "is ignored, as there is boss with boss@example.org"
CHANGE = "change the address on the page Account"
ADD = "`proctor admin account add` makes another account"


@pytest.mark.parametrize(
    ("words", "said"),
    [
        ((), []),
        (("--administrator", "boss"), []),
        (("--administrator-email", "BOSS@example.org"), []),
        (
            ("--administrator-email", ADDRESS),
            [f"--administrator-email {ADDRESS} {IGNORED}; {CHANGE}"],
        ),
        (
            ("--administrator", "ada"),
            [f"--administrator ada {IGNORED}; {ADD}"],
        ),
    ],
    ids=str,
)
async def test_an_option_that_came_too_late_is_said_to_be_ignored(
    parts: Parts, words: tuple[str, ...], said: list[str]
) -> None:
    boss = await approved(parts, "boss", "administrator")
    there = [parts.accounts.get(boss)]
    assert ignored_options(parse_options(build_command(), words), there) == said


@pytest.mark.parametrize("value", ["nan", "inf", "-1", "0", "1e99", "many"])
@pytest.mark.parametrize(
    "name", ["sandboxes", "policy-cpus", "policy-memory-mib", "policy-start-s"]
)
def test_a_number_has_an_end(name: str, value: str) -> None:
    """A policy without a limit of time, or of memory, keeps its place for ever."""
    with pytest.raises(WrongUsage, match=f"--{name}: {value}: expected an? .*>"):
        parse_options(build_command(), (f"--{name}", value))


@pytest.mark.parametrize("value", ["nan", "inf", "-1", "36501", "many"])
@pytest.mark.parametrize(
    "words",
    [
        ("platform", "usage"),
        ("platform", "clean"),
        ("account", "key", "ada"),
        ("records", "prune"),
    ],
    ids=" ".join,
)
def test_days_are_a_time_that_a_calendar_has(
    words: tuple[str, ...], value: str, capsys: pytest.CaptureFixture[str]
) -> None:
    option = "--older-than" if words[0] == "records" else "--days"
    assert main([*words, f"{option}={value}"]) == 2
    said = f"{option}: {value}: expected a number of days from 0 to 36500"
    assert said in capsys.readouterr().err
