"""A forgotten password: its mail, its code, its limits, and what no answer says."""

from __future__ import annotations

import re
from dataclasses import replace

import httpx
import pytest

from reference_platform.accounts.password_resets import LIFE_S, MAILS_PER_DAY
from reference_platform.accounts.passwords import LIMITS, PERIOD_S
from reference_platform.mail.outbox import Mail
from reference_platform.parts import Parts
from reference_server.rules.refusal import Refused
from tests.support.platform.approved_accounts import Clock
from tests.support.platform.hosted_server import form_secret

NEW = "a battery and a staple"
ADDRESS = "192.0.2.1"


def mails(parts: Parts) -> list[str]:
    rows = parts.database.rows(
        Mail, "SELECT * FROM mail WHERE subject = 'A new password' ORDER BY number"
    )
    return [mail.body for mail in rows]


def code_of(body: str) -> str:
    found = re.search(r"^[A-Za-z0-9_-]{43}$", body, re.MULTILINE)
    assert found is not None, body
    return found[0]


async def send(client: httpx.AsyncClient, page: str, **form: str) -> httpx.Response:
    shown = await client.get(f"/hosting/{page}")
    secret = {"csrf": form_secret(shown.text)}
    return await client.post(f"/hosting/{page}", data=secret | form)


async def test_a_code_sets_a_password_once(
    client: httpx.AsyncClient, parts: Parts, ada: str
) -> None:
    cookie = parts.sessions.begin(ada, parts.clock())
    answer = await send(client, "forgotten", account=ada)
    assert answer.status_code == 200
    (body,) = mails(parts)
    assert "http" not in body  # the host has no address that it knows to be its own
    short = await send(client, "reset", code=code_of(body), password="short")
    assert "10 to 200 characters" in short.text
    done = await send(client, "reset", code=code_of(body), password=NEW)
    assert "The password of ada was changed" in done.text
    assert parts.sessions.find(cookie, parts.clock()) is None
    again = await send(client, "reset", code=code_of(body), password="another one")
    assert "was used" in again.text
    assert await parts.accounts.sign_in(ada, NEW, ADDRESS)


async def test_the_answer_hides_which_accounts_exist(
    client: httpx.AsyncClient, parts: Parts, ada: str
) -> None:
    answers = [
        await send(client, "forgotten", account=name) for name in (ada, "unknown")
    ]
    texts = [re.sub(r'value="[^"]*"', "", answer.text) for answer in answers]
    assert texts[0] == texts[1]
    assert [answer.status_code for answer in answers] == [200, 200]
    assert len(mails(parts)) == 1


@pytest.mark.parametrize("change", ["old", "other", "stolen later", "none there"])
async def test_a_wrong_code_sets_nothing(
    parts: Parts, clock: Clock, ada: str, change: str
) -> None:
    parts.resets.begin(ada, ADDRESS)
    parts.resets.begin("unknown", ADDRESS)
    code = code_of(mails(parts)[0])
    if change == "old":
        clock.now += LIFE_S + 1
    elif change == "other":
        code = code[:-1] + ("A" if code[-1] != "A" else "B")
    elif change == "stolen later":  # a newer code was used
        parts.resets.begin(ada, ADDRESS)
        await parts.resets.finish(code_of(mails(parts)[1]), NEW, ADDRESS)
    else:
        code = ""
    with pytest.raises(Refused, match="The code is wrong"):
        await parts.resets.finish(code, NEW, ADDRESS)


async def test_tries_and_mails_are_limited(
    parts: Parts, ada: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    for _ in range(LIMITS["pair"]):
        parts.resets.begin(ada, ADDRESS)
    with pytest.raises(Refused, match="too many"):
        parts.resets.begin(ada, ADDRESS)
    assert len(mails(parts)) == MAILS_PER_DAY  # from any number of clients
    parts.resets.begin(ada, "192.0.2.2")
    assert len(mails(parts)) == MAILS_PER_DAY
    for _ in range(LIMITS["address"]):
        with pytest.raises(Refused, match="The code is wrong"):
            await parts.resets.finish("guess", NEW, "192.0.2.3")
    with pytest.raises(Refused, match="too many"):
        await parts.resets.finish(code_of(mails(parts)[0]), NEW, "192.0.2.3")
    now = parts.accounts.guesses._clock()
    monkeypatch.setattr(parts.accounts.guesses, "_clock", lambda: now + PERIOD_S + 1)
    await parts.resets.finish(code_of(mails(parts)[0]), NEW, "192.0.2.3")


async def test_a_host_that_names_its_address_gets_a_link(
    parts: Parts, ada: str
) -> None:
    resets = replace(parts.resets, public_url="https://eval.example.org/")
    resets.begin(ada, ADDRESS)
    (body,) = mails(parts)
    assert f"https://eval.example.org/hosting/reset?code={code_of(body)}" in body
