"""Every operation and every page, by all who may not use it, or not on this object.

Others read nothing that a person owns in any answer, and change nothing of it by any
request. The same requests succeed when the person sends them.
"""

from __future__ import annotations

import re
from pathlib import Path

import msgspec
import pytest

from reference_platform.accounts.account_keys import SCOPES, new_secret
from reference_platform.accounts.account_rules import AccountState
from reference_platform.parts import Parts
from tests.support.pages.page_reader import without_server
from tests.support.platform.approved_accounts import (
    Clock,
    approved,
    key_of,
    quick_parts,
)
from tests.support.platform.challenge_world import (
    ADMINISTRATION,
    HST_014,
    Call,
    Person,
    World,
    operations,
    pages,
)

OPERATIONS = operations()
# Texts of a person, and those that members of the organisation see, too.
PRIVATE, SHARED = "private-of-ada.", "shared-of-ada."
OPEN_PAGES = re.compile(
    r"/hosting(/|/register|/login|/forgotten|/reset|/logout|/openid.*)?"
)
OF_OTHERS = re.compile(r"{(key_id|organisation|submission_id|result_id)}")
# An account that is not approved may still do this with its own.
STILL_ALLOWED = (
    "/account/email", "/account/password", "/keys/{key_id}/revoke",
    "/submissions/{submission_id}/stop",
)  # fmt: skip


@pytest.fixture
async def world(parts: Parts, tmp_path: Path) -> World:
    return World.of(parts, tmp_path)


@pytest.fixture
async def owner(world: World) -> Person:
    return await world.person("ada")


class Mail(msgspec.Struct):
    body: str


def another_world(folder: Path) -> World:
    folder.mkdir()
    return World.of(quick_parts(folder / "platform.sqlite", clock=Clock()), folder)


def code_for(world: World, call: Call, account: str) -> str:
    """A code that the request of this account can use once."""
    parts = world.parts
    if "device" in call.name:
        secret, device = parts.devices.begin("a test")
        if call.name != "poll_device":
            return device.user_code
        parts.devices.decide(device.user_code, account, approve=True)
        return secret
    parts.organisations.invite("adalab", "ada", "new@example.org", "member")
    mail = parts.database.row(Mail, "SELECT body FROM mail ORDER BY number DESC")
    assert mail is not None
    return mail.body.split()[-1]


# --- controls: each request is right ---


@pytest.mark.parametrize("call", OPERATIONS, ids=lambda call: call.name)
async def test_the_owner_or_an_administrator_may(
    world: World, owner: Person, call: Call
) -> None:
    boss = await approved(world.parts, "boss", "administrator")
    is_for_host = call.name in HST_014.operations
    key = world.key(boss, "host") if is_for_host else world.key(owner.name)
    world.code = code_for(world, call, owner.name)
    async with world.client() as client:
        answer = await world.send(client, call, owner, key)
        assert answer.is_success, answer.text
        if call.method == "GET":  # OPT-008
            head = await world.send(client, call._replace(method="HEAD"), owner, key)
            assert head.status_code == answer.status_code


async def test_the_owner_or_an_administrator_sees_and_sends_each_page(
    world: World, owner: Person, tmp_path: Path
) -> None:
    """Each form in a world of its own, as it changes what the others are about."""
    for number, call in enumerate(pages(world.app)):
        if OPEN_PAGES.fullmatch(call.path):
            continue
        if call.method == "POST":
            world = another_world(tmp_path / str(number))
            owner = await world.person("ada")
        is_for_host = bool(ADMINISTRATION.match(call.path))
        name = owner.name
        if is_for_host:
            name = await approved(world.parts, f"boss{number}", "administrator")
        world.code = code_for(world, call, owner.name)
        async with world.client() as browser:
            answer = await world.open_page(
                browser, call, owner, world.sign_in(browser, name)
            )
        assert answer.status_code < 400, (call.name, answer.text)
        assert without_server(answer.text) == [], call.name


# --- operations ---


async def no_valid_key(world: World, owner: Person, clock: Clock, why: str) -> str:
    parts, account = world.parts, owner.name
    match why:
        case "none":
            return ""
        case "unknown":
            return new_secret()
        case "expired":
            key = key_of(parts, account, *SCOPES, lifetime_s=60)
            clock.now += 61
            return key
        case "revoked":
            made, key = parts.keys.make(account, "", SCOPES, 3600, clock())
            parts.keys.revoke(account, made.key_id, clock())
            return key
        case "of a former member":
            col = await approved(parts, "col")
            world.join(owner, col)
            key = world.key(col, organisation=owner.ids["organisation"])
            parts.organisations.remove(owner.ids["organisation"], account, col)
            return key
    col = await approved(parts, "col")
    key = world.key(col, *SCOPES)
    parts.database.execute("UPDATE accounts SET state = ? WHERE account = 'col'", why)
    return key


@pytest.mark.parametrize(
    "why",
    [
        *("none", "unknown", "expired", "revoked", "of a former member"),
        *("suspended", "rejected", "pending"),
    ],
)
async def test_a_key_that_is_not_valid_opens_nothing(
    world: World, owner: Person, clock: Clock, why: str
) -> None:
    key = await no_valid_key(world, owner, clock, why)
    before = world.owned_by(owner)
    async with world.client() as client:
        for call in OPERATIONS:
            if not call.is_open:
                answer = await world.send(client, call, owner, key)
                assert answer.status_code == 401, (call.name, answer.text)
    assert world.owned_by(owner) == before


async def test_each_operation_needs_one_scope(world: World) -> None:
    """Keys of an administrator with one scope each. Expect `host` as HST-014 says."""
    boss = await world.person("boss")
    world.parts.database.execute("UPDATE accounts SET role = 'administrator'")
    keys = {scope: world.key("boss", scope) for scope in SCOPES}
    async with world.client() as client:
        for call in OPERATIONS:
            if call.is_open:
                continue
            answers = {
                scope: (await world.send(client, call, boss, key)).text
                for scope, key in keys.items()
            }
            (needed,) = (s for s in SCOPES if "The key has no scope" not in answers[s])
            assert (needed == "host") == (call.name in HST_014.operations), call.name


@pytest.mark.parametrize("who", ["another account", "an administrator", "a member"])
async def test_others_read_and_change_nothing_by_operations(
    world: World, owner: Person, who: str
) -> None:
    """With keys of all scopes, and a member also with one of the organisation."""
    is_boss, is_member = who == "an administrator", who == "a member"
    eve = await approved(
        world.parts, "eve", "administrator" if is_boss else "participant"
    )
    keys = [world.key(eve, *SCOPES)]
    lab = owner.ids["organisation"]
    if is_member:
        world.join(owner, eve)
        keys.append(world.key(eve, *SCOPES, organisation=lab))
    before = world.owned_by(owner, with_organisation=not is_member)
    async with world.client() as client:
        for call in OPERATIONS:
            if is_boss and call.name in HST_014.operations:
                continue
            if is_member and call.name == "remove_member":
                continue  # it may leave, and so its own path is right
            for key in keys:
                answer = await world.send(client, call, owner, key)
                assert PRIVATE not in answer.text, call.name
                assert is_member or SHARED not in answer.text, call.name
                named = OF_OTHERS.findall(call.path)
                if is_member and named == ["organisation"]:
                    expected = {200} if call.name == "get_organisation" else {403}
                else:
                    expected = {404, 403 if call.name in HST_014.operations else 404}
                if named:
                    assert answer.status_code in expected, (call.name, answer.text)
    assert world.owned_by(owner, with_organisation=not is_member) == before


# --- pages ---


@pytest.mark.parametrize(
    "who", ["who has not signed in", "another account", "an administrator", "a member"]
)
async def test_others_read_and_change_nothing_on_pages(
    world: World, owner: Person, who: str
) -> None:
    is_boss, is_member = who == "an administrator", who == "a member"
    eve = await approved(
        world.parts, "eve", "administrator" if is_boss else "participant"
    )
    if is_member:
        world.join(owner, eve)
    before = world.owned_by(owner)
    for call in pages(world.app):
        is_administration = bool(ADMINISTRATION.match(call.path))
        if is_boss and is_administration:
            continue
        is_known = not who.startswith("who ")
        async with world.client() as browser:
            csrf = world.sign_in(browser, eve) if is_known else ""
            answer = await world.open_page(browser, call, owner, csrf)
        assert PRIVATE not in answer.text, call.name
        assert is_member or SHARED not in answer.text, call.name
        if not is_known and not OPEN_PAGES.fullmatch(call.path):
            where = answer.headers.get("location", "")
            assert "/login?next=" in where or answer.status_code == 403, call.name
        elif is_administration:
            assert "There is no such page" in answer.text, call.name
        elif OF_OTHERS.search(call.path):
            assert answer.status_code in (400, 404), call.name
    assert world.owned_by(owner) == before


@pytest.mark.parametrize("state", ["suspended", "rejected", "pending"])
async def test_an_account_that_is_not_approved_only_reads(
    world: World, owner: Person, state: AccountState
) -> None:
    """It signs in, and sends each form about what is its own. Expect refusals."""
    statement = "UPDATE accounts SET state = ? WHERE account = ?"
    world.parts.database.execute(statement, state, owner.name)
    for call in pages(world.app):
        if call.method == "GET" or OPEN_PAGES.fullmatch(call.path):
            continue
        if call.path.removeprefix("/hosting") in STILL_ALLOWED:
            continue
        world.code = world.parts.devices.begin("a test")[1].user_code
        before = world.owned_by(owner)
        async with world.client() as browser:
            csrf = world.sign_in(browser, owner.name)
            before = world.owned_by(owner)
            answer = await world.open_page(browser, call, owner, csrf)
        assert answer.status_code >= 400, call.name
        assert world.owned_by(owner) == before, call.name
