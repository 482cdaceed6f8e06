"""How a server is reached: its URL, the token, certificates, proxies.

Generated from spec/openapi.yaml by `make generate`; never edited by hand.
"""

from __future__ import annotations

import ssl
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any
from urllib.parse import urlsplit
from urllib.request import getproxies, proxy_bypass

import urllib3


@dataclass
class Configuration:
    """The settings of an ApiClient.

    host: base URL of the control plane, or of a run's data plane (`run.endpoint`).
    access_token: bearer token, sent with every request.
    retries: how often urllib3 repeats a request without an answer, or urllib3's Retry.
        None: urllib3's default. False: the caller repeats.
    connection_pool_maxsize: how many connections stay open.
    verify_ssl: whether the server's certificate is checked.
    ssl_ca_cert, ca_cert_data: a file, or PEM text, of the authorities to trust.
    cert_file, key_file: the client's own certificate.
    assert_hostname: the name in the certificate, or False for any.
    tls_server_name: the name sent in the TLS handshake.
    ssl_context: a context to use instead of the settings above.
    proxy: URL of a proxy. None: the proxy that the environment names (HTTPS_PROXY,
        NO_PROXY). Empty text: no proxy. SOCKS needs the package PySocks.
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
        proxy = _environment_proxy(self.host) if self.proxy is None else self.proxy
        if not proxy:
            return urllib3.PoolManager(**options)
        if proxy.startswith("socks"):
            from urllib3.contrib.socks import SOCKSProxyManager

            return SOCKSProxyManager(proxy, headers=self.proxy_headers, **options)
        return urllib3.ProxyManager(
            proxy,
            proxy_headers=self.proxy_headers,
            proxy_ssl_context=self.proxy_ssl_context,
            **options,
        )


def _environment_proxy(host: str) -> str | None:
    parts, proxies = urlsplit(host), getproxies()
    if proxy_bypass(parts.netloc.rpartition("@")[2]):
        return None
    return proxies.get(parts.scheme) or proxies.get("all")
