"""Refusals of paths and parameters name what is right, in words."""

from __future__ import annotations

import re

import pytest

from reference_record.texts.pattern_words import in_words
from reference_server.assembly.nearest_path import PATH_CHARS_MAX, UnknownPath
from reference_server.generated import models, parameters
from reference_server.http.handlers import Handlers
from reference_server.profiles.operation_tables import profile_tables
from reference_server.settings import Settings

HANDLERS = Handlers(Settings(profiles="ebench,flageval"), None)  # type: ignore[arg-type]
PATHS = UnknownPath([*HANDLERS.table(), *profile_tables(HANDLERS)])
CONTROL = "api/v1/benchmark/onlineEvaluation"


@pytest.mark.parametrize(
    ("path", "nearest"),
    [
        ("/v1/runs/", "/v1/runs"),
        ("/V1/Runs", "/v1/runs"),
        ("/v1//runs", "/v1/runs"),
        ("/v1/v1/runs", "/v1/runs"),
        ("/proctor/v1/runs/run_1/score", "/v1/runs/run_1/score"),
        ("/runs", "/v1/runs"),
        ("/v1/run", "/v1/runs"),
        ("/v1/benchmark", "/v1/benchmarks"),
        ("/v1/runs/run_1/scores", "/v1/runs/run_1/score"),
        ("/v1/runs/run_1/workers/w/predicts", "/v1/runs/run_1/workers/w/predict"),
        ("/v1/runs/<b>/scores", "/v1/runs/{run_id}/score"),
        (f"/eval/landing-page/{CONTROL}/createTask", f"/{CONTROL}/createTask"),
        (f"/{CONTROL}/createtask", f"/{CONTROL}/createTask"),
        (f"/{CONTROL}/create_task", f"/{CONTROL}/createTask"),
        ("/", ""),
        ("/v1/nothing", ""),
        ("/favicon.ico", ""),
        ("/" * PATH_CHARS_MAX + "v1/runs", ""),
        ("/v1/runs" + "/a" * 100, ""),
    ],
)
def test_the_nearest_path_is_named(path: str, nearest: str) -> None:
    assert PATHS.nearest(path) == nearest


def test_every_pattern_has_words() -> None:
    texts = {pattern for table in (parameters.PATH_PATTERNS, parameters.HEADER_PATTERNS,
                                   parameters.QUERY_PATTERNS)
             for pattern in table.values()}  # fmt: skip
    requests = (models.SubmitRun, models.AttachWorker, models.Predict, models.Heartbeat)
    for model in (*requests, models.StopRun, models.PublishEntry, models.FlagEntry):
        texts |= set(patterns_of(model.model_json_schema()))
    assert len(texts) > 15, "the control"
    for pattern in texts:
        words = in_words(pattern)
        assert words.startswith("must "), pattern
        assert not re.search(r"[\^$\\\[{]|must match", words), words
        assert in_words(pattern, "").startswith("is empty; it must ")


def test_an_unknown_pattern_is_shown_as_it_is() -> None:
    assert in_words("^[xyz]+$") == "must match [xyz]+"
    assert in_words("[xyz]{1,2}") == "must match [xyz]{1,2}"
    assert in_words("[0-9a-f]{64}") == "must be 64 digits or letters from a to f"


def patterns_of(schema: object) -> list[str]:
    if isinstance(schema, dict):
        own = [schema["pattern"]] if isinstance(schema.get("pattern"), str) else []
        return own + [p for part in schema.values() for p in patterns_of(part)]
    if isinstance(schema, list):
        return [pattern for part in schema for pattern in patterns_of(part)]
    return []
