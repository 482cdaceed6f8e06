"""The operations of spec/hosting.yaml on organisations and their members."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import msgspec
from starlette.responses import Response

from reference_platform.accounts.organisations import MemberRole
from reference_platform.http.api_calls import (
    ApiCall,
    Handler,
    json_response,
    maybe_time,
)


class NewOrganisation(msgspec.Struct, forbid_unknown_fields=True):
    organisation: str
    title: str


class NewInvitation(msgspec.Struct, forbid_unknown_fields=True):
    email: str
    role: MemberRole = "member"


class Code(msgspec.Struct, forbid_unknown_fields=True):
    code: str


class NewRole(msgspec.Struct, forbid_unknown_fields=True):
    role: MemberRole


def organisation_table() -> dict[str, dict[str, tuple[Handler, str | None]]]:
    """path → method → handler, and the scope of the key."""
    one = "/organisations/{organisation}"
    return {
        "/organisations": {
            "GET": (list_organisations, "account"),
            "POST": (create_organisation, "account"),
        },
        one: {"GET": (get_organisation, "account")},
        f"{one}/invitations": {"POST": (invite_member, "account")},
        f"{one}/members/{{account}}": {
            "PUT": (set_role, "account"),
            "DELETE": (remove_member, "account"),
        },
        "/memberships": {"POST": (accept_invitation, "account")},
    }


async def list_organisations(call: ApiCall) -> Response:
    mine = call.parts.organisations.of_account(call.account.account)
    views = [_view(call, member.organisation) for member in mine]
    return json_response({"organisations": views})


async def create_organisation(call: ApiCall) -> Response:
    body = await call.body(NewOrganisation)
    call.parts.organisations.create(body.organisation, body.title, call.account)
    return json_response(_view(call, body.organisation), 201)


async def get_organisation(call: ApiCall) -> Response:
    return json_response(_view(call, call.path("organisation")))


async def invite_member(call: ApiCall) -> Response:
    """The code is in the mail alone."""
    body, name = await call.body(NewInvitation), call.path("organisation")
    actor = call.account.account
    call.parts.organisations.invite(name, actor, body.email, body.role)
    return json_response(_view(call, name), 201)


async def accept_invitation(call: ApiCall) -> Response:
    """HST-005: codes are not guessed either."""
    body, account = await call.body(Code), call.account
    guesses = call.parts.accounts.guesses
    with guesses.guard_code(account.account, "invitation", call.address):
        member = call.parts.organisations.accept(body.code, account)
    return json_response(_view(call, member.organisation), 201)


async def set_role(call: ApiCall) -> Response:
    body, name = await call.body(NewRole), call.path("organisation")
    actor, account = call.account.account, call.path("account")
    call.parts.organisations.set_role(name, actor, account, body.role)
    return json_response(_view(call, name))


async def remove_member(call: ApiCall) -> Response:
    name, account = call.path("organisation"), call.path("account")
    call.parts.organisations.remove(name, call.account.account, account)
    return Response(status_code=204)


def _view(call: ApiCall, name: str) -> Mapping[str, Any]:
    """Schema Organisation. Raises Refused for an account without a role (HST-033)."""
    organisations, account = call.parts.organisations, call.account.account
    return {
        "organisation": name,
        "title": organisations.title(name),
        "members": organisations.members(name, account),
        "invitations": [
            {"email": one.email, "role": one.role, "invited_by": one.invited_by}
            | {"expires_at": maybe_time(one.expires_at)}
            for one in organisations.invitations(name, account)
        ],
    }
