"""The pages of hosted submissions: their state and log, and the review of images."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from itertools import groupby
from typing import Any, Final

import msgspec
from starlette.responses import Response

from reference_platform.images.image_reviews import (
    DECISIONS,
    ImageDecision,
    ImageReviews,
)
from reference_platform.pages.form_calls import PageCall, Show
from reference_platform.submissions.interfaces import LogLine
from reference_platform.submissions.lifecycle import (
    FINAL,
    OPEN_STATES,
    TRANSITIONS,
    Submission,
)
from reference_platform.submissions.log_redaction import LogRedaction
from reference_platform.submissions.queue_places import with_place
from reference_platform.submissions.submission_logs import FileLogs
from reference_record.texts.repeated_lines import RepeatedLines
from reference_server.rules.refusal import Refused

LINES_SHOWN: Final = 500
# A browser reads the page of a submission again while it changes.
REFRESH_S: Final = 5


@dataclass(frozen=True, slots=True)
class SubmissionPages:
    """The pages of a host that runs submissions."""

    reviews: ImageReviews
    logs: FileLogs

    def shown(self) -> Mapping[str, tuple[Show, str]]:
        """Path → page, and who may see it."""
        return {
            "/submissions/{submission_id}": (self.show_submission, "account"),
            "/results/{result_id}/log": (self.show_log, "account"),
            "/images": (self.show_images, "administrator"),
        }

    def changed(self) -> Mapping[str, tuple[Show, str]]:
        """Path → what a form does, and who may send it."""
        return {
            "/submissions/{submission_id}/start": (start_submission, "approved"),
            "/submissions/{submission_id}/stop": (stop_submission, "account"),
            "/images/{digest}": (self.decide_image, "administrator"),
        }

    async def show_submission(self, call: PageCall) -> Response:
        submission = call.parts.submissions.get_own(
            call.path("submission_id"), call.owners
        )
        legal = TRANSITIONS[submission.state]
        response = call.page(
            "submissions/submission",
            submission=with_place(call.parts.submissions, submission),
            acts=[act for act in ("start", "stop") if act in legal],
            **self._log(call, submission),
        )
        if submission.state not in FINAL:
            response.headers["Refresh"] = str(REFRESH_S)
        return response

    async def show_log(self, call: PageCall) -> Response:
        """The log of a result of others, where its phase shows logs (HST-026)."""
        result = call.parts.results.get(call.path("result_id"), "log", call.owners)
        log = self._log(call, call.parts.submissions.get(result.result_id))
        return call.page("submissions/result_log", result=result, **log)

    def _log(self, call: PageCall, submission: Submission) -> Mapping[str, Any]:
        """The entries of a log that its phase shows (HST-041)."""
        phase = call.parts.submissions.place_of(submission).phase
        redaction = LogRedaction.of(phase, self.logs.host_folders)
        lines = redaction.shown(self.logs.read(submission.submission_id))
        return {
            "entries": log_entries(without_repeats(lines[-LINES_SHOWN:])),
            "shown": min(len(lines), LINES_SHOWN),
            "explanation": redaction.explanation,
            "left_out": max(0, len(lines) - LINES_SHOWN),
        }

    async def show_images(self, call: PageCall, problem: str = "") -> Response:
        """Images that wait, and what is played or stuck."""
        return call.page(
            "submissions/images",
            problem=problem,
            waiting=self.reviews.in_state("waiting"),
            decisions=DECISIONS,
            submissions=call.parts.submissions.in_states(*OPEN_STATES),
            now=call.parts.clock(),
        )

    async def decide_image(self, call: PageCall) -> Response:
        try:
            decision = msgspec.convert(call.form.get("decision"), ImageDecision)
            reason, actor = call.form.get("reason", ""), call.account.account
            self.reviews.decide(call.path("digest"), decision, reason, actor)
        except msgspec.ValidationError:
            return await self.show_images(call, "Choose a decision.")
        except Refused as refused:
            return await self.show_images(call, refused.detail)
        return call.redirect("/images")


def without_repeats(lines: Iterable[LogLine]) -> Iterator[LogLine]:
    """The lines of the policy that come again are shown once, and counted."""
    repeats, line = RepeatedLines(), None
    for line in lines:
        if line.source == "policy":
            shown = repeats.add(line.text)
        else:
            shown = repeats.flush()
        yield from (LogLine(line.number, line.at, "policy", text) for text in shown)
        if line.source != "policy":
            yield line
    if line is not None:
        for text in repeats.flush():
            yield LogLine(line.number, line.at, "policy", text)


def log_entries(lines: Iterable[LogLine]) -> list[LogLine]:
    """Lines of one source and one second, such as those of a traceback, as one."""
    grouped = groupby(lines, key=lambda line: (line.source, int(line.at)))
    entries = []
    for _, same in grouped:
        first, *others = same
        text = "\n".join([first.text, *(line.text for line in others)])
        entries.append(LogLine(first.number, first.at, first.source, text))
    return entries


async def show_submissions(call: PageCall) -> Response:
    store = call.parts.submissions
    mine = [with_place(store, one) for one in store.of_owners(call.owners)[:100]]
    return call.page("submissions/submissions", submissions=mine)


async def start_submission(call: PageCall) -> Response:
    name = call.path("submission_id")
    call.parts.submissions.start(name, call.owners)
    return call.redirect(f"/submissions/{name}")


async def stop_submission(call: PageCall) -> Response:
    name = call.path("submission_id")
    call.parts.submissions.stop(name, call.owners)
    return call.redirect(f"/submissions/{name}")
