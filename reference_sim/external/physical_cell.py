"""The declarations of a robot cell: its stop, its setups and its rubric.

The member `physical` of a description; see spec/profiles/physical.md.
"""

from __future__ import annotations

import base64
import hashlib
from collections.abc import Sequence
from typing import Annotated, Any

from pydantic import Field, field_validator

from reference_sim.definition import Json
from reference_sim.external.described_map import DescribedMap

PICTURE_CHARS_MAX = 1 << 20
_Seconds = Annotated[float, Field(gt=0, le=60)]
_Text = Annotated[str, Field(min_length=1, max_length=2000)]


class Setup(DescribedMap):
    """How a person arranges things before an attempt.

    picture: of the arrangement, PNG or JPEG in base64; empty if there is none.
    """

    instruction: _Text
    picture: Annotated[str, Field(max_length=PICTURE_CHARS_MAX)] = ""

    @field_validator("picture")
    @classmethod
    def _is_base64(cls, picture: str) -> str:
        base64.b64decode(picture, validate=True)  # raises ValueError
        return picture

    @property
    def picture_sha256(self) -> str:
        return hashlib.sha256(base64.b64decode(self.picture)).hexdigest()


class Rubric(DescribedMap):
    """The questions to a person: when an attempt is a success, and further criteria."""

    success: _Text
    criteria: Annotated[Sequence[_Text], Field(max_length=20)] = ()


class PhysicalCell(DescribedMap):
    """stop_within_s: from the arrival of a stop to the end of motion. watchdog_s: after
    the last message the cell stops by itself. setups: of each task. order_seed: of the
    order in which episodes are played. second_judge_share: of the episodes of a run,
    those that a second person judges."""

    stop_within_s: _Seconds
    watchdog_s: _Seconds
    setups: dict[str, Setup]
    rubric: Rubric
    blind: bool = True
    order_seed: Annotated[int, Field(ge=0, lt=2**53)] = 0
    second_judge_share: Annotated[float, Field(ge=0, le=1)] = 0.0

    def require_setups(self, tasks: Sequence[str]) -> None:
        """Raises ValueError unless each task has its setup."""
        if self.setups.keys() != set(tasks):
            raise ValueError(f"setups are of {sorted(self.setups)}, tasks are {tasks}")

    def ordered(self, episodes: Sequence[Json]) -> list[Json]:
        """PHY-002: blocks of one repetition, each in the order that the seed gives."""
        splits = list(dict.fromkeys(episode["split"] for episode in episodes))

        def place(episode: Json) -> tuple[int, int, str]:
            name = f"{self.order_seed}/{episode['seed']}/{episode['task']}"
            digest = hashlib.sha256(name.encode()).hexdigest()
            return splits.index(episode["split"]), episode["seed"], digest

        return sorted(episodes, key=place)

    def manifest(self) -> Json:
        """PHY-001: the member of the manifest; it has the digests of pictures."""
        setups: dict[str, dict[str, Any]] = {}
        for name, setup in self.setups.items():
            setups[name] = {"instruction": setup.instruction}
            if setup.picture:
                setups[name]["picture_sha256"] = setup.picture_sha256
        rubric = {
            "success": self.rubric.success,
            "criteria": list(self.rubric.criteria),
        }
        share = self.second_judge_share
        return {
            "stop_within_s": self.stop_within_s,
            "watchdog_s": self.watchdog_s,
            "setups": setups,
            "rubric": rubric,
            "blind": self.blind,
            "order_seed": self.order_seed,
            **({"second_judge_share": share} if share else {}),
        }
