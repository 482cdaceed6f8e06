"""The requests of FlagEval's client: their schemas, and the submission each stands for.

Numbers above the maximum of schema PolicyServer are reduced to it. An `api_key` goes
into the submission, where it is encrypted, and nowhere else (FLE-006, FLE-017). Must
not know runs, sessions or responses.
"""

from __future__ import annotations

import hashlib
import re
from typing import Annotated, Any, Literal, TypeAlias

from pydantic import BaseModel, Field, model_validator

from reference_record.generated.answers import ImageChoice
from reference_server.generated import models
from reference_server.http import codec
from reference_server.rules.manifest import PolicyServer, Submission
from reference_server.rules.refusal import Refused
from reference_server.runs.service import body_digest

NO_KEY = "EMPTY"
# End of an `eval_url` → the policy protocol that asks there (FLE-019).
PROTOCOLS: dict[str, models.PolicyProtocol] = {
    "/chat/completions": "openai_chat",
    "/completions": "openai_completions",
}
RETRY_TIME_S, DEFAULT = 3600, -1  # FLE-018: -1 is the default
CALL_TIMEOUT_S_MOST, RETRIES_MOST = 600, 10  # of schema PolicyServer
EVALUATIONS_MOST = 16
# Two datasets of `calibration`, so that a kit can judge this profile without images.
CALIBRATION_TASKS = ["score", "score", "score", "score", "count", "count"]
# Run ids, joined by dots.
RequestId: TypeAlias = Annotated[
    str, Field(pattern=r"^[A-Za-z0-9_-]{1,64}(\.[A-Za-z0-9_-]{1,64}){0,15}$")
]
_PAIR = re.compile(
    r"\s*([a-z][a-z0-9_]{0,39})\s*=\s*(-?[0-9]{1,9}(?:\.[0-9]{1,9})?)\s*"
)
_RENAMED = {"max_gen_toks": "max_tokens"}
# Pointer into a submission → the member of `eval_infos` that it was made of.
_MEMBERS = {
    "/policy/name": "eval_model",
    "/policy_server/url": "eval_url",
    "/policy_server/model": "model",
    "/policy_server/api_key": "api_key",
    "/policy_server/max_concurrent": "num_concurrent",
}


class _Defaults(BaseModel):
    """FLE-018: a member that is null is absent, as FlagEval's server has it."""

    @model_validator(mode="before")
    @classmethod
    def _drop_nulls(cls, members: Any) -> Any:
        if not isinstance(members, dict):
            return members
        return {name: value for name, value in members.items() if value is not None}


class EvalInfo(_Defaults):
    """One model to evaluate; unknown members are ignored."""

    eval_model: str = Field(min_length=1, max_length=200)
    model: str
    eval_url: str
    tokenizer: str = Field("", max_length=200)
    api_key: str = NO_KEY
    batch_size: int = Field(1, ge=1)
    num_concurrent: int = Field(1, ge=1, le=1024)
    num_retry: int = Field(10, ge=0)
    gen_kwargs: str = Field("", max_length=2000)
    thinking: bool = False
    max_gen_toks: int = Field(DEFAULT, ge=DEFAULT, le=999_999_999)
    retry_time: Literal[-1] | Annotated[int, Field(ge=1)] = DEFAULT
    chip: str = Field("Nvidia-H100", max_length=200)
    base_model_name: str = Field("", max_length=200)


class EvaluationRequest(_Defaults):
    eval_infos: list[EvalInfo] = Field(min_length=1, max_length=EVALUATIONS_MOST)
    domain: Literal["NLP", "MM"]
    mode: str = ""
    region: Literal["bj", "sz"] = "bj"
    special_event: str = Field("yes", max_length=200)
    user_id: int | None = None

    def check(self) -> None:
        """Check that the names of models differ, which no schema expresses (FLE-003).

        Raises Refused.
        """
        names = [info.eval_model for info in self.eval_infos]
        for number, name in enumerate(names):
            if name in names[:number]:
                raise _invalid(f"/eval_infos/{number}/eval_model", "must be unique")

    def submission(
        self, number: int, benchmark_id: str, images: ImageChoice | None
    ) -> Submission:
        """The submission of one evaluation (FLE-005), with its labels."""
        info, at = self.eval_infos[number], f"/eval_infos/{number}"
        url, protocol = _endpoint(info.eval_url, f"{at}/eval_url")
        timeout_s = RETRY_TIME_S if info.retry_time == DEFAULT else info.retry_time
        server: PolicyServer = {
            "url": url,
            "protocol": protocol,
            "model": info.model,
            "call_timeout_s": float(min(timeout_s, CALL_TIMEOUT_S_MOST)),
            "max_concurrent": info.num_concurrent,
            "max_retries": min(info.num_retry, RETRIES_MOST),
            "generation": _generation(info, f"{at}/gen_kwargs"),
        }
        if info.api_key != NO_KEY:
            server["api_key"] = info.api_key
        submission: Submission = {
            "benchmark_id": benchmark_id,
            "policy": {"name": info.eval_model},
            "mode": "push",
            "policy_server": server,
        }
        if images is not None:
            submission["images"] = images
        if benchmark_id == "calibration":
            submission["options"] = {"tasks": CALIBRATION_TASKS}
        try:
            checked = codec.read_submission(submission)
        except Refused as refused:
            raise translate_refusal(refused, number) from refused
        checked["labels"] = self._labels(number)
        return checked

    def _labels(self, number: int) -> dict[str, Any]:
        """The request without the key (FLE-017), which is stored with the run."""
        whole = self.model_dump(exclude={"eval_infos"})
        return whole | self.eval_infos[number].model_dump(exclude={"api_key"})

    def digest(self, number: int) -> str:
        """Digest of a request, by which a repeat is recognised (FLE-003, FLE-004)."""
        return body_digest(self._labels(number))


class RequestReference(BaseModel):
    request_id: RequestId


class ProgressRequest(RequestReference):
    domain: Literal["NLP", "MM"]


class DiffsRequest(BaseModel):
    """The first request is the baseline (FLE-015)."""

    request_ids: list[RequestId] = Field(min_length=1, max_length=EVALUATIONS_MOST)


def idempotency_key(eval_model: str) -> str:
    """The Idempotency-Key of an evaluation: a name is unique per account (FLE-003)."""
    return f"flageval-{hashlib.sha256(eval_model.encode()).hexdigest()}"


def translate_refusal(refused: Refused, number: int) -> Refused:
    """A refusal of a submission, with pointers into the request."""
    at = f"/eval_infos/{number}"
    errors = [
        (f"{at}/{_MEMBERS[where]}" if where in _MEMBERS else where, text)
        for where, text in refused.errors
    ]
    return Refused(refused.code, refused.detail, errors=errors)


def _endpoint(eval_url: str, at: str) -> tuple[str, models.PolicyProtocol]:
    """FLE-019: the base URL of a model and how it is asked."""
    url = eval_url.removesuffix("/")
    for end, protocol in PROTOCOLS.items():  # the longer end first
        if url.endswith(end):
            return url.removesuffix(end), protocol
    raise _invalid(at, f"must end with {' or '.join(PROTOCOLS)}")


def _generation(info: EvalInfo, at: str) -> dict[str, float]:
    """FLE-005: `temperature=0.6,max_gen_toks=16000` as numbers by name.

    FLE-018: the member `max_gen_toks`, if it is above 0, unless `gen_kwargs` has it.
    """
    generation: dict[str, float] = {}
    if info.max_gen_toks > 0:
        generation[_RENAMED["max_gen_toks"]] = info.max_gen_toks
    for part in filter(str.strip, info.gen_kwargs.split(",")):
        pair = _PAIR.fullmatch(part)
        if pair is None:
            raise _invalid(at, "must be name=number, separated by commas")
        generation[_RENAMED.get(pair[1], pair[1])] = float(pair[2])
    return generation


def _invalid(at: str, text: str) -> Refused:
    return Refused("invalid_request", "The body is invalid.", errors=[(at, text)])
