"""Deletes the runs of the checks when all have ended, and says which of them stay.

Earlier would be wrong: some checks read runs that others have played. Nothing here is
judged; whether the server deletes as it must is for the checks of DEL-001 and so on.
"""

import contextlib
import time
from collections.abc import Sequence

from conformance.client.check_context import CheckContext
from conformance.client.http_client import NoAnswer
from conformance.client.request_context import SharedContext
from conformance.run_settings import Settings

# Token and id of each run.
SubmittedRuns = Sequence[tuple[str | None, str]]
_DELETION = "deletion"
_TIMEOUT_S = 60.0


def delete_runs(settings: Settings, runs: SubmittedRuns) -> str | None:
    """Delete what the server deletes; a sentence on what stays, None if nothing does.

    A server that the kit has started keeps nothing.
    """
    if settings.start_cmd is not None or not runs:
        return None
    if not settings.is_offered(_DELETION):
        why = "it does not offer the profile deletion"
        return _sentence(len(runs), why, settings.url)
    stay = len(runs)
    with contextlib.closing(SharedContext.of(settings)) as shared:
        context = CheckContext(shared, "deletion of the runs of the checks")
        until = time.monotonic() + _TIMEOUT_S
        with contextlib.suppress(NoAnswer):
            for token, run_id in runs:
                if time.monotonic() > until:
                    break
                context.exchange_log.allow_more()
                caller = context.client_with_token(token)
                answer = context.call("delete_run", http_client=caller, run_id=run_id)
                # A check may have deleted it.
                stay -= answer.status in (204, 404)
    if stay == 0:
        return None
    why = "it does not delete what was played; the reference server does with "
    return _sentence(stay, f"{why}--delete-played-runs on", settings.url)


def _sentence(stay: int, why: str, url: str) -> str:
    noun = "run" if stay == 1 else "runs"
    return (
        f"{stay} {noun} of calibration, played by the checks, stay on the server: "
        f"{why}. `proctor status --benchmark calibration --url {url}` lists them."
    )
