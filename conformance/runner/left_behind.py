"""Deletes the runs of the checks when all have ended, and says what stays of them.

Earlier would be wrong: some checks read runs that others have played. Nothing here is
judged; whether the server deletes as it must is for the checks of DEL-001 and so on.
The commands that are named are those of the reference host.
"""

import contextlib
import time
from collections import Counter
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
        return _sentence(settings, len(runs), "it does not offer the profile deletion")
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
    return _sentence(
        settings,
        stay,
        "it does not delete what was played; the reference server does with "
        "--delete-played-runs on",
    )


# Kinds of what is left, and what becomes of them; then their nouns.
_LEFT = {
    ("account",): "which `proctor admin account delete {names}` removes",
    ("key", "upload"): "which `proctor admin platform clean --days 1` removes in a day",
    ("submission", "organisation"): "which stay, and count against no limit",
    ("entry",): "of which the history keeps the leaves for good",
}
_NOUNS = {
    "account": ("pending account", "pending accounts"),
    "key": ("revoked key", "revoked keys"),
    "upload": ("upload", "uploads"),
    "submission": ("stopped submission", "stopped submissions"),
    "organisation": ("empty organisation", "empty organisations"),
    "entry": ("withdrawn entry", "withdrawn entries"),
}


def describe_left(settings: Settings, left: Sequence[tuple[str, str]]) -> str | None:
    """A sentence on everything but runs that stays; None if nothing does.

    left: kind and name of each.
    """
    if settings.start_cmd is not None or not left:
        return None
    numbers = Counter(kind for kind, _ in left)
    names = " ".join(name for kind, name in left if kind == "account")
    parts = []
    for kinds, what_follows in _LEFT.items():
        there = [
            f"{numbers[kind]} {_NOUNS[kind][numbers[kind] > 1]}"
            for kind in kinds
            if numbers[kind]
        ]
        if there:
            parts.append(f"{' and '.join(there)}, {what_follows.format(names=names)}")
    return f"The checks left at the server: {'; '.join(parts)}."


def _sentence(settings: Settings, stay: int, why: str) -> str:
    noun = "run" if stay == 1 else "runs"
    text = f"{stay} {noun} of calibration, played by the checks, stay on the server"
    if not settings.is_offered("lists"):
        return f"{text}: {why}."
    command = f"proctor status --benchmark calibration --url {settings.url}"
    return f"{text}: {why}. `{command}` lists them."
