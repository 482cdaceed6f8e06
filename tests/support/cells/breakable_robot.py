"""A robot without a body that an argument breaks: one of the rules of robots.

python breakable_robot.py [SIM-031]
"""

import os
import sys
import threading
from pathlib import Path
from typing import Any

LIBRARIES = Path(__file__).parents[3] / "reference_sim" / "external" / "libraries"
sys.path.insert(0, str(LIBRARIES))

import proctor_simulator  # noqa: E402
from proctor_simulator import _Session, _StopGuard, _write, vector  # noqa: E402

Json = dict[str, Any]
REPLIES = os.dup(1)


class CountingRobot(proctor_simulator.Robot):
    def __init__(self) -> None:
        self.sum = 0.0
        self.benchmark = {
            "benchmark_id": "counting_robot",
            "simulator": {"name": "counting_robot", "version": "1"},
            "tasks": ["count"],
            "max_steps": 20,
            "deterministic": False,
            "action_space": {"add": vector(1, [0.0], [0.1])},
            "observation_space": {"state": {"sum": vector(1)}},
            "physical": {
                "stop_within_s": 0.1,
                "watchdog_s": 1.0,
                "setups": {"count": {"instruction": "Take your hands away."}},
                "rubric": {"success": "It has counted."},
            },
        }

    def reset(self, task: str, seed: int, split: str) -> Json:
        self.sum = 0.0
        return {"instruction": "Please count.", "state": {"sum": [self.sum]}}

    def step(self, action: Json) -> Json:
        self.sum += action["add"][0]
        return {"state": {"sum": [self.sum]}, "success": False}

    def stop(self) -> None:
        pass


ROBOT = CountingRobot()


def say_nothing_of_messages(reply: Json) -> Json:
    """Leave out that the server has stopped it; other stops are still named."""
    if reply["stopped"] == "server":
        return {name: value for name, value in reply.items() if name != "stopped"}
    return reply


def break_robot(rule: str) -> None:
    guard, session = _StopGuard, _Session
    if rule == "SIM-031":
        ROBOT.benchmark["physical"] = _LateWatchdog(ROBOT.benchmark["physical"])
    if rule == "SIM-033":
        right = session._step_robot
        session._step_robot = lambda self, action: say_nothing_of_messages(  # type: ignore[method-assign]
            right(self, action)
        )
    if rule == "SIM-034":
        ROBOT.benchmark["action_space"]["add"] = vector(1)
        session._check_limits = lambda *_: None  # type: ignore[method-assign]
    if rule == "SIM-035":
        session._check_limits = lambda *_: None  # type: ignore[method-assign]
    if rule == "SIM-036":
        receive = guard._receive
        one_frame = threading.Lock()  # a frame of one thread stays in one piece

        def write_whole(descriptor: int, message: Json) -> None:
            with one_frame:
                _write(descriptor, message)

        def answer_signals(self: Any, message: Json) -> None:
            if message["call"] in ("stop", "alive"):
                write_whole(REPLIES, {"number": message["number"]})
            receive(self, message)

        proctor_simulator._write = write_whole

        guard._receive = answer_signals  # type: ignore[method-assign]


class _LateWatchdog(dict[str, Any]):
    """Announces a second, and waits for an hour."""

    def __getitem__(self, name: str) -> Any:
        return 3600.0 if name == "watchdog_s" else super().__getitem__(name)


if __name__ == "__main__":
    break_robot("".join(sys.argv[1:2]))
    proctor_simulator.serve(ROBOT)
