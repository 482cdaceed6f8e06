"""`proctor admin image|submission`: the review of images, and what is played."""

from __future__ import annotations

import getpass
import time
from collections.abc import Callable, Sequence

import click
import msgspec

from reference_platform.images.image_reviews import (
    ImageDecision,
    ImageReviews,
    ImageState,
    ReviewedImage,
)
from reference_platform.parts import Parts
from reference_platform.submissions.lifecycle import STATES, WAITING
from reference_platform.submissions.queue_places import with_place
from reference_platform.submissions.submission_logs import FileLogs
from reference_record.command_line.click_commands import (
    Command,
    Group,
    Options,
    argument,
    option,
)
from reference_record.texts.timestamps import timestamp

_IMAGE_STATES: Sequence[ImageState] = ("waiting", "approved", "rejected")
Do = Callable[[Parts, Options], None]


def submission_groups(
    database: click.Parameter, folder: click.Parameter
) -> list[Group]:
    digest = argument("digest", "its digest, as `list` shows it")
    reason = option("--reason", "the account reads it", default="")
    images = [
        Command("list", "list images, those that wait first", [database], do=_images),
        Command(
            "show", "show the Dockerfile that came with it", [digest, database],
            do=_show_image,
        ),
        *(
            Command(
                name, f"{name} an image", [digest, reason, database],
                do=_decide_image, decision=name,
            )
            for name in ("approve", "reject")
        ),
    ]  # fmt: skip
    submission = argument("submission", "id of the submission")
    submissions = [
        Command(
            "list", "list submissions that have not ended", [database], do=_submissions
        ),
        Command(
            "stop", "stop a submission", [submission, reason, database], do=_stop
        ),
        Command(
            "log", "print the whole log, whatever its track shows",
            [submission, folder, database], do=_log,
        ),
    ]  # fmt: skip
    return [
        Group("image", "which images are run", images),
        Group("submission", "what is handed in", submissions),
    ]


def _images(parts: Parts, _args: Options) -> None:
    reviews = ImageReviews(parts.database)
    for state in _IMAGE_STATES:
        for image in reviews.in_state(state):
            print(_line_of(image))


def _line_of(image: ReviewedImage) -> str:
    size = f"{image.size / 2**20:.1f} MiB"
    text = f"{image.digest} {image.state:<9} {image.account}, {size}"
    return f"{text} {image.reason}".rstrip()


def _show_image(parts: Parts, args: Options) -> None:
    image = ImageReviews(parts.database).get(args.digest)
    print("there is no such image" if image is None else image.dockerfile)


def _decide_image(parts: Parts, args: Options) -> None:
    decision = msgspec.convert(args.decision, ImageDecision)
    reviews = ImageReviews(parts.database)
    print(_line_of(reviews.decide(args.digest, decision, args.reason, _actor())))


def _submissions(parts: Parts, _args: Options) -> None:
    """Each with the reason why it lasts; one that is over its deadline is stuck."""
    now = time.time()
    open_states = [state for state in STATES if state in WAITING]
    for one in parts.submissions.in_states(*open_states):
        is_stuck = one.deadline_at is not None and one.deadline_at < now
        stuck = " STUCK" if is_stuck else ""
        text = f"{one.submission_id} {one.state:<9}{stuck} {one.account} {one.track_id}"
        reason = with_place(parts.submissions, one).reason
        print(f"{text} since {timestamp(one.entered_at)}: {reason}")


def _stop(parts: Parts, args: Options) -> None:
    reason = args.reason or "The host stopped it."
    stopped = parts.submissions.stop_by_host(args.submission, reason, _actor())
    print(f"{stopped.submission_id} {stopped.state}")


def _log(parts: Parts, args: Options) -> None:
    parts.submissions.get_for_host(args.submission)
    logs = FileLogs(args.submissions / "logs", lambda _: True)
    for line in logs.read(args.submission):
        print(f"{timestamp(line.at)} {line.source:<8} {line.text}")


def _actor() -> str:
    return f"{getpass.getuser()} on this machine"
