"""Sign-in by OpenID Connect, at an issuer in this process that may lie."""

from __future__ import annotations

import base64
import hashlib
from collections.abc import Iterator
from pathlib import Path
from typing import Any
from urllib.parse import parse_qs, parse_qsl, urlsplit

import httpx
import pytest
from joserfc import jwt
from joserfc.jwk import ECKey, OctKey
from starlette.applications import Starlette
from starlette.requests import Request
from starlette.responses import JSONResponse, Response
from starlette.routing import Route

from reference_platform.accounts.openid import LIFE_S, OpenIdProvider
from reference_platform.http.server_calls import ServerRuns
from reference_platform.parts import Parts
from reference_platform.platform_app import make_application
from tests.support.platform.approved_accounts import Clock, approved, quick_parts
from tests.support.platform.hosted_server import form_secret

URL = "https://issuer.example"
BACK = "/hosting/openid/callback"


class Issuer:
    """Signs every caller in as `subject`; changed: claims that are wrong."""

    def __init__(self) -> None:
        self.key = ECKey.generate_key("P-256", {"kid": "1"})
        self.signing: Any = self.key
        self.algorithm = "ES256"
        self.subject = "sub-of-ada"
        self.changed: dict[str, Any] = {}
        self.name = URL
        self._begun: dict[str, dict[str, str]] = {}

    def authorize(self, address: str) -> str:
        """The way back for a browser that was sent to this address."""
        query = {k: v[0] for k, v in parse_qs(urlsplit(address).query).items()}
        code = f"code-{len(self._begun)}"
        self._begun[code] = query
        return f"{BACK}?code={code}&state={query['state']}"

    async def token(self, request: Request) -> Response:
        form = dict(parse_qsl((await request.body()).decode()))
        begun = self._begun.pop(form["code"], None)
        digest = hashlib.sha256(form.get("code_verifier", "").encode()).digest()
        challenge = base64.urlsafe_b64encode(digest).rstrip(b"=").decode()
        if begun is None or begun["code_challenge"] != challenge:
            return JSONResponse({"error": "invalid_grant"}, 400)
        claims = {
            "iss": URL, "aud": "proctor", "sub": self.subject, "exp": 4_000_000_000,
            "nonce": begun["nonce"],
        } | self.changed  # fmt: skip
        header = {"alg": self.algorithm, "kid": "1"}
        signed = jwt.encode(header, claims, self.signing, [self.algorithm])
        return JSONResponse(
            {"access_token": "x", "token_type": "Bearer", "id_token": signed}
        )

    async def describe(self, _request: Request) -> Response:
        return JSONResponse(
            {
                "issuer": self.name,
                "authorization_endpoint": f"{URL}/authorize",
                "token_endpoint": f"{URL}/token",
                "jwks_uri": f"{URL}/keys",
            }
        )

    async def send_keys(self, _request: Request) -> Response:
        return JSONResponse({"keys": [self.key.as_dict(private=False)]})

    def app(self) -> Starlette:
        return Starlette(
            routes=[
                Route("/.well-known/openid-configuration", self.describe),
                Route("/token", self.token, methods=["POST"]),
                Route("/keys", self.send_keys),
            ]
        )


@pytest.fixture
def issuer() -> Issuer:
    return Issuer()


@pytest.fixture
def parts(tmp_path: Path, clock: Clock, issuer: Issuer) -> Iterator[Parts]:
    transport = httpx.ASGITransport(issuer.app())
    provider = OpenIdProvider(URL, "proctor", "secret", "Issuer", transport)
    made = quick_parts(tmp_path / "platform.sqlite", clock=clock, openid=provider)
    yield made
    made.database.close()


@pytest.fixture
async def connected(parts: Parts, issuer: Issuer) -> None:
    """ada has connected its identity, in a browser with its session."""
    await approved(parts, "ada")
    async with browser(parts) as client:
        page = await client.get("/hosting/login")
        form = {"account": "ada", "password": "correct horse"}
        await client.post(
            "/hosting/login", data={"csrf": form_secret(page.text)} | form
        )
        assert "Connected" in (await go_there_and_back(client, issuer)).text


def browser(parts: Parts) -> httpx.AsyncClient:
    app = make_application(parts, ServerRuns("http://127.0.0.1:9"))
    transport = httpx.ASGITransport(app)
    return httpx.AsyncClient(transport=transport, base_url="http://host.example")


async def go_there_and_back(
    client: httpx.AsyncClient, issuer: Issuer
) -> httpx.Response:
    there = await client.get("/hosting/openid")
    assert there.status_code == 303, there.text
    return await client.get(issuer.authorize(there.headers["location"]))


@pytest.mark.usefixtures("connected")
async def test_an_identity_signs_its_account_in(parts: Parts, issuer: Issuer) -> None:
    async with browser(parts) as client:
        page = await go_there_and_back(client, issuer)
        assert "You are ada" in page.text
        assert "ada@example.org" in (await client.get("/hosting/account")).text
        issuer.subject = "another"
        page = await go_there_and_back(client, issuer)
        assert "signs ada in from now on" in page.text  # it has a session


async def test_an_unknown_identity_has_no_account(parts: Parts, issuer: Issuer) -> None:
    await approved(parts, "ada")
    async with browser(parts) as client:
        page = await go_there_and_back(client, issuer)
        assert page.status_code == 403
        assert "No account is connected" in page.text
        assert (await client.get("/hosting/account")).status_code == 303


@pytest.mark.usefixtures("connected")
@pytest.mark.parametrize(
    "changed",
    [
        {"iss": "https://other.example"},
        {"aud": "another"},
        {"nonce": "of another login"},
        {"exp": 1},
        {"sub": None},
    ],
    ids=str,
)
async def test_a_token_for_something_else_is_refused(
    parts: Parts, issuer: Issuer, changed: dict[str, Any]
) -> None:
    issuer.changed = changed
    async with browser(parts) as client:
        assert (await go_there_and_back(client, issuer)).status_code == 403
        issuer.changed = {}
        assert (await go_there_and_back(client, issuer)).status_code == 200


@pytest.mark.usefixtures("connected")
async def test_a_token_of_another_key_is_refused(parts: Parts, issuer: Issuer) -> None:
    """A key that the issuer does not publish, and one that is its public key."""
    public = str(issuer.key.as_dict(private=False)["x"])
    forged = [(ECKey.generate_key("P-256", {"kid": "1"}), "ES256")]
    forged += [(OctKey.import_key(public), "HS256")]  # type: ignore[list-item]
    for issuer.signing, issuer.algorithm in forged:
        async with browser(parts) as client:
            assert (await go_there_and_back(client, issuer)).status_code == 403


@pytest.mark.usefixtures("connected")
async def test_a_login_is_of_one_browser_and_used_once(
    parts: Parts, issuer: Issuer, clock: Clock
) -> None:
    """An attacker sends its way back to a victim; then one is used twice, and late."""
    async with browser(parts) as attacker, browser(parts) as victim:
        there = await attacker.get("/hosting/openid")
        back = issuer.authorize(there.headers["location"])
        assert (await victim.get(back)).status_code == 403
        assert (await attacker.get(back)).status_code == 200
        assert (await attacker.get(back)).status_code == 403
        there = await attacker.get("/hosting/openid")
        clock.now += LIFE_S
        back = issuer.authorize(there.headers["location"])
        assert (await attacker.get(back)).status_code == 403


@pytest.mark.usefixtures("connected")
async def test_another_site_connects_nothing(parts: Parts, issuer: Issuer) -> None:
    """A page of another site leads a reader with a session to the sign-in."""
    async with browser(parts) as client:
        await go_there_and_back(client, issuer)
        issuer.subject = "of the attacker"
        foreign = {"Sec-Fetch-Site": "cross-site"}
        there = await client.get("/hosting/openid", headers=foreign)
        page = await client.get(issuer.authorize(there.headers["location"]))
        assert "No account is connected" in page.text


async def test_an_issuer_that_is_away_or_another_is_named(
    parts: Parts, issuer: Issuer
) -> None:
    issuer.name = "https://other.example"
    async with browser(parts) as client:
        page = await client.get("/hosting/openid")
    assert page.status_code == 503
    assert "Issuer says that it is another issuer" in page.text
