"""Which token a request carries, where it is from, and how a person gets another one.

The first of: the one given, the environment's, the key that `proctor login` saved for
this URL, and the token of a server on this machine. The last two are in files that only
this user may read: a server that was given no tokens makes one, and leaves an entry in
the folder of state of the account that runs it. The token is found while the socket of
that entry listens, or nothing does, and each connection is checked before it is sent.
This module sends nothing.
"""

from __future__ import annotations

import contextlib
import os
import re
import socket
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from urllib.parse import urlsplit

from reference_record.formats import local_servers
from reference_record.formats.private_file import read_private
from reference_record.formats.user_folders import (
    former_name_of_url,
    name_of_url,
    state_folder,
)

_TOKEN_BYTES_MAX = 4096
# A shorter value of the environment may be a word.
_SECRET_CHARS_MIN = 8
_NAME_OF_SECRET = re.compile(
    r"(?i)(token|key|secret|passw(or)?d|passphrase|credentials?)\Z"
)
_USER_OF_URL = re.compile(r"(?<=://)[^/?#\s]*@")
_QUERY_OF_URL = re.compile(r"(://[^\s?#]*)[?#][^\s'\"<>]*")
_GIVEN = "the value of the argument `token`"
_VARIABLE = "the value of PROCTOR_TOKEN"
# Each step makes the next credential the one that is used.
_REMOVALS = {
    _GIVEN: "leave the argument `token` out",
    _VARIABLE: "unset PROCTOR_TOKEN",
}


@dataclass(frozen=True, slots=True)
class Credential:
    """The token that is sent. source: where it is from, for people; empty without one.

    url: of the server that it is for. is_of_files: whether it was looked for in files
    of this user. server_file: the one in which a server on this machine keeps it.
    """

    url: str
    token: str | None = field(default=None, repr=False)
    source: str = ""
    is_of_files: bool = False
    server_file: str = ""

    @classmethod
    def of_text(cls, url: str, token: str) -> Credential:
        """The one given. Raises BadToken, a ValueError, for one that cannot be sent."""
        # Imported late: completion at a Tab imports this module, and often ends here.
        from proctor_client.transport.copied_text import read_token

        given = read_token(token, "this call (`token`)")
        return cls(url, given, _GIVEN) if given else cls(url)

    def looked_up_again(self) -> Credential:
        """Look in the files again: a server that starts writes its token there."""
        return _of_files(self.url) if self.is_of_files else self

    def check_connection(self, connected: socket.socket) -> None:
        """Raise ProctorError where the token of a local server would go elsewhere."""
        if not self.server_file:
            return
        address, port = connected.getpeername()[:2]
        for _, server in _servers(self.url):
            is_its_file = str(Path(server.token_file).resolve()) == self.server_file
            if is_its_file and server.is_at(address, port):
                return
        from reference_client.errors import NOT_TRUSTED, ProctorError  # as in of_text

        raise ProctorError(
            NOT_TRUSTED,
            f"The program that listens at {self.url} is not known to be your server "
            f"whose token is in {self.server_file}, so the token is not sent. Start "
            "that server, or name another. A token in PROCTOR_TOKEN is sent to any "
            "program there.",
        )

    def explain_refusal(self, *, has_accounts: bool) -> str:
        """Sentences that name the refused token, its source and the next step.

        has_accounts: whether people register at the server, and make keys themselves.
        """
        behind = [other for other in _all(self.url) if other.token != self.token]
        removal = _REMOVALS.get(self.source, "")
        said = f"This client sent {self.source}." if self.token else self._why_none()
        if self.token and removal and behind:
            return f"{said} To use {behind[0].source}, {removal}."
        if has_accounts:
            login = f"`proctor login --url {self.url}` makes a key"
            said += f" {login}{f'; {removal} then' if removal else ''}."
            if self.token:  # it may have been a key of such an account
                page = f"{self.url.rstrip('/')}/hosting/account"
                said += f" A suspended account makes none: {page} shows its state."
            return said
        giver = "The operator of the server gives tokens"
        if _is_here(self.url):
            giver = "The server printed a token at its start, or its operator gives one"
        cure = "export PROCTOR_TOKEN, or give the argument `token`"
        return f"{said} {giver}: {cure}."

    def _why_none(self) -> str:
        files = (*_saved_keys(self.url), *_server_files(self.url))
        unsafe = next(filter(_is_unsafe, files), None)
        if unsafe is not None:
            text = f"This client does not send what is in {unsafe}, because other"
            return f"{text} accounts may read or write it (chmod 600 {unsafe})."
        for address, server in _servers(self.url):
            if server.is_at(address, urlsplit(self.url).port or 80) is False:
                text = f"This client sent none: another program listens at {self.url}"
                return f"{text} than the server whose token is in {server.token_file}."
        try:
            place = f"{state_folder()} has none"
        except RuntimeError:
            place = "there is no home directory to look in"
        return (
            "This client sent none: the argument `token` and PROCTOR_TOKEN are not set,"
            f" and {place} for {self.url}."
        )


def find_credential(url: str, given: str | None = None) -> Credential:
    """The token given, or PROCTOR_TOKEN, or a saved key, or that of a local server.

    Raises BadToken, a ValueError, for one that cannot be sent.
    """
    from proctor_client.transport.copied_text import token_of  # as in of_text

    if given and (credential := Credential.of_text(url, given)).token:
        return credential
    if token := token_of("PROCTOR_TOKEN"):
        return Credential(url, token, _VARIABLE)
    return _of_files(url)


def token_file(url: str) -> Path | None:
    """The file in which a server of this account on this machine keeps its token."""
    return next((path for path in _server_files(url) if _token_in(path)), None)


def saved_key_file(url: str) -> Path:
    """Where `proctor login` keeps the key for the server at a URL."""
    return state_folder() / "keys" / name_of_url(url)


def hides_saved_key(credential: Credential) -> str:
    """The step after which a key that is saved now is used; empty if there is none."""
    return _REMOVALS.get(credential.source, "")


def _of_files(url: str) -> Credential:
    return next(_all(url), Credential(url, is_of_files=True))


def _all(url: str) -> Iterator[Credential]:
    """Those in files, the one that is used first."""
    for path in _saved_keys(url):
        if token := _token_in(path):
            source = f"the key that `proctor login` keeps in {path}"
            yield Credential(url, token, source, is_of_files=True)
    for path in _server_files(url):
        if token := _token_in(path):
            source = f"the token that the server keeps in {path}"
            yield Credential(
                url, token, source, is_of_files=True, server_file=str(path)
            )


def _saved_keys(url: str) -> Iterator[Path]:
    with contextlib.suppress(OSError, RuntimeError):  # there is no home directory
        path = saved_key_file(url)
        # The two names differ for a server of this machine alone.
        former = path.with_name(former_name_of_url(url))
        yield from dict.fromkeys((path.resolve(), former.resolve()))


def _server_files(url: str) -> Iterator[Path]:
    """Files of tokens whose server listens at the URL, or where nothing does."""
    for address, server in _servers(url):
        if server.is_at(address, urlsplit(url).port or 80) is not False:
            yield Path(server.token_file).resolve()


def _servers(url: str) -> Iterator[tuple[str, local_servers.LocalServer]]:
    """The entries of servers of this user at an address of this machine."""
    from proctor_client.transport.proxy_route import find_route  # as in of_text

    with contextlib.suppress(OSError, RuntimeError, ValueError):  # no home, no such URL
        parts = urlsplit(url)
        if parts.scheme == "http" and _is_here(url) and not find_route(url).url:
            yield from local_servers.find(parts.hostname or "", parts.port or 80)


def without_secrets(text: str, token: str | None) -> str:
    """The text of an error as others may read it.

    The token of this client is taken out, the users, passwords and queries of URLs, and
    values of the environment whose names end as that of a key does.
    """
    secrets = {
        value: f"(value of {name})"
        for name, value in os.environ.items()
        if len(value) >= _SECRET_CHARS_MIN and _NAME_OF_SECRET.search(name)
    }
    if token:
        secrets[token] = "(token)"
    for secret in sorted(secrets, key=len, reverse=True):
        text = text.replace(secret, secrets[secret])
    return _QUERY_OF_URL.sub(r"\1?…", _USER_OF_URL.sub("", text))


def _is_unsafe(path: Path) -> bool:
    """Whether the file has a token that _read leaves out."""
    try:
        return path.stat().st_size > 0 and _token_in(path) is None
    except OSError:
        return False


def _is_here(url: str) -> bool:
    """Whether a URL is of this machine: its name, and what that leads to."""
    # Imported late, as in of_text.
    from proctor_client.transport.proxy_route import has_own_addresses, is_this_machine

    try:
        host = urlsplit(url).hostname or ""
    except ValueError:  # no URL
        return False
    return is_this_machine(host) and has_own_addresses(host)


def _token_in(path: Path) -> str | None:
    """None without a file, and if another account could have read or written it."""
    try:
        return read_private(path, _TOKEN_BYTES_MAX).decode("ascii").strip() or None
    except (OSError, UnicodeError):
        return None
