"""Benchmarks of the server (BEN)."""

from functools import partial
from typing import Any

from conformance.client.check_context import CheckContext
from conformance.runner.requirement import requirement
from conformance.verdicts import expect
from conformance.verdicts.expect import SetUpFailed

_BENCHMARKS_SUBMITTED = 4


def read_benchmarks(context: CheckContext) -> list[dict[str, Any]]:
    """List the benchmarks."""
    answer = context.require(
        lambda: context.call("list_benchmarks"), 200, "list_benchmarks"
    )
    benchmarks: list[dict[str, Any]] = answer["benchmarks"]
    return benchmarks


@requirement("BEN-001")
def test_ben_001_calibration_is_listed(context: CheckContext) -> None:
    """The benchmarks are listed. Expect `calibration`, once."""
    listed = expect.ok(context.call("list_benchmarks"))["benchmarks"]
    ids = [benchmark["benchmark_id"] for benchmark in listed]
    expect.equal(ids.count("calibration"), 1, "entries named `calibration`")


@requirement("BEN-002")
def test_ben_002_cannot_get_an_unknown_benchmark(context: CheckContext) -> None:
    """An unknown id, then a known one. Expect `not_found`, then the benchmark."""
    unknown = context.call("get_benchmark", benchmark_id="no_such_benchmark")
    expect.refused(unknown, "not_found")
    known = expect.ok(context.call("get_benchmark", benchmark_id="calibration"))
    expect.equal(known["benchmark_id"], "calibration", "benchmark_id")


@requirement("BEN-003")
def test_ben_003_manifest_hash_is_the_same_everywhere(context: CheckContext) -> None:
    """Benchmarks are listed, read, and submitted without options.

    Expect the same hash of the manifest.
    """
    for listed in read_benchmarks(context)[:_BENCHMARKS_SUBMITTED]:
        benchmark_id, listed_sha256 = listed["benchmark_id"], listed["manifest_sha256"]
        get_benchmark = partial(
            context.call, "get_benchmark", benchmark_id=benchmark_id
        )
        read = context.require(get_benchmark, 200, f"get_benchmark of {benchmark_id}")
        what = f"manifest_sha256 of {benchmark_id}"
        expect.equal(read["manifest_sha256"], listed_sha256, what)
        if read["unavailable_reason"] is not None:
            continue
        body = context.submit_body(benchmark_id=benchmark_id)
        answer = context.call("submit_run", json=body)
        if answer.status != 201:
            raise SetUpFailed(
                f"`submit_run`: unexpected response: {expect.describe_answer(answer)}"
            )
        run = context.adopt(answer.json)
        expect.equal(run.body["manifest_sha256"], listed_sha256, f"{what} in its run")
