"""Codes and tokens with which an account reads the pages of the server."""

from __future__ import annotations

from collections.abc import Callable
from html import unescape
from typing import Final
from urllib.parse import urlencode

import httpx
import pytest

from reference_platform.accounts.page_sign_ins import CODE_S, CODES_MAX
from reference_platform.pages.form_calls import COOKIE
from reference_platform.parts import Parts
from reference_server.http.auth import hash_of
from tests.support.pages.page_reader import links_of

Change = Callable[[Parts, str], object]
# How the sign-in at the pages of the server ends, whose session has the cookie.
ENDS: Final[dict[str, Change]] = {
    "signed out": lambda parts, cookie: parts.sessions.end(cookie),
    "suspended": lambda parts, _cookie: parts.accounts.decide(
        "ada", "suspend", "The key was published.", "a test"
    ),
}


def make_token(parts: Parts, owner: str = "ada") -> tuple[str, str]:
    """The cookie of a session of ada, and a token that came of it."""
    cookie, now = parts.sessions.begin("ada", parts.clock()), parts.clock()
    code = parts.page_sign_ins.make_code(hash_of(cookie), owner, "state", now)
    token = parts.page_sign_ins.take_token(code, "state", now)
    assert token is not None
    return cookie, token


@pytest.mark.parametrize("change", ENDS.values(), ids=ENDS)
async def test_a_token_ends_with_its_account(
    parts: Parts, ada: str, change: Change
) -> None:
    cookie, token = make_token(parts)
    assert parts.page_sign_ins.valid(parts.clock()) == {hash_of(token): ada}
    change(parts, cookie)
    assert not parts.page_sign_ins.valid(parts.clock())


async def test_a_token_is_for_own_names_alone(parts: Parts, ada: str) -> None:
    """Expect none for an organisation of which the account is no member."""
    make_token(parts, "another")
    assert not parts.page_sign_ins.valid(parts.clock())
    assert ada


@pytest.mark.parametrize(
    ("state", "waited_s", "times"),
    [("another", 0, 1), ("state", CODE_S, 1), ("state", 0, 2)],
    ids=["another browser", "too late", "twice"],
)
async def test_a_code_is_for_one_browser_once(
    parts: Parts, state: str, waited_s: float, times: int
) -> None:
    made_at, sign_ins = parts.clock(), parts.page_sign_ins
    code = sign_ins.make_code("session", "ada", "state", made_at)
    tokens = [
        sign_ins.take_token(code, state, made_at + waited_s) for _ in range(times)
    ]
    assert tokens[-1] is None


@pytest.mark.parametrize("asked", ["/pages/runs/run_1", "//evil.org", ""])
async def test_a_sign_in_with_a_key_leads_to_the_page_that_was_asked_for(
    client: httpx.AsyncClient, asked: str
) -> None:
    target = f"/hosting/pages?{urlencode({'next': asked, 'state': 'f' * 64})}"
    page = (await client.get("/hosting/login", params={"next": target})).text
    (link,) = [link for link in links_of(page) if "with=key" in link]
    found = httpx.URL(unescape(link)).params["next"]
    assert found == (asked if asked.startswith("/pages") else "/pages")


async def test_a_session_has_a_bounded_number_of_codes(parts: Parts) -> None:
    """The newest ones; those of other sessions stay."""
    now, sign_ins = parts.clock(), parts.page_sign_ins
    other = sign_ins.make_code("other", "bob", "state", now)
    codes = [
        sign_ins.make_code("session", "ada", "state", now) for _ in range(CODES_MAX + 1)
    ]
    taken = [sign_ins.take_token(code, "state", now) for code in (*codes, other)]
    assert [token is None for token in taken] == [True, *[False] * (CODES_MAX + 1)]


@pytest.mark.parametrize(
    ("state", "has_begun"),
    [(hash_of("secret"), True), ("", False), ("a", False), ("a" * 65, False)],
    ids=["a hash", "nothing", "too short", "too long"],
)
async def test_a_code_is_made_for_a_browser_that_began_at_the_server(
    parts: Parts, client: httpx.AsyncClient, ada: str, state: str, has_begun: bool
) -> None:
    """Another one is sent there to begin."""
    client.cookies.set(COOKIE.name, parts.sessions.begin(ada, parts.clock()))
    answer = await client.get("/hosting/pages", params={"state": state})
    place = httpx.URL(answer.headers["location"])
    assert (answer.status_code, place.path) == (303, "../pages/login")
    assert ("code" in place.params) is has_begun
