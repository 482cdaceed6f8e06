"""The operations of spec/hosting.yaml on accounts, keys and devices."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Final
from urllib.parse import parse_qsl

import msgspec
from starlette.responses import Response
from starlette.routing import BaseRoute, Route

from reference_platform.accounts.account_keys import Key
from reference_platform.accounts.account_rules import Account, Decision, SignUp
from reference_platform.accounts.devices import INTERVAL_S, LIFE_S
from reference_platform.http.api_calls import (
    ApiCall,
    Handler,
    endpoint_of,
    json_response,
    maybe_time,
    public_url,
)
from reference_platform.http.organisation_handlers import organisation_table
from reference_platform.http.submission_handlers import SubmissionHandlers
from reference_platform.http.track_handlers import TrackHandlers
from reference_platform.parts import Parts
from reference_server.http.bodies.request_bodies import read_body
from reference_server.http.tokens.open_requests import OpenRequests
from reference_server.rules.refusal import Refused

BASE: Final = "/v1/hosting"
_DEVICE_GRANT: Final = "urn:ietf:params:oauth:grant-type:device_code"


class NewKey(msgspec.Struct, forbid_unknown_fields=True):
    label: str = ""
    scopes: tuple[str, ...] = ("read", "run")
    lifetime_s: float = 90 * 86_400.0
    organisation: str = ""


class DecisionBody(msgspec.Struct, forbid_unknown_fields=True):
    decision: Decision
    reason: str = ""


def api_routes(
    parts: Parts,
    open_requests: OpenRequests,
    tracks: TrackHandlers,
    hosted: SubmissionHandlers | None = None,
) -> list[BaseRoute]:
    """path → method → handler, and the scope of the key; None: without a key.

    hosted: of submissions, if this host runs them.
    """
    table: dict[str, dict[str, tuple[Handler, str | None]]] = {
        "/accounts": {"POST": (register, None)},
        "/account": {"GET": (get_account, "read")},
        "/keys": {"GET": (list_keys, "account"), "POST": (make_key, "account")},
        "/keys/{key_id}": {"DELETE": (revoke_key, "account")},
        "/device_authorizations": {"POST": (begin_device, None)},
        "/device_tokens": {"POST": (poll_device, None)},
        "/reviews": {"GET": (list_reviews, "host")},
        "/accounts/{account}/decisions": {"POST": (decide_account, "host")},
        **organisation_table(),
        **tracks.table(),
        **({} if hosted is None else hosted.table()),
    }
    return [
        Route(BASE + path, endpoint_of(parts, handlers, open_requests))
        for path, handlers in table.items()
    ]


# --- accounts ---


async def register(call: ApiCall) -> Response:
    filled = await call.body(SignUp)
    account = await call.parts.accounts.register(filled, address=call.address)
    return json_response({"account": account.account, "state": "pending"}, 202)


async def get_account(call: ApiCall) -> Response:
    return json_response(account_view(call.account))


def account_view(account: Account) -> Mapping[str, Any]:
    shown = msgspec.structs.asdict(account)
    for name in ("password_hash", "email_changed_at", "agreed_at"):
        del shown[name]
    times = {name: maybe_time(shown[name]) for name in ("created_at", "decided_at")}
    return shown | times


async def list_reviews(call: ApiCall) -> Response:
    accounts = call.parts.accounts
    waiting = [
        {**account_view(account), "same_email": accounts.with_email_of(account)}
        for account in accounts.in_state("pending")
    ]
    entries = [
        {"track_id": entrant.track_id, "account": entrant.account}
        for entrant in call.parts.tracks.waiting_entrants()
    ]
    return json_response({"accounts": waiting, "entries": entries})


async def decide_account(call: ApiCall) -> Response:
    body = await call.body(DecisionBody)
    account = call.parts.accounts.decide(
        call.path("account"), body.decision, body.reason, call.account.account
    )
    return json_response(account_view(account))


# --- keys ---


async def list_keys(call: ApiCall) -> Response:
    keys = call.parts.keys.of_account(call.account.account, call.now)
    return json_response({"keys": [key_view(key) for key in keys]})


async def make_key(call: ApiCall) -> Response:
    """The answer alone has the secret (HST-007); no key is stronger (HST-016)."""
    body = await call.body(NewKey)
    assert call.key is not None, "the operation has a scope"
    if more := set(body.scopes) - set(call.key.scopes.split()):
        text = f"This key has no scope `{min(more)}`, so it makes none that has it."
        raise Refused("forbidden", text)
    owner = call.parts.organisations.owner(call.account.account, body.organisation)
    key, secret = call.parts.keys.make(
        call.account.account, body.label, body.scopes, body.lifetime_s, call.now,
        organisation=owner.name if owner.is_organisation else "",
    )  # fmt: skip
    return json_response({**key_view(key), "secret": secret}, 201)


async def revoke_key(call: ApiCall) -> Response:
    call.parts.keys.revoke(call.account.account, call.path("key_id"), call.now)
    return Response(status_code=204)


def key_view(key: Key) -> Mapping[str, Any]:
    return {
        "key_id": key.key_id,
        "label": key.label,
        "scopes": key.scopes.split(),
        "made_at": maybe_time(key.made_at),
        "expires_at": maybe_time(key.expires_at),
        "used_at": maybe_time(key.used_at),
        "organisation": key.organisation,
    }


# --- devices: RFC 8628 ---


async def begin_device(call: ApiCall) -> Response:
    form = await _form(call)
    call.parts.accounts.guesses.count_of_address(call.address)
    code, device = call.parts.devices.begin(form.get("label", ""))
    page = public_url(call.parts, call.request) + "/hosting/device"
    return json_response(
        {
            "device_code": code,
            "user_code": device.user_code,
            "verification_uri": page,
            "verification_uri_complete": f"{page}?code={device.user_code}",
            "expires_in": int(LIFE_S),
            "interval": int(INTERVAL_S),
        }
    )


async def poll_device(call: ApiCall) -> Response:
    form = await _form(call)
    if form.get("grant_type") != _DEVICE_GRANT:
        wrong = [("/grant_type", f"must be {_DEVICE_GRANT}")]
        raise Refused("invalid_request", "This grant is not offered.", errors=wrong)
    result = call.parts.devices.poll(form.get("device_code", ""))
    if isinstance(result, str):
        return json_response({"error": result}, 202)
    key, secret = result
    answer = {
        "access_token": secret,
        "token_type": "Bearer",
        "expires_in": round(key.expires_at - call.now),
        "account": key.account,
    }
    return json_response(answer)


async def _form(call: ApiCall) -> dict[str, str]:
    body = await read_body(call.request, 2**12)
    try:
        return dict(parse_qsl(body.decode(), max_num_fields=16))
    except ValueError as error:
        raise Refused("malformed_body", "The form cannot be read.") from error
