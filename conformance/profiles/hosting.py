"""The API of the profile `hosting` as a participant uses it: keys, tracks, codes.

The tokens of the kit are keys of two accounts with the scopes read, run and account.
"""

import hashlib
import os
import uuid
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from typing import Any
from urllib.parse import urlencode

from conformance.client.check_context import CheckContext
from conformance.client.http_client import HttpClient
from conformance.client.run_client import RunClient
from conformance.exchanges.answer import Answer
from conformance.verdicts import expect
from conformance.verdicts.expect import NotApplicable, SetUpFailed

# A revoked key is refused within this time; the kit looks for a little longer.
ENDS_S, LOOKS_S, POLL_S = 5.0, 8.0, 0.1
BASE = "/v1/hosting"
# Requests that leave a thing at the host, and its kind: see `runner/left_behind.py`.
_MADE_AT = {
    "/accounts": "account",
    "/keys": "key",
    "/organisations": "organisation",
    "/submissions": "submission",
}
_RESULTS_MAX = 1000  # of `list_results`, by its schema
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
    answer = client.request(method, f"{client.base_url}{BASE}{path}", json=json)
    if method == "POST" and answer.status in (201, 202) and path in _MADE_AT:
        context.left.append((_MADE_AT[path], (json or {}).get("account", "")))
    return answer


def call_with_form(context: CheckContext, path: str, **form: str) -> Answer:
    """Send a form without a key."""
    client = context.client_with_token(None)
    content, url = urlencode(form).encode(), f"{client.base_url}{BASE}{path}"
    return client.request("POST", url, content=content, headers=_FORM)


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
    """Give a track, entered by the first account, with an open phase on calibration."""
    tracks = require_hosting(call_hosting(context, "GET", "/tracks"))["tracks"]
    for track in tracks:
        if open_phase(track) is not None and track["entry_state"] == "entered":
            entered: dict[str, Any] = track
            return entered
    text = "the account has entered no open track on the whole of calibration"
    raise SetUpFailed(text, allowed=True)


def open_phase(track: Mapping[str, Any]) -> dict[str, Any] | None:
    """Give the open phase of a track on the whole of calibration, with any options."""
    fitting = [phase for phase in playable(track) if phase["options"] is None]
    return next(iter(fitting), None)


def playable(track: Mapping[str, Any]) -> list[dict[str, Any]]:
    """Give the open phases in which the kit can play a run of calibration."""
    return [
        phase
        for phase in track["phases"]
        if phase["is_open"]
        and (phase["benchmark_id"], phase["seeds"]) == ("calibration", "benchmark")
        and not phase["splits"]
        and set((phase["options"] or {}).get("tasks", ["score"])) == {"score"}
    ]


def played_run(context: CheckContext, phase: Mapping[str, Any]) -> RunClient:
    """Complete a run with the options of a phase."""
    options = {"tasks": ["score"]} | (phase["options"] or {})
    tasks = options.pop("tasks")
    policy = {"name": f"conformance kit {uuid.uuid4()}"}
    run = context.submit(*tasks, policy=policy, **options)
    worker = run.worker()
    worker.attach()
    for _ in tasks:
        worker.play(score=1.0, success=1)
    run.until("completed")
    return run


def find_result(
    context: CheckContext, track_id: str, run_id: str, client: HttpClient | None = None
) -> dict[str, Any] | None:
    """Give the result of a run as a caller sees it; None if it is not shown."""
    answer = call_hosting(context, "GET", f"/tracks/{track_id}/results", None, client)
    rows: Sequence[dict[str, Any]] = expect.ok(answer)["results"]
    shown = next((row for row in rows if row["result_id"] == run_id), None)
    if shown is None and len(rows) == _RESULTS_MAX:
        raise SetUpFailed("the track has more results than a list shows")
    return shown


@contextmanager
def made_organisation(context: CheckContext) -> Iterator[str]:
    """Make an organisation of the first account, which leaves it after the block."""
    name = f"kit{uuid.uuid4().hex[:12]}"
    body = {"organisation": name, "title": "Conformance Kit"}
    require_hosting(call_hosting(context, "POST", "/organisations", body), 201)
    try:
        yield name
    finally:
        leave_organisation(context, name)


def leave_organisation(context: CheckContext, name: str) -> Answer:
    """Send `remove_member` for the first account itself."""
    own = require_hosting(call_hosting(context, "GET", "/account"))["account"]
    return call_hosting(context, "DELETE", f"/organisations/{name}/members/{own}")


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


class HostedUpload:
    """A file of random bytes for the first account; nothing of it has arrived."""

    size = 1000

    def __init__(self, context: CheckContext) -> None:
        self._client = context.http_client
        self._content = os.urandom(self.size)
        digest = f"sha256:{hashlib.sha256(self._content).hexdigest()}"
        self._url = f"{self._client.base_url}{BASE}/uploads/{digest}"
        if self.read().status == 404:
            raise NotApplicable("the host plays no submissions")
        context.left.append(("upload", ""))

    def read(self) -> Answer:
        return self._client.request("GET", self._url)

    def append(self, offset: int, end: int, content: bytes | None = None) -> Answer:
        """Send the bytes up to an end, or others, at an offset."""
        return self._client.request(
            "PATCH",
            f"{self._url}?offset={offset}&size={self.size}",
            content=self._content[offset:end] if content is None else content,
            headers={"Content-Type": "application/octet-stream"},
        )
