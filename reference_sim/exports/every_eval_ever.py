"""A run in the JSON of Every Eval Ever, schema version 0.3.0: one file for the run, and
one line for each episode in a file beside it.

The schema is made for language models. Facts that it has no member for are in its
open `additional_details`; facts that a record does not hold (who developed the policy,
whether its weights are open) are `unknown` and never guessed.
"""

from __future__ import annotations

import datetime as dt
import hashlib
import math
import re
import uuid
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import msgspec

from reference_record.contents.statement import EpisodeLine
from reference_sim.exports.source import Source

SCHEMA_VERSION = "0.3.0"
DEVELOPER = "unknown"
LIBRARY = "proctor"
Json = dict[str, Any]


def write_evaluation(source: Source, folder: Path) -> list[Path]:
    """Writes data/COLLECTION/DEVELOPER/MODEL/UUID.json and UUID_samples.jsonl.

    The same record gives the same bytes. Raises OSError.
    """
    said = source.evaluation
    name = str(uuid.UUID(source.statement_sha256[:32], version=4))
    collection = portable(f"proctor-{said.benchmark.benchmark_id}")
    place = Path("data", collection, DEVELOPER, portable(_model_name(source)))
    target = folder / place
    target.mkdir(parents=True)
    samples = target / f"{name}_samples.jsonl"
    digest, rows = hashlib.sha256(), 0
    with samples.open("wb") as file:
        for sample in _samples(source):
            data = msgspec.json.encode(sample) + b"\n"
            digest.update(data)
            file.write(data)
            rows += 1
    log = _log(source)
    if rows:
        log["detailed_evaluation_results"] = {
            "format": "jsonl",
            "file_path": (place / samples.name).as_posix(),
            "hash_algorithm": "sha256",
            "checksum": digest.hexdigest(),
            "total_rows": rows,
        }
    else:  # the schema knows no empty file
        samples.unlink()
    path = target / f"{name}.json"
    path.write_bytes(msgspec.json.format(msgspec.json.encode(log)) + b"\n")
    return [path, samples] if rows else [path]


def portable(text: str) -> str:
    """A part of a path on every system; texts of a record may have anything."""
    return re.sub(r"[^A-Za-z0-9_-]+", "-", text)[:80].strip("-") or "unnamed"


def _log(source: Source) -> Json:
    said = source.evaluation
    return {
        "schema_version": SCHEMA_VERSION,
        "evaluation_id": _evaluation_id(source),
        "evaluation_timestamp": said.finished_at,
        "retrieved_timestamp": _unix_time(said.finished_at),
        "source_metadata": {
            "source_name": f"Proctor record of the host {said.host.name}",
            "source_type": "evaluation_run",
            "source_organization_name": said.host.name,
            # Whether host and developer are one and the same, a record does not say.
            "evaluator_relationship": "other",
            "additional_details": {
                **source.provenance,
                "host_keyid": said.host.keyid,
                "attempts_by_submitter": str(said.attempts_by_submitter),
            },
        },
        "eval_library": {
            "name": LIBRARY,
            "version": said.protocol_version,
            "additional_details": {
                "version_is": "of the protocol",
                **{f"package_{k}": str(v) for k, v in _packages(source).items()},
            },
        },
        "model_info": {
            "name": said.policy.name,
            "id": _model_id(source),
            "developer": DEVELOPER,
            "additional_details": {
                "deployment_type": "unknown",
                "model_availability": "unknown",
                "policy_version": said.policy.version or "unknown",
            },
        },
        "evaluation_results": list(_results(source)),
    }


def _results(source: Source) -> Iterator[Json]:
    """The success rate, and the score if every episode has one."""
    score = source.evaluation.score
    counts = score["counts"]
    scored = counts["total"] - counts["unscored"]
    if scored:
        interval = score["success_interval"]
        bounds = {
            "lower": interval["low"],
            "upper": interval["high"],
            "confidence_level": 0.95,
            "method": "Wilson score interval",
        }
        detail = {
            "score": counts["success"] / scored,
            "details": {"episodes": str(counts["total"]), "scored": str(scored)},
            "uncertainty": {"confidence_interval": bounds, "num_samples": scored},
        }
        yield _result(source, "success_rate", "Success rate", detail)
    if score["score"] is not None:
        values = [line.score or 0.0 for line in source.lines()]
        yield _result(
            source,
            "mean_score",
            "Mean score",
            {"score": score["score"], "uncertainty": _spread(values)},
        )


def _spread(values: list[float]) -> Json:
    """The uncertainty of the mean of these scores; a single score has none."""
    count, mean = len(values), math.fsum(values) / len(values)
    if count < 2:
        return {"num_samples": count}
    variance = math.fsum((value - mean) ** 2 for value in values) / (count - 1)
    error = {"value": math.sqrt(variance / count), "method": "analytic"}
    return {
        "standard_error": error,
        "standard_deviation": math.sqrt(variance),
        "num_samples": count,
    }


def _result(source: Source, metric: str, title: str, details: Json) -> Json:
    said, rate = source.evaluation, metric == "success_rate"
    return {
        "evaluation_result_id": _result_id(source, metric),
        "evaluation_name": said.benchmark.benchmark_id,
        "evaluation_timestamp": said.finished_at,
        "source_data": {
            "dataset_name": said.benchmark.benchmark_id,
            "source_type": "other",
            "additional_details": {
                "version": said.benchmark.version,
                "manifest_sha256": said.manifest_sha256,
            },
        },
        "metric_config": {
            "evaluation_description": "Episodes that end as a success, of those with a "
            "result." if rate else "Mean over all episodes of a score from 0 to 1.",
            "metric_id": metric,
            "metric_name": title,
            "metric_kind": "pass_rate" if rate else "mean_score",
            "metric_unit": "proportion",
            "lower_is_better": False,
            "score_type": "continuous",
            "min_score": 0,
            "max_score": 1,
        },
        "score_details": details,
    }  # fmt: skip


def _samples(source: Source) -> Iterator[Json]:
    """A line for each episode that counts in the success rate."""
    for line in source.lines():
        if line.outcome is not None:
            yield _sample(source, line)


def _sample(source: Source, line: EpisodeLine) -> Json:
    task = f"{line.task} (split {line.split}, episode {line.index})"
    outcome = {"turn_idx": 1, "source": "messages[1].content"}
    said = f"{line.outcome} after {line.steps} steps"
    facts = {
        "task": line.task,
        "split": line.split,
        "outcome": str(line.outcome),
        "steps": str(line.steps),
        "attempts": str(line.attempts),
    }
    if line.score is not None:
        facts["episode_score"] = str(line.score)
    if line.recording is not None:
        facts["recording_sha256"] = line.recording.sha256
    sample: Json = {
        "schema_version": SCHEMA_VERSION,
        "evaluation_id": _evaluation_id(source),
        "model_id": _model_id(source),
        "evaluation_name": source.evaluation.benchmark.benchmark_id,
        "evaluation_result_id": _result_id(source, "success_rate"),
        "sample_id": f"{source.evaluation.manifest_sha256[:16]}/{line.index}",
        "interaction_type": "agentic",
        "input": {"raw": task, "reference": ["success"]},
        "output": None,
        "messages": [
            {"turn_idx": 0, "role": "user", "content": task},
            {"turn_idx": 1, "role": "tool", "content": said},
        ],
        "answer_attribution": [
            outcome | {
                "extracted_value": str(line.outcome),
                "extraction_method": "success rule of the benchmark",
                "is_terminal": True,
            }
        ],
        # Values of the result that is named above: its score is their mean.
        "evaluation": {"score": float(line.success), "is_correct": line.success},
        "metadata": facts,
    }  # fmt: skip
    if line.latency:
        named = {name: str(value) for name, value in line.latency.items()}
        sample["performance"] = {"additional_details": named}
    return sample


def _evaluation_id(source: Source) -> str:
    said = source.evaluation
    return f"{said.benchmark.benchmark_id}/{_model_id(source)}/{said.run.run_id}"


def _result_id(source: Source, metric: str) -> str:
    return f"{_evaluation_id(source)}#{metric}"


def _model_id(source: Source) -> str:
    return f"{DEVELOPER}/{portable(_model_name(source))}"


def _model_name(source: Source) -> str:
    policy = source.evaluation.policy
    return f"{policy.name}-{policy.version}" if policy.version else policy.name


def _packages(source: Source) -> Mapping[str, object]:
    packages = source.evaluation.engine.get("packages")
    return packages if isinstance(packages, dict) else {}


def _unix_time(text: str) -> str:
    try:
        seconds = dt.datetime.fromisoformat(text).timestamp()
    except (ValueError, OverflowError):
        seconds = 0.0  # a record may say anything; the text itself is exported, too
    return str(int(seconds))
