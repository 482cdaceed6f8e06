"""Why the server did not hear from a worker for longer than its lease.

A session that ends so costs the attempt of its episode, and nothing else shows it: the
worker attaches again and plays on. The cause is measured here, not guessed.
"""

from __future__ import annotations

import math
import time
from dataclasses import dataclass
from typing import Literal

from reference_record.texts.counted_text import counted

Cause = Literal["standstill", "suspended", "unreached", "request"]


@dataclass(frozen=True, slots=True)
class LostSession:
    """A session that has ended because its worker was silent for too long.

    step: at which the episode was lost; 0 costs no attempt. lease_s, silent_s: the
    lease, and the time in which the server heard nothing.
    """

    worker_id: str
    episode_id: str
    step: int
    attempt: int
    lease_s: float
    silent_s: float
    cause: Cause

    def describe(self) -> str:
        what = f"attempt {self.attempt} of {self.episode_id} at step {self.step}"
        if self.step == 0:
            what = f"its session before the first step of {self.episode_id}"
        return (
            f"{self.worker_id} lost {what}: {_CAUSES[self.cause]} for "
            f"{self.silent_s:.1f} s, and the lease is {self.lease_s:g} s"
        )


_CAUSES = {
    "standstill": "this program stood still",
    "suspended": "this machine was suspended",
    "unreached": "the server was not reached",
    "request": "a request had no answer",
}
_CURES = {
    "standstill": (
        "Code that holds the Python interpreter (the GIL), also that of another "
        "worker, stops the thread that extends the lease; so does a machine that "
        "swaps, or that suspends this program. Give a new run a longer lease "
        "({lease}), or serve the policy from a program of its own "
        "(`proctor serve-policy`, then `proctor run --policy-url`)."
    ),
    "suspended": (
        "Keep the machine awake while a run is played (`systemd-inhibit` or "
        "`caffeinate` before the command), or give a new run a longer lease ({lease})."
    ),
    "unreached": "A new run with a longer lease ({lease}) outlives such a cut.",
    "request": (
        "The network, a proxy or the server held it back; a new run with a longer "
        "lease ({lease}) outlives that."
    ),
}


def summary(lost: list[LostSession], abandoned: int) -> str:
    """All losses of an evaluation in a few sentences, with what to do about them."""
    attempts = sum(session.step > 0 for session in lost)
    workers = len({session.worker_id for session in lost})
    many = "" if len(lost) == 1 else "s"
    text = (
        f"Lost by silence: {len(lost)} session{many} of {workers} "
        f"worker{'' if workers == 1 else 's'}, and with them {attempts} "
        f"attempt{'' if attempts == 1 else 's'}."
    )
    if abandoned:
        one = "episode has no attempt left and counts 0"
        several = "episodes have no attempt left and count 0"
        text += f" {counted(abandoned, one, several)}."
    longest_s = max(session.silent_s for session in lost)
    seconds = max(10, math.ceil(longest_s / 5) * 10)
    lease = f"--idle-timeout-s {seconds}, in Python idle_timeout_s={seconds}"
    for cause in dict.fromkeys(session.cause for session in lost):
        text += " " + _CURES[cause].format(lease=lease)
    return text


class SilenceMeter:
    """Measures since the server's last answer, from any thread.

    A clock that goes on while the machine is suspended is compared with one that does
    not.
    """

    def __init__(self) -> None:
        self.answered()

    def answered(self) -> None:
        """The server has answered: a lease begins."""
        self._at, self._awake_at = _clocks()
        self._failed_at: float | None = None
        self._sent_at: float | None = None

    def failed(self) -> None:
        """A heartbeat had no answer."""
        self._failed_at = self._failed_at or _clocks()[1]

    def sent(self) -> None:
        """A request other than a heartbeat begins."""
        self._sent_at = _clocks()[1]

    def silence(self, lease_s: float) -> tuple[float, Cause]:
        """How long the server has heard nothing, and the most likely cause."""
        now, awake = _clocks()
        silent_s = now - self._at
        awake_s = awake - self._awake_at
        if silent_s - awake_s > lease_s / 2:
            return silent_s, "suspended"
        if self._failed_at is not None:
            return silent_s, "unreached"
        if self._sent_at is not None and awake - self._sent_at > lease_s / 2:
            return silent_s, "request"
        return silent_s, "standstill"


def _clocks() -> tuple[float, float]:
    """A clock that counts suspended time, and one that does not, where they differ."""
    awake = time.monotonic()
    boot = getattr(time, "CLOCK_BOOTTIME", None)
    if boot is not None:
        return time.clock_gettime(boot), awake
    return time.time(), awake
