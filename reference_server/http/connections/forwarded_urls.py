"""The base URL at which a client reached the server, for `run.endpoint`.

A proxy that serves the server under a path of its own, or over TLS, says so in headers.
Only those of a trusted proxy count: any other client could name another server.
"""

from __future__ import annotations

import re
from functools import lru_cache
from ipaddress import ip_address

from starlette.requests import Request

from reference_server.settings.allowed_hosts import ANY_HOST
from reference_server.settings.allowed_networks import AllowedNetworks

# The path under which a proxy serves this server, without characters that would have
# to be quoted in a URL.
_PREFIX = re.compile(r"(/(?!\.\.?(/|$))[A-Za-z0-9._~-]{1,64}){1,16}")


def base_url_of(request: Request, trusted_proxies: str) -> str:
    """The URL without a slash at its end. Refuses a malformed header Host."""
    if host := request.headers.get("host"):
        ANY_HOST.check(host)
        url = f"{request.scope['scheme']}://{host}"
    else:
        url = str(request.base_url).rstrip("/")
    peer = request.client.host if request.client else ""
    if not _is_trusted(peer, trusted_proxies):
        return url
    prefix = request.headers.get("x-forwarded-prefix", "").rstrip("/")
    if _PREFIX.fullmatch(prefix):
        url += prefix
    # A chain of proxies lists the scheme of the client first.
    scheme = request.headers.get("x-forwarded-proto", "").partition(",")[0].strip()
    if scheme in ("http", "https"):
        url = f"{scheme}://{url.partition('://')[2]}"
    return url


@lru_cache(maxsize=256)
def _is_trusted(peer: str, trusted_proxies: str) -> bool:
    networks = AllowedNetworks.parse(trusted_proxies)
    if networks.all_addresses:
        return True
    try:
        address = ip_address(peer)
    except ValueError:  # no address, as of a socket in a file
        return False
    return networks.contains_any({getattr(address, "ipv4_mapped", None) or address})
