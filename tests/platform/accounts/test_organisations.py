"""Organisations: who may do what, and what is theirs."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import get_args

import msgspec
import pytest

from reference_platform.accounts.organisations import (
    ALLOWED,
    INVITATION_S,
    MemberRole,
    Owner,
)
from reference_platform.parts import Parts
from reference_platform.tracks.track_rules import AskedRun, Phase, Track
from reference_server.rules.refusal import Refused
from tests.support.platform.approved_accounts import Clock, approved
from tests.support.platform.read_runs import ShownRuns


class Mailed(msgspec.Struct):
    recipient: str
    body: str


@pytest.fixture
async def lab(parts: Parts, ada: str) -> str:
    """An organisation of Ada."""
    parts.organisations.create("lab", "A Laboratory", parts.accounts.get(ada))
    return "lab"


def invite(parts: Parts, role: MemberRole, name: str = "bob") -> str:
    """The code of an invitation, which its mail alone has."""
    parts.organisations.invite("lab", "ada", f"{name}@example.org", role)
    statement = "SELECT recipient, body FROM mail ORDER BY number DESC LIMIT 1"
    (mail,) = parts.database.rows(Mailed, statement)
    assert mail.recipient == f"{name}@example.org"
    return str(re.findall(r"[\w-]{32}", mail.body)[0])


async def join(parts: Parts, role: MemberRole, name: str = "bob") -> str:
    account = parts.accounts.get(await approved(parts, name))
    assert parts.organisations.accept(invite(parts, role, name), account).role == role
    return name


@pytest.mark.parametrize("role", get_args(MemberRole))
async def test_a_role_may_do_what_the_table_says(
    parts: Parts, lab: str, role: MemberRole
) -> None:
    """HST-034: each act of the table. Expect `forbidden` for what it does not give."""
    bob = await join(parts, role)
    await join(parts, "member", "cyd")
    await join(parts, "admin", "dan")
    eve = "eve@example.org"
    acts: dict[str, Callable[[], object]] = {
        "submit": lambda: parts.organisations.owner(bob, lab),
        "invite": lambda: parts.organisations.invite(lab, bob, eve, "member"),
        "remove_member": lambda: parts.organisations.remove(lab, bob, "cyd"),
        "change_role": lambda: parts.organisations.set_role(lab, bob, "dan", "owner"),
        "remove": lambda: parts.organisations.remove(lab, bob, "dan"),
    }
    for act, do in acts.items():
        if act in ALLOWED[role]:
            do()
        else:
            with pytest.raises(Refused, match=f"As {role} of lab"):
                do()
    if role != "owner":
        with pytest.raises(Refused, match="you may not"):
            parts.organisations.invite(lab, bob, eve, "owner")


async def test_an_invitation_is_used_once_and_ends(
    parts: Parts, clock: Clock, lab: str
) -> None:
    code, late = invite(parts, "member"), invite(parts, "member")
    bob = parts.accounts.get(await approved(parts, "bob"))
    assert parts.organisations.accept(f" {code} ", bob).role == "member"
    cyd = parts.accounts.get(await approved(parts, "cyd"))
    clock.now += INVITATION_S
    for wrong in (code, late, ""):
        with pytest.raises(Refused, match="no such invitation"):
            parts.organisations.accept(wrong, cyd)
    assert [m.account for m in parts.organisations.members(lab, "ada")] == [
        "ada",
        "bob",
    ]


async def test_an_organisation_has_an_owner_while_it_has_members(
    parts: Parts, ada: str, lab: str
) -> None:
    bob = await join(parts, "member")
    for leave in (
        lambda: parts.organisations.remove(lab, ada, ada),
        lambda: parts.organisations.set_role(lab, ada, ada, "admin"),
    ):
        with pytest.raises(Refused, match="no other owner"):
            leave()
    parts.organisations.remove(lab, bob, bob)
    parts.organisations.remove(lab, ada, ada)
    account = parts.accounts.get(ada)
    for name in (lab, ada):  # one space of names, which are not used again
        with pytest.raises(Refused, match="is the name of another"):
            parts.organisations.create(name, "Again", account)
    with pytest.raises(Refused, match="is the name of another"):
        await approved(parts, lab)


async def test_members_share_limits_and_submissions(
    parts: Parts, ada: str, lab: str
) -> None:
    """Organisations enter; one run a day. Expect the second member to be refused."""
    bob, now = await join(parts, "member"), parts.clock()
    phase = Phase("main", "calibration", now, now + 1e6, per_day=1)
    track = Track("letters", "Letters", (phase,), entrants="organisations")
    parts.tracks.put(track, "a test")
    with pytest.raises(Refused, match="Only organisations"):
        parts.tracks.enter("letters", Owner(ada))
    parts.tracks.enter("letters", parts.organisations.owner(bob, lab))
    keys = [
        parts.keys.make(name, "", ("run",), 3600, now, organisation=lab)[0]
        for name in (ada, bob)
    ]
    runs = [AskedRun(f"run_{key.account}", key.owner, "calibration") for key in keys]
    await parts.tracks.admit(runs[0], ShownRuns())
    with pytest.raises(Refused, match="in 24 hours"):
        await parts.tracks.admit(runs[1], ShownRuns())
    name = parts.submissions.create(lab, "letters", policy_name="ours").submission_id
    for member in (ada, bob):
        owners = parts.organisations.names_of(member)
        assert parts.submissions.get_own(name, owners).account == lab
    # Who has left sees nothing of it, and the key has ended.
    parts.organisations.remove(lab, ada, bob)
    assert [key.account for key in parts.keys.valid(now)] == [ada]
    with pytest.raises(Refused, match="no such submission"):
        parts.submissions.get_own(name, parts.organisations.names_of(bob))
    with pytest.raises(Refused, match="no such organisation"):
        parts.organisations.owner(bob, lab)
