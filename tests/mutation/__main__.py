"""`python -m tests.mutation SERVER`: judge a sample of its mutants, go on if ended.

The page of all results is written at the end. With `--written` there is no page.
"""

import argparse
import contextlib
import signal
import sys

from tests.mutation.campaign import Campaign, Record, choose, results_of
from tests.mutation.page import build_page
from tests.mutation.targets import TARGETS
from tests.mutation.triage import read_triage
from tests.mutation.written.written_bugs import (
    are_noticed,
    read_bugs,
    results_of_written,
)


def main() -> int:
    """Return 0 when the results reach the goal, or each written bug is noticed."""
    arguments = argparse.ArgumentParser(description=__doc__)
    arguments.add_argument("server", choices=TARGETS)
    arguments.add_argument("--sample", type=int, default=0, help="0: all mutants")
    arguments.add_argument("--seed", type=int, default=1, help="of sample and kit")
    arguments.add_argument("--jobs", type=int, default=2, help="kits at once")
    arguments.add_argument(
        "--again",
        default="",
        metavar="OUTCOME,…",
        help="judge these once more, unless excused",
    )
    arguments.add_argument("--only", default="", metavar="ID,…", help="mutants")
    arguments.add_argument(
        "--written", action="store_true", help="the bugs that people wrote instead"
    )
    options = arguments.parse_args()
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    target = TARGETS[options.server]
    results = results_of(target)
    mutants = target.mutants()
    if options.written:
        results = results_of_written(target)
        mutants = [bug.mutant for bug in read_bugs(target)]
    chosen = choose(mutants, options.sample, options.seed)
    if options.only:
        wanted = set(options.only.split(","))
        chosen = [mutant for mutant in mutants if mutant.id in wanted]
    again = {word for word in options.again.split(",") if word}
    excused = {id_ for id_, reason in read_triage().items() if reason.is_excused}
    if not options.only:
        chosen = [mutant for mutant in chosen if mutant.id not in excused or not again]
    campaign = Campaign(target, options.seed, options.jobs, results)
    with contextlib.suppress(KeyboardInterrupt):
        campaign.run(chosen, again, _print)
    return 0 if (are_noticed(target) if options.written else build_page()) else 1


def _print(record: Record) -> None:
    change = f"`{_short(record.original)}` → `{_short(record.replacement)}`"
    what = " ".join(record.failed) or record.conclusion.split("\n")[0][:80]
    sys.stdout.write(
        f"{record.outcome:9} {record.id} {record.file}:{record.line} "
        f"{record.function} {record.operator} {change} ({what}, "
        f"{record.elapsed_s:.1f} s)\n"
    )
    sys.stdout.flush()


def _short(source: str) -> str:
    line = " ".join(source.split())
    return line if len(line) < 60 else line[:57] + "…"


if __name__ == "__main__":
    sys.exit(main())
