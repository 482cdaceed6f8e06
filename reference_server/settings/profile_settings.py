"""The APIs of other platforms."""

from __future__ import annotations

from typing import Literal

from pydantic import BaseModel, Field, field_validator

from reference_record.command_line.spelling import unknown
from reference_server.profiles.flageval.mode_table import ModeTable

OFFERED: tuple[Literal["ebench", "flageval"], ...] = ("ebench", "flageval")


class ProfileSettings(BaseModel):
    """The APIs of other platforms."""

    profiles: str = Field(
        "",
        description="Third-party API profiles to enable, comma-separated: ebench, "
        "flageval.",
    )
    flageval_modes: str = Field(
        "",
        description="Benchmarks for the modes of FlagEval's scripts, comma-separated, "
        "each DOMAIN:MODE=BENCHMARK_ID with the domain NLP or MM and * for any other "
        "mode, for example NLP:Qnext=arithmetic,MM:*=question_answering.",
    )
    flageval_account: str = Field(
        "",
        pattern=r"^[A-Za-z0-9_.-]{0,64}$",
        description="Account of requests of the profile flageval that come from this "
        "machine without a token. If empty, there is none. Needs a loopback host and "
        "no public_url; every user of this machine can then use the account.",
    )
    ebench_prefixes: str = Field(
        "/eval",
        pattern=r"^((/[A-Za-z0-9_.-]+)+(,(/[A-Za-z0-9_.-]+)+)*)?$",
        description="Profile ebench: paths under which it answers besides the root, "
        "each beginning with /, comma-separated.",
    )
    ebench_max_chunk: int = Field(
        1024,
        ge=1,
        le=4096,
        description="Profile ebench: maximum steps in one list of steps.",
    )
    ebench_max_attempts: int = Field(
        0,
        ge=0,
        le=1_000_000,
        description="Profile ebench: maximum attempts of an episode; if the last one "
        "ends without a result, the episode is abandoned. 0 for no limit.",
    )
    ebench_equal_steps: Literal["execute", "answer_chunks", "answer"] = Field(
        "execute",
        description="Profile ebench: what a step is that equals the last one of its "
        "worker, whose answer was sent. execute: a new step. answer: a repetition, "
        "answered and not executed. answer_chunks: a repetition if it is a list of "
        "steps that are not all equal.",
    )

    @property
    def enabled_profiles(self) -> list[Literal["ebench", "flageval"]]:
        """The names in `profiles`, without repetitions."""
        chosen = self.profiles.split(",")
        return [name for name in OFFERED if name in chosen]

    @property
    def mode_table(self) -> ModeTable:
        """`flageval_modes`, parsed."""
        return ModeTable.parse(self.flageval_modes)

    @field_validator("profiles")
    @classmethod
    def _check_profiles(cls, text: str) -> str:
        for name in text.split(",") if text else ():
            if name not in OFFERED:
                raise ValueError(unknown("profile", name, OFFERED))
        return text

    @field_validator("flageval_modes")
    @classmethod
    def _check_modes(cls, text: str) -> str:
        ModeTable.parse(text)  # raises ValueError
        return text
