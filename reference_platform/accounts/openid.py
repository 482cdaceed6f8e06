"""Sign-in by OpenID Connect: the code flow with PKCE, at one provider.

An identity is connected with an account on the page of the account, by its owner; from
then on it signs that account in. A login is bound to the browser that began it.
"""

from __future__ import annotations

import hashlib
import secrets
import time
from base64 import urlsafe_b64encode
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, Final

import httpx
import msgspec
from joserfc import jwt
from joserfc.errors import JoseError
from joserfc.jwk import KeySet

from reference_platform.storage.platform_database import Database
from reference_server.http.auth import hash_of
from reference_server.rules.refusal import Refused

LIFE_S: Final = 600.0
TIMEOUT_S: Final = 10.0
# Signatures alone: never `none`, and no key that both sides share.
ALGORITHMS: Final = ("RS256", "ES256", "PS256", "EdDSA", "Ed25519")
_FAILED: Final = "The sign-in did not succeed; begin it again."


class Login(msgspec.Struct, frozen=True):
    """account: that an identity is to be connected with; empty for a sign-in."""

    hash: str
    nonce: str
    verifier: str
    account: str
    expires_at: float


class _Identity(msgspec.Struct):
    account: str


@dataclass(frozen=True, slots=True)
class OpenIdProvider:
    """name: for people. transport: for tests."""

    issuer: str
    client_id: str
    client_secret: str
    name: str = "OpenID"
    transport: httpx.AsyncBaseTransport | None = None

    def client(self) -> httpx.AsyncClient:
        return httpx.AsyncClient(transport=self.transport, timeout=TIMEOUT_S)


@dataclass(frozen=True, slots=True)
class OpenIdLogins:
    """provider: None if there is none."""

    database: Database
    provider: OpenIdProvider | None = None
    clock: Callable[[], float] = time.time

    def require(self) -> OpenIdProvider:
        if self.provider is None:
            raise Refused("not_found", "This host has no other sign-in.")
        return self.provider

    async def begin(self, account: str, redirect_uri: str) -> tuple[str, str]:
        """The address of the provider, and the secret that the browser keeps."""
        provider, now = self.require(), self.clock()
        state, nonce, verifier = (secrets.token_urlsafe(32) for _ in range(3))
        async with provider.client() as client:
            found = await _discover(provider, client)
        digest = hashlib.sha256(verifier.encode()).digest()
        query = {
            "response_type": "code",
            "client_id": provider.client_id,
            "redirect_uri": redirect_uri,
            "scope": "openid",
            "state": state,
            "nonce": nonce,
            "code_challenge": urlsafe_b64encode(digest).rstrip(b"=").decode(),
            "code_challenge_method": "S256",
        }
        address = httpx.URL(found["authorization_endpoint"]).copy_merge_params(query)
        with self.database.transaction():
            self.database.execute("DELETE FROM logins WHERE expires_at < ?", now)
            login = Login(hash_of(state), nonce, verifier, account, now + LIFE_S)
            self.database.insert("logins", login)
        return str(address), state

    async def finish(
        self, state: str, code: str, redirect_uri: str
    ) -> tuple[str, bool]:
        """The account, and whether the identity was connected with it just now.

        state: that the provider sent back and the browser kept. Raises Refused.
        """
        provider = self.require()
        login = self._take(state)
        try:
            async with provider.client() as client:
                found = await _discover(provider, client)
                form = {
                    "grant_type": "authorization_code",
                    "code": code,
                    "redirect_uri": redirect_uri,
                    "code_verifier": login.verifier,
                }
                keys = await client.get(found["jwks_uri"])
                answer = await client.post(
                    found["token_endpoint"],
                    data=form,
                    auth=(provider.client_id, provider.client_secret),
                )
            id_token = answer.raise_for_status().json()["id_token"]
            subject = _subject(provider, id_token, keys.json(), login.nonce)
        except (JoseError, httpx.HTTPError, KeyError, ValueError, TypeError) as error:
            raise Refused("forbidden", _FAILED) from error
        if login.account:
            self._connect(subject, login.account)
            return login.account, True
        identity = self.database.row(
            _Identity,
            "SELECT account FROM identities WHERE issuer = ? AND subject = ?",
            *(provider.issuer, subject),
        )
        if identity is None:
            text = "No account is connected with this identity. Sign in with a password"
            raise Refused("forbidden", f"{text}, and connect it on the page Account.")
        return identity.account, False

    def _take(self, state: str) -> Login:
        """A login is finished once."""
        with self.database.transaction():
            login = self.database.row(
                Login,
                "SELECT * FROM logins WHERE hash = ? AND expires_at > ?",
                *(hash_of(state), self.clock()),
            )
            if login is None:
                raise Refused("forbidden", _FAILED)
            self.database.execute("DELETE FROM logins WHERE hash = ?", login.hash)
        return login

    def _connect(self, subject: str, account: str) -> None:
        """An identity has one account; connected again, the other one loses it."""
        self.database.execute(
            "INSERT INTO identities (issuer, subject, account) VALUES (?, ?, ?) "
            "ON CONFLICT (issuer, subject) DO UPDATE SET account = excluded.account",
            *(self.require().issuer, subject, account),
        )


async def _discover(
    provider: OpenIdProvider, client: httpx.AsyncClient
) -> Mapping[str, Any]:
    address = f"{provider.issuer.rstrip('/')}/.well-known/openid-configuration"
    try:
        answer = await client.get(address)
        answer.raise_for_status()
        found: Mapping[str, Any] = answer.json()
        is_other = found["issuer"] != provider.issuer
    except (httpx.HTTPError, KeyError, ValueError, TypeError) as error:
        text = f"{provider.name} cannot be reached now."
        raise Refused("unavailable", text) from error
    if is_other:
        raise Refused("unavailable", f"{provider.name} says that it is another issuer.")
    return found


def _subject(provider: OpenIdProvider, id_token: str, keys: Any, nonce: str) -> str:
    """The subject of a token that is for this login. Raises JoseError, ValueError."""
    token = jwt.decode(id_token, KeySet.import_key_set(keys), [*ALGORITHMS])
    registry = jwt.JWTClaimsRegistry(
        iss={"essential": True, "value": provider.issuer},
        aud={"essential": True, "value": provider.client_id},
        nonce={"essential": True, "value": nonce},
        exp={"essential": True},
        sub={"essential": True},
    )
    registry.validate(token.claims)
    return str(token.claims["sub"])
