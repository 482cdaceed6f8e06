"""A track, its phases, and whether an account may make a run on one. Pure: no clock."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from datetime import UTC, datetime
from typing import Any, Final, Literal, NamedTuple

import msgspec

from reference_record.command_line.printed_commands import server_command
from reference_record.texts.counted_text import counted
from reference_record.texts.timestamps import timestamp
from reference_server.rules.refusal import NAME_CHARS_MAX, Refused, list_names

DAY_S: Final = 86_400.0
_ID: Final = re.compile(r"[a-z][a-z0-9_-]{0,63}")
_BENCHMARK: Final = re.compile(r"[a-z][a-z0-9_]{0,63}")
Limit = Literal["per_day", "total", "at_once"]
# Whether entrants wait for an administrator, or must stand in `accounts`.
Entry = Literal["open", "review", "listed"]
# Which lines of the logs of submissions their owners see.
LogVisibility = Literal["all", "platform", "none"]
_PATTERNS_MAX: Final = 20
_ID_WORDS: Final = (
    "must be a letter and up to 63 letters, digits, _ and -, all lowercase"
)
_TITLE_WORDS: Final = "must be a text of at most 200 characters"
# Who enters: an account or an organisation, or organisations alone.
Entrants = Literal["any", "organisations"]
# When a part of a result is shown to other accounts, and which parts there are.
Moment = Literal["at_once", "after_close", "never"]
Shown = Literal["score", "log", "record"]
# Which result of an entrant stands for it in the table of its phase.
Ranks = Literal["best", "last"]
SHOWN: Final[tuple[Shown, ...]] = ("score", "log", "record")
# `held_out`: the host draws the seeds when the phase closes, and plays all submissions
# that were committed to before (HST-029).
Seeds = Literal["benchmark", "held_out"]


class Phase(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A part of a track with dates, episodes, limits and visibility of its own.

    splits: that a run has to select, in any order; empty: the whole benchmark.
    options: of the benchmark, that a run has to have; None: any. opens_at, closes_at:
    seconds since the epoch. A limit that is None is none. score, log, record: when
    each is shown to others. log_removes: regular
    expressions of what entrants do not see in a log.
    """

    phase_id: str
    benchmark_id: str
    opens_at: float
    closes_at: float
    title: str = ""
    splits: tuple[str, ...] = ()
    options: dict[str, Any] | None = None
    seeds: Seeds = "benchmark"
    per_day: int | None = None
    total: int | None = None
    at_once: int | None = None
    score: Moment = "at_once"
    log: Moment = "never"
    record: Moment = "never"
    log_shows: LogVisibility = "all"
    log_removes: tuple[str, ...] = ()
    ranks: Ranks = "best"

    def is_open(self, now: float) -> bool:
        return self.opens_at <= now < self.closes_at

    def shows(self, part: Shown, now: float) -> bool:
        """HST-026: whether other accounts see this part of a result."""
        moment: Moment = getattr(self, part)
        return moment == "at_once" or (
            moment == "after_close" and now >= self.closes_at
        )

    @property
    def limits(self) -> Mapping[Limit, int]:
        """The limits that there are, of one entrant."""
        limits: Mapping[Limit, int | None] = {
            "per_day": self.per_day, "total": self.total, "at_once": self.at_once
        }  # fmt: skip
        return {limit: most for limit, most in limits.items() if most is not None}

    @property
    def is_held_out(self) -> bool:
        return self.seeds == "held_out"


class Track(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A challenge: who may enter it, and its phases."""

    track_id: str
    title: str
    phases: tuple[Phase, ...]
    rules: str = ""
    entry: Entry = "open"
    entrants: Entrants = "any"
    accounts: tuple[str, ...] = ()

    @property
    def closes_at(self) -> float:
        return max(phase.closes_at for phase in self.phases)

    def phase(self, phase_id: str) -> Phase:
        """Raises Refused."""
        for phase in self.phases:
            if phase.phase_id == phase_id:
                return phase
        detail = f"The track {self.track_id} has no phase {phase_id[:NAME_CHARS_MAX]}."
        phases = list_names(phase.phase_id for phase in self.phases)
        raise Refused("not_found", detail, act=phases)


class Place(NamedTuple):
    """A phase of a track."""

    track: Track
    phase: Phase

    def __str__(self) -> str:
        return f"the phase {self.phase.phase_id} of the track {self.track.track_id}"


class TrackRun(msgspec.Struct, frozen=True):
    """A run of the server, or under its own id a hosted submission that counts.

    state: as the server says it; `admitted` before that, `refunded` if it failed.
    """

    run_id: str
    track_id: str
    account: str
    made_at: float
    state: str
    score: float | None
    phase_id: str
    policy_name: str = ""

    @property
    def is_counted(self) -> bool:
        return self.state != "refunded"

    @property
    def is_open(self) -> bool:
        return self.state in OPEN_STATES

    @property
    def is_hosted(self) -> bool:
        return self.run_id.startswith("sub_")


OPEN_STATES: Final = ("admitted", "queued", "ready", "running", "stopping")


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
    options: dict[str, Any] = {}
    policy_url: str = ""
    policy_name: str = ""


def check_track(track: Track) -> None:
    """Raises Refused, which names each member that is wrong."""
    phases = track.phases
    has_phases = 1 <= len(phases) <= 50
    rules: dict[str, tuple[object, str]] = {
        "track_id": (_ID.fullmatch(track.track_id), _ID_WORDS),
        "title": (track.title.strip() and len(track.title) <= 200, _TITLE_WORDS),
        "rules": (len(track.rules) <= 20_000, "must have at most 20,000 characters"),
        "phases": (
            has_phases and len({phase.phase_id for phase in phases}) == len(phases),
            "must be 1 to 50 phases, each with a phase_id of its own",
        ),
    }
    for place, phase in enumerate(phases):
        rules |= {f"phases/{place}/{n}": rule for n, rule in _rules(phase).items()}
    errors = [(f"/{name}", text) for name, (holds, text) in rules.items() if not holds]
    if errors:
        said = "; ".join(f"{pointer[1:]} {text}" for pointer, text in errors)
        raise Refused("invalid_request", f"Wrong in the track: {said}.", errors=errors)


def _are_patterns(texts: Sequence[str]) -> bool:
    """None of them may match the empty text, which is everywhere."""
    try:
        return len(texts) <= _PATTERNS_MAX and not any(
            re.compile(text).search("") for text in texts
        )
    except re.error:
        return False


def _rules(phase: Phase) -> Mapping[str, tuple[object, str]]:
    """By member: whether its rule holds, and the rule."""
    patterns = f"must be at most {_PATTERNS_MAX} regular expressions that match a text"
    return {
        "phase_id": (_ID.fullmatch(phase.phase_id), _ID_WORDS),
        "title": (len(phase.title) <= 200, "must have at most 200 characters"),
        "benchmark_id": (
            _BENCHMARK.fullmatch(phase.benchmark_id),
            "must be a letter and up to 63 letters, digits and _, all lowercase",
        ),
        "closes_at": (phase.closes_at > phase.opens_at, "must be after opens_at"),
        **{
            limit: (most >= 1, "must be 1 or more")
            for limit, most in phase.limits.items()
        },
        "log_removes": (_are_patterns(phase.log_removes), patterns),
    }


def usages(phase: Phase, runs: Sequence[TrackRun], now: float) -> list[Usage]:
    """The limits of a phase, for the runs of one entrant in it (HST-011, HST-015).

    `per_day` is a window of 24 hours that ends now: it opens when its oldest run is a
    day old.
    """
    counted = [run for run in runs if run.is_counted]
    today = sorted(run.made_at for run in counted if run.made_at > now - DAY_S)
    limits = []
    if phase.per_day is not None:
        is_full = len(today) >= phase.per_day
        opens_at = today[-phase.per_day] + DAY_S if is_full else None
        limits.append(Usage("per_day", phase.per_day, len(today), opens_at))
    if phase.total is not None:
        limits.append(Usage("total", phase.total, len(counted), None))
    if phase.at_once is not None:
        playing = sum(run.is_open for run in runs)
        limits.append(Usage("at_once", phase.at_once, playing, None))
    return limits


def fits(phase: Phase, asked: AskedRun) -> bool:
    """Whether the run plays what the phase evaluates."""
    is_same = phase.benchmark_id == asked.benchmark_id and not asked.tasks
    has_options = phase.options is None or phase.options == asked.options
    return is_same and has_options and set(phase.splits) == set(asked.splits)


def choose_phase(
    tracks: Sequence[Track],
    asked: AskedRun,
    runs: Sequence[TrackRun],
    now: float,
    url: str = "",
) -> Place:
    """The phase that a run counts for: the first that has room. Raises Refused.

    tracks: that the account has entered. runs: of the account (HST-010, HST-011). url:
    see `phase_command`.
    """
    if not tracks:
        text = "The account has entered no track."
        raise Refused(
            "forbidden", text, act="Enter one on its page; /hosting/ lists them."
        )
    places = [Place(track, phase) for track in tracks for phase in track.phases]
    of_benchmark = [p for p in places if p.phase.benchmark_id == asked.benchmark_id]
    if not of_benchmark:
        names = ", ".join(sorted({place.phase.benchmark_id for place in places}))
        text = f"No track of this account has the benchmark; its tracks have {names}."
        raise Refused("forbidden", text)
    fitting = [place for place in of_benchmark if fits(place.phase, asked)]
    if not fitting:
        ways = "; ".join(sorted({_selection(place.phase) for place in of_benchmark}))
        text = f"The tracks of this benchmark evaluate {ways}."
        raise Refused("forbidden", text, act=_commands_of(of_benchmark, url))
    played_here = [place for place in fitting if not place.phase.is_held_out]
    if not played_here:
        text = f"Hand the policy in: {fitting[0]} evaluates submissions alone."
        raise Refused("forbidden", text, act=_commands_of(fitting[:1], url))
    is_open = [place for place in played_here if place.phase.is_open(now)]
    if not is_open:
        raise closed_refusal(played_here[0], now)
    refusals = []
    for place in sorted(is_open, key=lambda place: place.phase.closes_at):
        refusal = room_refusal(place, runs, now)
        if refusal is None:
            return place
        refusals.append(refusal)
    raise refusals[0]


def phase_command(place: Place, url: str) -> str:
    """The command that takes part in a phase; its reader replaces words in capitals.

    url: of the server for participants; empty where it is not known.
    """
    track, phase = place
    if phase.is_held_out:
        words = ["submit", "--track", track.track_id, "--phase", phase.phase_id]
        return server_command(url, *words, "--code", "FOLDER", "--preset", "PRESET")
    words = ["run", "--policy", "POLICY", "--benchmark", phase.benchmark_id]
    if phase.splits:
        words += ["--split", ",".join(phase.splits)]
    if phase.options:
        words += ["--options", msgspec.json.encode(phase.options).decode()]
    return server_command(url, *words)


def _commands_of(places: Sequence[Place], url: str) -> str:
    """The sentence of a refusal that names the commands of these phases."""
    commands = dict.fromkeys(phase_command(place, url) for place in places)
    return f"Do it with {' or '.join(f'`{command}`' for command in commands)}."


def open_place(track: Track, phase_id: str, now: float) -> Place:
    """The open phase of that id, or without one the one that closes first.

    The order of the track decides between phases that close at the same time.
    Raises Refused.
    """
    phases = [track.phase(phase_id)] if phase_id else track.phases
    places = sorted(
        (Place(track, phase) for phase in phases), key=lambda p: p.phase.closes_at
    )
    for place in places:
        if place.phase.is_open(now):
            return place
    raise closed_refusal(places[0], now)


def closed_refusal(place: Place, now: float) -> Refused:
    """It names the dates of the phase."""
    phase = place.phase
    text = f"It closed at {said_time(phase.closes_at)}, and takes nothing more."
    if now < phase.opens_at:
        text = f"It opens at {said_time(phase.opens_at)}."
    return Refused("forbidden", f"{str(place).capitalize()} is not open now. {text}")


def room_refusal(place: Place, runs: Sequence[TrackRun], now: float) -> Refused | None:
    """Why the phase has no room for one more run, if it has none (HST-011).

    A limit that never opens again comes first.
    """
    ids = (place.track.track_id, place.phase.phase_id)
    of_phase = [run for run in runs if (run.track_id, run.phase_id) == ids]
    used_up = [u for u in usages(place.phase, of_phase, now) if u.used >= u.allowed]
    used_up.sort(key=lambda usage: usage.limit != "total")
    return _quota_refusal(place, used_up[0], now) if used_up else None


def said_time(at: float) -> str:
    """The next whole second in UTC as people read it, in messages and on pages."""
    return f"{datetime.fromtimestamp(math.ceil(at), UTC):%Y-%m-%d %H:%M:%S} UTC"


def _selection(phase: Phase) -> str:
    text = "the whole benchmark, without `select`"
    if phase.splits:
        noun = "split" if len(phase.splits) == 1 else "splits"
        text = f"the {noun} {', '.join(phase.splits)}"
    if phase.options is not None:
        text += f" with `options` {msgspec.json.encode(phase.options).decode()}"
    return text


_AFTER_LIMIT = {
    "per_day": "Repeat it then.",
    "total": "They are used up for good, and deleting runs gives none back.",
    "at_once": "Wait until one of them has ended, or stop one.",
}


def _quota_refusal(place: Place, usage: Usage, now: float) -> Refused:
    """HST-028: it says when the limit opens, if that is known."""
    words = {"per_day": "in 24 hours", "total": "in all", "at_once": "at a time"}
    allowed = counted(usage.allowed, "run")
    text = f"{str(place).capitalize()} allows {allowed} {words[usage.limit]}."
    members: dict[str, object] = {
        "limit": usage.limit,
        "track_id": place.track.track_id,
        "phase_id": place.phase.phase_id,
    }
    if usage.resets_at is not None:
        members["resets_at"] = timestamp(usage.resets_at)
        text += f" The window opens again at {said_time(usage.resets_at)}."
    act = _AFTER_LIMIT[usage.limit]
    retry_after_s = None if usage.resets_at is None else usage.resets_at - now
    return Refused(
        "quota_exceeded", text, act=act, members=members, retry_after_s=retry_after_s
    )
