"""Each act of an administrator is in the audit log, wherever it is done.

The acts are those of the specification, of the pages and of `proctor admin`: one that
is new has no row here, or no line in the log, and fails.
"""

from __future__ import annotations

import asyncio
from collections.abc import Iterator
from pathlib import Path

import click
import pytest

from reference_platform.command_line import challenge_command, operation_commands
from reference_platform.parts import Parts
from reference_platform.storage.platform_database import AuditLine, audit_lines
from tests.support.platform.approved_accounts import approved, quick_parts
from tests.support.platform.challenge_world import (
    ADMINISTRATION,
    HST_014,
    Person,
    World,
    operations,
    pages,
)
from tests.support.platform.hosted_server import track_file

READS = frozenset((
    "account list", "audit", "image list", "image show", "key list", "platform status",
    "platform usage", "preset list", "submission list", "submission log", "track list",
))  # fmt: skip
REASON = ("--reason", "for a test")
# Command of `proctor admin` → what follows it; in the order in which they are done.
ACTS = {
    "account add": (
        *("bea", "--full-name", "B", "--organisation", "L"),
        *("--email", "bea@example.org"),
    ),
    "account suspend": ("bea", *REASON),
    "account reinstate": ("bea",),
    "account reject": ("pen", *REASON),
    "account delete": ("out",),
    "account approve": ("pen",),
    "account password": ("bea",),
    "account key": ("bea",),
    "track put": ("FOLDER/track.toml",),
    "track delete": ("new",),
    "image approve": ("DIGEST",),
    "image reject": ("DIGEST", *REASON),
    "submission stop": ("SUBMISSION",),
    "preset add": ("python-here", "--packages", ""),
    "key revoke": ("ada", "KEY"),
    "platform clean": (),
    "platform backup": ("FOLDER/backup",),
    "platform restore": ("FOLDER/backup",),
}


def newest(parts: Parts) -> AuditLine:
    return audit_lines(parts.database, 1)[0]


@pytest.fixture
async def world(parts: Parts, tmp_path: Path) -> World:
    return World.of(parts, tmp_path)


async def test_acts_by_operations_and_pages_are_in_the_log(
    world: World, tmp_path: Path
) -> None:
    """Each in a world of its own. Expect its line, under who has done it."""
    acts = [c for c in operations() if c.name in HST_014.operations]
    acts += [c for c in pages(world.app) if ADMINISTRATION.match(c.path)]
    for number, call in enumerate(c for c in acts if c.method != "GET"):
        (tmp_path / str(number)).mkdir()
        database = tmp_path / str(number) / "platform.sqlite"
        world = World.of(quick_parts(database), tmp_path / str(number))
        owner = await world.person("ada")
        boss = await approved(world.parts, "boss", "administrator")
        before = newest(world.parts).number
        async with world.client() as client:
            if call.path.startswith("/hosting"):
                csrf = world.sign_in(client, boss)
                await world.open_page(client, call, owner, csrf)
            else:
                await world.send(client, call, owner, world.key(boss, "host"))
        line = newest(world.parts)
        assert (line.number, line.actor) == (before + 1, boss), call.name
        assert line.subject, call.name
        world.parts.database.close()


def commands(group: click.Command, *words: str) -> Iterator[str]:
    if isinstance(group, click.Group):
        for name, command in group.commands.items():
            yield from commands(command, *words, name)
    else:
        yield " ".join(words)


def filled(word: str, owner: Person, folder: Path) -> str:
    values = {
        "FOLDER": str(folder), "DIGEST": owner.ids["digest"],
        "SUBMISSION": owner.submissions["created"], "KEY": owner.ids["key_id"],
    }  # fmt: skip
    for name, value in values.items():
        word = word.replace(name, value)
    return word


async def test_acts_by_commands_are_in_the_log(
    world: World, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A preset, which is a copy of a whole Python, is not made here."""
    monkeypatch.setattr(operation_commands, "make_python_preset", lambda *_: tmp_path)
    parts, owner = world.parts, await world.person("ada")
    for name in ("pen", "out"):
        await approved(parts, name)
        statement = "UPDATE accounts SET state = 'pending' WHERE account = ?"
        parts.database.execute(statement, name)
    (tmp_path / "track.toml").write_text(track_file("new"))
    areas = click.Group(commands=challenge_command.challenge_areas())
    assert {*commands(areas)} == READS | set(ACTS)
    for act, rest in ACTS.items():
        before, database = newest(parts).number, parts.database.path
        words = [filled(word, owner, tmp_path) for word in rest]
        folder = tmp_path
        if act == "platform restore":
            folder, database = tmp_path / "new", tmp_path / "new.sqlite"
        if act.split()[0] in ("platform", "preset"):
            words += ["--submissions", str(folder)]
        words += ["--database", str(database)]
        arguments = [*act.split(), *words]
        assert await asyncio.to_thread(challenge_command.main, arguments) == 0, act
        stored = quick_parts(database)
        line = newest(stored)
        stored.database.close()
        assert line.number > before, act
        assert line.actor.endswith("on this machine"), act
