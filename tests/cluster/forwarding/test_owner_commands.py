"""A command for a run of another node: what its owner answers, and where it went."""

from __future__ import annotations

import asyncio
from typing import Any

import msgspec
import pytest

from reference_server.cluster.node_connections import NodeConnections
from reference_server.cluster.requests.owner_commands import MOVES_MAX, OwnerCommands
from reference_server.rules.refusal import Refused
from reference_server.rules.run_owner import OwnedElsewhere
from reference_server.runs.service import CarryOut, RunCommand
from reference_server.storage.node_store import Node
from reference_server.storage.runs.run_store import StoreFailed


class Nodes:
    """What a node knows of the owner of a run: another one, or itself when it is None.

    owners: what each look-up finds, one after another.
    """

    lease_s = 5.0

    def __init__(self, *owners: Node | None) -> None:
        self.owners, self.forgotten = list(owners), 0
        self.secret, self.node_id = "of this node", "me"

    async def find_other(self, _run_id: str, *, only_reads: bool) -> Node | None:
        assert not only_reads, "a command changes the run"
        return self.owners.pop(0)

    async def ensure_lease(self) -> None:
        """It has one."""

    def note_moved(self, _run_id: str) -> None:
        self.forgotten += 1

    async def forget_owner(self, _run_id: str) -> None:
        self.forgotten += 1


OTHER = Node("other", "http://127.0.0.1:1", "of the other")


def carry_out_with(outcome: Exception | None) -> CarryOut:
    """What each node does with a command: it meets that outcome."""

    async def carry_out(command: RunCommand, account: str, run_id: str) -> None:
        assert (command, account, run_id) == ("stop", "alice", "run_1")
        if outcome is not None:
            raise outcome

    return carry_out


def commands_of(nodes: Nodes, carry_out: CarryOut) -> OwnerCommands:
    """Those of a node, whose other nodes carry commands out in that way."""
    connections: Any = NodeConnections.__new__(NodeConnections)
    connections.membership = nodes
    commands = OwnerCommands(connections)

    async def ask(_node: Node, question: Any) -> Any:
        """Over what another node would read, and answer."""
        sent = msgspec.json.decode(msgspec.json.encode(question), type=type(question))
        answer = await commands.carry_out(carry_out, sent)
        return msgspec.json.decode(msgspec.json.encode(answer), type=type(answer))

    commands.requests.ask = ask  # type: ignore[assignment,method-assign]
    return commands


def outcome_of(nodes: Nodes, outcome: Exception | None) -> Refused | None:
    try:
        carry_out = carry_out_with(outcome)
        commands = commands_of(nodes, carry_out)
        asyncio.run(commands.apply("stop", "alice", "run_1", carry_out))
    except Refused as refused:
        return refused
    return None


@pytest.mark.parametrize("owner", [OTHER, None])
def test_a_command_is_refused_as_the_owner_refuses_it(owner: Node | None) -> None:
    why = Refused(
        "illegal_transition",
        "It is completed.",
        errors=[("/a", "b")],
        requirement="LIFE-702",
        members={"state": "completed"},
    )
    assert outcome_of(Nodes(owner), None) is None
    refused = outcome_of(Nodes(owner), why)
    assert refused is not None
    assert vars(refused) == vars(why)
    away = outcome_of(Nodes(owner), StoreFailed("no database"))
    assert away is not None
    assert away.code == "unavailable"


def test_a_command_follows_a_run_that_moves() -> None:
    """Its next owner carries it out; one that moves on for ever is left."""
    moved = OwnedElsewhere("run_1")
    nodes = Nodes(*[OTHER] * MOVES_MAX)
    assert isinstance(outcome_of(nodes, moved), OwnedElsewhere)
    assert (nodes.owners, nodes.forgotten) == ([], MOVES_MAX)


def test_a_node_that_does_not_answer_is_looked_for_again() -> None:
    nodes = Nodes(OTHER)
    carry_out = carry_out_with(None)
    commands = commands_of(nodes, carry_out)

    async def say_nothing(_node: Node, _question: Any) -> None:
        return None

    commands.requests.ask = say_nothing  # type: ignore[assignment,method-assign]
    with pytest.raises(Refused) as refused:
        asyncio.run(commands.apply("stop", "alice", "run_1", carry_out))
    assert (refused.value.code, nodes.forgotten) == ("unavailable", 1)
