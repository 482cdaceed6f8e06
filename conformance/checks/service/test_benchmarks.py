"""Benchmarks of the server (BEN)."""

from functools import partial
from itertools import permutations
from typing import Any

from conformance.client.check_context import CheckContext
from conformance.oracle.vector_declarations import declaration_faults
from conformance.runner.requirement import each_requirement, requirement
from conformance.verdicts import expect
from conformance.verdicts.expect import SetUpFailed

_BENCHMARKS_SUBMITTED = 4
_BENCHMARKS_READ = 30
_SUMMARY = ("version", "title", "manifest_sha256", "episodes_total")


def read_benchmarks(context: CheckContext) -> list[dict[str, Any]]:
    read = partial(context.call, "list_benchmarks")
    answer = context.require(read, 200, "list_benchmarks")
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
    control = expect.ok(context.call("get_benchmark", benchmark_id="calibration"))
    expect.equal(control["benchmark_id"], "calibration", "benchmark_id")


@requirement("BEN-003")
def test_ben_003_manifest_hash_is_the_same_everywhere(context: CheckContext) -> None:
    """Benchmarks are listed, read, and submitted without options. Expect the same hash
    of the manifest."""
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
        answer = context.require_admitted(context.call("submit_run", json=body))
        if answer.status != 201:
            raise SetUpFailed(
                f"`submit_run`: unexpected response: {expect.describe_answer(answer)}"
            )
        run = context.adopt(answer.json)
        expect.equal(run.body["manifest_sha256"], listed_sha256, f"{what} in its run")


@requirement("BEN-004")
def test_ben_004_list_shows_each_benchmark_once(context: CheckContext) -> None:
    """The benchmarks are listed, and each is read. Expect each once, sorted by id, and
    the same members in both places."""
    listed = expect.ok(context.call("list_benchmarks"))["benchmarks"]
    ids = [benchmark["benchmark_id"] for benchmark in listed]
    expect.equal(ids, sorted(set(ids)), "ids of the benchmarks")
    for summary in listed[:_BENCHMARKS_READ]:
        benchmark_id = summary["benchmark_id"]
        read = expect.ok(context.call("get_benchmark", benchmark_id=benchmark_id))
        expect.equal(read["benchmark_id"], benchmark_id, "benchmark_id")
        for name in _SUMMARY:
            expect.equal(summary[name], read[name], f"{name} of {benchmark_id}")


@each_requirement("rule", {r: r for r in ("CONV-001", "CONV-002", "CONV-003")})
def test_conv_001_parts_of_vectors_are_declared(
    context: CheckContext, rule: str
) -> None:
    """The benchmarks are read. Expect every vector to have parts, which hold each of
    its numbers once; four numbers in a quaternion, and so on; and two values at the
    ends of each gripper."""
    for listed in read_benchmarks(context)[:_BENCHMARKS_READ]:
        name = listed["benchmark_id"]
        get_benchmark = partial(context.call, "get_benchmark", benchmark_id=name)
        read = context.require(get_benchmark, 200, f"get_benchmark of {name}")
        spaces = {"action": read["action_space"]} | read["observation_space"]
        for group in ("action", "state"):
            for vector_name, vector in spaces[group].items():
                faults = [t for id_, t in declaration_faults(vector) if id_ == rule]
                what = f"the parts of the {group} {vector_name} of {name}"
                expect.equal(faults, [], f"faults in {what}")


MANY_TASKS = ["score"] * 1000  # the most that a run may have


def digest_of(context: CheckContext, **members: Any) -> str:
    """Submit a run of `calibration` and give the digest of its manifest."""
    body = context.submit_body(**members)
    answer = expect.require(context.call("submit_run", json=body), 201, "submit_run")
    digest: str = context.adopt(answer).body["manifest_sha256"]
    return digest


def sealed_choices(context: CheckContext, tasks: list[str]) -> list[dict[str, Any]]:
    """Give the options with sealed seeds, if there are any; expect one hash of them."""
    if not context.offers("sealed_seeds"):
        return []
    options = {"tasks": tasks, "sealed": True}
    first, second = (digest_of(context, options=options) for _ in range(2))
    expect.equal(first, second, "manifest_sha256 of two runs with sealed seeds")
    return [options, {"sealed": True}]


def choices_of_profiles(
    context: CheckContext, tasks: list[str]
) -> tuple[dict[str, Any], list[dict[str, Any]], list[dict[str, Any]]]:
    """Give the defaults of all options, members that are a run's own, and options that
    make another manifest, as far as the server offers them."""
    defaults: dict[str, Any] = {"max_steps": 10, "success_rule": "any_step"}
    own: list[dict[str, Any]] = [{"policy": {"name": "another"}, "max_workers": 1}]
    choices: list[dict[str, Any]] = []
    if context.offers("sessions"):
        defaults["max_attempts"] = 3
        choices.append({"tasks": tasks, "max_attempts": 4})
        own.append({"idle_timeout_s": context.limits["idle_timeout_s_min"]})
    if context.offers("faults"):
        defaults["max_faults"] = 3
        choices.append({"tasks": tasks, "max_faults": 4})
    if context.offers("control"):
        own.append({"options": {"tasks": tasks, "queue_s": 0.5}})
    if context.offers("observations"):
        size = context.benchmark["image_sizes"][-1]
        images = {name: size[name] for name in ("width", "height")}
        own.append({"images": images | {"codec": "raw"}})
    return defaults, own, choices


@requirement("BEN-005")
def test_ben_005_hash_stands_for_the_choices(context: CheckContext) -> None:
    """Runs whose options differ in one choice, also in the last of many episodes and in
    large numbers, and runs with the same choices. Expect another hash for each choice
    of the manifest, and the same one for a default that is spelled out and for choices
    that are the run's own."""
    tasks = ["score", "count"]
    defaults, own, choices = choices_of_profiles(context, tasks)
    first = digest_of(context, options={"tasks": tasks})
    for members in ({}, {"options": {"tasks": tasks, **defaults}}, *own):
        digest = digest_of(context, **({"options": {"tasks": tasks}} | members))
        expect.equal(digest, first, f"manifest_sha256 with {members}")
    by_hash = {first: "the first choices"}
    for options in (
        *sealed_choices(context, tasks),
        {"tasks": ["count", "score"]},
        {"tasks": ["score", "delay"]},
        {"tasks": ["score"]},
        *({"tasks": [*order]} for order in sorted({*permutations([*tasks, "count"])})),
        {"tasks": MANY_TASKS},
        {"tasks": [*MANY_TASKS[:-1], "count"]},
        *({"tasks": tasks, "max_steps": steps} for steps in (11, 9999, 10000)),
        {"tasks": tasks, "success_rule": "last_step"},
        *choices,
    ):
        digest = digest_of(context, options=options)
        twin = by_hash.get(digest)
        expect.true(twin is None, f"another hash for {options}", twin)
        by_hash[digest] = f"the same as for {options}"
    expect.equal(
        digest_of(context, options={"tasks": ["score"], **defaults}),
        digest_of(context),
        "manifest_sha256 without options",
    )
