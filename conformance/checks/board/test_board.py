"""Entries of a leaderboard and their ranking: the profile `board` (BRD).

Each check plays and publishes on a manifest of its own (`support/published_runs.py`);
`oracle/expected_ranking.py` computes the expected ranking.
"""

from itertools import islice
from typing import Any

from conformance.checks.support.given_states import without
from conformance.checks.support.published_runs import (
    BENCHMARK,
    Board,
    change_entry,
    description_of,
    listed_entries,
    require_entry,
    try_publish,
)
from conformance.client.check_context import CheckContext
from conformance.exchanges.pages import read_pages
from conformance.runner.requirement import each_requirement, requirement
from conformance.verdicts import expect

FULL_DESCRIPTION = {
    "model_name": "Ünïted πolicy <b>7</b>",
    "is_public": True,
    "model_type": "VLA",
    "organisation": "Conformance & Co.",
    "homepage": "https://example.org/policy?a=1#b",
    "code_url": "http://example.org/code",
    "notes": "first line\nsecond line",
}
DESCRIPTION_MEMBERS = tuple(FULL_DESCRIPTION)
UNKNOWN_MANIFEST, UNKNOWN_BENCHMARK = "0" * 64, "no_benchmark_of_this_name"
# Runs of eight episodes, of which some can be distinguished and some cannot.
PATTERNS = ("11111111", "11110000", "00000000", "10101010", "11111110", "00000000")
# Other checks submit meanwhile; what they hide in one try, they do not in each.
COUNTS, TRIES = 3, 12


def shown_description(entry: dict[str, Any]) -> dict[str, Any]:
    """Give the members of an entry that show its description."""
    return {name: entry[name] for name in DESCRIPTION_MEMBERS if name in entry}


def ranked_board(context: CheckContext) -> Board:
    """Publish runs that differ, two of which have the same score."""
    board = Board(context)
    for successes in PATTERNS:
        board.add(successes)
    return board


@requirement("BRD-001")
def test_brd_001_a_run_has_one_entry(context: CheckContext) -> None:
    """A run is published, again with the same body, and with another description.
    Expect 201, then 200 with the same entry and what was sent last."""
    board = Board(context)
    run = board.play("10")
    first = expect.ok(try_publish(run, **FULL_DESCRIPTION), 201)
    repeated = expect.ok(try_publish(run, **FULL_DESCRIPTION))
    expect.equal(shown_description(repeated), FULL_DESCRIPTION, "the description")
    changed = expect.ok(try_publish(run, model_name="Another"))
    described = {"model_name": "Another", "is_public": True}
    expect.equal(shown_description(changed), described, "the description")
    for entry in (repeated, changed):  # `attempts` may have grown meanwhile
        for member in ("entry_id", "published_at", "score", "run_id"):
            expect.equal(entry[member], first[member], member)
    expect.equal(board.ranked_ids(), [first["entry_id"]], "entries in the ranking")


@requirement("BRD-002")
def test_brd_002_cannot_publish_an_incomplete_run(context: CheckContext) -> None:
    """A run with an episode to play is published, a stopped one, and a completed one.
    Expect `illegal_transition` and no entry, then an entry."""
    board = Board(context)
    run = board.play("11", episodes=1)
    expect.refused(try_publish(run), "illegal_transition", state=run.get()["state"])
    run.stop()
    expect.refused(try_publish(run), "illegal_transition", state="stopped")
    expect.equal(board.ranked_ids(), [], "entries in the ranking")
    entry = expect.ok(try_publish(board.play("11")), 201)
    expect.equal(board.ranked_ids(), [entry["entry_id"]], "entries in the ranking")


@requirement("BRD-003")
def test_brd_003_an_entry_shows_its_run(context: CheckContext) -> None:
    """A graded run is published. Expect the run as `get_run` and the score as
    `get_score` has it."""
    run = Board(context).play("101", scores=(0.75, 1 / 3, 0.1))
    entry = expect.ok(try_publish(run), 201)
    shown, score = run.get(), run.score()
    for member in ("run_id", "benchmark_id", "benchmark_version", "manifest_sha256"):
        expect.equal(entry[member], shown[member], member)
    expect.members(entry, {"policy": shown["policy"], "state": "published"})
    for member in entry["score"]:
        expect.equal(entry["score"][member], score[member], f"score.{member}")
    again = context.call("get_entry", entry_id=entry["entry_id"])
    expect.equal(without(expect.ok(again), "attempts"), without(entry, "attempts"), "")


@requirement("BRD-024")
def test_brd_024_an_entry_shows_its_description(context: CheckContext) -> None:
    """A run is published with a full description and one with a short one, which is
    then changed to a full one. Expect each description as it was sent."""
    board = Board(context)
    entry = expect.ok(try_publish(board.play("1"), **FULL_DESCRIPTION), 201)
    expect.equal(shown_description(entry), FULL_DESCRIPTION, "the description")
    run = board.play("1")
    short = expect.ok(try_publish(run), 201)
    expect.equal(shown_description(short), description_of(), "the description")
    changed = expect.ok(try_publish(run, **FULL_DESCRIPTION), 200)
    expect.equal(shown_description(changed), FULL_DESCRIPTION, "the new description")


@requirement("BRD-004")
def test_brd_004_private_entries_are_for_their_account(context: CheckContext) -> None:
    """An entry is private, then public, then private again, and withdrawn at last;
    another account looks. So is one of two public entries. Expect it to be seen by its
    own account each time, and else while it is public; withdrawn ones neither in the
    ranking nor in the list."""
    board, second_account = Board(context), context.second_account
    run = board.play("11")
    entry_id = require_entry(run, is_public=False)["entry_id"]
    for is_public in (False, True, False):
        change_entry(run, is_public=is_public)
        expect.ok(context.call("get_entry", entry_id=entry_id))
        own = listed_entries(context, {entry_id})
        expect.equal(own, [entry_id], "entries listed for its account")
        answer = context.call(
            "get_entry", entry_id=entry_id, http_client=second_account
        )
        listed = listed_entries(context, {entry_id}, second_account, limit=1000)
        ranked = board.ranked_ids()
        if is_public:
            expect.ok(answer)
        else:
            expect.refused(answer, "not_found")
        expected = [entry_id] if is_public else []
        expect.equal(listed, expected, "entries listed for another account")
        expect.equal(ranked, expected, "entries in the ranking")
    expect.ok(run.call("withdraw_entry"))
    expect.ok(context.call("get_entry", entry_id=entry_id))
    answer = context.call("get_entry", entry_id=entry_id, http_client=second_account)
    expect.refused(answer, "not_found")
    board = Board(context)
    first, second = board.play("11"), board.play("10")
    ids = [require_entry(run)["entry_id"] for run in (first, second)]
    expect.equal(board.ranked_ids(), ids, "entries in the ranking")
    expect.ok(first.call("withdraw_entry"))
    expect.equal(board.ranked_ids(), ids[1:], "entries in the ranking")
    listed = listed_entries(context, set(ids), limit=1000)
    expect.equal(listed, ids[1:], "entries listed")
    for http_client in (context.http_client, context.second_account):
        expect.ok(context.call("get_entry", entry_id=ids[0], http_client=http_client))


@requirement("BRD-005")
def test_brd_005_withdrawals_are_for_good(context: CheckContext) -> None:
    """An entry is withdrawn, twice; so is that of a run without one. Expect it
    withdrawn and else as before, the same again, and `not_found` at last."""
    board = Board(context)
    run = board.play("11")
    changing = ("attempts", "changed_at", "state")
    published = without(require_entry(run), *changing)
    withdrawn = expect.ok(run.call("withdraw_entry"))
    expect.equal(withdrawn["state"], "withdrawn", "state")
    expect.equal(without(withdrawn, *changing), published, "the entry else")
    withdrawn = without(withdrawn, "attempts")
    again = without(expect.ok(run.call("withdraw_entry")), "attempts")
    expect.equal(again, withdrawn, "the entry")
    shown = context.call("get_entry", entry_id=published["entry_id"])
    expect.equal(without(expect.ok(shown), "attempts"), withdrawn, "the entry")
    expect.refused(board.play("01").call("withdraw_entry"), "not_found")


@requirement("BRD-006")
def test_brd_006_cannot_publish_after_a_withdrawal(context: CheckContext) -> None:
    """The run of a withdrawn entry is published, also as it was, and another run.
    Expect `entry_withdrawn` and the entry as it was, then an entry."""
    board = Board(context)
    run = board.play("11")
    entry_id = require_entry(run)["entry_id"]
    expect.ok(run.call("withdraw_entry"))
    for description in ({"model_name": "Another"}, {}):
        expect.refused(try_publish(run, **description), "entry_withdrawn")
    shown = expect.ok(context.call("get_entry", entry_id=entry_id))
    expect.equal(shown["state"], "withdrawn", "state")
    expect.equal(board.ranked_ids(), [], "entries in the ranking")
    expect.ok(try_publish(board.play("11")), 201)


@requirement("BRD-022")
def test_brd_022_cannot_publish_one_result_twice(context: CheckContext) -> None:
    """Two runs of one policy go alike; the second is published, first privately. Expect
    `result_published` with the first's id and one row; another result, another policy
    and, once the first is withdrawn, the same are accepted."""
    board = Board(context)
    first, second = (board.play("10", policy="one policy") for _ in range(2))
    entry_id = require_entry(first)["entry_id"]
    expect.ok(try_publish(second, is_public=False), 201)
    for description in ({}, {"model_name": "Another"}):
        answer = try_publish(second, **description)
        expect.refused(answer, "result_published", entry_id=entry_id)
    expect.equal(board.ranked_ids(), [entry_id], "entries in the ranking")
    expect.ok(try_publish(first, model_name="Another"))
    for run in (board.play("11", policy="one policy"), board.play("10")):
        expect.ok(try_publish(run), 201)
    context.require(lambda: first.call("withdraw_entry"), 200, "withdraw_entry")
    expect.ok(try_publish(second))


@requirement("BRD-007")
def test_brd_007_entries_are_listed_newest_first(context: CheckContext) -> None:
    """Three entries are listed: by pages of different lengths, and by benchmark. Expect
    each once and the newest first, and none for another benchmark."""
    board = Board(context)
    ids = [board.add("1", is_public=bool(n % 2))["entry_id"] for n in range(3)]
    for params in ({}, {"limit": 1}, {"limit": 2}, {"benchmark_id": BENCHMARK}):
        listed = listed_entries(context, set(ids), **params)
        expect.equal(listed, ids[::-1], f"entries with {params}")
    page = expect.ok(context.call("list_entries", params={"limit": 2}))
    expect.true(len(page["entries"]) in (1, 2), "one or two entries on a page of two")
    listed = listed_entries(context, set(ids), benchmark_id=UNKNOWN_BENCHMARK)
    expect.equal(listed, [], "entries of another benchmark")


def expect_replaced_row(context: CheckContext) -> None:
    """Expect an entry that comes as another one leaves, so that their number stays."""
    board = Board(context)
    leaving, staying = board.play("11"), board.play("10")
    ids = [require_entry(run)["entry_id"] for run in (leaving, staying)]
    expect.equal(board.ranked_ids(), ids, "entries in the ranking")
    leaving.call("withdraw_entry")
    coming = require_entry(board.play("00"))["entry_id"]
    expect.equal(board.ranked_ids(), [ids[1], coming], "entries after the change")


@requirement("BRD-008")
def test_brd_008_rows_are_in_their_order(context: CheckContext) -> None:
    """Ten entries, some with equal scores; a private one, and one of other episodes.
    Another ranking is read before one of its entries is replaced, and after. Expect the
    public ones of the manifest by score, then by successes, the same by pages."""
    expect_replaced_row(context)
    board = ranked_board(context)
    board.add("11100000", scores=(0.5,) * 8)
    board.add("11110100", scores=(0.5,) * 8)
    board.add("11110000", scores=(0.5,) * 8)
    board.add("11110001", scores=(0.25,) * 8)
    board.add("11111111", is_public=False)
    Board(context).add("11111111")
    expected = [row["entry_id"] for row in board.expected()["rows"]]
    expect.equal(board.ranked_ids(), expected, "entries in the ranking")
    pages = read_pages(lambda params: board.ranking_page(**params), limit=3)
    entry_ids = [
        row["entry"]["entry_id"]
        for page in islice(pages, len(expected))
        for row in page["rows"]
    ]
    expect.equal(entry_ids, expected, "entries on all pages of three")


def expect_members(board: Board, members: tuple[str, ...]) -> None:
    """Expect these members of each row, by the id of its entry."""
    rows, due = board.ranking()["rows"], board.expected()["rows"]
    actual = {row["entry"]["entry_id"]: [row.get(n) for n in members] for row in rows}
    expected = {row["entry_id"]: [row[n] for n in members] for row in due}
    expect.equal(actual, expected, f"{', '.join(members)} of the rows by entry")


@each_requirement(
    "members", {"BRD-009": ("rank", "better", "worse"), "BRD-010": ("letters",)}
)
def test_brd_009_rows_say_what_can_be_distinguished(
    context: CheckContext, members: tuple[str, ...]
) -> None:
    """Six entries come one after another, and one leaves; then three, of which failures
    have higher scores than successes. Expect each time the ranks and letters that the
    exact tests of successes give."""
    board = Board(context)
    runs = [board.play(successes) for successes in PATTERNS]
    for run, successes in zip(runs, PATTERNS, strict=True):
        entry = require_entry(run)
        mean = successes.count("1") / len(successes)
        board.note(entry["entry_id"], mean, successes)
        expect_members(board, members)
    runs[2].call("withdraw_entry")
    del board.published[2]
    expect_members(board, members)
    board = Board(context)
    for successes in PATTERNS[:3]:
        board.add(successes, scores=[1 - int(success) / 2 for success in successes])
        expect_members(board, members)


@requirement("BRD-011")
def test_brd_011_a_ranking_says_what_it_can_distinguish(context: CheckContext) -> None:
    """Rankings of entries with 8 and with 5 episodes, of one entry and of more. Expect
    the number of tests, and how many episodes two entries must differ on."""
    for patterns in (PATTERNS, ("11111", "00000"), ("1" * 7,)):
        board = Board(context)
        for count, successes in enumerate(patterns, start=1):
            board.add(successes)
            ranking, expected = board.ranking(), board.expected()
            for member in ("ranked", "comparisons", "differing_min"):
                expect.equal(ranking[member], expected[member], member)
            enough = ranking["differing_enough"]
            expect.equal(enough, expected["differing_enough"], "differing_enough")
            due = {"episodes_total": len(successes), "alpha": 0.05, "ranked": count}
            expect.members(ranking, due)


@requirement("BRD-019")
def test_brd_019_attempts_are_counted(context: CheckContext) -> None:
    """An entry is read after a run is submitted and stopped, and deleted where that is
    offered, and before another one. Expect at least the number of the first, and less
    than that of the second."""
    has_another = context.shared.settings.token_2 is not None
    account = context.second_account if has_another else context.http_client
    entry_id = Board(context).add("1", http_client=account)["entry_id"]
    exact = 0
    for _ in range(TRIES):
        before = context.submit("score", http_client=account)
        before.stop()
        low = before.get()["attempts_by_submitter"]
        if context.offers("deletion"):
            before.call("delete_run")
        shown = expect.ok(context.call("get_entry", entry_id=entry_id))
        after = context.submit("score", http_client=account)
        high = after.get()["attempts_by_submitter"]
        attempts = shown["attempts"]
        expect.true(low <= attempts < high, f"attempts from {low} to {high}", attempts)
        exact += high == low + 1
        if exact == COUNTS:
            return


@requirement("BRD-020")
def test_brd_020_links_are_http_or_https(context: CheckContext) -> None:
    """A run is published with links of other schemes, then with right ones. Expect
    `invalid_request` that points at each, and no entry of it."""
    board = Board(context)
    run = board.play("1")
    wrong = ("javascript:alert(1)", "data:text/html,x", "ftp://a.example/", "//a.b/")
    for member in ("homepage", "code_url"):
        for link in (*wrong, "example.org", " https://a.example", "https://a b"):
            answer = try_publish(run, **{member: link})
            expect.refused(answer, "invalid_request", pointer=f"/{member}")
    expect.equal(board.ranked_ids(), [], "entries in the ranking")
    links = {"homepage": "http://a.example", "code_url": "https://a.example/b"}
    expect.ok(try_publish(run, **links), 201)


@requirement("BRD-021")
def test_brd_021_rankings_of_nothing(context: CheckContext) -> None:
    """Rankings of an unknown benchmark, an unknown manifest, and one with an entry.
    Expect `not_found`, no rows, and a row."""
    unknown = context.call("get_ranking", benchmark_id=UNKNOWN_BENCHMARK)
    expect.refused(unknown, "not_found")
    board = Board(context)
    board.manifest_sha256 = UNKNOWN_MANIFEST
    expect.members(board.ranking(), {"rows": [], "ranked": 0})
    expect.ok(context.call("get_ranking", benchmark_id=BENCHMARK))
    entry = board.add("1")
    expect.equal(board.ranked_ids(), [entry["entry_id"]], "entries in the ranking")
