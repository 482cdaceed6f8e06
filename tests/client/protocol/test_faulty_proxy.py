"""The proxy of these tests applies the faults that it is configured with."""

from __future__ import annotations

from collections import deque
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer

import httpx
import pytest

from tests.support.client.faulty_proxy import FaultyProxy, serve_in_thread


@pytest.mark.parametrize(
    ("fault", "arrives", "error"),
    [
        ("lose_request", 0, "without sending a response"),
        ("lose_answer", 1, "without sending a response"),
        ("cut_answer", 1, "without sending complete message body"),
    ],
)
def test_the_proxy_applies_its_faults(fault: str, arrives: int, error: str) -> None:
    arrived: list[str] = []

    class Upstream(BaseHTTPRequestHandler):
        def do_GET(self) -> None:
            arrived.append(self.path)
            self.send_response(200)
            self.send_header("Content-Length", "4")
            self.end_headers()
            self.wfile.write(b"true")

        def log_message(self, *_: object) -> None:
            pass

    with serve_in_thread(ThreadingHTTPServer(("127.0.0.1", 0), Upstream)) as upstream:
        upstream_url = f"http://127.0.0.1:{upstream.server_address[1]}"
        with serve_in_thread(FaultyProxy(upstream_url)) as proxy:
            proxy.faults["/x"] = deque([fault])
            with pytest.raises(httpx.RemoteProtocolError, match=error):
                get_x(proxy)
            assert len(arrived) == arrives
            assert get_x(proxy) == b"true"


def get_x(proxy: FaultyProxy) -> bytes:
    return httpx.get(f"{proxy.url}/x", trust_env=False).content
