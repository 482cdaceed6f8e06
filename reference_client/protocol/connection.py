"""The connections to one server: its control plane, and the data planes of runs."""

from __future__ import annotations

import importlib.metadata
import socket
import threading
import warnings
from collections.abc import Callable
from typing import Any, Self
from urllib.parse import urlsplit

import urllib3
from proctor_client import ApiClient, BadProxy, Configuration, ControlApi
from proctor_client.interim_answers import HttpConnection
from proctor_client.transport.fault_texts import is_of_proctor
from proctor_client.transport.proxy_route import is_this_machine
from proctor_client.transport.server_address import check_base_url
from proctor_client.transport.tls_trust import client_context, proxy_context
from urllib3.exceptions import SystemTimeWarning

from reference_client.errors import BAD_ANSWER, NOT_TRUSTED, UNREACHABLE, ProctorError
from reference_client.protocol.credentials import Credential
from reference_client.protocol.data_plane import DataPlane
from reference_client.protocol.http_connection import accept_all
from reference_client.protocol.retry_policy import (
    FAILURES,
    FIRST_ANSWER_S,
    FIRST_CONTACT_S,
    RETRY_TIMEOUT_S,
    Contact,
    RetryPolicy,
)
from reference_record.generated.protocol_version import PROTOCOL_VERSION

USER_AGENT = f"proctor-reference-client/{importlib.metadata.version('proctor-eval')}"
# (connect, read). A turn may take longer: the repeated request waits for it (PRED-005).
TIMEOUTS_S = (5.0, 60.0)
_EXPLAIN_S = 3.0  # for what makes an error clearer

# The error of the certificate says it, in a sentence.
warnings.filterwarnings("ignore", category=SystemTimeWarning)


class _ContactingClient(ApiClient):
    """Bounds the first answer of a server, and notes that it is one of Proctor.

    find_token: for each request until then, because a server that is waited for may
    make a token of its own at its start.
    """

    def __init__(
        self,
        configuration: Configuration,
        contact: Contact,
        find_token: Callable[[], str | None],
    ) -> None:
        super().__init__(configuration)
        self._contact, self._find_token = contact, find_token

    def send(self, method: str, path: str, **parts: Any) -> urllib3.BaseHTTPResponse:
        if not self._contact.has_answered:
            self.configuration.access_token = self._find_token()
            timeout = parts.get("timeout")
            if isinstance(timeout, tuple):
                answer_s = min(timeout[1], self._contact.answer_s)
                parts["timeout"] = (timeout[0], answer_s)
        response = super().send(method, path, **parts)
        if is_of_proctor(response.headers):
            self._contact.has_answered = True
        return response


class Connection:
    """The control plane at `url`, and the data planes at the endpoints of runs.

    credential: whose token is sent to both; a text is a token. requests: how many may
    be made at a time.
    Raises ValueError if `url` or the token cannot be used, or the environment names a
    proxy or certificates that cannot be. Nothing is sent yet.
    """

    def __init__(
        self, url: str, credential: Credential | str | None, *, requests: int
    ) -> None:
        self.url = check_base_url(url)
        if not isinstance(credential, Credential):
            credential = Credential.of_text(self.url, credential or "")
        self.credential = credential
        self._requests = requests
        self.contact = Contact()
        self._clients: dict[str, ApiClient] = {}
        self._planes: list[DataPlane] = []
        self.control = ControlApi(self._client(self.url))

    def retry_policy(
        self,
        stop: threading.Event,
        report_waiting: Callable[[str | None], None],
        given_s: float | None,
        first_s: float = FIRST_CONTACT_S,
    ) -> RetryPolicy:
        """The retry policy of requests to this server.

        given_s: the limit that a user gives, which holds from the first contact.
        first_s: that of the first contact without it.
        """
        if given_s is not None:
            self.contact.answer_s = min(max(given_s, FIRST_ANSWER_S), TIMEOUTS_S[1])
        return RetryPolicy(
            self.url,
            RETRY_TIMEOUT_S if given_s is None else given_s,
            stop,
            report_waiting,
            first_s=first_s if given_s is None else given_s,
            explain=self.explain,
            contact=self.contact,
        )

    def data(self, endpoint: str) -> DataPlane:
        """The data plane at a run's `endpoint`, for one worker.

        Raises ProctorError: `not_trusted` if the token would be sent unencrypted,
        `bad_answer` if the endpoint is not a URL, `unreachable` if the environment
        names a proxy for it that cannot be used.
        """
        try:
            endpoint = check_base_url(endpoint)
        except ValueError as error:
            raise ProctorError(
                BAD_ANSWER,
                f"{self.url} named an endpoint of the run that cannot be used: "
                f"{error}. Ask the operator to set the server's public URL.",
            ) from error
        if self.url.startswith("https:") and not endpoint.startswith("https:"):
            raise ProctorError(
                NOT_TRUSTED,
                f"The data endpoint {endpoint} of {self.url} is not HTTPS; refusing to "
                "send the token. Ask the operator to set the server's public URL.",
            )
        headers = {"User-Agent": USER_AGENT, "Proctor-Version": PROTOCOL_VERSION}
        if (token := self._find_token()) is not None:
            headers["Authorization"] = f"Bearer {token}"
        try:
            client = self._client(endpoint)
            check = self._check_of(endpoint)
            plane = DataPlane(
                endpoint, client, headers, TIMEOUTS_S, token=token, check=check
            )
        except BadProxy as error:
            text = f"{endpoint}, the endpoint of the run, is unreachable: {error}."
            raise ProctorError(UNREACHABLE, text) from error
        self._planes.append(plane)
        return plane

    def explain(self, error: ProctorError) -> ProctorError:
        """The error; one of a token says where that is from and how to get another."""
        if error.code != "unauthenticated":
            return error
        advice = self.credential.explain_refusal(has_accounts=self.has_accounts())
        return error.explained(advice)

    def has_accounts(self) -> bool:
        """Whether people register at the server; False if it does not say so soon."""
        try:
            service = self.control.describe_service(_request_timeout=_EXPLAIN_S)
        except FAILURES:
            return False
        return "hosting" in service.profiles

    def close(self) -> None:
        for plane in self._planes:
            plane.close()
        for client in self._clients.values():
            client.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def _find_token(self) -> str | None:
        """The token: looked up until the server answers, and the same from then on."""
        if not self.contact.has_answered:
            self.credential = self.credential.looked_up_again()
        return self.credential.token

    def _client(self, host: str) -> ApiClient:
        if host not in self._clients:
            configuration = Configuration(
                host=host,
                access_token=self.credential.token,
                connection_pool_maxsize=self._requests,
                # Retries are decided in retry_policy.py only.
                retries=False,
                ssl_context=client_context() if host.startswith("https:") else None,
                proxy_ssl_context=proxy_context(host),
            )
            client = _ContactingClient(configuration, self.contact, self._find_token)
            client.pool_manager.pool_classes_by_scheme = {
                **client.pool_manager.pool_classes_by_scheme,
                "http": _checked_pool(self._check_of(host)),
            }
            client.default_headers |= {
                "User-Agent": USER_AGENT,
                "Proctor-Version": PROTOCOL_VERSION,
            }
            self._clients[host] = client
        return self._clients[host]

    def _check_of(self, endpoint: str) -> Callable[[socket.socket], None]:
        """The check of a new connection; the server vouches for other places."""
        own, other = urlsplit(self.url), urlsplit(endpoint)
        is_own = own.netloc == other.netloc or (
            own.port == other.port and is_this_machine(other.hostname or "")
        )
        return self._check_connection if is_own else accept_all

    def _check_connection(self, connected: socket.socket) -> None:
        self.credential.check_connection(connected)


def _checked_pool(
    check: Callable[[socket.socket], None],
) -> type[urllib3.HTTPConnectionPool]:
    """Connections on which nothing is sent where `check` raises."""

    class Checked(HttpConnection):
        def connect(self) -> None:
            super().connect()
            assert self.sock is not None
            check(self.sock)

    class CheckedPool(urllib3.HTTPConnectionPool):
        ConnectionCls = Checked

    return CheckedPool
