"""Sessions of the pages: which are forgotten, and which sign-in secrets are used."""

from __future__ import annotations

import httpx
import pytest
from starlette.responses import JSONResponse, Response

from reference_server.http.auth import hash_of
from reference_server.http.pages import page_sessions
from reference_server.http.pages.page_sessions import (
    IDLE_S,
    SESSION_COOKIE,
    SESSIONS_PER_ACCOUNT_MAX,
    PageSessions,
    login_secret,
    new_login_secret,
)
from reference_server.http.problems import problem_response
from reference_server.rules.refusal import lacks_scope
from tests.support.pages.page_api import PageApi, client_of, sign_in, text_of
from tests.support.pages.page_reader import fields_of, links_of


class Clock:
    def __init__(self) -> None:
        self.now = 0.0

    def __call__(self) -> float:
        return self.now


def alive(sessions: PageSessions, cookies: list[str]) -> list[str]:
    return [cookie for cookie in cookies if sessions.find(cookie) is not None]


def test_an_account_of_many_tokens_ends_its_own_sessions_alone() -> None:
    sessions = PageSessions()
    others = sessions.begin("a token", "other")
    numbers = range(SESSIONS_PER_ACCOUNT_MAX + 9)
    own = [sessions.begin(f"token {number}", "reader") for number in numbers]
    assert alive(sessions, [others]) == [others]
    assert alive(sessions, own) == own[-SESSIONS_PER_ACCOUNT_MAX:]


def test_the_account_with_the_most_sessions_makes_room(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(page_sessions, "SESSIONS_MAX", 5)
    sessions = PageSessions()
    first = sessions.begin("a", "few")
    many = [sessions.begin("b", "many") for _ in range(4)]
    second = sessions.begin("a", "few")
    third = sessions.begin("c", "other")
    assert alive(sessions, [first, second, third]) == [first, second, third]
    assert alive(sessions, many) == many[2:]


def test_what_is_over_goes_also_behind_what_is_used() -> None:
    clock = Clock()
    sessions = PageSessions(clock)
    used, idle = sessions.begin("1", "a"), sessions.begin("2", "b")
    clock.now = IDLE_S - 1
    assert sessions.find(used) is not None
    clock.now = IDLE_S + 1
    sessions.begin("3", "c")
    assert next(iter(sessions._sessions)) == used
    assert sessions.find(idle) is None
    sessions.end(used)
    assert set(sessions._by_account) == {"c"}, "nothing is kept of what has ended"


@pytest.mark.parametrize("sent", ["", "x", "a" * 42, "a" * 44, '"' + "a" * 41 + '"'])
def test_only_a_login_secret_of_this_server_is_used_again(sent: str) -> None:
    assert login_secret(sent) == ""
    own = new_login_secret()
    assert login_secret(own) == own


@pytest.mark.parametrize(("begins_here", "status"), [(True, 303), (False, 403)])
async def test_a_code_signs_in_only_a_browser_that_began_here(
    begins_here: bool, status: int
) -> None:
    """The other one has followed a link with the code of someone else."""
    codes: dict[tuple[str, str], str] = {}

    async def take_token(code: str, state: str) -> str | None:
        return codes.pop((code, state), None)

    async with client_of(PageApi(), take_token=take_token) as client:
        state = hash_of("")
        if begins_here:
            away = await client.get("/pages/login")
            state = httpx.URL(away.headers["location"]).params["state"]
        codes["code", state] = "alice"
        answer = await client.get("/pages/login?code=code")
    assert answer.status_code == status
    assert (SESSION_COOKIE.name in answer.headers["set-cookie"]) is begins_here


async def test_over_tls_no_other_site_plants_a_cookie() -> None:
    """Cookies that other hosts and connections can set. Expect that none is read."""
    async with client_of(PageApi(), url="https://server") as client:
        page = await client.get("/pages/login")
        (sent,) = page.headers.get_list("set-cookie")
        assert sent.startswith("__Host-proctor_login=")
        assert "Path=/;" in sent
        assert "Secure" in sent
        assert "Domain" not in sent
        planted = new_login_secret()
        form = {"token": "alice", "csrf": planted}
        cookies = {"Cookie": f"proctor_login={planted}"}
        answer = await client.post("/pages/login", data=form, headers=cookies)
        assert answer.status_code == 403
        await sign_in(client, "alice")
        assert set(client.cookies) == {"__Host-proctor_session"}
        assert (await client.get("/pages/runs")).status_code == 200
        cookie = client.cookies["__Host-proctor_session"]
        client.cookies.clear()
        unprefixed = {"Cookie": f"proctor_session={cookie}"}
        answer = await client.get("/pages/runs", headers=unprefixed)
        assert answer.status_code == 303


class OperatorsApi(PageApi):
    """The token `olga` has the scope `operator` alone."""

    def _answer(self, path: list[str], token: str, start: int) -> Response:
        match path, token:
            case ["cells" | "second_judgements", *_], _:
                return JSONResponse({"cells": [], "judgements": []})
            case ["runs", *_], "olga":
                return problem_response(lacks_scope("read"))
        return super()._answer(path, token, start)


@pytest.mark.parametrize("is_host", [True, False])
async def test_pages_at_a_host_lead_to_its_tracks(is_host: bool) -> None:
    async def take_token(_code: str, _state: str) -> str | None:
        return None

    taken = take_token if is_host else None
    async with client_of(PageApi(), take_token=taken) as client:
        form = fields_of((await client.get("/pages/login?with=key")).text)
        await client.post("/pages/login", data=form | {"token": "alice"})
        links = links_of(await text_of(client, "/pages/runs"))
    assert any(link.endswith("hosting") for link in links) is is_host


@pytest.mark.parametrize(("token", "reads"), [("olga", False), ("alice", True)])
async def test_an_operator_has_no_link_to_what_is_refused(
    token: str, reads: bool
) -> None:
    """Its first page is that of the cells; a refusal leads to a sign-in that helps."""
    async with client_of(OperatorsApi()) as client:
        await sign_in(client, token)
        links = links_of(await text_of(client, "/pages/cells"))
        assert ("runs" in " ".join(links)) is reads
        assert any(link.endswith("/pages") for link in links) is reads
        answer = await client.get("/pages/runs/run_1")
    assert answer.status_code == (404 if reads else 403)
    assert ("Sign in with one that has the scope `read`" in answer.text) is not reads
    assert ("/pages/login?next=" in answer.text) is not reads
