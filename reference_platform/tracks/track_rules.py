"""A track, and whether an account may make a run on it. Pure: no clock."""

from __future__ import annotations

import re
from collections.abc import Sequence
from datetime import UTC, datetime
from typing import Final, Literal

import msgspec

from reference_server.rules.refusal import Refused

DAY_S: Final = 86_400.0
_ID: Final = re.compile(r"[a-z][a-z0-9_-]{0,63}")
_BENCHMARK: Final = re.compile(r"[a-z][a-z0-9_]{0,63}")
Limit = Literal["per_day", "total", "at_once"]
# Whether entrants wait for an administrator, or must stand in `accounts`.
Entry = Literal["open", "review", "listed"]
# Which lines of the logs of submissions their owners see.
LogVisibility = Literal["all", "platform", "none"]
_PATTERNS_MAX: Final = 20


class Track(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """splits: that a run has to select, in any order; empty: the whole benchmark.

    opens_at, closes_at: seconds since the epoch. A limit that is None is none.
    log_removes: regular expressions of what owners do not see in a log.
    """

    track_id: str
    title: str
    benchmark_id: str
    opens_at: float
    closes_at: float
    rules: str = ""
    splits: tuple[str, ...] = ()
    entry: Entry = "open"
    accounts: tuple[str, ...] = ()
    per_day: int | None = None
    total: int | None = None
    at_once: int | None = None
    log_shows: LogVisibility = "all"
    log_removes: tuple[str, ...] = ()

    def is_open(self, now: float) -> bool:
        return self.opens_at <= now < self.closes_at


class TrackRun(msgspec.Struct, frozen=True):
    """state: as the server says it; `admitted` before that, `refunded` if it failed."""

    run_id: str
    track_id: str
    account: str
    made_at: float
    state: str
    score: float | None

    @property
    def is_counted(self) -> bool:
        return self.state != "refunded"

    @property
    def is_open(self) -> bool:
        return self.state in OPEN_STATES


OPEN_STATES: Final = ("admitted", "queued", "ready", "running", "stopping", "hosted")


class Usage(msgspec.Struct, frozen=True):
    """The use of one limit. resets_at: when it allows one more, if known."""

    limit: Limit
    allowed: int
    used: int
    resets_at: float | None


class AskedRun(msgspec.Struct, frozen=True):
    """A run that an account is about to make."""

    run_id: str
    account: str
    benchmark_id: str
    splits: tuple[str, ...] = ()
    tasks: tuple[str, ...] = ()
    policy_url: str = ""


def check_track(track: Track) -> None:
    """Raises Refused, which names each member that is wrong."""
    limits = (track.per_day, track.total, track.at_once)
    wrong = {
        "track_id": not _ID.fullmatch(track.track_id),
        "title": not (track.title.strip() and len(track.title) <= 200),
        "benchmark_id": not _BENCHMARK.fullmatch(track.benchmark_id),
        "closes_at": track.closes_at <= track.opens_at,
        "per_day, total, at_once": any(n is not None and n < 1 for n in limits),
        "rules": len(track.rules) > 20_000,
        "log_removes": not _are_patterns(track.log_removes),
    }
    errors = [(f"/{name}", "is wrong") for name, is_wrong in wrong.items() if is_wrong]
    if errors:
        names = ", ".join(pointer[1:] for pointer, _ in errors)
        raise Refused("invalid_request", f"Wrong in the track: {names}.", errors=errors)


def _are_patterns(texts: Sequence[str]) -> bool:
    """None of them may match the empty text, which is everywhere."""
    try:
        return len(texts) <= _PATTERNS_MAX and not any(
            re.compile(text).search("") for text in texts
        )
    except re.error:
        return False


def usages(track: Track, runs: Sequence[TrackRun], now: float) -> list[Usage]:
    """The limits of a track, for the runs of one account on it (HST-011, HST-015).

    `per_day` is a window of 24 hours that ends now: it opens when its oldest run is a
    day old.
    """
    counted = [run for run in runs if run.is_counted]
    today = sorted(run.made_at for run in counted if run.made_at > now - DAY_S)
    found = []
    if track.per_day is not None:
        is_full = len(today) >= track.per_day
        opens_at = today[-track.per_day] + DAY_S if is_full else None
        found.append(Usage("per_day", track.per_day, len(today), opens_at))
    if track.total is not None:
        found.append(Usage("total", track.total, len(counted), None))
    if track.at_once is not None:
        playing = sum(run.is_open for run in runs)
        found.append(Usage("at_once", track.at_once, playing, None))
    return found


def fits(track: Track, asked: AskedRun) -> bool:
    """Whether the run plays what the track evaluates."""
    is_same = track.benchmark_id == asked.benchmark_id and not asked.tasks
    return is_same and set(track.splits) == set(asked.splits)


def choose_track(
    tracks: Sequence[Track],
    asked: AskedRun,
    runs: Sequence[TrackRun],
    now: float,
) -> Track:
    """The track that a run counts for: the first that has room. Raises Refused.

    tracks: that the account has entered. runs: of the account (HST-010, HST-011).
    """
    if not tracks:
        raise Refused("forbidden", "The account has entered no track.")
    of_benchmark = [t for t in tracks if t.benchmark_id == asked.benchmark_id]
    if not of_benchmark:
        names = ", ".join(sorted({track.benchmark_id for track in tracks}))
        text = f"No track of this account has the benchmark; its tracks have {names}."
        raise Refused("forbidden", text)
    fitting = [track for track in of_benchmark if fits(track, asked)]
    if not fitting:
        ways = "; ".join(sorted({_selection(track) for track in of_benchmark}))
        raise Refused("forbidden", f"The tracks of this benchmark evaluate {ways}.")
    is_open = [track for track in fitting if track.is_open(now)]
    if not is_open:
        text = f"The track {fitting[0].track_id} is not open now."
        raise Refused("forbidden", text)
    refusals = []
    for track in sorted(is_open, key=lambda track: track.closes_at):
        of_track = [run for run in runs if run.track_id == track.track_id]
        used_up = [u for u in usages(track, of_track, now) if u.used >= u.allowed]
        if not used_up:
            return track
        refusals.append(_quota_refusal(track, used_up[0]))
    raise refusals[0]


def time_text(at: float) -> str:
    """RFC 3339 in UTC, with milliseconds, as everywhere in the standard."""
    moment = datetime.fromtimestamp(at, UTC).isoformat(timespec="milliseconds")
    return moment.replace("+00:00", "Z")


def _selection(track: Track) -> str:
    if not track.splits:
        return "the whole benchmark, without `select`"
    return f"the splits {', '.join(track.splits)}"


def _quota_refusal(track: Track, usage: Usage) -> Refused:
    words = {"per_day": "in 24 hours", "total": "in all", "at_once": "at a time"}
    text = f"The track {track.track_id} allows {usage.allowed} runs "
    text += f"{words[usage.limit]}."
    members: dict[str, object] = {"limit": usage.limit, "track_id": track.track_id}
    if usage.resets_at is not None:
        opens_at = time_text(usage.resets_at)
        members["resets_at"] = opens_at
        text += f" The next is possible at {opens_at}."
    return Refused("quota_exceeded", text, members=members)
