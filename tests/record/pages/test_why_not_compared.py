"""A report says why runs of one benchmark are not compared with each other."""

from pathlib import Path
from typing import Any

import pytest

from reference_record.pages.static_pages import ReportedRun, StaticReport

BENCHMARK = {"benchmark_id": "b", "version": "1", "sealed_splits": ["val", "test"]}


def reported(manifest: str, seeds: str, **benchmark: Any) -> ReportedRun:
    run = {
        "run_id": f"run_{manifest}",
        "benchmark_id": "b",
        "manifest_sha256": manifest,
    }
    described = BENCHMARK | {"manifest_sha256": manifest, "seeds_sha256": seeds}
    return ReportedRun(run, {}, [], described | benchmark, "", lambda _: None)


@pytest.mark.parametrize(
    ("other", "said"),
    [
        (reported("m", "s"), None),
        (reported("n", "t"), "their episodes of val and test have other seeds"),
        (reported("n", "s", version="2"), "their benchmarks or their choices of"),
        (reported("n", "t", version="2"), "differ, and so do their seeds"),
    ],
)
def test_the_difference_of_two_manifests_is_said(
    other: ReportedRun, said: str | None, tmp_path: Path
) -> None:
    notes = StaticReport(tmp_path, [reported("m", "s"), other]).why_not_compared()
    assert len(notes) == (said is not None)
    assert (said or "") in "".join(notes)
