"""The connections to one server: its control plane, and the data planes of runs."""

from __future__ import annotations

import importlib.metadata
from types import TracebackType
from typing import Self
from urllib.parse import urlsplit

from proctor_client import ApiClient, Configuration, ControlApi

from reference_client.errors import NOT_TRUSTED, ProctorError
from reference_client.generated.protocol_version import PROTOCOL_VERSION
from reference_client.protocol.data_plane import DataPlane
from reference_client.protocol.tls_context import client_context

USER_AGENT = f"proctor-reference-client/{importlib.metadata.version('proctor-eval')}"
# (connect, read). A turn may take longer: the repeated request waits for it (PRED-005).
TIMEOUTS_S = (5.0, 60.0)


class Connection:
    """The control plane at `url`, and the data planes at the endpoints of runs.

    token: bearer token, sent to both. requests: maximum of simultaneous requests.
    Raises ValueError if `url` is not an http or https URL, or certificates are named
    that cannot be read. Nothing is sent yet.
    """

    def __init__(self, url: str, token: str | None, *, requests: int) -> None:
        parts = urlsplit(url)
        if parts.scheme not in ("http", "https") or not parts.netloc:
            raise ValueError(f"url must be like http://127.0.0.1:8460, not {url!r}")
        self.url = url.rstrip("/")
        self._token = token
        self._requests = requests
        self._clients: dict[str, ApiClient] = {}
        self._planes: list[DataPlane] = []
        self.control = ControlApi(self._client(self.url))

    def data(self, endpoint: str) -> DataPlane:
        """The data plane at a run's `endpoint`, for one worker.

        Raises ProctorError `not_trusted` if the token would be sent unencrypted.
        """
        if self.url.startswith("https:") and not endpoint.startswith("https:"):
            raise ProctorError(
                NOT_TRUSTED,
                f"The data endpoint {endpoint} of {self.url} is not HTTPS; refusing to "
                "send the token. Ask the operator to set the server's public URL.",
            )
        headers = {"User-Agent": USER_AGENT, "Proctor-Version": PROTOCOL_VERSION}
        if self._token is not None:
            headers["Authorization"] = f"Bearer {self._token}"
        client = self._client(endpoint.rstrip("/"))
        plane = DataPlane(endpoint, client, headers, TIMEOUTS_S)
        self._planes.append(plane)
        return plane

    def close(self) -> None:
        for plane in self._planes:
            plane.close()
        for client in self._clients.values():
            client.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        self.close()

    def _client(self, host: str) -> ApiClient:
        if host not in self._clients:
            configuration = Configuration(
                host=host,
                access_token=self._token,
                connection_pool_maxsize=self._requests,
                # Retries are decided in retry_policy.py only.
                retries=False,
                ssl_context=client_context() if host.startswith("https:") else None,
            )
            client = ApiClient(configuration)
            client.default_headers |= {
                "User-Agent": USER_AGENT,
                "Proctor-Version": PROTOCOL_VERSION,
            }
            self._clients[host] = client
        return self._clients[host]
