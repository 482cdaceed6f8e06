"""Fetches records and the keys of hosts, and hands records in.

The generated client keeps a whole body in memory; a record is sent and read by blocks.
"""

from __future__ import annotations

import io
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from typing import BinaryIO
from urllib.parse import quote

from proctor_client import PublicKey, RecordImport, refusal
from urllib3 import BaseHTTPResponse

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
    path = f"/v1/runs/{quote(run_id, safe='')}/record"
    return _read(connection, retry_policy, path, "record")


def fetch_recording(
    connection: Connection, retry_policy: RetryPolicy, run_id: str, episode_id: str
) -> bytes:
    """The recording of an episode that has its result. Raises ProctorError."""
    path = f"{quote(run_id, safe='')}/episodes/{quote(episode_id, safe='')}/recording"
    return b"".join(_read(connection, retry_policy, f"/v1/runs/{path}", "recording"))


def fetch_keys(
    connection: Connection, retry_policy: RetryPolicy
) -> Mapping[str, PublicKey]:
    """By keyid, those that the host publishes."""
    published = retry_policy.call(
        lambda: connection.control.list_keys(_request_timeout=TIMEOUTS_S)
    )
    return {key.keyid: key for key in published.keys}


def send_record(
    connection: Connection,
    retry_policy: RetryPolicy,
    path: Path,
    report: Callable[[int, int], object],
) -> RecordImport:
    """Hand a record in. Raises ProctorError, and OSError if it cannot be read.

    report: called with the bytes that are sent, and those of the whole file.
    """

    def send() -> RecordImport:
        # Sent again, the same bytes are the same import (REC-119).
        size = path.stat().st_size
        with _ReportedFile(path, lambda sent: report(sent, size)) as file:
            response = _request(
                connection,
                "POST",
                "/v1/records",
                file,
                {"Content-Length": str(size)},
            )
        try:
            return RecordImport.model_validate_json(response.read(BLOCK_BYTES))
        finally:
            response.release_conn()

    return retry_policy.call(send, is_upload=True)


def read_import(
    connection: Connection, retry_policy: RetryPolicy, import_id: str
) -> RecordImport:
    """The state of an import on the server. Raises ProctorError."""
    return retry_policy.call(
        lambda: connection.control.get_import(import_id, _request_timeout=TIMEOUTS_S)
    )


def _read(
    connection: Connection, retry_policy: RetryPolicy, path: str, what: str
) -> Iterator[bytes]:
    response = retry_policy.call(lambda: _request(connection, "GET", path))
    try:
        yield from response.stream(BLOCK_BYTES)
    except NO_ANSWER_ERRORS as error:
        raise ProctorError(
            BAD_ANSWER, f"{connection.url} did not send the whole {what}: {error}"
        ) from error
    finally:
        response.release_conn()


class _ReportedFile(io.BufferedReader):
    """Reports after each read up to which byte of the file it came."""

    def __init__(self, path: Path, report: Callable[[int], object]) -> None:
        super().__init__(io.FileIO(path), BLOCK_BYTES)
        self._report, self._sent = report, 0

    def read(self, size: int | None = -1, /) -> bytes:
        block = super().read(size)
        self._sent += len(block)
        self._report(self._sent)
        return block


def _request(
    connection: Connection,
    method: str,
    path: str,
    body: BinaryIO | None = None,
    headers: Mapping[str, str] | None = None,
) -> BaseHTTPResponse:
    """An answer that was not read yet; raises ApiException for a refusal."""
    response = connection.control.api_client.send(
        method,
        path,
        body=body,
        content_type="application/zip",
        more_headers={"Accept": "*/*", **(headers or {})},
        timeout=RECORD_TIMEOUTS_S,
        stream=True,
    )
    if not 200 <= response.status < 300:
        raise refusal(response)
    return response
