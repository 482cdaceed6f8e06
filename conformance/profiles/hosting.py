"""The API of the profile `hosting` as a participant uses it: keys, tracks, codes.

The tokens of the kit are keys of two accounts with the scopes read, run and account.
"""

import uuid
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any
from urllib.parse import urlencode

from conformance.client.check_context import CheckContext
from conformance.client.http_client import HttpClient
from conformance.exchanges.answer import Answer
from conformance.verdicts import expect
from conformance.verdicts.expect import SetUpFailed

# A revoked key is refused within this time; the kit looks for a little longer.
ENDS_S, LOOKS_S, POLL_S = 5.0, 8.0, 0.1
BASE = "/v1/hosting"
_FORM = {"Content-Type": "application/x-www-form-urlencoded"}


def call_hosting(
    context: CheckContext,
    method: str,
    path: str,
    json: Any = None,
    http_client: HttpClient | None = None,
) -> Answer:
    """Send a request to an operation of hosting.yaml."""
    client = http_client or context.http_client
    return client.request(method, f"{client.base_url}{BASE}{path}", json=json)


def call_with_form(context: CheckContext, path: str, **form: str) -> Answer:
    """Send a form without a key."""
    client = context.client_with_token(None)
    return client.request(
        "POST",
        f"{client.base_url}{BASE}{path}",
        content=urlencode(form).encode(),
        headers=_FORM,
    )


def require_hosting(answer: Answer, status: int = 200) -> Any:
    """Give the body of a step of set-up; a token of the kit may not be a key."""
    if answer.status in (401, 403):
        raise SetUpFailed(
            "the token is not a key with the scopes read, run and account of an "
            "approved account (PROCTOR_TOKEN, PROCTOR_TOKEN_2)",
            allowed=True,
        )
    return expect.require(answer, status, "a request of the profile hosting")


@contextmanager
def made_key(context: CheckContext, **members: Any) -> Iterator[dict[str, Any]]:
    """Make a key of the first account, which is revoked after the block."""
    body = {"label": "conformance kit", "lifetime_s": 600} | members
    made = require_hosting(call_hosting(context, "POST", "/keys", body), 201)
    try:
        yield made
    finally:
        call_hosting(context, "DELETE", f"/keys/{made['key_id']}")


def entered_track(context: CheckContext) -> dict[str, Any]:
    """Give an open track on calibration, entered by the first account."""
    tracks = require_hosting(call_hosting(context, "GET", "/tracks"))["tracks"]
    for track in tracks:
        is_fitting = track["benchmark_id"] == "calibration" and not track["splits"]
        if is_fitting and track["is_open"] and track["entry_state"] == "entered":
            found: dict[str, Any] = track
            return found
    text = "the account has entered no open track on the whole of calibration"
    raise SetUpFailed(text, allowed=True)


def sign_up(**members: Any) -> dict[str, Any]:
    """Give a body of `register` with a name and an address of its own."""
    name = f"kit{uuid.uuid4().hex[:12]}"
    body = {
        "account": name,
        "full_name": "Conformance Kit",
        "organisation": "Conformance",
        "email": f"{name}@example.org",
        "password": uuid.uuid4().hex,
        "agrees": True,
    }
    return body | members
