"""The reference server, right but slow: a resume is answered when its queue is over.

`python -m tests.support.kit.server_with_late_answers_to_resume`. A busy machine does
the same now and then: the run in the answer is `ready`, as it is by then.
"""

import asyncio
import sys

from reference_server.__main__ import main
from reference_server.rules.run import Run
from reference_server.runs.registry import RunRegistry
from tests.mutants import put

LATE_S = 0.7

commit_opened = RunRegistry.commit_opened


async def commit_late(registry: RunRegistry, run: Run) -> None:
    await commit_opened(registry, run)
    await asyncio.sleep(LATE_S)


if __name__ == "__main__":
    put(RunRegistry, "commit_opened", commit_late)
    sys.exit(main())
