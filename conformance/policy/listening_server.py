"""An HTTP server of the kit at an address of this machine, of IPv4 or IPv6."""

import socket
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer

from conformance.client.connections.loopback import in_url


class ListeningServer(ThreadingHTTPServer):
    """Listens at a free port of a host; `origin` is the URL without a path."""

    daemon_threads = True

    def __init__(self, host: str, handler: type[BaseHTTPRequestHandler]) -> None:
        is_ipv6 = ":" in host
        self.address_family = socket.AF_INET6 if is_ipv6 else socket.AF_INET
        super().__init__((host, 0), handler)
        self.origin = f"http://{in_url(host)}:{self.server_port}"
