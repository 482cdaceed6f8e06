"""Attacks on accounts, keys, sessions and forms; each has a control that succeeds."""

from __future__ import annotations

import re
from typing import Any

import httpx
import pytest

from reference_platform.accounts.account_keys import is_well_formed, new_secret
from reference_platform.accounts.browser_sessions import SESSIONS_PER_ACCOUNT_MAX
from reference_platform.accounts.passwords import LIMITS, PERIOD_S
from reference_platform.parts import Parts
from reference_server.http.codec import pointer
from reference_server.rules.refusal import Refused
from tests.support.platform.approved_accounts import Clock, approved, key_of
from tests.support.platform.hosted_server import form_secret

SIGN_UP = {
    "account": "ada", "full_name": "A. Person", "organisation": "A Laboratory",
    "email": "ada@example.org", "password": "correct horse", "agrees": True,
}  # fmt: skip
PASSWORD = str(SIGN_UP["password"])
API = "/v1/hosting"


async def sign_in(
    client: httpx.AsyncClient, name: str, password: str = PASSWORD, **form: str
) -> httpx.Response:
    page = await client.get("/hosting/login")
    secret = {"csrf": form_secret(page.text)}
    data = secret | {"account": name, "password": password} | form
    return await client.post("/hosting/login", data=data)


def bearer(key: str) -> dict[str, str]:
    return {"Authorization": f"Bearer {key}"}


# --- forms of other sites ---


@pytest.mark.parametrize(
    ("changed", "headers"),
    [
        ({"csrf": ""}, {}),
        ({"csrf": "x" * 43}, {}),
        ({}, {"Origin": "http://evil.example"}),
        ({}, {"Sec-Fetch-Site": "cross-site"}),
    ],
)
async def test_cannot_send_a_form_from_another_site(
    client: httpx.AsyncClient,
    parts: Parts,
    ada: str,
    changed: dict[str, str],
    headers: dict[str, str],
) -> None:
    """A key is asked for by a form that is not the page's own. Expect none."""
    await sign_in(client, ada)
    page = await client.get("/hosting/keys")
    form = {"csrf": form_secret(page.text), "scope_read": "on", "days": "9"}
    answer = await client.post("/hosting/keys", data=form | changed, headers=headers)
    assert answer.status_code == 403
    assert not parts.keys.of_account(ada, parts.clock())
    answer = await client.post("/hosting/keys", data=form)
    assert len(parts.keys.of_account(ada, parts.clock())) == 1


async def test_over_tls_no_other_site_plants_a_cookie(
    client: httpx.AsyncClient, ada: str
) -> None:
    """Cookies that other hosts and connections can set. Expect that none is read."""
    client.base_url = httpx.URL("https://host.example")
    await client.get("/hosting/login")
    assert set(client.cookies) == {"__Host-proctor_hosting_form"}
    assert (await sign_in(client, ada)).status_code == 303
    assert set(client.cookies) == {"__Host-proctor_hosting"}
    assert (await client.get("/hosting/account")).status_code == 200
    cookie = client.cookies["__Host-proctor_hosting"]
    client.cookies.clear()
    planted = {"Cookie": f"proctor_hosting={cookie}"}
    assert (await client.get("/hosting/account", headers=planted)).status_code == 303


async def test_an_account_ends_its_own_oldest_sessions_alone(
    parts: Parts, ada: str
) -> None:
    now = parts.clock()
    others = parts.sessions.begin(await approved(parts, "eve"), now)
    numbers = range(SESSIONS_PER_ACCOUNT_MAX + 2)
    own = [parts.sessions.begin(ada, now + number) for number in numbers]
    alive = [one for one in (others, *own) if parts.sessions.find(one, now)]
    assert alive == [others, *own[2:]]


async def test_cannot_fix_a_session(client: httpx.AsyncClient, ada: str) -> None:
    """A cookie was planted before the sign-in. Expect another one after it."""
    client.cookies.set("proctor_hosting", "planted", path="/hosting")
    answer = await sign_in(client, ada)
    assert answer.status_code == 303
    cookie = re.search(r"proctor_hosting=([^;]+)", answer.headers["set-cookie"])
    assert cookie is not None
    assert cookie[1] != "planted"
    planted = {"Cookie": "proctor_hosting=planted"}
    assert (await client.get("/hosting/account", headers=planted)).status_code == 303


async def test_a_session_ends(
    client: httpx.AsyncClient, parts: Parts, clock: Clock, ada: str
) -> None:
    """By a new password, a suspension, and by time."""

    async def is_signed_in() -> bool:
        return (await client.get("/hosting/account")).status_code == 200

    await sign_in(client, ada)
    assert await is_signed_in()
    await parts.accounts.set_password(parts.accounts.get(ada), "another horse")
    assert not await is_signed_in()
    await sign_in(client, ada, "another horse")
    parts.accounts.decide(ada, "suspend", "for a test", "a test")
    assert not await is_signed_in()
    await sign_in(client, ada, "another horse")
    clock.now += 3 * 3600
    assert not await is_signed_in()


@pytest.mark.parametrize(
    "target", ["//evil.example", "https://evil.example", "/hosting/../pages", "/pages"]
)
async def test_a_sign_in_leads_nowhere_else(
    client: httpx.AsyncClient, ada: str, target: str
) -> None:
    answer = await sign_in(client, ada, next=target)
    assert answer.headers["location"] == "../hosting"


# --- guessing ---


async def test_cannot_guess_passwords(
    client: httpx.AsyncClient, parts: Parts, ada: str
) -> None:
    """The right password does not help after many wrong ones, until time has passed."""
    for _ in range(LIMITS["pair"]):
        assert "is wrong" in (await sign_in(client, ada, "wrong")).text
    assert "too many wrong tries" in (await sign_in(client, ada)).text
    parts.accounts.guesses._clock = lambda: 1e9 + PERIOD_S
    assert (await sign_in(client, ada)).status_code == 303


async def test_cannot_learn_which_accounts_and_addresses_exist(
    client: httpx.AsyncClient, ada: str
) -> None:
    """Sign-in and registration say the same of what exists and what does not."""
    texts = {
        re.sub(r"value=\"[^\"]*\"", "", (await sign_in(client, name, "wrong")).text)
        for name in (ada, "no_such_account")
    }
    assert len(texts) == 1
    answers = [
        await client.post(f"{API}/accounts", json=SIGN_UP | {"account": name} | email)
        for name, email in (("eve", {}), ("eva", {"email": "new@example.org"}))
    ]
    assert {answer.status_code for answer in answers} == {202}
    assert answers[0].text.replace("eve", "eva") == answers[1].text


async def test_cannot_register_without_end(client: httpx.AsyncClient) -> None:
    """A program registers one account after the other. Expect a limit."""
    statuses = [
        (await client.post(f"{API}/accounts", json=SIGN_UP | {"account": f"ada{n}"}))
        for n in range(LIMITS["pair"] + 1)
    ]
    assert [answer.status_code for answer in statuses][-2:] == [202, 429]


async def test_cannot_hold_all_codes(client: httpx.AsyncClient) -> None:
    """A program begins one sign-in after the other. Expect a limit."""
    path = f"{API}/device_authorizations"
    statuses = [
        (await client.post(path, data={"label": "x"})).status_code
        for _ in range(LIMITS["address"] + 1)
    ]
    assert statuses[-2:] == [200, 429]


async def test_cannot_guess_codes(
    client: httpx.AsyncClient, parts: Parts, ada: str
) -> None:
    """Every place that takes codes of programs or invitations refuses (HST-005).

    Expect a refusal of the right code, too, once there were too many wrong ones.
    """
    await sign_in(client, ada)
    headers = bearer(key_of(parts, ada))
    form = {"csrf": form_secret((await client.get("/hosting/keys")).text)}

    async def show(code: str) -> httpx.Response:
        return await client.get(f"/hosting/device?code={code}")

    async def confirm(code: str) -> httpx.Response:
        sent = form | {"code": code, "decision": "approve"}
        return await client.post("/hosting/device", data=sent)

    async def join(code: str) -> httpx.Response:
        sent = form | {"code": code}
        return await client.post("/hosting/organisations/join", data=sent)

    async def accept(code: str) -> httpx.Response:
        body = {"code": code}
        return await client.post(f"{API}/memberships", json=body, headers=headers)

    for guess, code in (
        (show, parts.devices.begin("a laptop")[1].user_code),
        (confirm, parts.devices.begin("a laptop")[1].user_code),
        (join, "unknown"),
        (accept, "unknown"),
    ):
        parts.accounts.guesses._failures.clear()
        for _ in range(LIMITS["pair"]):
            assert "too many wrong tries" not in (await guess("BBBB-BBBB")).text
        assert "too many wrong tries" in (await guess(code)).text


async def test_a_program_gets_no_more_than_it_needs(
    client: httpx.AsyncClient, parts: Parts, ada: str
) -> None:
    """Expect no key that makes other keys, and its 90 days on the page and as sent."""
    await sign_in(client, ada)
    code, device = parts.devices.begin("a laptop")
    page = await client.get(f"/hosting/device?code={device.user_code}")
    assert "submit runs and policies; it ends after 90 days" in page.text
    parts.devices.decide(device.user_code, ada, approve=True)
    grant = "urn:ietf:params:oauth:grant-type:device_code"
    form = {"grant_type": grant, "device_code": code}
    answer = (await client.post(f"{API}/device_tokens", data=form)).json()
    assert answer["expires_in"] == 90 * 86_400
    headers = bearer(answer["access_token"])
    assert (await client.get(f"{API}/account", headers=headers)).status_code == 200
    assert (await client.get(f"{API}/keys", headers=headers)).status_code == 403


# --- keys ---


async def test_no_form_makes_a_key_of_an_administrator(
    client: httpx.AsyncClient, parts: Parts, ada: str
) -> None:
    await sign_in(client, ada)
    form = {"csrf": form_secret((await client.get("/hosting/keys")).text)}
    form |= {"scope_host": "on", "days": "9"}
    assert "no administrator" in (await client.post("/hosting/keys", data=form)).text
    assert not parts.keys.of_account(ada, parts.clock())


async def test_a_key_ends(
    client: httpx.AsyncClient, parts: Parts, clock: Clock, ada: str
) -> None:
    """By revocation, by expiry, and with its account; another one stays valid."""

    async def status(key: str) -> int:
        answer = await client.get(f"{API}/account", headers=bearer(key))
        return answer.status_code

    key, secret = parts.keys.make(ada, "", ["read"], 3600, clock())
    other, short = key_of(parts, ada), key_of(parts, ada, lifetime_s=60)
    assert {await status(one) for one in (secret, other, short)} == {200}
    parts.keys.revoke(ada, key.key_id, clock())
    clock.now += 61
    assert [await status(one) for one in (secret, other, short)] == [401, 200, 401]
    parts.accounts.decide(ada, "suspend", "for a test", "a test")
    assert await status(other) == 401
    # A program whose sign-in was allowed before gets no key after it (HST-003).
    code, device = parts.devices.begin("a laptop")
    parts.devices.decide(device.user_code, ada, approve=True)
    with pytest.raises(Refused, match="Only an approved account has keys"):
        parts.devices.poll(code)
    parts.accounts.decide(ada, "reinstate", "", "a test")
    assert await status(other) == 401
    with pytest.raises(Refused, match="unknown"):
        parts.devices.poll(code)


def test_a_secret_is_recognised_by_its_checksum() -> None:
    secret = new_secret()
    assert is_well_formed(secret)
    wrong = "0" if secret[10] != "0" else "1"
    assert not is_well_formed(secret[:10] + wrong + secret[11:])


async def test_secrets_are_stored_as_hashes(
    client: httpx.AsyncClient, parts: Parts, ada: str
) -> None:
    """A thief of the database has no password, no key, no session and no code."""
    key, (code, _) = key_of(parts, ada), parts.devices.begin("x")
    await sign_in(client, ada)
    parts.database.close()
    stored = parts.database.path.read_bytes()
    cookie = client.cookies["proctor_hosting"]
    for secret in (key, code, cookie, "correct horse"):
        assert secret.encode() not in stored


# --- hostile input ---

HOSTILE = [
    {"account": "Ada"},
    {"account": "local"},
    {"account": "a" * 33},
    {"account": "ada\n"},
    {"full_name": "A\r\nBcc: all@example.org"},
    {"email": "ada@example.org\nBcc: all@example.org"},
    {"email": "ada@example.org,all@example.org"},
    {"email": "ada@localhost"},
    {"password": "short"},
    {"password": "correct ada horse"},
    {"agrees": False},
    {"role": "administrator"},
    {"state": "approved"},
    {"~a/b": 1},
    {"account": 7},
]


@pytest.mark.parametrize(
    ("path", "status", "allowed"),
    [
        ("/account", 405, "GET, HEAD"),
        ("/keys", 405, "GET, HEAD, POST"),
        ("/nothing", 404, None),
    ],
)
@pytest.mark.parametrize("method", ["PUT", "BREW"])
async def test_cannot_use_another_method_or_path(
    client: httpx.AsyncClient, method: str, path: str, status: int, allowed: str | None
) -> None:
    """Expect a problem of the standard, with the methods of the path (ERR-022)."""
    answer = await client.request(method, API + path)
    assert (answer.status_code, answer.headers.get("allow")) == (status, allowed)
    assert answer.headers["content-type"] == "application/problem+json"


@pytest.mark.parametrize("changed", HOSTILE, ids=str)
async def test_cannot_register_with(
    client: httpx.AsyncClient, parts: Parts, changed: dict[str, Any]
) -> None:
    answer = await client.post(f"{API}/accounts", json=SIGN_UP | changed)
    assert (answer.status_code, answer.json()["code"]) == (422, "invalid_request")
    pointers = [error["pointer"] for error in answer.json()["errors"]]
    assert pointers == [pointer([name]) for name in changed]  # ERR-003, HST-001
    assert not parts.accounts.in_state("pending")


async def test_names_are_texts_on_pages(
    client: httpx.AsyncClient, parts: Parts
) -> None:
    """Names, labels and reasons with markup. Expect texts."""
    markup = "<b onload=x>'\"&{{7*7}}"
    names = {"full_name": markup, "organisation": markup}
    assert (
        await client.post(f"{API}/accounts", json=SIGN_UP | names)
    ).status_code == 202
    parts.accounts.decide("ada", "reject", markup, "a test")
    parts.devices.begin(markup)
    boss = await approved(parts, "boss", "administrator")
    parts.keys.make(boss, markup, ["read"], 3600, parts.clock())
    await sign_in(client, boss)
    for path in ("review", "keys"):
        page = (await client.get(f"/hosting/{path}")).text
        assert "&lt;b onload=x&gt;" in page
        assert "<b onload" not in page
        assert "{{7*7}}" in page


async def test_the_mail_of_a_decision_goes_to_one_address(parts: Parts) -> None:
    async def change(email: str, password: str = PASSWORD) -> None:
        account = parts.accounts.get("ada")
        await parts.accounts.change_email(account, email, password, "192.0.2.1")

    await approved(parts, "ada")
    with pytest.raises(Refused, match="must be an e-mail address"):
        await change("a@b.org\nTo: c@d.org")
    for _ in range(LIMITS["pair"] - 1):
        with pytest.raises(Refused, match="current password is wrong"):
            await change("new@example.org", "a wrong one")
    await change("new@example.org")
    with pytest.raises(Refused, match="less than 30 days ago"):
        await change("newer@example.org")
    recipients = parts.database.number(
        "SELECT count(DISTINCT recipient) FROM mail WHERE subject LIKE '%address%'"
    )
    assert recipients == 2
