"""Seeds: which results show them, and what a host may keep secret (SEAL)."""

import json
from collections.abc import Iterator
from typing import Any

from conformance.checks.profiles.test_events import in_state
from conformance.checks.support.given_states import submit_and_attach
from conformance.client.check_context import CheckContext
from conformance.client.event_reader import follow_run
from conformance.profiles.record_files import fetched_record
from conformance.runner.requirement import requirement
from conformance.verdicts import expect
from conformance.verdicts.expect import NotApplicable, SetUpFailed

TASKS = ("score", "echo", "count", "score")


def results_in(value: Any) -> Iterator[dict[str, Any]]:
    """Give every episode or result in an answer, at any depth."""
    if isinstance(value, dict):
        if "episode_id" in value:
            yield value
        for item in value.values():
            yield from results_in(item)
    elif isinstance(value, list):
        for item in value:
            yield from results_in(item)


def play_and_read(context: CheckContext, **options: Any) -> list[Any]:
    """Play a run with both splits, and abandon one episode of each, where any can be.

    Gives all that was answered about it.
    """
    can_abandon, tasks = context.offers("sessions"), context.tasks(*TASKS)
    observe = "all" if context.offers("observations") else None
    options["max_attempts"] = 1 if can_abandon else None
    worker = submit_and_attach(context, *tasks, **options)
    read: list[Any] = [worker.run.body, worker.turn]
    for is_played in (True, True, *[not can_abandon] * (len(tasks) - 2)):
        if worker.turn["done"]:
            raise SetUpFailed("no session for the next episode", breaks="EPI-004")
        read.append(worker.predict(context.action(), observe=observe))
        if is_played:
            read.append(worker.predict(context.action(end=1)))
        else:
            worker.detach()
        read.append(worker.run.get())
        if context.offers("lists"):
            read.append(worker.run.episodes())
        if not is_played and worker.run.body["state"] != "completed":
            read.append(worker.attach())
    read.append(worker.run.score())
    if context.offers("events"):
        with follow_run(worker.run) as reader:
            is_end = in_state("completed")
            events = reader.until(is_end, "`run` that is completed")
        read += [event.body for event in events]
    return read


def splits_with_a_seed(read: list[Any]) -> dict[str, set[bool]]:
    """Give for each split whether its results have a seed: all, none, or both."""
    by_split: dict[str, set[bool]] = {}
    for entry in results_in(read):
        if "outcome" in entry:
            by_split.setdefault(entry["split"], set()).add("seed" in entry)
    return by_split


@requirement("SEAL-001")
def test_seal_001_results_have_their_seed(context: CheckContext) -> None:
    """A run of both splits without sealing. Expect `seed` in every result."""
    by_split = splits_with_a_seed(play_and_read(context))
    expect.equal(by_split, {"even": {True}, "odd": {True}}, "results with a `seed`")


@requirement("SEAL-002")
def test_seal_002_sealed_seeds_are_not_shown(context: CheckContext) -> None:
    """A run whose split `odd` is sealed: its turns, results, lists, events and record.
    Expect no `seed` of that split, and one in every result of the other."""
    read = play_and_read(context, sealed=True)
    by_split = splits_with_a_seed(read)
    expect.equal(by_split, {"even": {True}, "odd": {False}}, "results with a `seed`")
    for entry in results_in(read):
        shown = entry.get("split") == "odd" and "seed" in entry
        expect.true(not shown, "no seed of the split `odd`", entry)
    if context.offers("record"):
        worker = submit_and_attach(context, "score", "score", sealed=True)
        while not worker.turn["done"]:
            worker.predict(context.action(end=1))
        record = fetched_record(worker.run.call("fetch_record"))
        entries = [*record.lines]
        for name, content in record.files.items():
            if name == "manifest.json":
                entries += json.loads(content).get("episodes", [])
        found_there = [
            entry
            for entry in entries
            if entry.get("split") == "odd" and "seed" in entry
        ]
        expect.equal(found_there, [], "sealed seeds in the record")


@requirement("SEAL-003")
def test_seal_003_sealed_splits_have_a_commitment(context: CheckContext) -> None:
    """Every benchmark of the server that has sealed splits. Expect that `splits` has
    them, and a `seeds_sha256` that no other one shows."""
    listed = expect.ok(context.call("list_benchmarks"))["benchmarks"]
    shown: dict[str, str] = {}
    for summary in listed:
        name = summary["benchmark_id"]
        benchmark = expect.ok(context.call("get_benchmark", benchmark_id=name))
        sealed = benchmark.get("sealed_splits", [])
        if not sealed:
            continue
        unknown = set(sealed) - set(benchmark["splits"])
        expect.true(not unknown, f"sealed_splits of {name} in splits", sorted(unknown))
        digest = benchmark.get("seeds_sha256")
        expect.true(digest is not None, f"seeds_sha256 of {name}", benchmark)
        expect.true(digest not in shown, "another seeds_sha256", shown.get(digest))
        shown[digest] = f"{digest} of {name} is that of another benchmark"
    if not shown:
        raise NotApplicable("no benchmark of the server has sealed splits")
