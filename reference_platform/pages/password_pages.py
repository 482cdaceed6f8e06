"""The pages of a forgotten password."""

from __future__ import annotations

from starlette.responses import Response

from reference_platform.pages.form_calls import PageCall
from reference_server.rules.refusal import Refused

_SENT = (
    "If there is such an account, a mail with a code is on its way to its address. "
    "Enter the code here within half an hour."
)


_NOT_SENT = (
    "This host sends no mail, so it sends no code either. Ask its people for a new "
    "password."
)


async def show_forgotten(call: PageCall) -> Response:
    return call.page("passwords/forgotten")


async def ask_for_reset(call: PageCall) -> Response:
    """The answer is the same for every name."""
    try:
        call.parts.resets.begin(call.form.get("account", ""), call.address)
    except Refused as refused:
        return call.page("passwords/forgotten", problem=refused.detail)
    text = _SENT if call.parts.outbox.is_sent else _NOT_SENT
    return call.page("passwords/reset", code="", text=text)


async def show_reset(call: PageCall) -> Response:
    return call.page("passwords/reset", code=call.request.query_params.get("code", ""))


async def set_password(call: PageCall) -> Response:
    code, password = call.form.get("code", ""), call.form.get("password", "")
    try:
        name = await call.parts.resets.finish(code, password, call.address)
    except Refused as refused:
        return call.page("passwords/reset", problem=refused.detail, code=code)
    text = f"The password of {name} was changed. Sign in with it."
    return call.page("notice", heading="Password changed", text=text)
