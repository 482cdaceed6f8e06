"""`proctor verify`: what people read, what scripts read, and the exit codes."""

import json
import re
import shutil
import zipfile
from pathlib import Path

import msgspec
import pytest

from reference_client.command.main import main
from reference_record.contents.statement import EpisodeLine
from reference_record.formats.names import EPISODES
from reference_record.keys import load_or_make, own_key_file, own_keyid
from tests.support.client.command import Proctor, options
from tests.support.paths import ROOT
from tests.support.record.sample_records import Sample, contents_of, make_archive
from tests.support.servers import TOKENS, ReferenceServer

VECTORS = ROOT / "spec" / "vectors" / "record"
KEYS = json.loads((VECTORS / "records.json").read_text())["keys"]
HOST, OTHER = (next(k for k in KEYS if KEYS[k] == name) for name in KEYS.values())
GOOD = str(VECTORS / "good_replayed.proctor")


@pytest.mark.parametrize(
    ("keys", "level"),
    [
        ([], "reported: the owner of the key"),
        ([HOST], "signed by the owner of SHA256:"),
        ([f"a lab={HOST}"], "signed by a lab; key"),
        ([f"lab={HOST}", f"R={OTHER}"], "signed by lab, replayed by R (exact, 4 of 4"),
    ],
)
def test_a_level_stands_beside_the_score(
    keys: list[str], level: str, capsys: pytest.CaptureFixture[str]
) -> None:
    given = [word for key in keys for word in ("--key", key)]
    assert main(["verify", GOOD, *given]) == 0
    lines = capsys.readouterr().out.splitlines()
    shown = dict(line.split(maxsplit=1) for line in lines)
    assert shown["level"].startswith(level)
    assert shown["score"] == "0.5625"
    assert shown["run"] == "r-1"
    many = "of this benchmark by its account, this one included, when the record was "
    assert shown["runs"].endswith(many + "signed")
    assert "verified" not in str(shown)


def test_scripts_read_one_value(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["verify", GOOD, "--json", "--key", f"H={HOST}"]) == 0
    value = json.loads(capsys.readouterr().out)
    assert value["levels"] == ["signed by H"]
    assert (value["episodes"], value["turns"]) == (4, 7)
    assert value["replays"][0]["by"] is None
    assert value["statement"]["run"]["run_id"] == "r-1"


@pytest.mark.parametrize("is_own", [True, False])
def test_a_replay_with_the_own_key_is_by_you(
    is_own: bool,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """The key of this user names who replayed, and does not raise the level."""
    assert main(["verify", GOOD, "--json"]) == 0
    (replay,) = json.loads(capsys.readouterr().out)["replays"]
    own = replay["keyid"] if is_own else "SHA256:another"
    module = "reference_client.command.records.record_commands"
    monkeypatch.setattr(f"{module}.own_keyid", lambda: own)
    assert main(["verify", GOOD]) == 0
    said = capsys.readouterr().out
    row = next(line for line in said.splitlines() if line.startswith("replays"))
    who = "you" if is_own else f"unknown key {replay['keyid']}"
    assert row.split(maxsplit=1)[1].startswith(f"{who}: {replay['result']}")
    assert "level      reported" in said


def test_the_own_key_is_that_of_replays(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path))
    assert own_keyid() is None
    own_key_file().parent.mkdir(parents=True)
    own_key_file().write_text("no key")
    own_key_file().chmod(0o600)
    assert own_keyid() is None
    own_key_file().unlink()
    made = load_or_make(own_key_file())
    assert own_keyid() == made.keyid


def test_a_broken_record_is_named(capsys: pytest.CaptureFixture[str]) -> None:
    broken = str(VECTORS / "recording_changed.proctor")
    assert main(["verify", broken, "--json"]) == 1
    out, err = capsys.readouterr()
    said = json.loads(out)
    assert (said["file"], said["rule"]) == ("episodes/00000.mcap", "REC-008")
    assert "do not trust it: episodes/00000.mcap: its SHA-256" in err


def unpacked(folder: Path) -> Path:
    with zipfile.ZipFile(GOOD) as archive:
        archive.extractall(folder)
    return folder


def packed(folder: Path, path: Path, method: int, before: str = "") -> Path:
    with zipfile.ZipFile(path, "w", method) as archive:
        for file in sorted(folder.rglob("*")):
            archive.write(file, before + file.relative_to(folder).as_posix())
    return path


@pytest.mark.parametrize("method", [zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED])
@pytest.mark.parametrize("before", ["", "run-1/"])
def test_an_archive_that_was_packed_again_has_a_way_out(
    method: int, before: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """An honest record. Expect no word against it, and that the way out leads out."""
    folder = unpacked(tmp_path / "folder")
    again = str(packed(folder, tmp_path / "again.zip", method, before))
    assert main(["verify", again, "--json"]) == 1
    out, err = capsys.readouterr()
    assert "do not trust" not in err
    assert "its content was not judged" in err
    assert "unzip FILE -d FOLDER" in json.loads(out)["way_out"]
    with zipfile.ZipFile(again) as archive:
        archive.extractall(tmp_path / "way out")
    if before:
        assert main(["verify", str(tmp_path / "way out")]) == 1
        assert "in that folder: name it in place" in capsys.readouterr().err
    assert main(["verify", str(tmp_path / "way out" / before)]) == 0


@pytest.mark.parametrize(
    ("name", "way_out"),
    [
        (".DS_Store", "An operating system put it there. Move it out of the folder"),
        ("episodes/.DS_Store", "An operating system put it there."),
        ("episodes/._00000.mcap", "An operating system put it there."),
        ("Thumbs.db", "An operating system put it there."),
        ("__MACOSX/._x", "Move it out of the folder of the record."),
        ("notes.txt", "Move it out of the folder of the record"),
    ],
)
def test_a_file_beside_a_record_has_a_way_out(
    name: str, way_out: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = unpacked(tmp_path / "folder")
    (folder / name).parent.mkdir(exist_ok=True)
    (folder / name).write_text("x")
    assert main(["verify", str(folder)]) == 1
    err = capsys.readouterr().err
    assert "do not trust" not in err
    assert way_out in err
    shutil.rmtree(folder / name.partition("/")[0]) if "MACOSX" in name else (
        folder / name
    ).unlink()
    assert main(["verify", str(folder)]) == 0


@pytest.mark.parametrize("command", ["verify {}", "report {} -o pages"])
@pytest.mark.parametrize(
    "place",
    [
        ("00006.mcap", "00006.mcap", "keep them."),
        ("p.sqlite.records/run_1/00006.mcap", "p.sqlite.records/run_1", "keep them."),
        ("p.sqlite.records/run_1/00006.mcap", "p.sqlite.records", "keep them."),
        ("p.sqlite.records/run_1/00006.mcap", ".", "keep them."),
        ("00006.mcap", ".", "`proctor export RUN` makes the record"),
        ("holiday/notes.txt", ".", "This folder is not a record: name another."),
        ("holiday/notes.txt", "holiday", "This folder is not a record: name another."),
    ],
)
def test_nothing_is_removed_from_a_folder_that_is_no_record(
    command: str,
    place: tuple[str, str, str],
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """A copy of the files of a server, most often: recordings are the only ones.

    place: a file, which path is named, and what is said.
    """
    file, named, says = place
    (tmp_path / file).parent.mkdir(parents=True, exist_ok=True)
    (tmp_path / file).write_bytes(b"\x89MCAP0\r\n")
    words = command.format(tmp_path / named).split()
    assert main(words) in (1, 2)
    err = capsys.readouterr().err
    assert says in err
    assert not re.search(r"(?i)remove|move it|do not trust", err)


def test_another_key_is_no_success(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["verify", GOOD, "--key", f"H={'SHA256:' + '0' * 64}"]) == 1
    assert "none of the keys named" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("words", "text"),
    [
        (["verify", "absent.proctor"], "absent.proctor: No such file"),
        (["verify", GOOD, "--key", "abc"], "--key abc: expected SHA256:"),
        (["verify", GOOD, "--server", "nowhere"], "url must be like"),
        (["export"], "export needs the id of a run"),
        (["export", "a/b"], "a/b"),
    ],
)
def test_mistakes_are_one_line(
    words: list[str], text: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(words) == 2
    said = capsys.readouterr().err
    assert text in said
    assert said.count("\n") == 1


@pytest.mark.slow("a server")
@pytest.mark.usefixtures("policy_folder")
def test_a_refused_export_says_why(proctor: Proctor) -> None:
    """The run is not completed, or does not exist."""
    run_id = proctor.json("submit", *options("count"))["run_id"]
    for name, reason in ((run_id, "complete"), ("run_none", "not")):
        assert proctor("export", name) != 0
        assert "without a problem document" not in proctor.err
        assert reason in proctor.err


def test_a_file_is_not_replaced_unasked(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "run.proctor"
    path.write_text("mine")
    assert main(["export", "r-1", "--output", str(path)]) == 2
    assert "--force replaces it" in capsys.readouterr().err
    assert path.read_text() == "mine"


@pytest.mark.parametrize(
    ("select", "text"),
    [
        ({"tasks": ["lift", "push"], "splits": ["test"]}, "tasks lift, push; splits t"),
        ({"tasks": 3}, '{"tasks":3}'),
    ],
)
def test_a_score_of_a_part_is_named_so(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], select: object, text: str
) -> None:
    path = tmp_path / "part.proctor"
    path.write_bytes(make_archive(Sample(change_score={"select": select})))
    assert main(["verify", str(path)]) == 0
    out = capsys.readouterr().out
    assert f"  {text}" in out
    assert ", and nothing else" in out


def test_a_line_has_the_player_of_its_result() -> None:
    player = {"name": "pi0", "checkpoint": "3"}

    def played(lines: list[EpisodeLine]) -> list[EpisodeLine]:
        return [msgspec.structs.replace(lines[0], player=player), *lines[1:]]

    lines = contents_of(make_archive(Sample(change_lines=played)))[EPISODES]
    players = [json.loads(line).get("player") for line in lines.splitlines()]
    assert players == [player, None, None, None]
    assert lines.count(b'"player"') == 1


@pytest.mark.slow("starts a server")
@pytest.mark.usefixtures("policy_folder")
def test_a_server_says_in_words_why_it_takes_a_record_that_is_cut_not_in(
    proctor: Proctor,
) -> None:
    """Expect the rule and the cure, and no word about members of the response."""
    cut = Path("cut.proctor")
    cut.write_bytes(Path(GOOD).read_bytes()[:-100])
    assert proctor("upload", str(cut)) == 1
    assert "Fetch it again from its host. [REC-" in proctor.err
    assert "`" not in proctor.err


@pytest.mark.slow("starts a server")
@pytest.mark.usefixtures("policy_folder")
def test_a_server_has_one_name_as_signer(proctor: Proctor) -> None:
    """For its reader: two servers of one machine do not look alike."""
    run = proctor.json("run", "--policy", "policies:Graded", *options("count"))
    proctor("export", run["run_id"], "-o", "run.proctor")
    server = ("--server", proctor.url)
    (level,) = proctor.json("verify", "run.proctor", *server)["levels"]
    taken = proctor.json("upload", "run.proctor")
    assert level == taken["level_text"] == f"signed by {proctor.url}"


@pytest.mark.slow("starts a server")
def test_a_server_that_takes_no_records_in_says_so(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """As servers are, unless their host says otherwise. Expect who can change it and
    what can be done without, and no word of ids."""
    monkeypatch.setenv("PROCTOR_TOKEN", TOKENS["alice"])
    with ReferenceServer(tmp_path) as server:
        proctor = Proctor(server.url, capsys)
        assert proctor("upload", GOOD) == 2
    assert "takes no records in" in proctor.err
    assert "--record-imports on or PROCTOR_RECORD_IMPORTS=on" in proctor.err
    assert f"proctor verify {GOOD}" in proctor.err
    assert "Check the id" not in proctor.err
