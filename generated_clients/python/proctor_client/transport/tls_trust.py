"""Which certificates a server with TLS is checked against, and why one fails.

Without any of the variables OpenSSL decides. This module sends nothing.
"""

from __future__ import annotations

import os
import ssl
from datetime import UTC, datetime
from pathlib import Path

from .copied_text import read_variable
from .proxy_route import find_route

# The first one that is set names a file of certificates, or a folder of them.
VARIABLES = ("PROCTOR_CA", "SSL_CERT_FILE", "REQUESTS_CA_BUNDLE", "CURL_CA_BUNDLE")
# Codes of OpenSSL for a certificate.
_NOT_IN_TIME = (9, 10)
_OTHER_NAME = (62, 64)
_UNKNOWN_AUTHORITY = (2, 18, 19, 20, 21)
_AUTHORITY = (
    "name the file with the certificate of its authority: PROCTOR_CA, SSL_CERT_FILE or "
    "REQUESTS_CA_BUNDLE"
)


def _named() -> str | None:
    """The variable that names the certificates, if one does. Raises EmptyVariable."""
    if read_variable(VARIABLES[0]):
        return VARIABLES[0]
    return next((name for name in VARIABLES if os.environ.get(name)), None)


def client_context() -> ssl.SSLContext:
    """Make a context that checks certificates and names.

    A file that cannot be used is a ValueError, and so is an empty PROCTOR_CA.
    """
    named = _named()
    if named is None:
        return ssl.create_default_context()
    path = os.environ[named]
    try:
        if Path(path).is_dir() and named != "SSL_CERT_FILE":
            return ssl.create_default_context(capath=path)
        context = ssl.create_default_context(cafile=path)
    except OSError as error:  # also ssl.SSLError
        raise ValueError(
            f"{named} names {path}, which has no certificates that can be read "
            f"({error.strerror or error})"
        ) from error
    # OpenSSL reads its own variable, beside SSL_CERT_DIR, and is silent if it cannot.
    return ssl.create_default_context() if named == "SSL_CERT_FILE" else context


def proxy_context(url: str) -> ssl.SSLContext | None:
    """The context for the proxy of a server, if there is one and it speaks TLS."""
    is_secure = find_route(url).url.startswith("https:")
    return client_context() if is_secure else None


def certificate_cure(error: ssl.SSLCertVerificationError) -> str:
    """The sentence that follows the reason why a certificate is not accepted."""
    code = getattr(error, "verify_code", None)
    if code in _NOT_IN_TIME:
        now = datetime.now(UTC).strftime("%Y-%m-%d %H:%M UTC")
        return f"Its host has to renew it, unless this machine's clock is wrong ({now})"
    if code in _OTHER_NAME:
        return "Use a name in the URL that the certificate is for"
    if code in _UNKNOWN_AUTHORITY:
        named = _named()
        used = f"; {named}={os.environ[named]} does not have it" if named else ""
        return f"{_AUTHORITY[:1].upper()}{_AUTHORITY[1:]}{used}"
    return f"Correct the name in the URL, or {_AUTHORITY}"
