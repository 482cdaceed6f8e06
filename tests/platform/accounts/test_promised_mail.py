"""Pages promise a mail where the host sends mail, and name another way elsewhere."""

from __future__ import annotations

import httpx
import pytest

from reference_platform.accounts.account_rules import SignUp
from reference_platform.http.server_calls import ServerRuns
from reference_platform.mail.outbox import Outbox
from reference_platform.parts import Parts
from reference_platform.platform_app import make_application
from tests.support.platform.approved_accounts import approved
from tests.support.platform.hosted_server import form_secret

FORMS = {
    "register": {
        "account": "cyd",
        "full_name": "A. Person",
        "organisation": "A Laboratory",
        "email": "cyd@example.org",
        "password": "correct horse",
        "agrees": "on",
    },
    "forgotten": {"account": "ada"},
    "organisations/lab/invite": {"email": "cyd@example.org", "role": "member"},
}


async def sign_up(parts: Parts, name: str) -> None:
    words = "A. Person", "A Lab", "p@example.org", "correct horse"
    filled = SignUp(name, *words, agrees=True)
    await parts.accounts.register(filled)


@pytest.mark.parametrize("is_sent", [True, False])
@pytest.mark.parametrize(
    ("page", "reader", "promise"),
    [
        ("register", "", "sends the decision to cyd@example.org"),
        ("register?", "", "It writes its decision to your address."),
        ("", "bea", "You get a mail."),
        ("forgotten", "", "a mail with a code is on its way"),
        ("organisations/lab/invite", "ada", "cyd@example.org gets a mail with a code"),
    ],
)
async def test_a_page_promises_what_the_host_does(
    parts: Parts, monkeypatch: pytest.MonkeyPatch, page: str, reader: str, promise: str,
    *, is_sent: bool,
) -> None:  # fmt: skip
    await approved(parts, "ada")
    await sign_up(parts, "bea")
    parts.organisations.create("lab", "A Lab", parts.accounts.get("ada"))
    app = make_application(parts, ServerRuns("http://127.0.0.1:9"))
    transport = httpx.ASGITransport(app)
    async with httpx.AsyncClient(
        transport=transport, base_url="http://host.example", follow_redirects=True
    ) as client:
        if reader:
            shown = await client.get("/hosting/login")
            form = {"account": reader, "password": "correct horse"}
            form["csrf"] = form_secret(shown.text)
            await client.post("/hosting/login", data=form)
        asked = "organisations" if "/" in page else page
        answer = await client.get(f"/hosting/{asked}")
        monkeypatch.setattr(Outbox, "is_sent", is_sent)
        if page.endswith("?"):  # before anything is filled in
            answer = await client.get(f"/hosting/{page}")
        elif page:
            form = FORMS[page] | {"csrf": form_secret(answer.text)}
            answer = await client.post(f"/hosting/{page}", data=form)
        else:
            answer = await client.get("/hosting/")
    text = " ".join(answer.text.split())
    assert (promise in text) == is_sent, text
    assert ("sends no mail" in text) != is_sent, text
