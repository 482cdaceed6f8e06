"""The numbers of a comparison: the vectors, a known test, the oracle of the kit."""

import json
from pathlib import Path
from typing import Any

import jsonschema_rs
import pytest
from hypothesis import given
from hypothesis import strategies as st

from conformance.oracle.expected_comparison import expected_comparison
from conformance.specification.ledger import load_ledger
from reference_record.generated.answers import Outcome
from reference_server.rules import comparison
from reference_server.rules.comparison import (
    TOLERANCE,
    compare,
    differing_members,
    manifest_mismatch,
)
from reference_server.rules.scoring import ScoredEpisode
from tests.support.kit.score_differences import differences
from tests.support.paths import ROOT
from tests.support.repository.answer_schemas import check_answer
from tests.support.repository.specification import DOCUMENT
from tests.support.server.score_equality import assert_same

SPEC = ROOT / "spec"
VECTORS = sorted((SPEC / "vectors" / "comparison").glob("*.json"))


@st.composite
def pairs(draw: st.DrawFn) -> tuple[ScoredEpisode, ScoredEpisode]:
    task = draw(st.sampled_from("abc"))

    def one() -> ScoredEpisode:
        outcome: Outcome | None = draw(
            st.sampled_from([None, "success", "failure", "abandoned"])
        )
        # The values of an abandoned episode count for nothing.
        return ScoredEpisode(task, "x", outcome, draw(st.floats(0, 1)))

    return one(), one()


runs = st.lists(pairs(), min_size=1, max_size=40)


def sides(
    drawn: list[tuple[ScoredEpisode, ScoredEpisode]],
) -> tuple[list[ScoredEpisode], list[ScoredEpisode]]:
    return [base for base, _ in drawn], [run for _, run in drawn]


def schema(name: str) -> Any:
    return json.loads((SPEC / "schema" / name).read_text())


@pytest.mark.parametrize("path", VECTORS, ids=lambda path: path.stem)
def test_a_vector_is_compared_as_it_says(path: Path) -> None:
    vector = json.loads(path.read_text())
    base, run = (
        [
            ScoredEpisode(e["task"], e["split"], e["outcome"], e["score"] or 0.0)
            for e in vector[side]
        ]
        for side in ("baseline", "run")
    )
    assert_same(compare(base, run, vector["tolerance"]), vector["comparison"])


@pytest.mark.parametrize("path", VECTORS, ids=lambda path: path.stem)
def test_a_vector_fits_its_schema(path: Path) -> None:
    registry = jsonschema_rs.Registry(
        [("scoring-vector.json", schema("scoring-vector.json"))]
    )
    document, vector = schema("comparison-vector.json"), json.loads(path.read_text())
    jsonschema_rs.validate(document, vector, registry=registry)


def test_there_are_vectors_of_every_number() -> None:
    cited = {json.loads(path.read_text())["requirement"] for path in VECTORS}
    assert cited >= {"CMP-002", "CMP-004", "CMP-006", "CMP-007", "CMP-008"}


# --- any two runs ---


@given(runs, st.floats(0, 1))
def test_the_oracle_of_the_kit_says_the_same(drawn: Any, tolerance: float) -> None:
    base, run = sides(drawn)
    shown = [[episode._asdict() for episode in side] for side in (base, run)]
    expected = expected_comparison(shown[0], shown[1], tolerance)
    assert differences(compare(base, run, tolerance), expected) == []


@given(runs, st.floats(0, 1))
def test_a_comparison_fits_its_schema(drawn: Any, tolerance: float) -> None:
    found = compare(*sides(drawn), tolerance)
    check_answer("ComparedRun", {"run_id": "r", **found})


# --- what cannot be compared ---


def test_runs_of_another_manifest_are_named() -> None:
    assert manifest_mismatch([("a", "1", {}), ("b", "1", {})]) is None
    other = {"version": "2", "tasks": list("abcdefg")}
    runs: list[tuple[str, str, dict[str, Any]]] = [
        ("a", "1", {}), ("b", "2", other), ("c", "1", {}), ("d", "3", {"x": 1}),
    ]  # fmt: skip
    refuse = manifest_mismatch(runs)
    assert refuse is not None
    assert (refuse.code, refuse.requirement) == ("not_comparable", "CMP-009")
    assert refuse.errors == (("query:runs", "b, d: another manifest than a"),)
    assert refuse.detail.endswith("These differ in version, tasks, x.")


@pytest.mark.parametrize(
    ("one", "other", "names"),
    [
        ({"benchmark_id": "a", "version": "1"}, {"benchmark_id": "b"}, "benchmark_id"),
        (
            {"version": "1", "episodes": [1]},
            {"version": "2", "episodes": [1]},
            "version",
        ),
        ({"episodes": [1, 2], "max_steps": 5}, {"episodes": [1]}, "episodes max_steps"),
        (
            {"simulator": {"sources": {"a.py": "1", "b.py": "2"}, "name": "x"}},
            {"simulator": {"sources": {"a.py": "3", "c.py": "2"}, "name": "x"}},
            "simulator.sources.a.py simulator.sources.b.py simulator.sources.c.py",
        ),
        ({"simulator": {}}, {"simulator": None}, "simulator"),
    ],
)
def test_what_differs_between_manifests_is_named(
    one: dict[str, Any], other: dict[str, Any], names: str
) -> None:
    assert differing_members(one, other) == names.split()


def test_seeds_that_differ_are_no_other_part() -> None:
    whole = {"tasks": ["lift"], "splits": ["val"]}
    runs = [
        (
            run_id,
            run_id,
            whole | {"episodes": [{"task": "lift", "split": "val"} | seed]},
        )
        for run_id, seed in (("a", {"seed": 1}), ("b", {"seed": 2}))
    ]
    refuse = manifest_mismatch(runs)
    assert refuse is not None
    assert refuse.detail.endswith("These differ in episodes.")


def test_many_differences_are_counted() -> None:
    runs = [("a", "1", {}), ("b", "2", dict.fromkeys("opqrstuv", 1))]
    refuse = manifest_mismatch(runs)
    assert refuse is not None
    assert refuse.detail.endswith("differ in o, p, q, r, s and 3 more.")


@pytest.mark.parametrize(
    ("episodes", "part"),
    [
        (["lift/val", "lift/test"], "a part (tasks lift)"),
        (["push/test"], "a part (tasks push; splits test)"),
        (["push/val", "lift/val"], "a part (splits val)"),
    ],
)
def test_a_run_of_another_part_is_said_to_be_one(
    episodes: list[str], part: str
) -> None:
    def manifest(*cells: str) -> dict[str, Any]:
        planned = [
            dict(zip(("task", "split"), c.split("/"), strict=True)) for c in cells
        ]
        whole = {"tasks": ["lift", "push"], "splits": ["val", "test"]}
        return whole | {"episodes": planned, "episodes_total": len(cells)}

    whole = manifest("lift/val", "lift/test", "push/val", "push/test")
    refuse = manifest_mismatch([("a", "1", whole), ("b", "2", manifest(*episodes))])
    assert refuse is not None
    of_both = f"Here a is of the whole benchmark, b is of {part}."
    assert refuse.detail == f"Episodes pair only within one manifest. {of_both}"
    assert refuse.act == "Compare runs of the same tasks and splits."


# --- what the specification says of the request ---


def test_the_tolerance_is_the_one_described() -> None:
    described = DOCUMENT["paths"]["/v1/comparisons"]["get"]["parameters"]
    (parameter,) = [p for p in described if p.get("name") == "tolerance"]
    assert f"{TOLERANCE:g} when absent" in parameter["description"]
    rounding = f"{comparison.ROUNDING:g}".replace("e-0", "e-")
    assert f"plus {rounding}." in load_ledger()["CMP-008"].text
