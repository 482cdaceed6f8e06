"""Robots and their cells, as far as no person has to act: the profile `physical` (PHY).

No request here can move a robot, which moves when an operator has said ready.
"""

import re
from collections.abc import Callable
from typing import Any

from conformance.checks.service.test_benchmarks import read_benchmarks
from conformance.client.check_context import CheckContext
from conformance.runner.requirement import requirement
from conformance.verdicts import expect

_SHA256 = re.compile("[0-9a-f]{64}")
_SEED_MAX = 2**53 - 1


def physical_benchmarks(context: CheckContext) -> list[dict[str, Any]]:
    """Read the benchmarks that robots play; there is at least one."""
    benchmarks = []
    for listed in read_benchmarks(context):
        read = context.call("get_benchmark", benchmark_id=listed["benchmark_id"])
        benchmark = expect.require(read, 200, "get_benchmark")
        if "physical" in benchmark:
            benchmarks.append(benchmark)
    expect.true(benchmarks, "a benchmark with `physical`", "none")
    return benchmarks


def is_number(value: Any, low: float, high: float = float("inf")) -> bool:
    """Whether it is a number from low to high."""
    is_numeric = isinstance(value, int | float) and not isinstance(value, bool)
    return is_numeric and low <= value <= high


def is_text(value: Any) -> bool:
    return isinstance(value, str) and bool(value)


def is_rubric(value: Any) -> bool:
    """Whether it has `success`, and `criteria` that may be empty."""
    if not isinstance(value, dict) or not isinstance(value.get("criteria"), list):
        return False
    return is_text(value.get("success")) and all(map(is_text, value["criteria"]))


def is_setup(value: Any) -> bool:
    """Whether it has an instruction, and the digest of its picture if it has one."""
    if not isinstance(value, dict) or not is_text(value.get("instruction")):
        return False
    digest = value.get("picture_sha256", "0" * 64)
    return isinstance(digest, str) and bool(_SHA256.fullmatch(digest))


def is_setups(value: Any) -> bool:
    return isinstance(value, dict) and all(map(is_setup, value.values()))


def is_seed(value: Any) -> bool:
    return isinstance(value, int) and is_number(value, 0, _SEED_MAX)


MEMBERS: dict[str, Callable[[Any], bool]] = {
    "stop_within_s": lambda value: is_number(value, 0),
    "watchdog_s": lambda value: is_number(value, 0),
    "setups": is_setups,
    "rubric": is_rubric,
    "blind": lambda value: isinstance(value, bool),
    "order_seed": is_seed,
}


@requirement("PHY-001")
def test_phy_001_a_robot_declares_its_cell(context: CheckContext) -> None:
    """Read each benchmark that a robot plays. Expect the values of `physical`. Its
    setups are those of its tasks."""
    for benchmark in physical_benchmarks(context):
        physical, of = benchmark["physical"], f"of {benchmark['benchmark_id']}"
        for name, fits in MEMBERS.items():
            value = physical.get(name)
            expect.true(fits(value), f"`{name}` {of} by the table of physical", value)
        share = physical.get("second_judge_share", 0)
        expect.true(is_number(share, 0, 1), f"a share from 0 to 1 {of}", share)
        tasks = sorted(benchmark["tasks"])
        expect.equal(sorted(physical["setups"]), tasks, f"tasks with a setup {of}")


@requirement("PHY-013")
def test_phy_013_cannot_operate_without_the_scope(context: CheckContext) -> None:
    """A token that may only read is used for the operations of cells. Expect
    `forbidden` of each, also of the stop, and success of a list of runs."""
    reader = context.read_only_account
    cell = f"/v1/cells/{physical_benchmarks(context)[0]['benchmark_id']}"
    requests: list[tuple[str, str, Any]] = [
        ("GET", "/v1/cells", None),
        ("GET", cell, None),
        ("POST", f"{cell}/acts", {"act": "claim", "takes_over": True}),
        ("POST", f"{cell}/stop", None),
    ]
    for method, path, body in requests:
        answer = reader.request(method, f"{reader.base_url}{path}", json=body)
        expect.refused(answer, "forbidden")
    expect.ok(context.call("list_runs", http_client=reader))
