"""A server that answers with success what is not the message that was asked for.

Every GET is redirected first. It lists runs rightly; each of them, asked for alone, is
answered in another wrong way. It knows nothing of the protocol but two paths: what is
right comes from another server.
"""

import json
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from http.server import BaseHTTPRequestHandler
from typing import Any

import msgspec

from tests.support.network.tls_gateway import serve_plainly

JSON, MSGPACK = "application/json", "application/msgpack"
MOVED = "/moved"


def answers(run: Mapping[str, Any]) -> dict[str, tuple[str, bytes]]:
    """Name → media type and body, each wrong where `run` is right."""
    without_progress = {name: run[name] for name in run if name != "progress"}
    texts = {
        "empty": "{}",
        "html": "<html>",
        "list": "[]",
        "missing": json.dumps(without_progress),
        "nothing": "",
        "null": "null",
        "wrong_type": json.dumps({**run, "progress": "half"}),
        "wrong_type_inside": json.dumps(
            {**run, "progress": {**run["progress"], "episodes_total": "eight"}}
        ),
    }
    packed = msgspec.msgpack.encode
    return {name: (JSON, text.encode()) for name, text in texts.items()} | {
        "msgpack_empty": (MSGPACK, packed({})),
        "msgpack_wrong_type": (MSGPACK, packed({**run, "progress": "half"})),
    }


@contextmanager
def wrong_answers(page: Mapping[str, Any]) -> Iterator[str]:
    """The URL of such a server. page: a RunList with a run at least."""
    run = page["runs"][0]
    wrong = answers(run)
    listed = {**page, "runs": [{**run, "run_id": name} for name in wrong]}
    right = {"/v1/runs": (JSON, json.dumps(listed).encode())}

    class Handler(BaseHTTPRequestHandler):
        protocol_version = "HTTP/1.1"

        def do_GET(self) -> None:
            path = self.path.partition("?")[0]
            if not path.startswith(MOVED):
                self.send_response_only(307)
                self.send_header("Location", MOVED + self.path)
                self.send_header("Content-Length", "0")
                self.end_headers()
                return
            path = path.removeprefix(MOVED)
            given = right.get(path) or wrong[path.rpartition("/")[2]]
            media_type, body = given
            self.send_response_only(200)
            self.send_header("Content-Type", media_type)
            self.send_header("Content-Length", str(len(body)))
            self.end_headers()
            self.wfile.write(body)

        def log_message(self, format: str, *arguments: object) -> None:  # noqa: A002
            """Requests are not logged."""

    with serve_plainly(Handler) as url:
        yield url
