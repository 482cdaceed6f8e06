"""Parts of results that others see, in every place that shows them (HST-026)."""

from __future__ import annotations

import re
from collections.abc import AsyncIterator, Sequence
from contextlib import nullcontext
from pathlib import Path
from typing import Any, cast

import httpx
import msgspec
import pytest

from reference_platform.accounts.organisations import Owner
from reference_platform.http.server_calls import ServerRuns
from reference_platform.images.image_reviews import ImageReviews
from reference_platform.images.presets import Presets
from reference_platform.images.unpacked_roots import UnpackedRoots
from reference_platform.images.upload_folder import UploadFolder
from reference_platform.pages.form_calls import COOKIE
from reference_platform.parts import Parts
from reference_platform.platform_app import make_application
from reference_platform.sandbox.sandbox_interface import Limits
from reference_platform.storage.platform_database import Database
from reference_platform.storage.upgrades import _STATEMENTS
from reference_platform.submissions.hosted_parts import HostedParts
from reference_platform.submissions.submission_logs import FileLogs
from reference_platform.tracks.result_rules import ShownResult
from reference_platform.tracks.results import AGAIN_S, READS_MAX, RESULTS_MAX
from reference_platform.tracks.track_rules import Phase, Track, TrackRun
from reference_platform.tracks.tracks import OPEN_READS_MAX
from reference_server.rules.refusal import Refused
from tests.support.platform.approved_accounts import Clock, approved, key_of
from tests.support.platform.read_runs import ShownRuns

CLOSES_S = 1000.0


@pytest.fixture
async def client(parts: Parts, tmp_path: Path) -> AsyncIterator[httpx.AsyncClient]:
    """The platform of a host that runs submissions; its server does not answer."""
    hosted = HostedParts(
        tmp_path,
        UploadFolder(tmp_path / "uploads"),
        ImageReviews(parts.database, parts.clock),
        Presets(tmp_path / "presets"),
        UnpackedRoots(tmp_path / "roots"),
        FileLogs(tmp_path / "logs", lambda _name: True),
        supervisor=cast(Any, None),
        maker=cast(Any, None),
        limits=Limits(),
    )
    app = make_application(parts, ServerRuns("http://127.0.0.1:9"), hosted)
    transport = httpx.ASGITransport(app)
    async with httpx.AsyncClient(transport=transport, base_url="http://h") as client:
        yield client


def complete(parts: Parts, ada: str, **shown: Any) -> str:
    """A completed submission of an account; returns its id."""
    now = parts.clock()
    phase = Phase("test", "calibration", now, now + CLOSES_S, **shown)
    parts.tracks.put(Track("letters", "Letters", (phase,)), "a test")
    parts.tracks.enter("letters", Owner(ada))
    name = parts.submissions.create(ada, "letters", policy_name="mine").submission_id
    for event in ("upload", "begin_verification", "pass_verification", "start"):
        parts.submissions.move(name, event)
    parts.submissions.move(name, "begin_run", run_id="run_1")
    parts.submissions.move(name, "complete")
    parts.database.execute("UPDATE submissions SET score = 0.625")
    return name


async def seen(
    parts: Parts, client: httpx.AsyncClient, who: str, name: str
) -> set[str]:
    """The parts of a result that an account sees: each place shows the same."""
    client.headers["Authorization"] = f"Bearer {key_of(parts, who)}"
    client.cookies.set(COOKIE.name, parts.sessions.begin(who, parts.clock()))
    api, pages = "/v1/hosting", "/hosting"
    rows = (await client.get(f"{api}/tracks/letters/results")).json()["results"]
    row = rows[0] if rows else {"score": None, "has_log": False, "has_record": False}
    track_page = (await client.get(f"{pages}/tracks/letters")).text
    results = track_page.partition('id="results"')[2]
    places = {
        "score": [row["score"] == 0.625, "0.625" in results],
        "log": [row["has_log"], f"{name}/log" in results],
        "record": [row["has_record"], f"{name}/record" in results],
    }
    # A record that is shown is asked for at the server, which does not answer here.
    statuses = {200: True, 503: True, 404: False}
    for part, path in (
        ("log", f"{api}/submissions/{name}/log"),
        ("log", f"{pages}/results/{name}/log"),
        ("record", f"{api}/results/{name}/record"),
        ("record", f"{pages}/results/{name}/record"),
    ):
        places[part].append(statuses[(await client.get(path)).status_code])
    for part, answers in places.items():
        assert len(set(answers)) == 1, (part, answers)
    return {part for part, answers in places.items() if answers[0]}


@pytest.mark.parametrize("part", ["score", "log", "record"])
@pytest.mark.parametrize(
    ("moment", "open_and_closed"),
    [
        ("at_once", (True, True)),
        ("after_close", (False, True)),
        ("never", (False, False)),
    ],
)
async def test_others_see_what_the_phase_shows(
    parts: Parts, client: httpx.AsyncClient, *, part: str, moment: str,
    clock: Clock, open_and_closed: tuple[bool, bool],
) -> None:  # fmt: skip
    """One part is shown by a rule, the others never. Expect it so, and all for Ada."""
    shown = {"score": "never", "log": "never", "record": "never"} | {part: moment}
    ada, _ = await approved(parts, "ada"), await approved(parts, "eve")
    name = complete(parts, ada, **shown)
    for is_visible in open_and_closed:
        expected = {part} if is_visible else set()
        assert await seen(parts, client, "eve", name) == expected
        assert await seen(parts, client, ada, name) == {"score", "log", "record"}
        may_publish = part == "score" and is_visible
        with nullcontext() if may_publish else pytest.raises(Refused, match="shows sc"):
            parts.tracks.check_publication("run_1")
        clock.now += CLOSES_S


async def test_a_refused_limit_says_when_it_opens(
    parts: Parts, ada: str, client: httpx.AsyncClient
) -> None:
    """HST-028: one submission a day; the second is started four hours later."""
    complete(parts, ada, per_day=1)
    first = parts.submissions.create(ada, "letters", policy_name="again").submission_id
    for event in ("upload", "begin_verification", "pass_verification"):
        parts.submissions.move(first, event)
    client.headers["Authorization"] = f"Bearer {key_of(parts, ada)}"
    refused = await client.post(f"/v1/hosting/submissions/{first}/start")
    assert (refused.status_code, refused.headers["retry-after"]) == (429, "86400")
    assert "The window opens again at 2027-01-16 08:00:00 UTC." in refused.text


def test_a_track_of_an_earlier_version_has_one_phase(parts: Parts) -> None:
    """Its limits and its runs are those of the phase `main`."""
    document = (
        '{"track_id":"old","title":"Old","benchmark_id":"tabletop","opens_at":1.0,'
        '"closes_at":2.0,"rules":"","splits":["test"],"per_day":3,"log_shows":"none"}'
    )
    for statement in _STATEMENTS:
        _alter, _table, table, _add, _column, column, *_ = statement.split()
        parts.database.execute(f"ALTER TABLE {table} DROP COLUMN {column}")
    parts.database.execute("INSERT INTO tracks VALUES ('old', ?)", document)
    parts.database.execute("PRAGMA user_version = 1")
    Database(parts.database.path).close()
    (phase,) = parts.tracks.get("old").phases
    assert (phase.phase_id, phase.per_day, phase.log_shows) == ("main", 3, "none")
    assert parts.tracks.runs_of("ada") == []


SCORE = {
    "score": 0.625,
    "success_rate": 0.5,
    "success_interval": {"low": 0.25, "high": 0.75},
    "counts": {"success": 4, "total": 8},
    "by_split": {"test": {"mean": 0.625}},
    "by_task": {"a": {"mean": 0.625}},
}


FIGURES = {name: SCORE[name] for name in SCORE if name != "by_task"}
FIGURES["by_split"] = {"test": {}}
AWAY = ServerRuns("http://127.0.0.1:9")


async def figures_of(parts: Parts, owners: list[str], reader: Any) -> list[Any]:
    results = await parts.results.of_track("letters", owners, reader)
    return [one.figures for one in results]


async def test_figures_are_read_once_and_shown_where_the_score_is(
    parts: Parts, ada: str, clock: Clock
) -> None:
    """The server is away at first. Expect the result without them, and no error."""
    complete(parts, ada, score="after_close", record="at_once")
    assert await figures_of(parts, [ada], AWAY) == [None]
    reader = ShownRuns()
    reader.figures["run_1"] = SCORE
    for owners, shown in (([], None), ([ada], FIGURES), ([ada], FIGURES)):
        assert await figures_of(parts, owners, reader) == [shown]
    assert reader.figures_read == ["run_1"]
    clock.now += CLOSES_S
    assert await figures_of(parts, [], AWAY) == [FIGURES]


async def test_a_score_that_the_server_does_not_have_yet_is_asked_for_again(
    parts: Parts, ada: str, clock: Clock
) -> None:
    """An earlier version has stored `null` for it. Expect one request a minute."""
    complete(parts, ada)
    parts.database.execute("UPDATE submissions SET score = NULL")
    parts.database.execute("INSERT INTO run_figures VALUES ('run_1', 'null')")
    with pytest.raises(Refused, match="does not answer"):
        await figures_of(parts, [ada], AWAY)
    reader = ShownRuns()
    for _ in range(2):
        assert await figures_of(parts, [ada], reader) == [None]
    assert reader.figures_read == ["run_1"]
    reader.figures["run_1"] = SCORE
    clock.now += AGAIN_S
    (result,) = await parts.results.of_track("letters", [ada], reader)
    assert (result.score, result.figures) == (0.625, FIGURES)


async def test_a_page_reads_few_scores_at_the_server(parts: Parts, ada: str) -> None:
    track = track_of(Phase("test", "calibration", 0.0, 1.0))
    parts.tracks.put(track, "a test")
    for number in range(READS_MAX + 3):
        store(parts, ada, None, number)
    reader = ShownRuns()
    for reads, left in ((READS_MAX, 3), (READS_MAX + 3, 0), (READS_MAX + 3, 0)):
        assert await parts.results.refresh("letters", reader) == left
        assert len(set(reader.figures_read)) == len(reader.figures_read) == reads


async def test_a_run_elsewhere_has_its_figures_as_soon_as_it_is_completed(
    parts: Parts, ada: str
) -> None:
    parts.tracks.put(track_of(Phase("test", "calibration", 0.0, 1.0)), "a test")
    store(parts, ada, None, 1, state="running")
    reader = ShownRuns()
    reader.runs["run_ada-1"] = {"state": "completed"}
    reader.figures["run_ada-1"] = SCORE
    await parts.tracks.refresh(ada, reader)
    (result,) = await parts.results.of_track("letters", [], AWAY)
    assert (result.score, result.figures) == (0.625, FIGURES)


@pytest.mark.parametrize("of_whom", ["everyone", "ada"])
async def test_many_open_runs_keep_no_completed_one_out(
    parts: Parts, ada: str, clock: Clock, of_whom: str
) -> None:
    """Runs that stay stopped fill a request. Expect the other one by the next."""
    track = track_of(Phase("test", "calibration", 0.0, 1.0))
    parts.tracks.put(track, "a test")
    reader = ShownRuns()
    for number in range(OPEN_READS_MAX + 1):
        store(parts, ada, None, number, state="stopped")
        reader.runs[f"run_ada-{number}"] = {"state": "stopped"}
    reader.runs["run_ada-0"] = {"state": "completed"}
    reader.figures["run_ada-0"] = SCORE
    for left, completed in ((1, []), (0, ["ada-0"])):
        if of_whom == "ada":
            await parts.tracks.refresh(ada, reader)
        else:
            assert await parts.results.refresh("letters", reader) == left
        ranking = parts.results.ranking(track, track.phases[0], [])
        assert names_of(ranking.leading) == completed
        clock.now += 1


def track_of(*phases: Phase) -> Track:
    return Track("letters", "Letters", phases)


def store(
    parts: Parts, owner: str, score: float | None, at: float, state: str = "completed"
) -> None:
    run_id = f"run_{owner}-{at:g}"
    run = TrackRun(run_id, "letters", owner, at, state, score, "test", "")
    parts.database.insert("track_runs", run)


def names_of(results: Sequence[ShownResult]) -> list[str]:
    return [one.stored.result_id.removeprefix("run_") for one in results]


@pytest.mark.parametrize(
    ("ranks", "leading", "others"),
    [
        ("best", ["eve-2", "ada-1", "kim-4"], ["ada-5", "eve-3"]),
        ("last", ["eve-3", "ada-5", "kim-4"], ["eve-2", "ada-1"]),
    ],
)
def test_one_result_of_each_entrant_leads_in_the_order_of_the_score(
    parts: Parts, ranks: Any, leading: list[str], others: list[str]
) -> None:
    phase = Phase("test", "calibration", 0.0, 1.0, ranks=ranks)
    dev = msgspec.structs.replace(phase, phase_id="dev")
    track = track_of(phase, dev)
    parts.tracks.put(track, "a test")
    for owner, score, at in (
        ("ada", 0.5, 5),
        ("kim", None, 4),
        ("eve", 0.75, 3),
        ("eve", 0.875, 2),
        ("ada", 0.75, 1),
    ):
        store(parts, owner, score, at)
    ranking = parts.results.ranking(track, phase, [])
    assert (names_of(ranking.leading), names_of(ranking.others)) == (leading, others)
    assert ranking.others_total == 2
    assert parts.results.ranking(track, dev, []).leading == []


def test_a_hidden_score_decides_no_order(parts: Parts) -> None:
    """The record is shown, the score is not. Expect the order in which they came."""
    phase = Phase("test", "calibration", 0.0, 1.0, score="never", record="at_once")
    track = track_of(phase)
    parts.tracks.put(track, "a test")
    for owner, score, at in (("ada", 0.1, 1), ("eve", 0.9, 2), ("ada", 0.8, 3)):
        store(parts, owner, score, at)
    seen = parts.results.ranking(track, phase, [])
    assert (names_of(seen.leading), names_of(seen.others)) == (
        ["ada-1", "eve-2"],
        ["ada-3"],
    )
    own = parts.results.ranking(track, phase, ["ada"])
    assert names_of(own.leading) == ["ada-3", "eve-2"]
    hidden = msgspec.structs.replace(phase, record="never", log="at_once")
    assert parts.results.ranking(track, hidden, []).leading == []


@pytest.mark.parametrize("ranks", ["best", "last"])
async def test_many_results_of_one_entrant_push_no_other_out(
    parts: Parts, ranks: Any
) -> None:
    """1,200 of Ada after one of Eve. Ada's best is her oldest one."""
    phase = Phase("test", "calibration", 0.0, 1.0, ranks=ranks)
    track = track_of(phase)
    parts.tracks.put(track, "a test")
    with parts.database.transaction():
        store(parts, "eve", 0.5, 1)
        for number in range(2, 1202):
            store(parts, "ada", 0.25 if number > 2 else 0.75, number)
        parts.database.execute(
            "INSERT INTO run_figures SELECT run_id, '{}' FROM track_runs"
        )
    ranking = parts.results.ranking(track, phase, [], others_max=50)
    leading = ["ada-2", "eve-1"] if ranks == "best" else ["eve-1", "ada-1201"]
    assert names_of(ranking.leading) == leading
    assert (len(ranking.others), ranking.others_total) == (50, 1199)
    results = await parts.results.of_track("letters", [], AWAY)
    assert len(results) == RESULTS_MAX
    assert set(leading) < set(names_of(results))
    assert [one.stored.made_at for one in results] == sorted(
        (one.stored.made_at for one in results), reverse=True
    )


async def test_the_page_has_interval_episodes_and_one_row_of_each_team(
    parts: Parts, ada: str, client: httpx.AsyncClient
) -> None:
    complete(parts, ada)
    document = msgspec.json.encode(SCORE).decode()
    parts.database.execute("INSERT INTO run_figures VALUES ('run_1', ?)", document)
    client.cookies.set(COOKIE.name, parts.sessions.begin(ada, parts.clock()))
    page = (await client.get("/hosting/tracks/letters")).text
    results = page.partition('id="results"')[2]
    shown = "50.0 %<small>25.0–75.0 %</small><small>4/8</small>"
    assert (results.count(shown), results.count("<svg")) == (1, 1)
    assert "<details>" not in results
    run = TrackRun("run_2", "letters", ada, 1.0, "completed", 0.5, "test")
    parts.database.insert("track_runs", run)
    page = (await client.get("/hosting/tracks/letters")).text
    leading, _, others = page.partition("<details>")
    assert "1 more of the same submitters" in others
    assert ("0.625" in leading, "0.500</td>" in others) == (True, True)


async def test_each_time_of_a_submission_says_which_it_is(
    parts: Parts, ada: str, client: httpx.AsyncClient
) -> None:
    """It is started a minute after it was created. Expect equal times under one word
    on the track, in the list of submissions and on its own page."""
    name = complete(parts, ada)
    parts.database.execute("UPDATE submissions SET created_at = 60, started_at = 120")
    client.cookies.set(COOKIE.name, parts.sessions.begin(ada, parts.clock()))
    created, started = ("1970-01-01 00:01", "1970-01-01 00:02")
    track = (await client.get("/hosting/tracks/letters")).text
    assert (track.count(started), track.count(created)) == (2, 0)
    assert track.count('<th scope="col">Started</th>') == 2
    listed = (await client.get("/hosting/submissions")).text
    assert ">Created<" in listed.partition(created)[0]
    assert started not in listed
    page = (await client.get(f"/hosting/submissions/{name}")).text
    assert re.search(f"<dt>Created</dt><dd>[^/]*{created}", page)
    assert re.search(f"<dt>Started</dt><dd>[^/]*{started}", page)


async def test_a_track_shows_its_limits_before_one_enters_it(
    parts: Parts, client: httpx.AsyncClient
) -> None:
    eve, now = await approved(parts, "eve"), parts.clock()
    phases = (
        Phase("test", "calibration", now, now + CLOSES_S, per_day=5, total=1),
        Phase("free", "calibration", now, now + CLOSES_S),
    )
    for entrants, of_whom in (("any", ""), ("organisations", ", each organisation")):
        track = Track("letters", "Letters", phases, entrants=cast(Any, entrants))
        parts.tracks.put(track, "a test")
        client.cookies.set(COOKIE.name, parts.sessions.begin(eve, now))
        page = (await client.get("/hosting/tracks/letters")).text
        assert page.count("<dt>Limits</dt>") == 1
        assert f"<dd>5 runs in 24 hours, 1 run in all{of_whom}</dd>" in page
