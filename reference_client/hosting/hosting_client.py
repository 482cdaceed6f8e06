"""Hosted submissions at a server with the profile `hosting`: uploads, state, logs.

A file is sent in blocks, each at the offset that the server names: an upload that broke
off goes on where it ended, whatever broke it.
"""

from __future__ import annotations

import gzip
import hashlib
import tarfile
from collections.abc import Callable
from dataclasses import replace
from datetime import UTC, datetime, timedelta
from functools import partial
from pathlib import Path
from typing import Any, BinaryIO, TypeVar
from urllib.parse import quote

import msgspec
from proctor_client import refusal

from reference_client.errors import ProctorError
from reference_client.protocol.connection import TIMEOUTS_S, Connection
from reference_client.protocol.control_client import ControlClient
from reference_client.protocol.retry_policy import RetryPolicy

WAITED_FOR_S = 300.0
BLOCK_BYTES = 8 * 2**20
# The last block of an upload is answered when the digest of the file was computed.
_UPLOAD_TIMEOUTS_S = (TIMEOUTS_S[0], 600.0)
_JSON = "application/json"
_Answer = TypeVar("_Answer")
# These are not parts of a policy, and may be large.
LEFT_OUT = frozenset({".git", ".hg", ".venv", "__pycache__", ".mypy_cache", ".cache"})


class HostedSubmission(msgspec.Struct):
    """A submission as the server shows it; other members are ignored.

    cause: who brought its end about. continues_at: before when it cannot go on.
    """

    submission_id: str
    state: str
    reason: str
    kind: str = "image"
    next_action: str = ""
    run_id: str = ""
    cause: str = ""
    continues_at: datetime | None = None
    deadline_at: datetime | None = None
    track_id: str = ""
    phase_id: str = ""
    digest: str = ""
    preset: str = ""
    policy_name: str = ""
    created_at: datetime | None = None
    entered_at: datetime | None = None

    @property
    def has_ended(self) -> bool:
        return self.state in ("completed", "failed", "stopped", "expired")

    @property
    def waits_for_a_date(self) -> bool:
        """Whether nothing happens until a date that is too far to wait for."""
        soon = datetime.now(UTC) + timedelta(seconds=WAITED_FOR_S)
        return self.continues_at is not None and self.continues_at > soon


class _Phase(msgspec.Struct):
    phase_id: str
    closes_at: datetime
    is_open: bool


class _Track(msgspec.Struct):
    phases: list[_Phase]


class _Submissions(msgspec.Struct):
    submissions: list[HostedSubmission]


class LogLine(msgspec.Struct):
    """source: `policy` or `platform`."""

    number: int
    source: str
    text: str


class SubmissionLog(msgspec.Struct):
    """Lines of a log. is_ended: whether the log has its last line."""

    lines: list[LogLine]
    is_ended: bool


class _Presets(msgspec.Struct):
    presets: list[str]


class _UploadState(msgspec.Struct):
    offset: int
    is_complete: bool


def require_accounts(connection: Connection, retry_policy: RetryPolicy) -> None:
    """Raises ProctorError for a server without accounts of people, and so no tracks."""
    client = ControlClient(connection.control, retry_policy)
    if "hosting" not in client.check_service(1).profiles:
        raise ProctorError(
            "not_found",
            f"{connection.url} has no accounts of people and no tracks. Its operator "
            "gives tokens: export PROCTOR_TOKEN, or give the argument `token`.",
        )


class HostingClient:
    """Operations on submissions; every method raises ProctorError and Interrupted."""

    def __init__(self, connection: Connection, retry_policy: RetryPolicy) -> None:
        self._connection = connection
        self._retry_policy = retry_policy

    def upload(
        self, path: Path, digest: str, report: Callable[[int, int], object]
    ) -> None:
        """Send what the server lacks of a file.

        digest: as `digest_of` the file. report: called with the bytes that have
        arrived, and those of the whole file.
        """
        target = f"/uploads/{digest}"
        with path.open("rb") as file:
            size = file.seek(0, 2)

            def send_next_block() -> _UploadState:
                state = self._read("GET", target, _UploadState)
                report(state.offset, size)
                if state.is_complete:
                    return state
                file.seek(state.offset)
                return self._read(
                    "PATCH",
                    f"{target}?offset={state.offset}&size={size}",
                    _UploadState,
                    body=file.read(BLOCK_BYTES),
                )

            is_complete = False
            while not is_complete:
                sent = self._retry_policy.call(send_next_block, is_upload=True)
                is_complete = sent.is_complete
        report(size, size)

    def has_begun(self, digest: str) -> bool:
        """Whether bytes of the file with this digest have arrived."""
        target = f"/uploads/{digest}"
        read = partial(self._read, "GET", target, _UploadState)
        return self._retry_policy.call(read).offset > 0

    def phase_of_next(self, track_id: str) -> str | None:
        """The phase that a submission without a phase gets; None if none is open."""
        path = f"/tracks/{quote(track_id, safe='')}"
        track = self._retry_policy.call(lambda: self._read("GET", path, _Track))
        phases = [phase for phase in track.phases if phase.is_open]
        first = min(phases, key=lambda phase: phase.closes_at, default=None)
        return None if first is None else first.phase_id

    def all(self) -> list[HostedSubmission]:
        """The submissions of the account, the newest first."""
        return self._retry_policy.call(
            lambda: self._read("GET", "/submissions", _Submissions)
        ).submissions

    def create(self, **members: str) -> HostedSubmission:
        """Make a submission, for which nothing is uploaded yet."""
        return self._change("/submissions", members)

    def attach(self, submission_id: str, digest: str, dockerfile: str) -> None:
        """Name the upload of a submission. Repeated, it changes nothing."""
        body = {"digest": digest, "dockerfile": dockerfile}
        once = replace(self._retry_policy, total_s=0.0)
        once.call(
            lambda: self._send("POST", f"{_path(submission_id)}/upload", json=body)
        )

    def presets(self) -> list[str]:
        """Names of what code can be run in."""
        return self._retry_policy.call(
            lambda: self._read("GET", "/presets", _Presets)
        ).presets

    def start(self, submission_id: str) -> HostedSubmission:
        return self._change(f"{_path(submission_id)}/start", {})

    def read(self, submission_id: str) -> HostedSubmission:
        path = _path(submission_id)
        return self._retry_policy.call(
            lambda: self._read("GET", path, HostedSubmission)
        )

    def log(self, submission_id: str, after: int) -> SubmissionLog:
        path = f"{_path(submission_id)}/log?after={after}"
        return self._retry_policy.call(lambda: self._read("GET", path, SubmissionLog))

    def _change(self, path: str, body: Any) -> HostedSubmission:
        """Sent once: the state says afterwards whether it was done."""
        once = replace(self._retry_policy, total_s=0.0)
        return once.call(lambda: self._read("POST", path, HostedSubmission, json=body))

    def _read(
        self,
        method: str,
        path: str,
        kind: type[_Answer],
        *,
        json: Any = None,
        body: bytes | None = None,
    ) -> _Answer:
        """One request, and its answer as a structure. Raises as RetryPolicy expects."""
        return msgspec.json.decode(
            self._send(method, path, json=json, body=body), type=kind
        )

    def _send(
        self, method: str, path: str, *, json: Any = None, body: bytes | None = None
    ) -> bytes:
        """json: a body as a value. body: one as bytes."""
        response = self._connection.control.api_client.send(
            method,
            f"/v1/hosting{path}",
            body=body if json is None else msgspec.json.encode(json),
            content_type="application/octet-stream" if json is None else _JSON,
            more_headers={"Accept": _JSON},
            timeout=_UPLOAD_TIMEOUTS_S,
        )
        if not 200 <= response.status < 300:
            refused = refusal(response)
            refused.method = method
            raise refused
        return bytes(response.data)


def digest_of(path: Path) -> str:
    """The name of the upload of a file."""
    with path.open("rb") as file:
        return f"sha256:{hashlib.file_digest(file, 'sha256').hexdigest()}"


class _CountedGzip(gzip.GzipFile):
    """Reports how many bytes were written to it."""

    def __init__(self, file: BinaryIO, report: Callable[[int], object]) -> None:
        # Weights are most of a policy, and become no smaller by a higher level.
        super().__init__("", "wb", compresslevel=1, fileobj=file, mtime=0)
        self._packed, self._report = 0, report

    def write(self, data: Any) -> int:
        written = super().write(data)
        self._packed += written
        self._report(self._packed)
        return written


def pack_code(
    folder: Path, archive: Path, report: Callable[[int, int], object]
) -> None:
    """Write the files of a folder as a tar file; the same files are the same bytes.

    report: called with the bytes that are packed, and those of the whole folder.
    """

    def cleaned(entry: tarfile.TarInfo) -> tarfile.TarInfo | None:
        if LEFT_OUT & set(Path(entry.name).parts):
            return None
        entry.uid = entry.gid = 0
        entry.uname = entry.gname = ""
        entry.mtime = 0
        return entry

    size = sum(
        path.lstat().st_size
        for path in folder.rglob("*")
        if not LEFT_OUT & set(path.relative_to(folder).parts)
    )
    report(0, size)
    with (
        archive.open("wb") as file,
        _CountedGzip(file, lambda packed: report(min(packed, size), size)) as gzipped,
        tarfile.open(fileobj=gzipped, mode="w") as packed,
    ):
        for path in sorted(folder.iterdir()):
            packed.add(path, path.name, filter=cleaned)
    report(size, size)


def _path(submission_id: str) -> str:
    return f"/submissions/{quote(submission_id, safe='')}"
