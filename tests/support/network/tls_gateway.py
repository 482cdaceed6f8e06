"""Servers that speak TLS, and a gateway that stands before another server."""

import contextlib
from collections.abc import Iterator
from pathlib import Path

import httpx

from tests.support.kit.null_servers import Behaviour, Reply, Request, run_server
from tests.support.server.certificates import create_certificate


def gateway_to(upstream: str) -> Behaviour:
    """Pass requests on, but for DELETE, to a server that does not know of it."""

    def pass_on(request: Request) -> Reply:
        if request.method == "DELETE":
            return 501, {}, b""
        sent = httpx.request(
            request.method,
            f"{upstream}{request.path}",
            headers=dict(request.headers),
            content=request.body,
            trust_env=False,
        )
        kept = ("Content-Type", "Proctor-Version")
        return sent.status_code, {n: sent.headers[n] for n in kept}, sent.content

    return pass_on


@contextlib.contextmanager
def serve_tls(
    folder: Path, behaviour: Behaviour, name: str = "localhost"
) -> Iterator[tuple[str, Path]]:
    """A server for a name that no authority knows: its URL and certificate."""
    pem, context = create_certificate(folder, name)
    with run_server(behaviour, context) as url:
        yield url.replace("http://127.0.0.1", f"https://{name}"), pem
