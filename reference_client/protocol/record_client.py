"""Fetches records and the keys of hosts.

The generated client keeps a whole answer in memory; a record is read block by block.
"""

from __future__ import annotations

import contextlib
from collections.abc import Iterator, Mapping
from urllib.parse import quote

from proctor_client import ApiException, Problem
from urllib3 import BaseHTTPResponse, Timeout

from reference_client.errors import BAD_ANSWER, NO_ANSWER_ERRORS, ProctorError
from reference_client.protocol.connection import TIMEOUTS_S, Connection
from reference_client.protocol.retry_policy import RetryPolicy

BLOCK_BYTES = 1 << 20
# The first record of a long run is made before its first byte is sent.
RECORD_TIMEOUTS_S = (TIMEOUTS_S[0], 600.0)


def fetch_record(
    connection: Connection, retry_policy: RetryPolicy, run_id: str
) -> Iterator[bytes]:
    """The record of a run, block by block. Raises ProctorError."""
    url = f"{connection.url}/v1/runs/{quote(run_id, safe='')}/record"
    return _read(connection, retry_policy, url, "record")


def fetch_recording(
    connection: Connection, retry_policy: RetryPolicy, run_id: str, episode_id: str
) -> bytes:
    """The recording of an episode that has its result. Raises ProctorError."""
    path = f"{quote(run_id, safe='')}/episodes/{quote(episode_id, safe='')}/recording"
    url = f"{connection.url}/v1/runs/{path}"
    return b"".join(_read(connection, retry_policy, url, "recording"))


def fetch_keys(connection: Connection, retry_policy: RetryPolicy) -> Mapping[str, str]:
    """keyid → public key in base64, of those that the host publishes."""
    found = retry_policy.call(
        lambda: connection.control.list_keys(_request_timeout=TIMEOUTS_S)
    )
    return {key.keyid: key.public_key for key in found.keys}


def _read(
    connection: Connection, retry_policy: RetryPolicy, url: str, what: str
) -> Iterator[bytes]:
    response = retry_policy.call(lambda: _open(connection, url))
    try:
        yield from response.stream(BLOCK_BYTES)
    except NO_ANSWER_ERRORS as error:
        raise ProctorError(
            BAD_ANSWER, f"{connection.url} did not send the whole {what}: {error}"
        ) from error
    finally:
        response.release_conn()


def _open(connection: Connection, url: str) -> BaseHTTPResponse:
    client = connection.control.api_client
    headers = dict(client.default_headers)
    if token := client.configuration.access_token:
        headers["Authorization"] = f"Bearer {token}"
    response: BaseHTTPResponse = client.rest_client.pool_manager.request(
        "GET",
        url,
        headers=headers,
        preload_content=False,
        redirect=False,
        retries=False,
        timeout=Timeout(*RECORD_TIMEOUTS_S),
    )
    if response.status != 200:
        body = response.read(BLOCK_BYTES).decode(errors="replace")
        refusal = ApiException(status=response.status, reason=response.reason)
        refusal.body, refusal.headers = body, response.headers
        with contextlib.suppress(ValueError):  # it is no problem document
            refusal.data = Problem.from_json(body)
        raise refusal
    return response
