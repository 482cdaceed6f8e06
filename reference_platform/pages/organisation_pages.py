"""The page of organisations: make one, invite people, change what they may do."""

from __future__ import annotations

import msgspec
from starlette.responses import Response

from reference_platform.accounts.organisations import ALLOWED, MemberRole
from reference_platform.pages.form_calls import PageCall
from reference_server.rules.refusal import Refused


async def show_organisations(
    call: PageCall, problem: str = "", said: str = ""
) -> Response:
    """Those of the reader. said: what was just done."""
    organisations, name = call.parts.organisations, call.account.account
    mine = [
        (
            member,
            organisations.title(member.organisation),
            organisations.members(member.organisation, name),
            organisations.invitations(member.organisation, name),
            ALLOWED[member.role],
        )
        for member in organisations.of_account(name)
    ]
    return call.page(
        "organisations/organisations",
        problem=problem,
        said=said,
        mine=mine,
        roles=[*ALLOWED],
    )


async def create_organisation(call: PageCall) -> Response:
    name, title = call.form.get("organisation", ""), call.form.get("title", "")
    try:
        call.parts.organisations.create(name, title, call.account)
    except Refused as refused:
        return await show_organisations(call, refused.detail)
    return call.redirect("/organisations")


async def invite_member(call: PageCall) -> Response:
    name, email = call.path("organisation"), call.form.get("email", "")
    try:
        role = _role(call)
        call.parts.organisations.invite(name, call.account.account, email, role)
    except Refused as refused:
        return await show_organisations(call, refused.detail)
    said = f"{email} gets a mail with a code."
    if not call.parts.outbox.is_sent:
        said = f"{email} is invited, but this host sends no mail now: the code waits."
    return await show_organisations(call, said=said)


async def join_organisation(call: PageCall) -> Response:
    """HST-005: codes are not guessed either."""
    guesses, name = call.parts.accounts.guesses, call.account.account
    try:
        with guesses.guard_code(name, "invitation", call.address):
            call.parts.organisations.accept(call.form.get("code", ""), call.account)
    except Refused as refused:
        return await show_organisations(call, refused.detail)
    return call.redirect("/organisations")


async def change_member(call: PageCall) -> Response:
    """Another role, or none."""
    organisations, actor = call.parts.organisations, call.account.account
    name, account = call.path("organisation"), call.path("account")
    try:
        if call.form.get("role") == "none":
            organisations.remove(name, actor, account)
        else:
            organisations.set_role(name, actor, account, _role(call))
    except Refused as refused:
        return await show_organisations(call, refused.detail)
    return call.redirect("/organisations")


def _role(call: PageCall) -> MemberRole:
    """Raises Refused."""
    try:
        return msgspec.convert(call.form.get("role"), MemberRole)  # type: ignore[no-any-return]
    except msgspec.ValidationError as error:
        raise Refused("invalid_request", "Choose a role.") from error
