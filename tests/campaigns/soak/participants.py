"""Participants of a challenge: each hands in one policy after another, to its end."""

from __future__ import annotations

import contextlib
import time
from collections.abc import Iterator
from dataclasses import dataclass, field
from random import Random
from typing import Any

from tests.campaigns.campaign_server import WATCHER_ADDRESS
from tests.campaigns.players.raw_client import NoAnswer, RawClient
from tests.campaigns.players.watcher import RETRY_S, Ended, Watcher
from tests.support.platform.archives import digest_of, entry, gzipped, tar_of
from tests.support.platform.uploaded_policies import SUPPORT

BASE = "/v1/hosting"
FINAL = ("completed", "failed", "stopped", "expired")
# Behaviour → how often it is chosen. `stopped` is steady, and stopped by its owner.
BEHAVIOURS = {
    "steady": 10,
    "stopped": 2,
    "image": 2,
    "crash": 2,
    "silent": 1,
    "unanswered": 1,
    "malformed": 1,
    "memory": 1,
}
PADDING_BYTES = 300_000
# A submission that has not ended by then is stuck; its host is down for a part of it.
ENDS_S = 600.0
_LOOK_S = 0.1


@dataclass
class Handed:
    """A submission, and what its owner saw. shown: as the host shows it at last."""

    name: str
    behaviour: str
    began_at: float = field(default_factory=time.monotonic)
    took_s: float = 0.0
    submission_id: str = ""
    shown: dict[str, Any] = field(default_factory=dict)
    is_ended: bool = False


class Participant(Watcher):
    """Hands in `count` policies. image: an OCI archive that is approved."""

    def __init__(
        self, url: str, key: str, name: str, *, seed: int, count: int, image: bytes
    ) -> None:
        super().__init__(url, seed, name)
        self._client = RawClient(url, key, timeout_s=60, source=WATCHER_ADDRESS)
        self._image = image
        self.handed: list[Handed] = []
        names, weights = list(BEHAVIOURS), list(BEHAVIOURS.values())
        self._plans = iter(self._random.choices(names, weights, k=count))

    def step(self) -> None:
        behaviour = next(self._plans, None)
        if behaviour is None:
            raise Ended
        handed = Handed(f"{self.name}-{len(self.handed)}", behaviour)
        self.handed.append(handed)
        is_image = behaviour == "image"
        content = self._image if is_image else archive(behaviour, self._random)
        digest = self._upload(content)
        handed.submission_id = self._create(handed.name, is_image=is_image)
        path = f"{BASE}/submissions/{handed.submission_id}"
        answer = self._until_answered("POST", f"{path}/upload", {"digest": digest})
        if answer.status not in (204, 409):
            self.report.violations.append(f"{handed.name}: attach: {answer}")
        self._follow(handed, path)
        handed.took_s = time.monotonic() - handed.began_at

    def _upload(self, content: bytes) -> str:
        """In blocks, some of which are cut."""
        digest = digest_of(content)
        path = f"{BASE}/uploads/{digest}"
        while True:
            state = self._until_answered("GET", path).json()
            if state["is_complete"]:
                return digest
            offset = state["offset"]
            block = content[offset : offset + PADDING_BYTES // 3]
            query = f"{path}?offset={offset}&size={len(content)}"
            if self._random.random() < 0.2:
                self._cut(query, block)
                continue
            answer = self._until_answered("PATCH", query, block, "application/tar")
            # The answer of an earlier try was lost, or the bytes were not.
            if answer.status != 200 and answer.code != "invalid_request":
                self.report.violations.append(f"{self.name}: upload: {answer}")

    def _cut(self, query: str, block: bytes) -> None:
        """Send a part of a request, and hang up."""
        request = self._client.encode("PATCH", query, block, "application/tar")
        with contextlib.suppress(OSError):
            self._client.connect().sendall(request[: -len(block) // 2])
        self._client.close()

    def _create(self, name: str, *, is_image: bool) -> str:
        """Once, also when the answer is lost: the name shows whether it was made."""
        body: dict[str, Any] = {"track_id": "soak", "policy_name": name}
        body |= {"kind": "image"} if is_image else {"kind": "code", "preset": "python"}
        path = f"{BASE}/submissions"
        while not self._is_ending.is_set():
            for row in self._until_answered("GET", path).json()["submissions"]:
                if row["policy_name"] == name:
                    return str(row["submission_id"])
            with contextlib.suppress(NoAnswer, OSError):
                self.report.add_answer(self._client.request("POST", path, body))
            self._is_ending.wait(RETRY_S)
        raise Ended

    def _follow(self, handed: Handed, path: str) -> None:
        stop_at = handed.began_at + self._random.uniform(0.5, 8)
        while time.monotonic() < handed.began_at + ENDS_S:
            answer = self._until_answered("GET", path)
            if answer.status != 200:
                self.report.violations.append(f"{handed.name}: read: {answer}")
            else:
                handed.shown = answer.json()
                handed.is_ended = handed.shown["state"] in FINAL
                if handed.is_ended:
                    return
                if handed.behaviour == "stopped" and time.monotonic() > stop_at:
                    self._until_answered("POST", f"{path}/stop", {})
                elif handed.shown["state"] == "verified":
                    self._until_answered("POST", f"{path}/start", {})
            self._is_ending.wait(_LOOK_S)

    # --- what is judged afterwards ---

    def log_of(self, handed: Handed) -> Iterator[dict[str, Any]]:
        """The lines, to the one after which none comes."""
        after = 0
        path = f"{BASE}/submissions/{handed.submission_id}/log"
        while True:
            page = self._until_answered("GET", f"{path}?after={after}").json()
            yield from page["lines"]
            if not page["lines"]:
                if page["is_ended"]:
                    return
                self._is_ending.wait(_LOOK_S)
            else:
                after = page["lines"][-1]["number"]

    def result_of(self, handed: Handed) -> dict[str, Any]:
        """The result of its only episode."""
        path = f"/v1/runs/{handed.shown['run_id']}/episodes"
        (episode,) = self._until_answered("GET", path).json()["episodes"]
        return dict(episode["result"])

    def used(self) -> int:
        """How many submissions the host has counted."""
        (track,) = self._until_answered("GET", f"{BASE}/tracks").json()["tracks"]
        return int(track["phases"][0]["limits"][0]["used"])

    def run_ids(self) -> set[str]:
        runs = self._until_answered("GET", "/v1/runs?limit=100").json()["runs"]
        return {run["run_id"] for run in runs}


def archive(behaviour: str, chance: Random) -> bytes:
    """Code on a preset; no two are the same."""
    program = (SUPPORT / "policy_program.py").read_bytes()
    behaves = "steady" if behaviour == "stopped" else behaviour
    files = {
        "main.py": program,
        "behaviour": behaves.encode(),
        "padding": chance.randbytes(PADDING_BYTES),
    }
    return gzipped(tar_of(entry(name, content) for name, content in files.items()))
