"""Simulators that are robots: what stops them, as far as replies show it (SIM)."""

import time
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from conformance.client.check_context import CheckContext
from conformance.runner.requirement import requirement
from conformance.simulator.simulator_client import (
    NO_ROBOT,
    SimulatorClient,
    action_of,
    simulator,
    tasks_of,
)
from conformance.verdicts import expect
from conformance.verdicts.expect import NotApplicable

_SILENCE_S = 0.2


def _benchmark(context: CheckContext) -> dict[str, Any]:
    """The description. Raises NotApplicable for a simulator that is not a robot."""
    benchmark: dict[str, Any] = context.shared.settings.simulator["benchmark"]
    if "physical" not in benchmark:
        raise NotApplicable(NO_ROBOT)
    return benchmark


@contextmanager
def _robot(context: CheckContext) -> Iterator[SimulatorClient]:
    """A robot in an episode, after one step that was not stopped."""
    _benchmark(context)
    with simulator(context) as client:
        done = client.play(tasks_of(context)[0], 0, steps=1)[-1]
        expect.true(not done.get("stopped"), "a step without a stop", str(done)[:80])
        yield client


def _expect_stopped(reply: dict[str, Any]) -> None:
    expect.true(bool(reply.get("stopped")), "`stopped` in the reply", str(reply)[:80])
    expect.equal(reply.get("terminated"), True, "terminated")


@requirement("SIM-031")
def test_sim_031_silence_stops_the_robot(context: CheckContext) -> None:
    """No message for longer than `watchdog_s`, then a step. Expect it to be stopped."""
    with _robot(context) as client:
        time.sleep(_benchmark(context)["physical"]["watchdog_s"] + _SILENCE_S)
        _expect_stopped(client.step(tasks_of(context)[0], 1))


@requirement("SIM-033")
def test_sim_033_a_stopped_step_says_so(context: CheckContext) -> None:
    """A stop during a step, or before it, and a step behind it. Expect `stopped` in the
    replies, and an episode that plays after another reset."""
    task = tasks_of(context)[0]
    with _robot(context) as client:
        client.send("step", action=action_of(_benchmark(context), task, 1))
        client.signal("stop")
        client.receive("step")
        _expect_stopped(client.step(task, 2))
        played = client.play(task, 0, steps=1)[-1]
        expect.true(not played.get("stopped"), "an episode that plays", str(played))


@requirement("SIM-034")
def test_sim_034_actions_of_a_robot_have_bounds(context: CheckContext) -> None:
    """Its description. Expect bounds for each vector of the action space."""
    for name, space in _benchmark(context)["action_space"].items():
        has_bounds = {"minimum", "maximum"} <= space.keys()
        expect.true(has_bounds, f"bounds of {name}", f"{sorted(space)}")


@requirement("SIM-035")
def test_sim_035_a_step_beyond_the_bounds_is_a_fault(context: CheckContext) -> None:
    """A step beyond the bounds, then a right one. Expect a fault, and a stop."""
    task = tasks_of(context)[0]
    with _robot(context) as client:
        action = action_of(_benchmark(context), task, 1)
        spaces = _benchmark(context)["action_space"]
        beyond = {name: [x + 1 for x in spaces[name]["maximum"]] for name in action}
        expect.true("fault" in client.ask("step", action=beyond), "a fault", "a reply")
        _expect_stopped(client.step(task, 1))


@requirement("SIM-036")
def test_sim_036_signals_have_no_reply(context: CheckContext) -> None:
    """`alive` and `stop`. Expect no byte."""
    with _robot(context) as client:
        client.signal("alive")
        client.signal("stop")
        rest = client.process.read_rest(_SILENCE_S)
        expect.true(not rest, "no reply to a signal", repr(rest[:80]))
