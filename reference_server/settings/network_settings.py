"""Where the server listens, who may call it, and how much one caller may send."""

from __future__ import annotations

from pydantic import BaseModel, Field, field_validator

from reference_server.settings.allowed_hosts import AllowedHosts
from reference_server.settings.allowed_networks import AllowedNetworks


class NetworkSettings(BaseModel):
    """Settings of the listener, of who may call, and of how much a caller may send."""

    host: str = Field("127.0.0.1", min_length=1, description="Address to listen on.")
    port: int = Field(
        8460, ge=0, le=65535, description="Port to listen on; 0 chooses a free port."
    )
    public_url: str = Field(
        "",
        pattern=r"^(https?://[^\s?#]+)?$",  # RUN-033
        description="Base URL at which clients reach this server, used in "
        "run.endpoint; it begins with http:// or https://. If empty, it is taken from "
        "each request.",
    )
    trusted_proxies: str = Field(
        "127.0.0.1,::1",
        description="Networks of the proxies whose headers X-Forwarded-Prefix and "
        "X-Forwarded-Proto are used in run.endpoint, comma-separated; all trusts every "
        "client. Of no effect with public_url.",
    )
    allowed_hosts: str = Field(
        "",
        description="Names that a request may have in its header Host, "
        "comma-separated and without ports, for example eval.example.org or "
        "*.example.org; localhost and loopback addresses are always allowed. If empty, "
        "any.",
    )
    account_service: str = Field(
        "",
        max_length=100,
        description="Unix socket of a program of this machine that keeps accounts, as "
        "`proctor-host` does. Its keys are accepted beside the tokens of this server, "
        "it admits their runs, and requests below /v1/hosting and /hosting are passed "
        "on to it. If empty, there is none.",
    )
    wait_s_max: int = Field(
        30, ge=0, le=600, description="Maximum wait of a long-poll, in seconds."
    )
    max_body_bytes: int = Field(
        8 * 2**20, ge=2**16, description="Maximum size of a request body."
    )
    max_control_body_bytes: int = Field(
        2**16,
        ge=2**16,
        description="Maximum size of the body of a request of this protocol that is no "
        "predict.",
    )
    max_connections: int = Field(
        2000,
        ge=16,
        description="Maximum open connections of clients; fewer if the limit of open "
        "files is too low.",
    )
    max_connections_per_address: int = Field(
        1500,
        ge=1,
        description="Maximum open connections of one client address (of IPv6, a /64 "
        "network), at most three quarters of all. Behind a proxy all clients have its "
        "address.",
    )
    max_event_streams: int = Field(
        100,
        ge=1,
        description="Maximum open streams of events of one run; one account may have "
        "four times as many.",
    )
    request_timeout_s: float = Field(
        10.0,
        ge=0.1,
        le=600,
        description="Maximum time for the headers of a request; its body, and an "
        "answer that is slowly read, may take as long and 1 s more per 16 KiB.",
    )

    @field_validator("allowed_hosts")
    @classmethod
    def _check_hosts(cls, text: str) -> str:
        AllowedHosts.parse(text)  # raises ValueError
        return text

    @field_validator("trusted_proxies")
    @classmethod
    def _check_proxies(cls, text: str) -> str:
        AllowedNetworks.parse(text)  # raises ValueError
        return text

    @property
    def hosts(self) -> AllowedHosts:
        """The names that a request may have in its header Host."""
        return AllowedHosts.parse(self.allowed_hosts)

    @property
    def host_name(self) -> str:
        """The name of this host in records."""
        return self.public_url or self.host
