"""The reference server, which plays runs with one attempt per episode backwards.

`python -m tests.support.kit.server_with_one_wrong_order`. No check of the kit judges
the order of episodes in such a run; set-ups of other checks see it.
"""

import heapq
import sys

from reference_server.__main__ import main
from reference_server.rules.runs.run import Episode, Run
from tests.mutants import put


def take_last_pending(run: Run, first: int | None = None) -> Episode | None:
    if not run.pending or run.manifest["max_attempts"] != 1:
        return right(run, first)
    last = max(run.pending)
    run.pending.remove(last)
    heapq.heapify(run.pending)
    run.episodes[last].in_progress = True
    return run.episodes[last]


right = Run.take_pending

if __name__ == "__main__":
    put(Run, "take_pending", take_last_pending)
    sys.exit(main())
