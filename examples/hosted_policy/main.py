"""A policy that a host plays in a sandbox: change `act`, and hand in this folder.

The host starts this file and calls it at the Unix socket that PROCTOR_POLICY_SOCKET
names, with the three operations of spec/policy.yaml. It needs Python alone; what it
prints is in the log of the submission.
"""

import json
import os
import socketserver
from http.server import BaseHTTPRequestHandler
from typing import Any

BENCHMARKS: dict[str, Any] = {}  # of each session: the description, with its spaces
ANSWERS: dict[str, Any] = {}  # the last of each session, for a repeat of its turn


def act(benchmark: dict[str, Any], turn: dict[str, Any]) -> dict[str, Any]:  # noqa: ARG001 - yours reads it
    """One action: a list of numbers for each name of the action space.

    turn["observation"]["state"] has the vectors, turn["episode"]["instruction"] says
    what is to be done.
    """
    spaces = benchmark["action_space"].items()
    return {name: space.get("minimum", [0.0] * space["size"]) for name, space in spaces}


class Handler(BaseHTTPRequestHandler):
    protocol_version = "HTTP/1.1"  # connections are kept

    def do_GET(self) -> None:  # describe_policy
        protocol = {"min": "1.0", "max": "1.0"}
        self.answer({"name": "example", "protocol": protocol, "max_sessions": 8})

    def do_POST(self) -> None:
        body = json.loads(self.rfile.read(int(self.headers["Content-Length"])))
        session_id = body["session_id"]
        if self.path.endswith("/reset"):
            episode = body["episode"]
            print(f"episode {episode['index']}: {episode['instruction']}", flush=True)
            BENCHMARKS[session_id] = body["benchmark"]
            ANSWERS.pop(session_id, None)
            names = {name: episode[name] for name in ("episode_id", "attempt")}
            self.answer({"session_id": session_id, **names})
            return
        seq = body["seq"] + 1  # the number of the turn that follows from the answer
        if ANSWERS.get(session_id, {}).get("seq") != seq:
            actions = [{"values": act(BENCHMARKS[session_id], body)}]
            ANSWERS[session_id] = {"session_id": session_id, "seq": seq}
            ANSWERS[session_id]["actions"] = actions  # one, or several as a chunk
        self.answer(ANSWERS[session_id])

    def answer(self, body: dict[str, Any]) -> None:
        content = json.dumps(body).encode()
        self.send_response(200)
        self.send_header("Content-Type", "application/json")
        self.send_header("Content-Length", str(len(content)))
        self.end_headers()
        self.wfile.write(content)

    def log_message(self, *_: object) -> None:
        """Requests are not logged."""


if __name__ == "__main__":
    place = os.environ["PROCTOR_POLICY_SOCKET"]
    socketserver.ThreadingUnixStreamServer(place, Handler).serve_forever()
