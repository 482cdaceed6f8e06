"""The model of a cluster's capacity: what saturates first, and what more nodes give."""

import dataclasses

import pytest

from benchmarks.cluster.capacity_model import (
    DATABASE,
    LOADS,
    Constants,
    Load,
    needs_table,
    nodes_needed,
    parts_used,
)

FREE = Constants(0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0)
LOAD = Load("one turn a second", turn_s=1.0, turns_of_episode=10, readers=2)


@pytest.mark.parametrize(
    ("changes", "resource", "part"),
    [
        ({"turn_s": 0.0021}, "a node's core", 1.0),
        ({"passed_on_s": 0.0021}, "a node's core", 2 / 3 * 1.1),  # turns, heartbeats
        ({"heartbeat_s": 0.0021}, "a node's core", 0.1),
        ({"episode_s": 0.0021}, "a node's core", 0.1),
        ({"event_s": 0.0021}, "a node's core", 0.2),
        ({"idle_node": 0.7}, "a node's core", 1.0),
        ({"episode_database_s": 0.007}, DATABASE, 1.0),
        ({"idle_database": 0.07}, DATABASE, 0.1),
        ({"simulator_turn_s": 0.0021}, "cores of simulators, one a node", 1.0),
        ({"simulator_mb": 137.6256}, "memory, 64 GB a node", 1.0),
        ({"session_files": 137.6256}, "files, 65,536 a node", 1.0),
    ],
)
def test_each_constant_loads_its_resource(
    changes: dict[str, float], resource: str, part: float
) -> None:
    used = parts_used(dataclasses.replace(FREE, **changes), LOAD)
    assert used.pop(resource) == pytest.approx(part, rel=0.01)
    assert not any(used.values())


def test_more_nodes_carry_more_but_pass_on_more() -> None:
    costs = dataclasses.replace(FREE, turn_s=0.0007)
    assert nodes_needed(costs, LOAD) == 1
    passing = dataclasses.replace(costs, turn_s=0.0014, passed_on_s=0.0014)
    assert nodes_needed(passing, LOAD) == 4  # without passing on, two would do
    heavy = dataclasses.replace(FREE, simulator_mb=100.0)
    assert nodes_needed(heavy, LOAD) == 3


def test_the_table_names_what_is_short_first() -> None:
    costs = dataclasses.replace(FREE, turn_s=0.00042, simulator_mb=13.76)
    *_, fast, slower, _, _ = needs_table(costs).splitlines()
    assert "| a node's core | 500 |" in fast
    assert "| a node's core | 5,000 |" in slower
    assert len(needs_table(costs).splitlines()) == 2 + len(LOADS)
