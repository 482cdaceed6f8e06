"""The operations of second judges: what they see of a recording, and what they say.

A view names no run, policy or account, and no judgement (PHY-025).
"""

from __future__ import annotations

import asyncio
from collections import OrderedDict
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import Annotated, Any

from pydantic import BaseModel, ConfigDict, Field
from starlette.responses import Response

from reference_record.broken import BrokenRecord
from reference_record.generated import answers
from reference_record.pages.recorded_episode import (
    RecordedEpisode,
    read_recorded_episode,
)
from reference_server.cells.second_judge import JudgedEpisode, SecondJudge
from reference_server.http.auth import OPERATOR
from reference_server.http.dispatch import Operation, OperationCall
from reference_server.profiles.physical.setup_pictures import picture_response
from reference_server.rules.manifest import Manifest
from reference_server.rules.refusal import Refused
from reference_server.rules.runs.run import Episode, RunHead, index_of
from reference_server.runs.service import RunService

LISTED_MAX = 100
RECORDINGS_KEPT = 4


class SecondAct(BaseModel):
    """Schema SecondAct of spec/profiles/physical.yaml."""

    model_config = ConfigDict(extra="forbid")

    success: bool
    met: list[Annotated[int, Field(ge=0, lt=20)]] = Field([], max_length=20)
    note: str = Field("", max_length=2000)


@dataclass(frozen=True, slots=True)
class SecondJudgeHandlers:
    """The operations over the samples of the runs of this server."""

    judge: SecondJudge
    service: RunService
    _kept: OrderedDict[str, RecordedEpisode] = field(default_factory=OrderedDict)

    def table(self) -> dict[str, dict[str, Operation]]:
        """path → method → operation."""
        operation = partial(Operation, scope=OPERATOR)
        one = "/v1/second_judgements/{judgement_id}"
        return {
            "/v1/second_judgements": {"GET": operation(self.list_second_judgements)},
            one: {
                "GET": operation(self.get_second_judgement),
                "POST": operation(self.add_second_judgement, body=SecondAct),
            },
            f"{one}/picture": {
                "GET": operation(self.get_judged_setup_picture, writes=())
            },
            f"{one}/pictures/{{number}}": {
                "GET": operation(self.get_judged_picture, writes=())
            },
        }

    async def list_second_judgements(self, call: OperationCall) -> Response:
        listed: list[answers.Judgement] = []
        for judged in self.judge.waiting_for(call.account):
            try:
                _, episode = await self._read(judged)
                await self._find_recording(judged)
            except Refused:  # it was removed, or its result is not there yet
                continue
            listed.append(
                {
                    "judgement_id": judged.judgement_id,
                    "benchmark_id": judged.benchmark_id,
                    "task": episode.task,
                }
            )
            if len(listed) == LISTED_MAX:
                break
        return call.answer({"judgements": listed})

    async def get_second_judgement(self, call: OperationCall) -> Response:
        judged = self._find(call)
        return call.answer(await self._view(judged))

    async def add_second_judgement(self, call: OperationCall) -> Response:
        judged, given = self._find(call), call.body
        manifest, _ = await self._read(judged)
        rubric = manifest["physical"]["rubric"]
        await self.judge.judge(judged, call.account, rubric, **given.model_dump())
        return call.answer(await self._view(judged))

    async def get_judged_setup_picture(self, call: OperationCall) -> Response:
        judged = self._find(call)
        manifest, episode = await self._read(judged)
        setup = manifest["physical"]["setups"][episode.task]
        return picture_response(judged.benchmark_id, episode.task, setup)

    async def get_judged_picture(self, call: OperationCall) -> Response:
        recorded = await self._recorded(self._find(call))
        number = int(call.path["number"])
        if number >= len(recorded.pictures):
            raise Refused("not_found", "The recording has no such picture.")
        picture = recorded.pictures[number]
        kind = "jpeg" if picture.extension == "jpg" else picture.extension
        return Response(picture.data, media_type=f"image/{kind}")

    def _find(self, call: OperationCall) -> JudgedEpisode:
        return self.judge.find(call.path["judgement_id"], call.account)

    async def _read(self, judged: JudgedEpisode) -> tuple[Manifest, Episode]:
        """The manifest of the run, and the episode. Raises Refused without a result."""
        index = index_of(judged.episode_id) or 0

        def view(run: RunHead, episodes: Any) -> tuple[Manifest, Episode]:
            return run.manifest, episodes[0]

        reader = self.service.registry.reader
        read = await reader.read_view(judged.run_id, None, view, index, index + 1)
        if read[1].result is None:
            raise Refused("not_found", "The recording is not complete yet.")
        return read

    async def _find_recording(self, judged: JudgedEpisode) -> tuple[Path, int]:
        """The file and its size. Raises Refused."""
        run_id, episode_id = judged.run_id, judged.episode_id
        return await self.service.find_recording(None, run_id, episode_id)

    async def _recorded(self, judged: JudgedEpisode) -> RecordedEpisode:
        kept = self._kept.get(judged.judgement_id)
        if kept is not None:
            return kept
        path, size = await self._find_recording(judged)

        def read() -> RecordedEpisode:
            with path.open("rb") as file:
                return read_recorded_episode(file, size, judged.judgement_id)

        try:
            recorded = await asyncio.to_thread(read)
        except (OSError, BrokenRecord) as error:
            detail = "The recording cannot be read."
            raise Refused("not_found", detail) from error
        self._kept[judged.judgement_id] = recorded
        while len(self._kept) > RECORDINGS_KEPT:
            self._kept.popitem(last=False)
        return recorded

    async def _view(self, judged: JudgedEpisode) -> answers.SecondJudgement:
        """The episode: no judgement, and nothing of the policy (PHY-025)."""
        manifest, episode = await self._read(judged)
        recorded = await self._recorded(judged)
        physical = manifest["physical"]
        setup = physical["setups"][episode.task]
        return {
            "judgement_id": judged.judgement_id,
            "benchmark_id": judged.benchmark_id,
            "setup": {
                "name": episode.task,
                "instruction": setup["instruction"],
                "has_picture": "picture_sha256" in setup,
            },
            "instruction": recorded.instruction,
            "rubric": physical["rubric"],
            "steps": recorded.steps,
            "rate_hz": manifest["control_rate_hz"],
            "pictures": [
                {"camera": picture.camera, "step": picture.step}
                for picture in recorded.pictures
            ],
            "judged": judged.is_judged_twice,
        }
