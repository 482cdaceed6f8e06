"""The pages of the sign-in by OpenID Connect: to the provider, and back.

Links lead there, not forms: the policy of these pages lets no form leave them. The way
back begins at another site, so no session comes with it; a cookie of its own says which
browser began.
"""

from __future__ import annotations

from typing import Final

from starlette.responses import RedirectResponse, Response

from reference_platform.http.api_calls import public_url
from reference_platform.pages.form_calls import BASE, PageCall
from reference_server.http.pages.cookies import Cookie
from reference_server.http.pages.page_sessions import is_from_other_site, is_same
from reference_server.rules.refusal import Refused

COOKIE: Final = Cookie("proctor_openid", same_site="lax")
PATH: Final = f"{BASE}/openid/callback"


async def begin_openid(call: PageCall) -> Response:
    """With a session: connect the identity with its account."""
    is_own = call.reader is not None and not is_from_other_site(call.request)
    account = call.account.account if is_own else ""
    address, state = await call.parts.openid.begin(account, _redirect_uri(call))
    response = RedirectResponse(address, 303)
    COOKIE.set(response, state, seconds=600, is_secure=call.is_secure)
    return response


async def finish_openid(call: PageCall) -> Response:
    query = call.request.query_params
    state = call.read(COOKIE)
    if not is_same(query.get("state", ""), state):
        text = "The sign-in was begun in another browser; begin it again."
        raise Refused("forbidden", text)
    if "error" in query:
        raise Refused("forbidden", "The sign-in was refused there.")
    account, is_connected = await call.parts.openid.finish(
        state, query.get("code", ""), _redirect_uri(call)
    )
    text = f"The identity signs {account} in from now on."
    if is_connected:
        return call.page("notice", heading="Connected", text=text)
    cookie = call.parts.sessions.begin(account, call.parts.clock())
    # A page, and no redirection: a browser that comes from another site would not send
    # the new cookie with it.
    page = call.page("notice", heading="Signed in", text=f"You are {account}.")
    return call.with_session(page, cookie)


def _redirect_uri(call: PageCall) -> str:
    return public_url(call.parts, call.request) + PATH
