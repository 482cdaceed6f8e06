"""How the server of a URL is reached: directly, or through a proxy.

One place decides it, for every connection. PROCTOR_PROXY names a proxy for all servers,
or is `none`. Without it the usual variables decide (http_proxy, https_proxy, all_proxy,
in lower or upper case), or the system's settings, but never for this machine or for
what NO_PROXY lists. Nothing here is sent, and no text has a password.
"""

from __future__ import annotations

import base64
import os
import re
import socket
import sys
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from fnmatch import fnmatchcase
from ipaddress import ip_address, ip_network
from typing import Any
from urllib.parse import SplitResult, unquote, urlsplit
from urllib.request import getproxies, proxy_bypass

from .copied_text import EmptyVariable, read_variable

OVERRIDE = "PROCTOR_PROXY"
_SYSTEM = "the system's settings"
_PORTS = {"http": 80, "https": 443}
_ANY_PORT = 9
_OF_LISTENERS = (
    "each machine takes this address for itself: from another one, name the machine of "
    "the server"
)
_AROUND = " \t\r\n\"'\ufeff\u200b\u00a0"
_EXAMPLE = "it must be like http://HOST:PORT or http://USER:PASSWORD@HOST:PORT"


class BadProxy(ValueError):
    """A proxy cannot be used; the text names the variable, and has no secret."""


class ProxyFault(OSError):
    """The proxy opened no way to the server, which got no request.

    status, phrase, challenges: of its refusal of a tunnel, with Proxy-Authenticate; 0
    and empty where it gave no answer.
    """

    def __init__(
        self, reason: str, status: int = 0, challenges: Sequence[str] = ()
    ) -> None:
        super().__init__(reason)
        self.status, self.phrase, self.challenges = status, reason, challenges


@dataclass(frozen=True)
class ProxyRoute:
    """How a server is reached.

    url: of the proxy, without its user and password; empty for a direct connection.
    variable: the environment variable that names the proxy; or the one that decided
        for a direct connection, if there is one.
    headers: what the proxy is sent; secret.
    how, advice: in words for an error, how the server was to be reached, and what
        changes that. Empty where neither a proxy nor another address can matter.
    """

    url: str = ""
    variable: str = ""
    headers: Mapping[str, str] = field(default_factory=dict, repr=False)
    how: str = ""
    advice: str = ""


def find_route(url: str) -> ProxyRoute:
    """Find how the server of a URL is reached. Raises BadProxy."""
    parts = urlsplit(url)
    host = (parts.hostname or "").rstrip(".")
    try:
        override = (read_variable(OVERRIDE) or "").strip(_AROUND)
    except EmptyVariable as error:
        raise BadProxy(str(error)) from None
    if override.lower() == "none":
        return _directly(OVERRIDE, f"{OVERRIDE} is none", f"unset {OVERRIDE}")
    if override:
        return proxy_of(OVERRIDE, override, f"{OVERRIDE}=none goes past it")
    variable, proxy = _find_variable(parts.scheme)
    if not proxy:
        return _without_variable(parts.scheme, host)
    if is_this_machine(host):
        why = f"{variable} is not for addresses of this machine"
        return _directly(variable, why, f"{OVERRIDE}=URL names a proxy for these, too")
    listed = _exclusion(variable, host, parts)
    if listed:
        return _directly(listed, f"{listed} excludes this host", f"change {listed}")
    return proxy_of(variable, proxy, f"NO_PROXY={host} goes past it")


def _without_variable(scheme: str, host: str) -> ProxyRoute:
    if is_this_machine(host):
        every = ("0.0.0.0", "::")  # noqa: S104
        return ProxyRoute(advice=_OF_LISTENERS if host in every else "")
    advice = f"{scheme}_proxy=URL names one, if one is needed"
    return _directly("", "no proxy is set", advice)


def proxy_of(variable: str, value: str, advice: str = "") -> ProxyRoute:
    """Read the URL of a proxy; http:// may be missing. Raises BadProxy."""
    text = value.strip(_AROUND)
    scheme, separator, rest = text.partition("://")
    scheme = scheme.lower() if separator else "http"
    if scheme.startswith("socks"):
        way_past = f"; {advice}" if advice else ""
        raise BadProxy(
            f"{variable} names a SOCKS proxy, which cannot be used here: name an HTTP "
            f"proxy instead{way_past}"
        )
    if scheme not in _PORTS:
        raise BadProxy(f"{variable} is not the URL of a proxy: {_EXAMPLE}")
    try:
        parts = urlsplit(f"{scheme}://{rest if separator else text}")
        host, port = parts.hostname, parts.port or _PORTS[scheme]
        is_host = bool(host) and re.fullmatch(r"[^\s%?#]+", host or "") is not None
        is_plain = parts.path in ("", "/") and not (parts.query or parts.fragment)
    except ValueError:
        is_host = is_plain = False
    if not (is_host and is_plain):
        raise BadProxy(
            f"{variable} is not the URL of a proxy: {_EXAMPLE}; in a password, write "
            "characters such as # / @ as %23 %2F %40"
        )
    place = f"[{host}]" if ":" in str(host) else host
    shown = f"{scheme}://{place}:{port}"
    how = f"through the proxy {shown} of {variable}"
    return ProxyRoute(shown, variable, _authorization(parts), how, advice)


def is_this_machine(host: str) -> bool:
    """Say whether a host is an address or the name of this machine."""
    host = host.lower().rstrip(".")
    try:
        address = ip_address(host)
    except ValueError:
        name = socket.gethostname().lower()
        own = name.partition(".")[0]
        if host in ("localhost", name, own) or host.endswith(".localhost"):
            return True
        return host.partition(".")[0] == own and has_own_addresses(host)
    return has_own_addresses(str(address))


def has_own_addresses(host: str) -> bool:
    """Say whether a host has addresses, and each of them is of this machine."""
    try:
        found = socket.getaddrinfo(host, _ANY_PORT, type=socket.SOCK_DGRAM)
        return all(_is_own(family, place) for family, _, _, _, place in found)
    except (OSError, UnicodeError):  # no such name, or no way there
        return False


def _is_own(family: int, place: tuple[Any, ...]) -> bool:
    address = ip_address(place[0])
    address = getattr(address, "ipv4_mapped", None) or address
    if address.is_loopback or address.is_unspecified:
        return True
    # Who sends to an address of its own does so from that address. Nothing is sent.
    with socket.socket(family, socket.SOCK_DGRAM) as sender:
        sender.connect(place)
        return bool(sender.getsockname()[0] == place[0])


def _directly(variable: str, why: str, advice: str) -> ProxyRoute:
    return ProxyRoute(variable=variable, how=f"without a proxy: {why}", advice=advice)


def _find_variable(scheme: str) -> tuple[str, str]:
    """The first variable that names a proxy for this scheme, and its value."""
    for lower in (f"{scheme}_proxy", "all_proxy"):
        for name in (lower, lower.upper()):
            # A CGI program is sent the header `Proxy` of its caller as HTTP_PROXY.
            if name == "HTTP_PROXY" and "REQUEST_METHOD" in os.environ:
                continue
            if name in os.environ:
                if value := os.environ[name].strip(_AROUND):
                    return name, value
                break  # lower case wins, also when it is empty
    # Elsewhere `getproxies` reads only the environment, and fails where another thread
    # writes there meanwhile.
    has_settings = sys.platform in ("darwin", "win32")
    system = getproxies() if has_settings and not _has_variables() else {}
    return _SYSTEM, system.get(scheme) or system.get("all") or ""


def _has_variables() -> bool:
    return any(name.lower().endswith("_proxy") for name in os.environ)


def _exclusion(variable: str, host: str, parts: SplitResult) -> str:
    """The variable that excludes a host from proxies, if one does. Raises BadProxy."""
    if variable == _SYSTEM:
        return _SYSTEM if proxy_bypass(parts.netloc.rpartition("@")[2]) else ""
    name = "no_proxy" if "no_proxy" in os.environ else "NO_PROXY"
    port = parts.port or _PORTS.get(parts.scheme, 0)
    for entry in re.split(r"[,\s]+", os.environ.get(name, "").strip(_AROUND)):
        if entry and _excludes(entry.lower(), host.lower(), port, name):
            return name
    return ""


def _excludes(entry: str, host: str, port: int, variable: str) -> bool:
    if "/" in entry:
        try:
            network = ip_network(entry, strict=False)
        except ValueError as error:
            raise BadProxy(
                f"{variable} has the entry {entry!r:.60}, which is neither a host nor "
                "a network such as 10.0.0.0/8"
            ) from error
        try:
            return ip_address(host) in network
        except ValueError:
            return False  # names are not looked up: the proxy may know others
    if match := re.fullmatch(r"\[(.+)\](?::(\d+))?|([^:]+):(\d+)", entry):
        entry, wanted = match[1] or match[3], match[2] or match[4]
        if wanted and int(wanted) != port:
            return False
    try:
        return ip_address(entry) == ip_address(host)
    except ValueError:
        pass
    entry = entry.removeprefix(".")
    if "*" in entry:
        return fnmatchcase(host, entry)
    return host == entry or host.endswith(f".{entry}")


def _authorization(parts: SplitResult) -> Mapping[str, str]:
    if parts.username is None:
        return {}
    pair = f"{unquote(parts.username)}:{unquote(parts.password or '')}"
    return {"Proxy-Authorization": f"Basic {base64.b64encode(pair.encode()).decode()}"}
