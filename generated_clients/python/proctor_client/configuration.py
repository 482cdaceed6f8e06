"""How a server is reached: its URL, the token, certificates, proxies.

Written by hand, beside what is generated from the specification.
"""

from __future__ import annotations

import ssl
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import urllib3

from .interim_answers import past_interim_answers
from .transport.copied_text import read_token
from .transport.proxy_route import ProxyRoute, find_route, proxy_of
from .transport.server_address import check_base_url


@dataclass
class Configuration:
    """The settings of an ApiClient.

    host: base URL of the control plane, or of a run's data plane (`run.endpoint`).
    access_token: bearer token, sent with every request. Spaces, quotes and a newline
        around it are dropped; BadToken, a ValueError, if a header cannot carry it.
    retries: how often urllib3 repeats a request without an answer, or urllib3's Retry.
        None: urllib3's default. False: the caller repeats.
    connection_pool_maxsize: how many connections stay open.
    verify_ssl: whether the server's certificate is checked.
    ssl_ca_cert, ca_cert_data: a file, or PEM text, of the authorities to trust.
    cert_file, key_file: the client's own certificate.
    assert_hostname: the name in the certificate, or False for any.
    tls_server_name: the name sent in the TLS handshake.
    ssl_context: a context to use instead of the settings above.
    proxy: URL of a proxy. None: as transport/proxy_route.py finds it in the environment. Empty
        text: no proxy. A SOCKS proxy can be given here only; it needs PySocks.
    proxy_headers, proxy_ssl_context: for the connection to the proxy itself.
    socket_options: as urllib3 takes them.
    """

    host: str = "http://127.0.0.1:8460"
    access_token: str | None = None
    retries: int | bool | urllib3.Retry | None = None
    connection_pool_maxsize: int = 10
    verify_ssl: bool = True
    ssl_ca_cert: str | None = None
    ca_cert_data: str | bytes | None = None
    cert_file: str | None = None
    key_file: str | None = None
    assert_hostname: str | bool | None = None
    tls_server_name: str | None = None
    ssl_context: ssl.SSLContext | None = None
    proxy: str | None = None
    proxy_headers: Mapping[str, str] | None = None
    proxy_ssl_context: ssl.SSLContext | None = None
    socket_options: list[tuple[int, int, int]] | None = None

    def __post_init__(self) -> None:
        self.host = check_base_url(self.host)
        self.access_token = read_token(self.access_token or "", "access_token")

    def pool_manager(self) -> urllib3.PoolManager:
        """The connections with these settings; none is opened yet."""
        named: dict[str, Any] = {
            "ssl_context": self.ssl_context,
            "ca_certs": self.ssl_ca_cert,
            "ca_cert_data": self.ca_cert_data,
            "cert_file": self.cert_file,
            "key_file": self.key_file,
            "assert_hostname": self.assert_hostname,
            "server_hostname": self.tls_server_name,
            "retries": self.retries,
            "socket_options": self.socket_options,
        }
        options = {name: value for name, value in named.items() if value is not None}
        options["maxsize"] = self.connection_pool_maxsize
        if self.ssl_context is None:
            options["cert_reqs"] = "CERT_REQUIRED" if self.verify_ssl else "CERT_NONE"
        if self.proxy and self.proxy.lower().startswith("socks"):
            from urllib3.contrib.socks import SOCKSProxyManager

            return SOCKSProxyManager(self.proxy, headers=self.proxy_headers, **options)
        route = self.route()
        if not route.url:
            return past_interim_answers(urllib3.PoolManager(**options))
        manager = urllib3.ProxyManager(
            route.url,
            proxy_headers=dict(route.headers) | dict(self.proxy_headers or {}),
            proxy_ssl_context=self.proxy_ssl_context,
            **options,
        )
        return past_interim_answers(manager)

    def route(self) -> ProxyRoute:
        """How the server is reached. Raises BadProxy, a ValueError."""
        if self.proxy is None:
            return find_route(self.host)
        return proxy_of("proxy", self.proxy) if self.proxy else ProxyRoute()
