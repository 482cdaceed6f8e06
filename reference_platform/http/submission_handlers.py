"""The operations of hosting.yaml on uploads, logs, presets and images."""

from __future__ import annotations

from collections.abc import AsyncIterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final

import msgspec
from starlette.responses import Response, StreamingResponse

from reference_platform.http.api_calls import (
    ApiCall,
    Handler,
    json_response,
    maybe_time,
)
from reference_platform.images.bounded_archives import InvalidArchive
from reference_platform.images.image_reviews import (
    ImageDecision,
    ImageReviews,
    ReviewedImage,
)
from reference_platform.images.presets import Presets
from reference_platform.images.unpacked_roots import UnpackedRoots, UnpackingFailed
from reference_platform.images.upload_folder import Upload, UploadFolder
from reference_platform.submissions.interfaces import LogLine
from reference_platform.submissions.lifecycle import Submission
from reference_platform.submissions.log_redaction import LogRedaction
from reference_platform.submissions.submission_logs import FileLogs
from reference_server.http.bodies.request_bodies import stream_body
from reference_server.rules.refusal import Refused

LINES_MAX: Final = 1000
_EVENT_STREAM: Final = "text/event-stream"


class AttachedUpload(msgspec.Struct, forbid_unknown_fields=True):
    """dockerfile: shown to the reviewer of an image, and never built."""

    digest: str
    dockerfile: str = ""


class ImageDecisionBody(msgspec.Struct, forbid_unknown_fields=True):
    decision: ImageDecision
    reason: str = ""


@dataclass(frozen=True, slots=True)
class SubmissionHandlers:
    """One method per operation."""

    uploads: UploadFolder
    reviews: ImageReviews
    presets: Presets
    logs: FileLogs
    roots: UnpackedRoots

    def table(self) -> Mapping[str, dict[str, tuple[Handler, str | None]]]:
        """path → method → handler, and the scope of the key."""
        one = "/submissions/{submission_id}"
        return {
            "/presets": {"GET": (self.list_presets, "read")},
            "/uploads/{digest}": {
                "GET": (self.get_upload, "run"),
                "PATCH": (self.append_upload, "run"),
            },
            f"{one}/upload": {"POST": (self.attach_upload, "run")},
            f"{one}/log": {"GET": (self.read_log, "read")},
            "/images": {"GET": (self.list_images, "host")},
            "/images/{digest}/decisions": {"POST": (self.decide_image, "host")},
        }

    # --- uploads ---

    async def list_presets(self, _call: ApiCall) -> Response:
        return json_response({"presets": self.presets.names()})

    async def get_upload(self, call: ApiCall) -> Response:
        digest = call.path("digest")
        return _upload_response(digest, self.uploads.state(call.owner.name, digest))

    async def append_upload(self, call: ApiCall) -> Response:
        """The body goes to the disk part by part, and is answered by what is there."""
        digest, size = call.path("digest"), _number(call, "size")
        self.uploads.check(digest, size)
        upload = await self.uploads.append(
            call.owner.name,
            digest,
            size,
            _number(call, "offset"),
            stream_body(call.request),
        )
        return _upload_response(digest, upload)

    # --- submissions ---

    async def attach_upload(self, call: ApiCall) -> Response:
        body = await call.body(AttachedUpload)
        own = self._own(call)
        account = call.owner.name
        if not self.uploads.state(account, body.digest).is_complete:
            text = "The account has not uploaded such a file completely."
            raise Refused("not_found", text)
        if own.kind == "code" and own.preset not in self.presets.names():
            names = ", ".join(self.presets.names()) or "none"
            text = f"There is no preset {own.preset}; there are: {names}."
            raise Refused("invalid_request", text, errors=[("/preset", text)])
        path = self.uploads.path_of(account, body.digest)
        if own.kind == "image":
            await self._check_image(path)
            size = path.stat().st_size
            self.reviews.add(body.digest, account, size, body.dockerfile)
        call.parts.submissions.attach(own.submission_id, body.digest)
        return Response(status_code=204)

    async def read_log(self, call: ApiCall) -> Response:
        """The lines after one, at most 1000; or all that come, as events."""
        submission, after = self._readable(call), _number(call, "after", 0)
        phase = call.parts.submissions.place_of(submission).phase
        redaction = LogRedaction.of(phase, self.logs.host_folders)
        if _EVENT_STREAM in call.request.headers.get("accept", ""):
            lines = self.logs.follow(submission.submission_id, after)
            headers = {"Cache-Control": "no-store", "X-Accel-Buffering": "no"}
            return StreamingResponse(
                _events(lines, redaction), media_type=_EVENT_STREAM, headers=headers
            )
        # Asked before the lines are read: what is written last is not missed.
        is_ended = self.logs.is_ended(submission.submission_id)
        found = redaction.shown(self.logs.read(submission.submission_id, after))
        answer = {
            "lines": [_line_view(line) for line in found[:LINES_MAX]],
            "is_ended": is_ended,
            "shows": redaction.visibility,
        }
        return json_response(answer)

    # --- images ---

    async def list_images(self, _call: ApiCall) -> Response:
        waiting = self.reviews.in_state("waiting")
        return json_response({"images": [_image_view(image) for image in waiting]})

    async def decide_image(self, call: ApiCall) -> Response:
        body = await call.body(ImageDecisionBody)
        image = self.reviews.decide(
            call.path("digest"), body.decision, body.reason, call.account.account
        )
        return json_response(_image_view(image))

    async def _check_image(self, path: Path) -> None:
        """Before a person is asked to review it. Raises Refused."""
        try:
            await self.roots.check_image(path)
        except InvalidArchive as error:
            text = f"The upload is refused. {error}"
            wrong = [("/digest", "is no image that this host can play")]
            raise Refused("invalid_request", text, errors=wrong) from error
        except UnpackingFailed as error:
            raise Refused("unavailable", str(error)) from error

    def _own(self, call: ApiCall) -> Submission:
        return call.parts.submissions.get_own(
            call.path("submission_id"), [call.owner.name]
        )

    def _readable(self, call: ApiCall) -> Submission:
        """One of the caller, or one whose phase shows its log (HST-026)."""
        try:
            return self._own(call)
        except Refused:
            shown = call.parts.results.get(
                call.path("submission_id"), "log", [call.owner.name]
            )
            return call.parts.submissions.get(shown.result_id)


async def _events(
    lines: AsyncIterator[LogLine], redaction: LogRedaction
) -> AsyncIterator[bytes]:
    async for written in lines:
        for line in redaction.shown([written]):
            data = msgspec.json.encode(_line_view(line))
            yield b"event: line\nid: %d\ndata: %s\n\n" % (line.number, data)
    yield b"event: end\ndata: {}\n\n"


def _line_view(line: LogLine) -> Mapping[str, Any]:
    return {
        "number": line.number,
        "at": maybe_time(line.at),
        "source": line.source,
        "text": line.text,
    }


def _image_view(image: ReviewedImage) -> Mapping[str, Any]:
    times = {"created_at": image.created_at, "decided_at": image.decided_at}
    texts = {name: maybe_time(at) for name, at in times.items()}
    return {**msgspec.structs.asdict(image), **texts}


def _upload_response(digest: str, upload: Upload) -> Response:
    return json_response(
        {
            "digest": digest,
            "offset": upload.offset,
            "is_complete": upload.is_complete,
        }
    )


def _number(call: ApiCall, name: str, default: int | None = None) -> int:
    """A number of the query. Raises Refused."""
    text = call.request.query_params.get(name, "" if default is None else str(default))
    if not (text.isascii() and text.isdecimal() and len(text) <= 18):
        wrong = [(f"/{name}", "must be a number of the query")]
        raise Refused("invalid_request", f"`{name}` is missing or wrong.", errors=wrong)
    return int(text)
