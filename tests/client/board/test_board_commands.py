"""`proctor publish`, `board` and `withdraw`: a ranking for people, scripts, sheets."""

import csv
import io
import re
import shlex
import sqlite3
from contextlib import closing
from pathlib import Path
from typing import Any

import pytest

from tests.support.client.command import Proctor, options
from tests.support.servers import ReferenceServer

pytestmark = pytest.mark.usefixtures("policy_folder")
EPISODES = 12
# Succeeds in the first episodes, as many as the file `successes` says.
FIRST_ONES = """
import pathlib
import policies


def first_ones(observation):
    many = int(pathlib.Path("successes").read_text())
    success = float(int(observation.episode_id[1:]) < many)
    return policies.action(score=success, success=success, end=1.0)
"""


@pytest.fixture(autouse=True)
def state(policy_folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (policy_folder / "first_ones.py").write_text(FIRST_ONES)
    monkeypatch.setenv("XDG_STATE_HOME", str(policy_folder / "state"))


def play(proctor: Proctor, successes: int, max_steps: int) -> str:
    """A completed run. max_steps: each test has a manifest of its own."""
    Path("successes").write_text(str(successes))
    tasks = options(*["score"] * EPISODES, max_steps=max_steps)
    made = proctor.json("run", "--policy", "first_ones.py:first_ones", *tasks)
    assert proctor.code == 0
    run_id: str = made["run_id"]
    return run_id


def publish(proctor: Proctor, run_id: str, *flags: str) -> dict[str, Any]:
    entry: dict[str, Any] = proctor.json("publish", run_id, *flags)
    assert proctor.code == 0, entry
    return entry


def test_people_and_scripts_read_a_ranking(
    proctor: Proctor, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Expect intervals of ranks in 80 columns, all of the answer as JSON, and CSV
    that a spreadsheet does not execute."""
    runs = [play(proctor, many, 21) for many in (12, 11, 0)]
    names = ["best", "=SUM(A1)", "a name that is much too long for a column"]
    flags = ["--organisation", "Lab", "--code-url", "https://example.org/c"]
    entries = [
        publish(proctor, run, "--name", name, *flags)
        for run, name in zip(runs, names, strict=True)
    ]
    manifest = ["--manifest", entries[0]["manifest_sha256"]]
    monkeypatch.setenv("COLUMNS", "80")
    assert proctor("board", "calibration", *manifest) == 0
    lines = proctor.out.splitlines()
    assert max(map(len, lines)) <= 80
    assert [line.split()[1] for line in lines[1:3]] == ["1–2", "1–2"]
    assert lines[3].startswith("a name that is much too long for a")
    assert " 3  b " in lines[3]
    assert lines[4] == "column"
    assert "Rows stand in the order of the score over all" in proctor.out
    found = proctor.json("board", "calibration", *manifest)
    assert [row["rank"]["high"] for row in found["rows"]] == [2, 2, 3]
    assert proctor("board", "calibration", *manifest, "--csv") == 0
    rows = list(csv.DictReader(io.StringIO(proctor.out)))
    assert [row["model_name"] for row in rows] == [names[0], f"'{names[1]}", names[2]]
    assert [row["entry_id"] for row in rows] == [one["entry_id"] for one in entries]
    assert (rows[0]["rank_low"], rows[0]["rank_high"]) == ("1", "2")
    splits = [[one[f"success_rate split {n}"] for n in ("even", "odd")] for one in rows]
    assert splits == [["1.0", "1.0"], ["1.0", str(5 / 6)], ["0.0", "0.0"]]
    assert rows[1]["success_rate task score"] == rows[1]["success_rate"]


@pytest.mark.parametrize(
    ("count", "said"), [(6, []), (5, ["--type", "VLA", "--organisation", "Our Lab"])]
)
def test_a_result_that_is_published_names_the_command_for_its_entry(
    proctor: Proctor, count: int, said: list[str]
) -> None:
    """With all that the entry says of itself, which the command would take away."""
    first = play(proctor, count, 25)
    publish(proctor, first, *said)
    assert proctor("publish", play(proctor, count, 25), "--name", "again") == 2
    kept = "".join(f"{word} " for word in map(shlex.quote, said))
    command = f"publish {first} {kept}--name NAME --url {proctor.url}"
    assert re.search(
        rf"To change its description: `\S+ {command}`\.",
        proctor.err,
    )
    assert "`entry_id`" not in proctor.err


def test_an_entry_is_private_public_and_withdrawn(proctor: Proctor) -> None:
    run_id = play(proctor, 6, 22)
    entry = publish(proctor, run_id, "--private")
    assert (entry["model_name"], entry["is_public"]) == ("first_ones", False)
    page = f"{proctor.url}/pages/entries/{entry['entry_id']}"
    assert proctor.err == (
        f"Page of the entry: {page}\nTo take it off the leaderboard, for good:\n"
        f"  proctor withdraw {run_id} --url {proctor.url}\n"
    )
    manifest = ["--manifest", entry["manifest_sha256"]]
    assert proctor("board", "calibration", *manifest) == 0
    assert "no public entry" in proctor.out
    assert publish(proctor, run_id)["is_public"]
    assert len(proctor.json("board", "calibration", *manifest)["rows"]) == 1
    assert proctor.json("withdraw", run_id)["state"] == "withdrawn"
    assert proctor.json("board", "calibration", *manifest)["rows"] == []
    assert proctor("publish", run_id) == 2
    assert "entry_withdrawn" in proctor.err


def test_other_manifests_of_a_benchmark_are_named(proctor: Proctor) -> None:
    """That of the server has no entry, that of a run with options has one."""
    entry = publish(proctor, play(proctor, 6, 23))
    hidden = publish(proctor, play(proctor, 6, 24), "--private")
    assert proctor("board", "calibration") == 0
    row = f"  --manifest {entry['manifest_sha256']}  1 entry"
    assert row in proctor.out.splitlines()
    assert hidden["manifest_sha256"] not in proctor.out
    assert proctor("board", "calibration", "--csv") == 0
    assert "--manifest" not in proctor.out
    assert proctor("board", "calibration", *row.split()[:2]) == 0
    assert "Other manifests" not in proctor.out
    assert proctor("board", "calibratoin") == 2
    assert "did you mean calibration?" in proctor.err


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["publish", "run_1", "--homepage", "javascript:x"], "--homepage"),
        (["publish", "run_1", "--name", "x" * 201], "--name"),
        (["publish"], "needs the id of a completed run"),
        (["publish", "run_1"], "not_found"),
        (["withdraw", "run_1"], "not_found"),
        (["board", "nothing"], "not_found"),
        (["board", "calibration", "--state", "f"], "an option of board verify only"),
    ],
)
def test_what_cannot_be_is_said_in_one_line(
    proctor: Proctor, words: list[str], said: str
) -> None:
    assert proctor(*words) == 2
    assert said in proctor.err
    assert len(proctor.err.splitlines()) == 1


@pytest.mark.parametrize(
    ("state", "said"),
    [
        (".", "proctor: .: Is a directory"),
        ("policies.py/kept.json", "/policies.py/kept.json cannot be written (File ex"),
        ("/proc/kept.json", "proctor: /proc/kept.json cannot be written (No such"),
    ],
)
def test_a_file_that_cannot_keep_a_checkpoint_is_wrong_usage(
    proctor: Proctor, state: str, said: str
) -> None:
    """Exit code 1 would say that the history was rewritten."""
    assert proctor("board", "verify", "--state", state) == 2
    assert said in proctor.err
    assert len(proctor.err.splitlines()) == 1


def test_a_rewritten_history_is_seen(proctor: Proctor, server: ReferenceServer) -> None:
    """Whole at first and when it has grown; then a leaf is changed in the database,
    then a row is removed from it. Expect 1 for both, and 0 when it is as it was."""
    run_id = play(proctor, 3, 23)
    publish(proctor, run_id, "--notes", "before")
    assert proctor("board", "verify") == 0
    assert "nothing; from now on" in proctor.out
    publish(proctor, run_id, "--notes", "after")
    grown = proctor.json("board", "verify")
    assert (grown["is_whole"], proctor.code) == (True, 0)
    assert grown["seen_before"] == grown["tree_size"] - 1
    last = grown["tree_size"] - 1

    def change(statement: str, *values: object) -> None:
        with closing(sqlite3.connect(server.database_file)) as database, database:
            database.execute(statement, values)

    leaf = 'UPDATE history SET leaf = replace(leaf, ?, ?) WHERE "index" = ?'
    change(leaf, "after", "other", last)
    assert proctor("board", "verify") == 1
    assert "not those that it signed" in proctor.err
    change(leaf, "other", "after", last)
    listed = "UPDATE entries SET is_listed = ? WHERE run_id = ?"
    change(listed, False, run_id)
    assert proctor("board", "verify") == 1
    assert "is in the history, and not shown" in proctor.err
    change(listed, True, run_id)
    assert proctor("board", "verify") == 0


@pytest.mark.parametrize(
    ("given", "said"),
    [
        (
            "entry_1",
            "the id of an entry of the leaderboard; give that of a run:",
        ),
        ("sub_1", "a submission; `proctor submit --submission sub_1 --url"),
        ("sess_1", "the id of a session of a worker; give that of a run"),
        ("imp_1", "the id of an import of a record; give that of a run"),
        ("key_1", "the id of a key; give that of a run"),
        (
            "run_1",
            "There is no run run_1. Check the id; runs of other accounts",
        ),
    ],
)
@pytest.mark.parametrize(
    "command",
    [
        *("status ID", "stop ID", "resume ID", "delete ID", "results ID", "export ID"),
        *("publish ID", "withdraw ID", "compare ID run_2", "video ID --failures"),
        *("report ID --output page.html", "run --policy policies:Graded --run-id ID"),
    ],
)
def test_an_id_of_another_kind_is_recognised(
    proctor: Proctor, command: str, given: str, said: str
) -> None:
    """Expect what it is and what to give, for every command that takes a run."""
    assert proctor(*command.replace("ID", given).split()) == 2
    assert said in " ".join(proctor.err.split())
    assert ("That is the id" in proctor.err) == (given != "run_1")


def test_the_run_of_an_entry_is_named(proctor: Proctor) -> None:
    """What `publish` prints leads to a withdrawal, by either id."""
    run_id = play(proctor, 6, 26)
    assert proctor("publish", run_id) == 0
    assert f"withdraw {run_id} --url {proctor.url}" in proctor.err
    assert run_id in proctor.out
    entry_id = re.findall("entry_[0-9a-f]+", proctor.out)[0]
    assert proctor("withdraw", entry_id) == 2
    assert f"give its run, {run_id}." in " ".join(proctor.err.split())
    assert proctor("withdraw", run_id) == 0
    assert proctor("submit", "--submission", run_id) == 2
