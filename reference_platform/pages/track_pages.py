"""The pages of tracks: their phases, what is left of limits, runs and results."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from starlette.responses import Response

from reference_platform.http.server_calls import ServerRuns
from reference_platform.http.track_handlers import record_response
from reference_platform.pages.form_calls import PageCall
from reference_platform.tracks.track_rules import Place, Track, phase_command
from reference_server.rules.refusal import Refused

RUNS_SHOWN = 50


async def show_index(call: PageCall) -> Response:
    tracks = call.parts.tracks.all()
    return call.page("tracks/index", tracks=tracks, now=call.parts.clock())


@dataclass(frozen=True, slots=True)
class TrackPages:
    """The pages that show what the server has. runs: reads it there."""

    runs: ServerRuns

    async def show_track(self, call: PageCall) -> Response:
        tracks = call.parts.tracks
        track = tracks.get(call.path("track_id"))
        stale, left = "", 0
        try:
            for name in call.owners:
                await tracks.refresh(name, self.runs)
            left = await call.parts.results.refresh(track.track_id, self.runs)
            await call.parts.results.entries.refresh(self.runs)
        except Refused as refused:
            stale = refused.detail
        return call.page(
            "tracks/track",
            track=track,
            commands={
                phase.phase_id: phase_command(
                    Place(track, phase), call.links.server_url
                )
                for phase in track.phases
            },
            now=call.parts.clock(),
            entries=[_entry(call, track, name) for name in call.owners],
            seeds={
                phase.phase_id: tracks.draws.describe(
                    Place(track, phase), call.parts.clock()
                )
                for phase in track.phases
            },
            boards={
                phase.phase_id: call.parts.results.entries.boards_of(
                    track.track_id, phase.phase_id
                )
                for phase in track.phases
            },
            rankings=[
                call.parts.results.ranking(track, phase, call.owners, RUNS_SHOWN)
                for phase in track.phases
            ],
            stale=stale,
            left=left,
        )

    async def show_record(self, call: PageCall) -> Response:
        result_id = call.path("result_id")
        result = call.parts.results.get(result_id, "record", call.owners)
        return await record_response(self.runs, result.run_id)


def _entry(call: PageCall, track: Track, name: str) -> dict[str, Any]:
    """How one of the names of the reader takes part in a track."""
    tracks = call.parts.tracks
    places = [Place(track, phase) for phase in track.phases]
    return {
        "name": name,
        "may_enter": track.entrants == "any" or name != call.account.account,
        "entrant": tracks.entrant(track.track_id, name),
        "usages": [
            (place.phase, usage)
            for place in places
            for usage in tracks.usages_of(place, name)
        ],
        "runs": tracks.runs_of(name, track.track_id)[:RUNS_SHOWN],
    }


async def enter_track(call: PageCall) -> Response:
    track_id = call.path("track_id")
    owner = call.parts.organisations.owner(
        call.account.account, call.form.get("owner", "")
    )
    call.parts.tracks.enter(track_id, owner)
    return call.redirect(f"/tracks/{track_id}")
