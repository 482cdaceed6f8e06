"""The command login: a person confirms a code in a browser, and a key is kept here.

It is the device grant of RFC 8628, as the profile `hosting` has it. The key is kept in
a file that only this user may read.
"""

from __future__ import annotations

import os
import socket
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import TypeVar
from urllib.parse import urlencode

from proctor_client import refusal
from pydantic import BaseModel, ValidationError

from reference_client.command.command_line.chosen_server import command_text
from reference_client.command.exit_codes import DONE
from reference_client.command.output.printer import Printer
from reference_client.command.server_connection import connect
from reference_client.command.usage_error import UsageError
from reference_client.errors import BAD_ANSWER, ProctorError
from reference_client.hosting.hosting_client import require_accounts
from reference_client.protocol.connection import TIMEOUTS_S, Connection
from reference_client.protocol.credentials import (
    find_credential,
    hides_saved_key,
    saved_key_file,
)
from reference_client.protocol.retry_policy import RetryPolicy
from reference_record.command_line.click_commands import Options
from reference_record.command_line.written_output import writing

ANSWER_BYTES_MAX = 1 << 20
POLL_S_MIN = 0.5
_FORM = "application/x-www-form-urlencoded"
_GRANT = "urn:ietf:params:oauth:grant-type:device_code"


class DeviceCodes(BaseModel):
    """user_code: that a person confirms at verification_uri."""

    device_code: str
    user_code: str
    verification_uri: str
    verification_uri_complete: str = ""
    expires_in: int
    interval: int = 5


class DeviceKey(BaseModel):
    """access_token: a key of `account`."""

    access_token: str
    account: str
    expires_in: int


class _Waits(BaseModel):
    error: str


Answer = TypeVar("Answer", bound=BaseModel)


def log_in(
    connection: Connection,
    retry_policy: RetryPolicy,
    show: Callable[[DeviceCodes], None],
) -> DeviceKey:
    """The key, after a person has confirmed the code. Raises ProctorError.

    show: is given the code, as soon as it is known.
    """

    def send(name: str, kinds: tuple[type[Answer], ...], **form: str) -> Answer:
        return retry_policy.call(lambda: _send(connection, name, kinds, form))

    label = socket.gethostname()[:100]
    codes = send("device_authorizations", (DeviceCodes,), label=label)
    show(codes)
    while True:
        retry_policy.pause(max(codes.interval, POLL_S_MIN))
        answer: BaseModel = send(
            "device_tokens",
            (DeviceKey, _Waits),
            grant_type=_GRANT,
            device_code=codes.device_code,
        )
        if isinstance(answer, DeviceKey):
            return answer


def _send(
    connection: Connection,
    name: str,
    kinds: tuple[type[Answer], ...],
    form: dict[str, str],
) -> Answer:
    response = connection.control.api_client.send(
        "POST",
        f"/v1/hosting/{name}",
        body=urlencode(form).encode(),
        content_type=_FORM,
        more_headers={"Accept": "application/json"},
        timeout=TIMEOUTS_S,
        stream=True,
    )
    if not 200 <= response.status < 300:
        raise refusal(response)
    data = response.read(ANSWER_BYTES_MAX)
    response.release_conn()
    for kind in kinds:
        try:
            return kind.model_validate_json(data)
        except ValidationError:
            continue
    text = f"{connection.url} answered what is not described in hosting.yaml."
    raise ProctorError(BAD_ANSWER, text)


def save_key(url: str, secret: str) -> Path:
    """Keep the key for this server. Raises OSError and RuntimeError (no home)."""
    path = saved_key_file(url)
    path.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
    descriptor, draft = tempfile.mkstemp(dir=path.parent)  # for this user alone
    with os.fdopen(descriptor, "w") as file:
        file.write(secret + "\n")
    Path(draft).replace(path)
    return path


def _require_place(url: str) -> None:
    """Refuse a place that cannot be written, before a person confirms a code."""
    try:
        folder = saved_key_file(url).parent
        with writing(folder, "XDG_STATE_HOME"):
            folder.mkdir(mode=0o700, parents=True, exist_ok=True)
            tempfile.TemporaryFile(dir=folder).close()
    except RuntimeError as error:
        raise UsageError(f"a key could not be kept: {error}") from error


def login(args: Options, printer: Printer) -> int:
    """Also with --forget: the key that is kept is removed, and stays valid."""
    if args.forget:
        try:
            saved_key_file(args.url).unlink(missing_ok=True)
        except OSError as error:
            raise UsageError(f"the key cannot be removed: {error}") from error
        page = f"{args.url.rstrip('/')}/hosting/keys"
        printer.say(f"No key is kept any more. Revoke it on {page}")
        return DONE

    def show(codes: DeviceCodes) -> None:
        page = codes.verification_uri_complete or codes.verification_uri
        printer.say(f"Open {page}")
        printer.say(f"and confirm the code {codes.user_code}. Waiting …")

    with connect(args, printer, anonymous_at=args.url) as (connection, retry_policy):
        require_accounts(connection, retry_policy)
        _require_place(connection.url)
        try:
            key = log_in(connection, retry_policy, show)
        except ProctorError as error:  # refused, or the code has become too old
            again = f"`{command_text(args, 'login')}` shows a new code."
            raise error.explained(again) from error
        try:
            path = save_key(connection.url, key.access_token)
        except (OSError, RuntimeError) as error:
            page = f"{connection.url}/hosting/keys"
            text = f"the key cannot be kept ({error}), and stays valid: revoke it on"
            raise UsageError(f"{text} {page}") from error
    credential = find_credential(connection.url)
    if step := hides_saved_key(credential):
        printer.say(f"{credential.source} is sent in place of this key: {step}.")
    value = {"account": key.account, "file": str(path)}
    days = round(key.expires_in / 86_400)
    printer.answer(value, f"Signed in as {key.account} for {days} days.")
    return DONE
