"""Options of `proctor-host` that are of the first start alone."""

from __future__ import annotations

import pytest

from reference_platform.command_line.host_command import build_command, ignored_options
from reference_platform.parts import Parts
from reference_record.command_line.click_commands import parse_options
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
