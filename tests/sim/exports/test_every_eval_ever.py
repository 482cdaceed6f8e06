"""The JSON of Every Eval Ever is valid by its schemas and says what the record says."""

import hashlib
import json
from pathlib import Path
from typing import Any

import jsonschema_rs
import pytest

from reference_sim.exports.every_eval_ever import portable, write_evaluation
from reference_sim.exports.source import open_source
from tests.support.paths import ROOT
from tests.support.record.played_records import save_calibration_record
from tests.support.sim.evaluation_schemas import read_schema

VECTORS = ROOT / "spec" / "vectors" / "record"


def validate(value: object, schema: str) -> None:
    jsonschema_rs.Draft7Validator(read_schema(schema)).validate(value)


def exported(record: Path, folder: Path) -> tuple[dict[str, Any], list[dict[str, Any]]]:
    """The log and its samples, valid, with the digest that the log names."""
    log_path, samples_path = write_evaluation(open_source(record), folder)
    log = json.loads(log_path.read_text())
    validate(log, "eval")
    data = samples_path.read_bytes()
    samples = [json.loads(line) for line in data.splitlines()]
    for sample in samples:
        validate(sample, "instance_level_eval")
        assert sample["evaluation_id"] == log["evaluation_id"]
        assert sample["model_id"] == log["model_info"]["id"]
    named = log["detailed_evaluation_results"]
    assert named["checksum"] == hashlib.sha256(data).hexdigest()
    assert named["total_rows"] == len(samples)
    assert folder / named["file_path"] == samples_path
    assert samples_path.name == f"{log_path.stem}_samples.jsonl"
    return log, samples


def test_a_record_with_every_outcome(tmp_path: Path) -> None:
    """Two successes of four. Expect the rate, the score and every episode."""
    log, samples = exported(VECTORS / "good.proctor", tmp_path)
    rate, score = log["evaluation_results"]
    assert rate["score_details"]["score"] == 0.5
    interval = rate["score_details"]["uncertainty"]["confidence_interval"]
    bounds = [interval["lower"], interval["upper"]]
    assert bounds == pytest.approx([0.15, 0.85], abs=1e-3)
    assert score["score_details"]["score"] == 0.5625
    assert score["score_details"]["uncertainty"]["num_samples"] == 4
    outcomes = [sample["metadata"]["outcome"] for sample in samples]
    assert sorted(outcomes) == ["abandoned", "failure", "success", "success"]
    correct = [sample["evaluation"]["is_correct"] for sample in samples]
    assert correct == [outcome == "success" for outcome in outcomes]
    # The samples name the rate; their graded scores are facts beside it.
    ids = {sample["evaluation_result_id"] for sample in samples}
    assert ids == {rate["evaluation_result_id"]}
    assert sum(sample["evaluation"]["score"] for sample in samples) / 4 == 0.5
    graded = [float(sample["metadata"]["episode_score"]) for sample in samples]
    assert sum(graded) / 4 == 0.5625
    # Facts that the record does not hold are unknown.
    assert log["source_metadata"]["evaluator_relationship"] == "other"
    assert log["model_info"]["additional_details"]["model_availability"] == "unknown"
    said = log["source_metadata"]["additional_details"]
    assert "without a signature" in said["note"]


def test_the_same_record_gives_the_same_bytes(folder: Path) -> None:
    path = folder / "run-1.proctor"
    save_calibration_record(path, folder / "recordings")
    contents = []
    for name in ("first", "second"):
        exported(path, folder / name)
        files = sorted(p for p in (folder / name).rglob("*") if p.is_file())
        contents.append([(p.name, p.read_bytes()) for p in files])
    assert contents[0] == contents[1]


@pytest.mark.parametrize("name", ["../..", "a/b\\c", "\x1b[2J", ".", "ü" * 300, ""])
def test_a_name_leads_to_no_other_folder(name: str) -> None:
    part = portable(name)
    assert 0 < len(part) <= 80
    assert not set(part) & set("./\\\x1b")
