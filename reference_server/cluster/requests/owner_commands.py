"""A command for a run, carried out by the node that has it.

A request that names one run in its path is passed on as it is (`forwarding.py`). Those
of a profile may name several runs, or name them in their body: the node that got one
asks the owner of each. Both commands may be repeated: a run that was stopped, or goes
on, stays as it is.
"""

from __future__ import annotations

from functools import partial
from typing import Any

import msgspec
from starlette.types import ASGIApp

from reference_server.cluster.node_connections import NodeConnections
from reference_server.cluster.requests.node_requests import NodeRequests
from reference_server.rules.refusal import Refused
from reference_server.rules.run_owner import OwnedElsewhere
from reference_server.runs.service import CarryOut, RunCommand
from reference_server.storage.node_store import Node
from reference_server.storage.runs.run_store import StoreFailed

PATH = "/node/commands"
# A command waits for one write to the database.
TIMEOUT_S = 10.0
# How often a run is followed that moves meanwhile.
MOVES_MAX = 3


class _Asked(msgspec.Struct):
    """A command that one node asks another to carry out, for an account."""

    command: RunCommand
    account: str
    run_id: str


class _Outcome(msgspec.Struct):
    """The outcome of a command. code: of a refusal, with its members; None without one.

    has_moved: another node has the run by now, and nothing was done.
    """

    code: str | None = None
    detail: str = ""
    errors: list[tuple[str, str]] = []
    requirement: str | None = None
    members: dict[str, Any] = {}
    has_moved: bool = False


class OwnerCommands:
    """Gives commands to the nodes that have their runs, and carries out theirs."""

    def __init__(self, connections: NodeConnections) -> None:
        self._membership = connections.membership
        self.requests = NodeRequests(
            connections,
            PATH,
            question_type=_Asked,
            answer_type=_Outcome,
            timeout_s=TIMEOUT_S,
        )

    def answered_by(self, carry_out: CarryOut) -> ASGIApp:
        """The endpoint for other nodes. carry_out: what a command does here."""
        return self.requests.answered_by(partial(self.carry_out, carry_out))

    async def apply(
        self, command: RunCommand, account: str, run_id: str, carry_out: CarryOut
    ) -> None:
        """Carry out a command at the node that has the run.

        Raises Refused and StoreFailed. carry_out: what the command does here, if this
        node has the run by now.
        """
        asked = _Asked(command, account, run_id)
        for _ in range(MOVES_MAX):
            node = await self._membership.find_other(run_id, only_reads=False)
            if node is None:  # this node has it by now, or there is no run
                outcome = await self.carry_out(carry_out, asked)
            else:
                outcome = await self._ask(node, asked)
            if not outcome.has_moved:
                _raise_refusal(outcome)
                return
            self._membership.note_moved(run_id)
        raise OwnedElsewhere(run_id)

    async def _ask(self, node: Node, asked: _Asked) -> _Outcome:
        outcome = await self.requests.ask(node, asked)
        if outcome is None:
            await self._membership.forget_owner(asked.run_id)
            raise Refused("unavailable", "The node that has the run does not answer.")
        return outcome

    async def carry_out(self, carry_out: CarryOut, asked: _Asked) -> _Outcome:
        """Carry out a command for another node, and return its outcome."""
        try:
            await self._membership.ensure_lease()
            await carry_out(asked.command, asked.account, asked.run_id)
        except OwnedElsewhere:
            return _Outcome(has_moved=True)
        except Refused as refused:
            return _Outcome(
                refused.code,
                refused.detail,
                list(refused.errors),
                refused.requirement,
                refused.members,
            )
        except StoreFailed:
            return _Outcome("unavailable", "The database is not available.")
        return _Outcome()


def _raise_refusal(outcome: _Outcome) -> None:
    if outcome.code is not None:
        raise Refused(
            outcome.code,
            outcome.detail,
            errors=outcome.errors,
            requirement=outcome.requirement,
            members=outcome.members,
        )
