"""Fetches records and the keys of hosts, and hands records in.

The generated client keeps a whole body in memory; a record is sent and read by blocks.
"""

from __future__ import annotations

import contextlib
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import BinaryIO
from urllib.parse import quote

from proctor_client import ApiException, Problem, PublicKey, RecordImport
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


def fetch_keys(
    connection: Connection, retry_policy: RetryPolicy
) -> Mapping[str, PublicKey]:
    """By keyid, those that the host publishes."""
    published = retry_policy.call(
        lambda: connection.control.list_keys(_request_timeout=TIMEOUTS_S)
    )
    return {key.keyid: key for key in published.keys}


def send_record(
    connection: Connection, retry_policy: RetryPolicy, path: Path
) -> RecordImport:
    """Hand a record in. Raises ProctorError, and OSError if it cannot be read."""

    def send() -> RecordImport:
        # Sent again, the same bytes are the same import (REC-119).
        with path.open("rb") as file:
            response = _request(
                connection,
                "POST",
                f"{connection.url}/v1/records",
                {
                    "Content-Type": "application/zip",
                    "Content-Length": str(path.stat().st_size),
                },
                file,
            )
        try:
            return RecordImport.model_validate_json(response.read(BLOCK_BYTES))
        finally:
            response.release_conn()

    return retry_policy.call(send)


def read_import(
    connection: Connection, retry_policy: RetryPolicy, import_id: str
) -> RecordImport:
    """The state of an import on the server. Raises ProctorError."""
    return retry_policy.call(
        lambda: connection.control.get_import(import_id, _request_timeout=TIMEOUTS_S)
    )


def _read(
    connection: Connection, retry_policy: RetryPolicy, url: str, what: str
) -> Iterator[bytes]:
    response = retry_policy.call(lambda: _request(connection, "GET", url, {}))
    try:
        yield from response.stream(BLOCK_BYTES)
    except NO_ANSWER_ERRORS as error:
        raise ProctorError(
            BAD_ANSWER, f"{connection.url} did not send the whole {what}: {error}"
        ) from error
    finally:
        response.release_conn()


def _request(
    connection: Connection,
    method: str,
    url: str,
    headers: Mapping[str, str],
    body: BinaryIO | None = None,
) -> BaseHTTPResponse:
    """An answer that was not read yet; of a refusal, ApiException."""
    client = connection.control.api_client
    all_headers = {**client.default_headers, **headers}
    if token := client.configuration.access_token:
        all_headers["Authorization"] = f"Bearer {token}"
    response: BaseHTTPResponse = client.pool_manager.request(
        method,
        url,
        body=body,
        headers=all_headers,
        preload_content=False,
        redirect=False,
        retries=False,
        timeout=Timeout(*RECORD_TIMEOUTS_S),
    )
    if not 200 <= response.status < 300:
        answer, problem = response.read(BLOCK_BYTES), None
        with contextlib.suppress(ValueError):  # the body is not a problem document
            problem = Problem.from_json(answer)
        raise ApiException(
            response.status,
            response.reason,
            body=answer.decode(errors="replace"),
            data=problem,
            headers=response.headers,
        )
    return response
