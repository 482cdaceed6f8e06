"""The base URL of a server, checked before use; no text repeats a secret."""

from __future__ import annotations

import re
from ipaddress import AddressValueError, IPv6Address
from urllib.parse import urljoin, urlsplit

from .copied_text import trim

_EXAMPLE = "http://127.0.0.1:8460 or https://robots.example/path"


def check_base_url(url: str) -> str:
    """The base URL without spaces around it and a slash at its end.

    Raises ValueError, whose text says what is wrong.
    """
    text = trim(url).rstrip("/")
    scheme, separator, rest = text.partition("://")
    if scheme.lower() not in ("http", "https") or not separator:
        raise ValueError(f"url must be like {_EXAMPLE}, with its http:// or https://")
    place = re.split(r"[/?#]", rest, maxsplit=1)[0]
    if "@" in place:
        raise ValueError(
            "url must not have a user and a password (USER:PASSWORD@), which no "
            "request would carry: a server is given a token"
        )
    fault = _fault_of_host(place) or _fault_behind_host(text)
    if fault:
        raise ValueError(f"url {fault}")
    return text


def url_of_host(host: str | None, port: int | None) -> str:
    """The base URL of a server at a host and a port."""
    name = trim(host or "127.0.0.1")
    is_bare_ipv6 = ":" in name and not name.startswith("[")
    return f"http://{f'[{name}]' if is_bare_ipv6 else name}:{port or 8460}"


def place_of_redirection(url: str, location: str) -> tuple[str, bool]:
    """The address that an answer of the server at a base URL points to.

    The base URL of a server, and True, if it is another one of the same interface.
    """
    place = urljoin(f"{url}/", location)
    base = re.fullmatch(r"(https?://[^/?#]+.*?)/v1(?:[/?#].*)?", place)
    return (base[1], True) if base and base[1] != url else (place, False)


def without_user(url: str) -> str:
    """The URL without a user and a password in it."""
    return re.sub(r"(?<=://)[^/?#]*@", "", url)


def _fault_of_host(place: str) -> str | None:
    """The fault of the part HOST:PORT of a URL."""
    if "%" in place:
        return (
            "names a network interface (a zone id, behind %), which only this machine "
            "knows: use another address or the name of the server"
        )
    if place.count(":") > 1 and not place.startswith("["):
        return "has an IPv6 address without brackets: write http://[::1]:8460"
    if place.startswith("["):
        try:
            address = IPv6Address(place[1:].partition("]")[0])
        except AddressValueError:
            return "has an invalid IPv6 address in its brackets"
        if address.is_link_local:
            return (
                "has a link-local address (fe80::), which is of one network interface, "
                "and a URL names none: use another address or the name of the server"
            )
    try:
        host, _ = (parts := urlsplit(f"http://{place}")).hostname or "", parts.port
    except ValueError:
        return "has an invalid port: it is a number up to 65535"
    return None if _is_host(host) else "has a host that is not a name or an address"


def _is_host(host: str) -> bool:
    try:
        host.encode("ascii" if host.isascii() else "idna")
    except UnicodeError:
        return False
    return re.fullmatch(r"[^\s\x00-\x20\x7f]+", host) is not None


def _fault_behind_host(url: str) -> str | None:
    if "?" in url or "#" in url:
        return "ends with a query: give the part before the ? or #"
    if re.search(r"[\s\x00-\x20\x7f]", url):
        return "has a space or an invisible character in it"
    return None
