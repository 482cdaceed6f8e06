"""Which certificates a server with TLS is checked against: one place for both planes.

Without any of the variables OpenSSL decides. This module sends nothing.
"""

from __future__ import annotations

import os
import ssl
from pathlib import Path

# The first one that is set names a file of certificates, or a folder of them.
VARIABLES = ("PROCTOR_CA", "SSL_CERT_FILE", "REQUESTS_CA_BUNDLE", "CURL_CA_BUNDLE")


def client_context() -> ssl.SSLContext:
    """Make a context that checks certificates and names; a bad file is a ValueError."""
    named = next((name for name in VARIABLES if os.environ.get(name)), None)
    if named in (None, "SSL_CERT_FILE"):  # OpenSSL's own, beside SSL_CERT_DIR
        return ssl.create_default_context()
    path = os.environ[named]
    try:
        if Path(path).is_dir():
            return ssl.create_default_context(capath=path)
        return ssl.create_default_context(cafile=path)
    except OSError as error:  # also ssl.SSLError
        raise ValueError(
            f"{named} names {path}, which has no certificates that can be read "
            f"({error.strerror or error})"
        ) from error
