"""A policy server of the standard library, for sandboxes: `python main.py [BEHAVIOUR]`.

It answers with the lower bound of each action, and 1 for `end`. The file `behaviour`
beside it names what it does wrong: crash, silent, unanswered, late, memory, malformed.
With `steady` it takes its time until the episode is over, and numbers what it prints.
"""

import itertools
import json
import os
import socketserver
import sys
import time
from http.server import BaseHTTPRequestHandler
from pathlib import Path
from typing import Any

FILE = Path(__file__).with_name("behaviour")
BEHAVIOUR = FILE.read_text().strip() if FILE.exists() else ""
SPACES: dict[str, dict[str, Any]] = {}
PRINTED = itertools.count()


class Handler(BaseHTTPRequestHandler):
    """The operations of policy.yaml."""

    protocol_version = "HTTP/1.1"

    def do_GET(self) -> None:
        if BEHAVIOUR == "unanswered":
            time.sleep(60)
        protocol = {"min": "1.0", "max": "1.0"}
        self.answer({"name": "python", "protocol": protocol, "max_sessions": 1})

    def do_POST(self) -> None:
        body = json.loads(self.rfile.read(int(self.headers["Content-Length"])))
        if self.path.endswith("/reset"):
            SPACES[body["session_id"]] = body["benchmark"]["action_space"]
            episode = body["episode"]
            self.answer(
                {
                    "session_id": body["session_id"],
                    "episode_id": episode["episode_id"],
                    "attempt": episode["attempt"],
                }
            )
            return
        is_steady = BEHAVIOUR == "steady"
        text = f"line {next(PRINTED)}" if is_steady else f"predict {body['seq']}"
        sys.stdout.write(text + "\n")
        sys.stdout.flush()
        if is_steady:
            time.sleep(0.2)
        if BEHAVIOUR == "crash":
            sys.stderr.write("Traceback (most recent call last):\n")
            sys.stderr.write("ValueError: the weights are missing\n")
            os._exit(3)
        if BEHAVIOUR == "late":
            time.sleep(3)
        if BEHAVIOUR == "memory":
            taken = []
            while True:
                taken.append(bytearray(b"x" * 2**24))
        values = {
            name: space.get("minimum") or [0.0] * space["size"]
            for name, space in SPACES[body["session_id"]].items()
        }
        if BEHAVIOUR == "numpy":
            import numpy as np

            sys.stdout.write(f"numpy {np.__version__}\n")
            arrays = {name: np.asarray(v) for name, v in values.items()}
            values = {name: (a @ np.eye(len(a))).tolist() for name, a in arrays.items()}
        values["end"] = [float(not is_steady)]
        actions = [] if BEHAVIOUR == "malformed" else [{"values": values}]
        self.answer(
            {
                "session_id": body["session_id"],
                "seq": body["seq"] + 1,
                "actions": actions,
            }
        )

    def answer(self, body: dict[str, Any]) -> None:
        content = json.dumps(body).encode()
        self.send_response(200)
        self.send_header("Content-Type", "application/json")
        self.send_header("Content-Length", str(len(content)))
        self.end_headers()
        self.wfile.write(content)

    def log_message(self, *_: object) -> None:
        """Requests are not logged."""


class Server(socketserver.ThreadingMixIn, socketserver.UnixStreamServer):
    """One thread per connection."""

    daemon_threads = True


if __name__ == "__main__":
    if BEHAVIOUR == "silent":
        time.sleep(60)
    with Server(os.environ["PROCTOR_POLICY_SOCKET"], Handler) as server:
        server.serve_forever()
