"""`proctor admin seeds`: opens the seeds of the sealed splits of a benchmark.

It writes the file with which anyone replays records of the benchmark (REC-015). The
host publishes it where it likes: `seeds_sha256` of each record proves it.
"""

from __future__ import annotations

import asyncio
import sys
from collections.abc import Iterator
from pathlib import Path

from reference_record.command_line.click_commands import (
    Command,
    Group,
    Options,
    argument,
    flag,
    option,
)
from reference_record.command_line.replaced_file import replace_file
from reference_record.command_line.written_output import writing
from reference_record.formats.opened_seeds import (
    OpenedEpisode,
    OpenedSeeds,
    write_opened_seeds,
)
from reference_server.files.seed_secret import SeedSecret
from reference_server.records.admin_areas import AdminFiles, CannotDo, opened_store
from reference_server.rules.manifest import is_sealed
from reference_server.rules.runs.run import RunHead
from reference_sim import benchmark_registry
from reference_sim.gymnasium import BadBenchmark
from reference_sim.host_seeds import salt_of, seal_for_run, secret_of_run
from reference_sim.replay import host_benchmarks


def seeds_area() -> Group:
    """The area of `proctor admin`; `do_with_files` is the function of its command."""
    output = option(
        "--output", "(seeds-BENCHMARK.json)", also="-o", type=Path, metavar="FILE"
    )
    opens = Command(
        "open",
        "write the seeds of a benchmark that was played here, to be published: anyone "
        "can then replay its records, and train on its episodes",
        [argument("benchmark", ""), output, flag("--force", "replace the file")],
        do_with_files=open_seeds,
    )
    return Group("seeds", "the seeds of sealed splits", [opens])


def open_seeds(files: AdminFiles, args: Options) -> None:
    """Open the seeds of each choice of options that has a run. Raises CannotDo."""
    name = args.benchmark
    output = args.output or Path(f"seeds-{name}.json")
    if output.exists() and not args.force:
        raise CannotDo(f"{output} exists: replace it with --force")
    secret = SeedSecret(files.seed_secret_path)
    if not files.seed_secret_path.exists():
        raise CannotDo(
            "there is no secret of sealed seeds; see the setting seed_secret"
        )
    try:
        secret.open()
        host_benchmarks.add(name, files.benchmarks, _say)
    except (ValueError, BadBenchmark) as error:
        raise CannotDo(str(error)) from error
    heads = asyncio.run(_heads_of(files.database_url, name))
    opened = list(_opened(heads, secret.value))
    if not opened:
        raise CannotDo(f"no run of {name} has sealed seeds that can be opened")
    with writing(output, "-o"):
        replace_file(output, write_opened_seeds(name, opened))
    episodes = sum(len(seeds.episodes) for seeds in opened)
    print(f"{output}: {episodes} seeds, of {len(opened)} choices of options")
    print(
        f"publish it and the seeds of {name} are known for good: scores of runs that "
        "are played from then on are no longer of unknown episodes"
    )


async def _heads_of(url: str, benchmark_id: str) -> list[RunHead]:
    """One run of each manifest."""
    async with opened_store(url) as store:
        run_ids = await store.runs_of_manifests(benchmark_id)
        # One by one: the seeds follow from the options, which `heads` leaves out.
        windows = [await store.read_window(run_id, 0, 0) for run_id in run_ids]
        return [window[0] for window in windows if window is not None]


def _opened(heads: list[RunHead], secret: bytes) -> Iterator[OpenedSeeds]:
    """Yield the seeds of each commitment; print which cannot be opened."""
    done: set[str] = set()
    for head in heads:
        commitment = head.manifest.get("seeds_sha256")
        if commitment is None or commitment in done:
            continue
        done.add(commitment)
        try:
            yield _seeds_of(head, commitment, secret)
        except CannotDo as error:
            _say(f"left out: {error}")


def _say(line: str) -> None:
    print(f"proctor: {line}", file=sys.stderr)


def _seeds_of(head: RunHead, commitment: str, secret: bytes) -> OpenedSeeds:
    """The seeds of the whole benchmark, even if the run plays only a part of it."""
    benchmark_id = head.manifest["benchmark_id"]
    try:
        resolved = benchmark_registry.resolve(
            benchmark_id,
            head.submission.get("options"),
            head.images,
            max_chunk=head.manifest["max_chunk"],
        )
    except (LookupError, ValueError) as error:
        raise CannotDo(
            f"run {head.run_id}: {benchmark_id} is not offered here, or not with its "
            "options; set PROCTOR_BENCHMARKS to what --benchmarks of its server was"
        ) from error
    drawn = head.manifest.get("seeds_drawn")
    whole = seal_for_run(
        resolved.manifest, secret, resolved.seed_block, resolved.seed_max, drawn
    )
    opened = OpenedSeeds(
        commitment,
        salt_of(secret_of_run(secret, drawn), benchmark_id).hex(),
        [
            OpenedEpisode(episode["task"], episode["split"], episode["seed"])
            for episode in whole["episodes"]
            if is_sealed(whole, episode["split"])
        ],
    )
    if opened.commitment != commitment:
        raise CannotDo(
            f"run {head.run_id} was played with other seeds: {benchmark_id} has "
            "changed since, or this is not the secret of its server (seed_secret)"
        )
    return opened
