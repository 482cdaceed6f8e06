"""The pages of participants and administrators: each form calls one use case."""

from __future__ import annotations

import re
from contextlib import AbstractContextManager
from http import HTTPStatus
from typing import Final
from urllib.parse import parse_qsl, urlencode

import msgspec
from starlette.responses import RedirectResponse, Response
from starlette.routing import BaseRoute, Route

from reference_platform.accounts.account_keys import SCOPES
from reference_platform.accounts.account_rules import (
    DECISIONS,
    SignUp,
    check_key_scopes,
    parse_decision,
)
from reference_platform.accounts.devices import KEY_LIFETIME_S
from reference_platform.http.server_calls import ServerRuns
from reference_platform.pages.form_calls import (
    BASE,
    COOKIE,
    PageCall,
    Show,
    page_endpoint,
)
from reference_platform.pages.openid_pages import begin_openid, finish_openid
from reference_platform.pages.organisation_pages import (
    change_member,
    create_organisation,
    invite_member,
    join_organisation,
    show_organisations,
)
from reference_platform.pages.password_pages import (
    ask_for_reset,
    set_password,
    show_forgotten,
    show_reset,
)
from reference_platform.pages.status_pages import OperationPages
from reference_platform.pages.submission_pages import (
    SubmissionPages,
    show_submissions,
)
from reference_platform.pages.track_pages import (
    TrackPages,
    enter_track,
    show_index,
)
from reference_platform.parts import Parts
from reference_platform.storage.platform_database import audit_lines
from reference_server.http.tokens.open_requests import OpenRequests
from reference_server.rules.refusal import Refused

DAY_S: Final = 86_400.0
AUDIT_LINES: Final = 100
# The sign-in of the server gives a browser that begins there a state of this form.
_STATE: Final = re.compile(r"[0-9a-f]{64}")


def page_routes(
    parts: Parts,
    open_requests: OpenRequests,
    runs: ServerRuns,
    hosted: SubmissionPages | None,
    operation: OperationPages,
) -> list[BaseRoute]:
    """Path → page, and who may see it. hosted: of submissions, if they are run here."""
    pages = TrackPages(runs)
    shown: dict[str, tuple[Show, str]] = {
        "": (show_index, ""),
        "/": (show_index, ""),
        "/register": (show_register, ""),
        "/login": (show_login, ""),
        "/forgotten": (show_forgotten, ""),
        "/reset": (show_reset, ""),
        "/openid": (begin_openid, ""),
        "/openid/callback": (finish_openid, ""),
        "/account": (show_account, "account"),
        "/keys": (show_keys, "account"),
        "/device": (show_device, "account"),
        "/organisations": (show_organisations, "account"),
        "/submissions": (show_submissions, "account"),
        "/tracks/{track_id}": (pages.show_track, "account"),
        "/results/{result_id}/record": (pages.show_record, "account"),
        "/pages": (lead_to_pages, "approved"),
        "/review": (show_review, "administrator"),
        **operation.shown(),
        **({} if hosted is None else hosted.shown()),
    }
    changed: dict[str, tuple[Show, str]] = {
        "/register": (register, ""),
        "/login": (sign_in, ""),
        "/forgotten": (ask_for_reset, ""),
        "/reset": (set_password, ""),
        "/logout": (sign_out, ""),
        "/account/email": (change_email, "account"),
        "/account/password": (change_password, "account"),
        "/keys": (make_key, "approved"),
        "/keys/{key_id}/revoke": (revoke_key, "account"),
        "/device": (decide_device, "approved"),
        "/organisations": (create_organisation, "approved"),
        "/organisations/join": (join_organisation, "approved"),
        "/organisations/{organisation}/invite": (invite_member, "approved"),
        "/organisations/{organisation}/members/{account}": (change_member, "approved"),
        "/tracks/{track_id}/enter": (enter_track, "approved"),
        "/review/accounts/{account}": (decide_account, "administrator"),
        "/review/entries/{track_id}/{account}": (decide_entry, "administrator"),
        **({} if hosted is None else hosted.changed()),
    }
    routes: list[BaseRoute] = [
        Route(BASE + path, page_endpoint(parts, open_requests, *row), methods=[method])
        for method, table in (("GET", shown), ("POST", changed))
        for path, row in table.items()
    ]
    nothing = page_endpoint(parts, open_requests, show_nothing)
    return [*routes, Route(BASE + "/{rest:path}", nothing)]


async def show_nothing(_call: PageCall) -> Response:
    raise Refused("not_found", "There is no such page.")


# --- sign-up and sign-in ---


async def show_register(call: PageCall) -> Response:
    return call.page("register")


async def register(call: PageCall) -> Response:
    names = ("account", "full_name", "organisation", "email", "password")
    filled = {name: call.form.get(name, "") for name in names}
    evaluation = call.form.get("evaluation", "own_machine")
    ticked = {name: name in call.form for name in ("is_own_model", "agrees")}
    try:
        sign_up = msgspec.convert(
            filled | ticked | {"evaluation": evaluation}, type=SignUp
        )
        account = await call.parts.accounts.register(sign_up, address=call.address)
    except msgspec.ValidationError:
        return call.page("register", problem="Choose a kind of evaluation.")
    except Refused as refused:
        return call.page("register", problem=refused.detail)
    after = f"The host sends the decision to {account.email}."
    if not call.parts.outbox.is_sent:
        after = "This host sends no mail: sign in, and look at the page of the account."
    text = f"The account {account.account} waits for its review. {after}"
    return call.page("notice", heading="Registered", text=text)


async def show_login(call: PageCall) -> Response:
    return _login_page(call, call.request.query_params.get("next", ""))


def _login_page(call: PageCall, target: str, problem: str = "") -> Response:
    """target: the path after the sign-in. A key leads to the pages of the server."""
    path, _, query = target.partition("?")
    key_target = ""
    if path == f"{BASE}/pages":
        key_target = dict(parse_qsl(query)).get("next") or "/pages"
    return call.page("login", problem=problem, next=target, key_target=key_target)


async def sign_in(call: PageCall) -> Response:
    target = call.form.get("next", "")
    name, password = call.form.get("account", ""), call.form.get("password", "")
    try:
        cookie = await call.parts.accounts.sign_in(name, password, call.address)
    except Refused as refused:
        return _login_page(call, target, refused.detail)
    call.parts.sessions.end(call.read(COOKIE))
    return call.begin_session(cookie, target)


async def lead_to_pages(call: PageCall) -> Response:
    """Back to the sign-in of the server's pages, which sent the browser here."""
    asked = call.request.query_params
    state = asked.get("state", "")
    owner = call.parts.organisations.owner(call.account.account, asked.get("owner", ""))
    assert call.session is not None, "the page needs a sign-in"
    if not _STATE.fullmatch(state):
        begin = call.links.login(asked.get("next", ""))
        return RedirectResponse(begin, HTTPStatus.SEE_OTHER)
    code = call.parts.page_sign_ins.make_code(
        call.session.hash, owner.name, state, call.parts.clock()
    )
    query = urlencode({"code": code, "next": asked.get("next", "")})
    return RedirectResponse(
        call.links.to(f"/pages/login?{query}"), HTTPStatus.SEE_OTHER
    )


async def sign_out(call: PageCall) -> Response:
    call.parts.sessions.end(call.read(COOKIE))
    response = call.redirect("/login")
    COOKIE.forget(response, is_secure=call.is_secure)
    return response


# --- what is one's own ---


async def show_account(call: PageCall, problem: str = "") -> Response:
    return call.page("account", problem=problem)


async def change_email(call: PageCall) -> Response:
    try:
        await call.parts.accounts.change_email(
            call.account, call.form.get("email", ""), call.form.get("current", ""),
            call.address,
        )  # fmt: skip
    except Refused as refused:
        return await show_account(call, refused.detail)
    return call.redirect("/account")


async def change_password(call: PageCall) -> Response:
    current, new = call.form.get("current", ""), call.form.get("password", "")
    try:
        await call.parts.accounts.change_password(
            call.account, current, new, call.address
        )
    except Refused as refused:
        return await show_account(call, refused.detail)
    return call.redirect("/login")


async def show_keys(
    call: PageCall, problem: str = "", secret: str = "", label: str = ""
) -> Response:
    """secret: of the key that was just made; no other page shows it."""
    now = call.parts.clock()
    keys = call.parts.keys.of_account(call.account.account, now)
    scopes = [name for name in SCOPES if name != "host"]
    if call.account.is_administrator:
        scopes = [*SCOPES]
    return call.page(
        "keys", problem=problem, keys=keys, secret=secret, label=label, scopes=scopes,
        owners=call.owners,
    )  # fmt: skip


async def make_key(call: PageCall) -> Response:
    account = call.account
    scopes = [name for name in SCOPES if f"scope_{name}" in call.form]
    days = call.form.get("days", "90")
    try:
        check_key_scopes(account, scopes)
        lifetime_s = float(days) * DAY_S if days.isdecimal() else 0.0
        owner = call.parts.organisations.owner(
            account.account, call.form.get("owner", "")
        )
        key, secret = call.parts.keys.make(
            account.account, call.form.get("label", ""), scopes, lifetime_s,
            call.parts.clock(),
            organisation=owner.name if owner.is_organisation else "",
        )  # fmt: skip
    except Refused as refused:
        return await show_keys(call, refused.detail)
    return await show_keys(call, secret=secret, label=key.label)


async def revoke_key(call: PageCall) -> Response:
    account, now = call.account.account, call.parts.clock()
    call.parts.keys.revoke(account, call.path("key_id"), now)
    return call.redirect("/keys")


async def show_device(call: PageCall) -> Response:
    """HST-005: codes are not guessed either."""
    code = call.request.query_params.get("code", "")
    device, problem = None, ""
    if code:
        try:
            with _guarded(call):
                device = call.parts.devices.find(code)
        except Refused as refused:
            problem = refused.detail
    days = round(KEY_LIFETIME_S / DAY_S)
    return call.page("device", device=device, problem=problem, key_days=days)


def _guarded(call: PageCall) -> AbstractContextManager[None]:
    guesses, account = call.parts.accounts.guesses, call.account.account
    return guesses.guard_code(account, "device", call.address)


async def decide_device(call: PageCall) -> Response:
    check_key_scopes(call.account, ())
    is_approved = call.form.get("decision") == "approve"
    with _guarded(call):
        call.parts.devices.decide(
            call.form.get("code", ""), call.account.account, approve=is_approved
        )
    text = "The program gets no key."
    if is_approved:
        text = "The program has a key now. You can close this page."
    return call.page("notice", heading="Sign in a program", text=text)


# --- administrators ---


async def show_review(call: PageCall, problem: str = "") -> Response:
    parts = call.parts
    accounts = parts.accounts
    waiting = [
        (account, accounts.with_email_of(account))
        for account in accounts.in_state("pending")
    ]
    decided = [
        account
        for state in ("approved", "suspended", "rejected")
        for account in accounts.in_state(state)
    ]
    return call.page(
        "review",
        problem=problem,
        waiting=waiting,
        decided=decided,
        decisions=DECISIONS,
        entrants=parts.tracks.waiting_entrants(),
        mail=parts.outbox.waiting(),
        audit=audit_lines(parts.database, AUDIT_LINES),
    )


async def decide_account(call: PageCall) -> Response:
    try:
        call.parts.accounts.decide(
            call.path("account"),
            parse_decision(call.form.get("decision", "")),
            call.form.get("reason", ""),
            call.account.account,
        )
    except Refused as refused:
        return await show_review(call, refused.detail)
    return call.redirect("/review")


async def decide_entry(call: PageCall) -> Response:
    try:
        call.parts.tracks.decide_entry(
            call.path("track_id"),
            call.path("account"),
            accept=call.form.get("decision") == "accept",
            reason=call.form.get("reason", ""),
            actor=call.account.account,
        )
    except Refused as refused:
        return await show_review(call, refused.detail)
    return call.redirect("/review")
