"""The operations of spec/hosting.yaml on tracks, their results, and submissions."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping
from dataclasses import asdict, dataclass
from typing import Any, Literal

import msgspec
from starlette.responses import Response, StreamingResponse

from reference_platform.http.api_calls import (
    ApiCall,
    Handler,
    json_response,
    maybe_time,
)
from reference_platform.http.server_calls import ServerRuns
from reference_platform.submissions.lifecycle import Submission
from reference_platform.submissions.queue_places import with_place
from reference_platform.tracks.result_rules import ShownResult
from reference_platform.tracks.track_rules import Place, Track, Usage


class NewSubmission(msgspec.Struct, forbid_unknown_fields=True):
    track_id: str
    phase_id: str = ""
    kind: Literal["image", "code"] = "image"
    preset: str = ""
    policy_name: str = ""


@dataclass(frozen=True, slots=True)
class TrackHandlers:
    """One method per operation. runs: reads results at the server."""

    runs: ServerRuns

    def table(self) -> dict[str, dict[str, tuple[Handler, str | None]]]:
        """path → method → handler, and the scope of the key."""
        one = "/submissions/{submission_id}"
        return {
            "/tracks": {"GET": (list_tracks, "read")},
            "/tracks/{track_id}": {"GET": (get_track, "read")},
            "/tracks/{track_id}/entries": {"POST": (enter_track, "run")},
            "/tracks/{track_id}/results": {"GET": (self.list_results, "read")},
            "/results/{result_id}/record": {"GET": (self.fetch_record, "read")},
            "/submissions": {
                "GET": (list_submissions, "read"),
                "POST": (create_submission, "run"),
            },
            one: {"GET": (get_submission, "read")},
            f"{one}/start": {"POST": (start_submission, "run")},
            f"{one}/stop": {"POST": (stop_submission, "run")},
        }

    async def list_results(self, call: ApiCall) -> Response:
        shown = await call.parts.results.of_track(
            call.path("track_id"), [call.owner.name], self.runs
        )
        return json_response({"results": [result_view(one) for one in shown]})

    async def fetch_record(self, call: ApiCall) -> Response:
        result = call.parts.results.get(
            call.path("result_id"), "record", [call.owner.name]
        )
        return await record_response(self.runs, result.run_id)


async def record_response(runs: ServerRuns, run_id: str) -> Response:
    """The record as the server sends it."""
    headers, blocks = await runs.open_record(run_id)
    return StreamingResponse(blocks, headers=headers)


# --- tracks ---


async def list_tracks(call: ApiCall) -> Response:
    tracks = [_track_view(call, track) for track in call.parts.tracks.all()]
    return json_response({"tracks": tracks})


async def get_track(call: ApiCall) -> Response:
    track = call.parts.tracks.get(call.path("track_id"))
    return json_response(_track_view(call, track))


async def enter_track(call: ApiCall) -> Response:
    tracks = call.parts.tracks
    tracks.enter(call.path("track_id"), call.owner)
    return json_response(_track_view(call, tracks.get(call.path("track_id"))), 201)


def _track_view(call: ApiCall, track: Track) -> Mapping[str, Any]:
    entrant = call.parts.tracks.entrant(track.track_id, call.owner.name)
    names = ("track_id", "title", "rules", "entry", "entrants")
    return {
        **{name: getattr(track, name) for name in names},
        "entry_state": "none" if entrant is None else entrant.state,
        "phases": [_phase_view(call, Place(track, phase)) for phase in track.phases],
    }


def _phase_view(call: ApiCall, place: Place) -> Mapping[str, Any]:
    phase = msgspec.structs.asdict(place.phase)
    for name in ("per_day", "total", "at_once", "log_removes", "ranks"):
        del phase[name]
    limits = call.parts.tracks.usages_of(place, call.owner.name)
    return phase | {
        "title": place.phase.title or place.phase.phase_id,
        "opens_at": maybe_time(place.phase.opens_at),
        "closes_at": maybe_time(place.phase.closes_at),
        "is_open": place.phase.is_open(call.now),
        "limits": [_usage_view(usage) for usage in limits],
    }


def _usage_view(usage: Usage) -> Mapping[str, Any]:
    return msgspec.structs.asdict(usage) | {"resets_at": maybe_time(usage.resets_at)}


def result_view(result: ShownResult) -> Mapping[str, Any]:
    stored = result.stored
    return {
        "result_id": stored.result_id,
        "phase_id": stored.phase_id,
        "submitter": stored.owner,
        "policy_name": stored.policy_name,
        "made_at": maybe_time(stored.made_at),
        "score": result.score,
        "excluded": stored.excluded,
        "has_log": "log" in result.shown,
        "has_record": "record" in result.shown,
    }


# --- submissions ---


async def create_submission(call: ApiCall) -> Response:
    body = await call.body(NewSubmission)
    submission = call.parts.submissions.create(
        call.owner.name,
        body.track_id,
        kind=body.kind,
        preset=body.preset,
        policy_name=body.policy_name,
        phase_id=body.phase_id,
    )
    return json_response(_submission_view(call, submission), 201)


async def list_submissions(call: ApiCall) -> Response:
    mine = call.parts.submissions.of_owners([call.owner.name])
    return json_response({"submissions": [_submission_view(call, one) for one in mine]})


async def get_submission(call: ApiCall) -> Response:
    return _own_submission(call, call.parts.submissions.get_own)


async def start_submission(call: ApiCall) -> Response:
    return _own_submission(call, call.parts.submissions.start)


async def stop_submission(call: ApiCall) -> Response:
    return _own_submission(call, call.parts.submissions.stop)


def _own_submission(
    call: ApiCall, act: Callable[[str, Collection[str]], Submission]
) -> Response:
    submission = act(call.path("submission_id"), [call.owner.name])
    return json_response(_submission_view(call, submission))


def _submission_view(call: ApiCall, submission: Submission) -> Mapping[str, Any]:
    continues_at = call.parts.submissions.continues_at(submission)
    shown = submission_view(with_place(call.parts.submissions, submission))
    return {**shown, "continues_at": maybe_time(continues_at)}


def submission_view(submission: Submission) -> Mapping[str, Any]:
    """HST-019, HST-043: why it is in its state, until when, and what follows."""
    times = ("entered_at", "created_at", "deadline_at", "started_at")
    shown = asdict(submission)
    del shown["account"], shown["score"]
    shown |= {name: maybe_time(shown[name]) for name in times}
    return shown | {"next_action": submission.next_action}
