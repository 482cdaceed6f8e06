"""A server that answers with success what is not the message that was asked for.

Every GET is redirected first. It lists runs rightly; each of them, asked for alone, is
answered in another wrong way. It knows nothing of the protocol but two paths: what is
right comes from another server.
"""

import json
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from typing import Any

import msgspec

from tests.support.kit.null_servers import Reply, Request, run_server

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

    def answer(request: Request) -> Reply:
        path = request.path.partition("?")[0]
        if not path.startswith(MOVED):
            return 307, {"Location": MOVED + request.path}, b""
        path = path.removeprefix(MOVED)
        media_type, body = right.get(path) or wrong[path.rpartition("/")[2]]
        return 200, {"Content-Type": media_type}, body

    with run_server(answer) as url:
        yield url
