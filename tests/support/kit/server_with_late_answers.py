"""The reference server, right but slow in one of its answers, as a busy machine is.

`python -m tests.support.kit.server_with_late_answers submit|resume|predict [OPTION…]`.
A submit or a resume is answered when its time in the queue is over: the run in the
answer is `ready`, as it is by then. A turn is answered long after the result of its
episode.
"""

import asyncio
import sys
from typing import Any

from reference_record.generated.answers import Turn
from reference_server.__main__ import main
from reference_server.rules.runs.run import Run
from reference_server.runs.registry import RunRegistry
from reference_server.runs.sessions.session_executor import SessionExecutor
from tests.mutants import put

LATE_SUBMIT_S, LATE_RESUME_S, LATE_TURN_S = 1.2, 0.7, 2.5

add, commit_opened = RunRegistry.add, RunRegistry.commit_opened
predict = SessionExecutor.predict


async def add_late(registry: RunRegistry, run: Run, *key: Any) -> Run:
    added = await add(registry, run, *key)
    await asyncio.sleep(LATE_SUBMIT_S)
    return added


async def commit_late(registry: RunRegistry, run: Run) -> None:
    await commit_opened(registry, run)
    await asyncio.sleep(LATE_RESUME_S)


async def answer_late(executor: SessionExecutor, *turn: Any) -> Turn:
    answer = await predict(executor, *turn)
    await asyncio.sleep(LATE_TURN_S)
    return answer


if __name__ == "__main__":
    late = sys.argv.pop(1)
    if late == "submit":
        put(RunRegistry, "add", add_late)
    elif late == "resume":
        put(RunRegistry, "commit_opened", commit_late)
    else:
        put(SessionExecutor, "predict", answer_late)
    sys.exit(main())
