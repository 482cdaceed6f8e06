"""The operations of the profile `physical`: what operators of robot cells see and do.

A view names no run, policy or account that submitted it: who judges is not to know
(PHY-019).
"""

from __future__ import annotations

import asyncio
import logging
import time
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import partial
from http import HTTPStatus
from typing import Annotated, Protocol

from pydantic import BaseModel, ConfigDict, Field
from starlette.responses import Response

from reference_record.generated import answers
from reference_server.cells.cell_rules import Act, OperatorAct
from reference_server.cells.cells import Cells
from reference_server.cells.newest_pictures import file_of
from reference_server.cells.robot_cell import RobotCell
from reference_server.http.auth import OPERATOR
from reference_server.http.dispatch import Operation, OperationCall
from reference_server.profiles.physical.second_judge_handlers import (
    SecondJudgeHandlers,
)
from reference_server.profiles.physical.setup_pictures import (
    no_picture,
    picture_response,
)
from reference_server.rules.manifest import Manifest
from reference_server.rules.refusal import Refused
from reference_server.runs.service import RunService

log = logging.getLogger("proctor.cells")


class CellAct(BaseModel):
    """Schema CellAct of spec/profiles/physical.yaml."""

    model_config = ConfigDict(extra="forbid")

    act: Act
    trial: int | None = None
    reason: str = Field("", max_length=500)
    success: bool | None = None
    met: list[Annotated[int, Field(ge=0, lt=20)]] = Field([], max_length=20)
    note: str = Field("", max_length=2000)
    takes_over: bool = False


class PlayedRuns(Protocol):
    """The runs of a server, and its cells."""

    @property
    def cells(self) -> Cells: ...
    @property
    def service(self) -> RunService: ...


@dataclass(frozen=True, slots=True)
class CellHandlers:
    """The operations over the cells of this server."""

    cells: Cells
    manifests: Callable[[], Iterable[Manifest]]
    second_judge: SecondJudgeHandlers

    @classmethod
    def of(cls, parts: PlayedRuns) -> CellHandlers:
        second_judge = SecondJudgeHandlers(parts.cells.second_judge, parts.service)
        return cls(parts.cells, parts.service.benchmarks.manifests, second_judge)

    def table(self) -> dict[str, dict[str, Operation]]:
        """path → method → operation."""
        operation = partial(Operation, scope=OPERATOR)  # PHY-013
        cell = "/v1/cells/{cell_id}"
        return {
            f"{cell}/stop": {"POST": operation(self.stop_cell)},
            f"{cell}/acts": {"POST": operation(self.act_on_cell, body=CellAct)},
            cell: {"GET": operation(self.get_cell)},
            f"{cell}/picture": {"GET": operation(self.get_setup_picture, writes=())},
            f"{cell}/live/{{camera}}": {
                "GET": operation(self.get_live_picture, writes=())
            },
            "/v1/cells": {"GET": operation(self.list_cells)},
            **self.second_judge.table(),
        }

    async def list_cells(self, call: OperationCall) -> Response:
        cells = self.cells.all(self.manifests())
        return call.answer({"cells": [_view(cell, call.account) for cell in cells]})

    async def get_cell(self, call: OperationCall) -> Response:
        cell = self._find(call)
        cell.live.watch()
        return call.answer(_view(cell, call.account))

    async def stop_cell(self, call: OperationCall) -> Response:
        """PHY-004: the stop is sent before anything else is done."""
        received_at = time.perf_counter()
        cell = self._find(call)
        cell.send_stop()
        spent_ms = (time.perf_counter() - received_at) * 1e3
        log.info("cell %s: stop sent after %.2f ms", cell.cell_id, spent_ms)
        cell.act(OperatorAct("stop", call.account))
        await self.cells.acts.flush()
        return call.answer(_view(cell, call.account))

    async def act_on_cell(self, call: OperationCall) -> Response:
        cell, wanted = self._find(call), call.body
        members = wanted.model_dump(exclude={"act"})
        cell.act(OperatorAct(wanted.act, call.account, **members))
        await self.cells.acts.flush()
        return call.answer(_view(cell, call.account))

    async def get_setup_picture(self, call: OperationCall) -> Response:
        """The picture of the setup that the trial needs."""
        cell = self._find(call)
        if cell.trial is None:
            raise no_picture()
        setup = cell.physical["setups"][cell.trial.task]
        return picture_response(cell.benchmark_id, cell.trial.task, setup)

    async def get_live_picture(self, call: OperationCall) -> Response:
        """The newest picture of a camera, from the turn that was answered last."""
        live = self._find(call).live
        live.watch()
        image = live.newest(call.path["camera"])
        if image is None:
            return Response(status_code=HTTPStatus.NO_CONTENT)
        data, media_type = await asyncio.to_thread(file_of, image)
        return Response(data, media_type=media_type)

    def _find(self, call: OperationCall) -> RobotCell:
        cell_id = call.path["cell_id"]
        if (used := self.cells.get(cell_id)) is not None:
            return used
        for cell in self.cells.all(self.manifests()):
            if cell.cell_id == cell_id:
                return cell
        raise Refused("not_found", "There is no such cell.")


def _view(cell: RobotCell, account: str) -> answers.Cell:
    """A cell; PHY-019: with nothing by which a judge could be biased."""
    state, trial = cell.state, cell.trial
    setup: answers.Setup | None = None
    if trial is not None:
        declared = cell.physical["setups"][trial.task]
        setup = {
            "name": trial.task,
            "instruction": declared["instruction"],
            "has_picture": "picture_sha256" in declared,
        }
    judgement = state.judgement
    return {
        "cell_id": cell.cell_id,
        "benchmark_id": cell.benchmark_id,
        "phase": state.phase,
        "trial": state.number,
        "since_s": round(time.monotonic() - cell.phase_since, 3),
        "operator": state.operator,
        "is_yours": state.operator == account,
        "is_paused": state.is_paused,
        "waiting": cell.waiting,
        "setup": setup,
        "stopped_by": state.stopped_by,
        "notice": state.notice,
        "voids": dict(state.voids),
        "cameras": list(cell.cameras),
        "rubric": cell.physical["rubric"],
        "judgement": None
        if judgement is None
        else {
            "success": judgement.success,
            "score": judgement.score,
            "met": list(judgement.met),
            "note": judgement.note,
        },
    }
