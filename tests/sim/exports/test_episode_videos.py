"""Videos of recorded episodes: the right pictures, and none of what left the record."""

import json
import re
import socket
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import av
import numpy as np
import pytest

from reference_record.formats import local_servers
from reference_sim import benchmark_registry
from reference_sim.benchmarks.calibration import Calibration
from reference_sim.episode import Episode
from reference_sim.exports.__main__ import main
from reference_sim.host_seeds import seal
from reference_sim.interface import Simulator
from reference_sim.replay.__main__ import main as replay
from reference_sim.replay.foreign_manifest import open_part
from tests.support.record.played_records import Chunk, play_chunks, save_played_record
from tests.support.sim.echo_records import other_action, other_digest, save_echo


def video(record: Path, **more: Any) -> int:
    job = {"kind": "video", "record": str(record), "output": str(record.parent / "v")}
    return main([json.dumps(job | {"json": True} | more)])


def decoded(path: Path) -> tuple[list[Any], Any]:
    with av.open(str(path)) as container:
        stream = container.streams.video[0]
        return list(container.decode(stream)), stream.average_rate


def test_a_picture_for_each_step_and_a_keyframe_for_each_second(folder: Path) -> None:
    record = save_echo(folder)
    assert video(record, episodes=[0]) == 0
    frames, rate = decoded(folder / "v" / "00000.mp4")
    assert (len(frames), rate) == (46, 10)
    keyframes = [number for number, frame in enumerate(frames) if frame.key_frame]
    assert keyframes == [0, 10, 20, 30, 40]
    assert (frames[0].width, frames[0].height) == (16, 12)
    times = [number / 10 for number in range(46)]
    assert [frame.time for frame in frames] == pytest.approx(times)


def test_the_size_is_the_one_that_is_wanted(folder: Path) -> None:
    assert video(save_echo(folder), episodes=[1], size=[96, 64]) == 0
    frames, _ = decoded(folder / "v" / "00001.mp4")
    assert (frames[0].width, frames[0].height) == (96, 64)


def test_what_came_before_a_fault_is_not_shown(folder: Path) -> None:
    """The start that counts has 45 steps; the one before it had 5."""
    assert video(save_echo(folder, faults=1), episodes=[0]) == 0
    frames, _ = decoded(folder / "v" / "00000.mp4")
    assert len(frames) == 46


def test_other_state_is_said(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert video(save_echo(folder, other_digest), episodes=[1]) == 0
    out, err = capsys.readouterr()
    (file,) = json.loads(out)["files"]
    assert file["replay"] == "outcome"
    assert file["leaves_the_record_at"] == {"turn": 3, "step": 15}
    assert "episode 1 leaves the record at turn 3 of attempt 1, step 15" in err
    assert "its result is the same" in err


def test_diverged_is_refused(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The other episode is drawn all the same; nothing is left of the refused one."""
    assert video(save_echo(folder, other_action), episodes=[0, 1]) == 1
    out, err = capsys.readouterr()
    said = json.loads(out)
    assert [one["episode"] for one in said["refused"]] == [1]
    assert said["refused"][0]["leaves_the_record_at"]["turn"] == 3
    assert "episode 1 leaves the record at turn 3" in err
    assert "--anyway keeps it" in err
    assert [path.name for path in (folder / "v").iterdir()] == ["00000.mp4"]


def test_what_diverged_is_kept_under_another_name(folder: Path) -> None:
    record = save_echo(folder, other_action)
    assert video(record, episodes=[1], anyway=True) == 0
    assert [path.name for path in (folder / "v").iterdir()] == ["00001-diverged.mp4"]


@pytest.mark.parametrize(
    ("more", "text"),
    [
        ({"episodes": [2]}, "no camera in the task score"),
        ({"episodes": [0], "cameras": ["front"]}, "no camera front; it has pattern"),
        ({"episodes": [7]}, "the record has no episode 7; it has 0 to "),
        ({"episodes": [0], "benchmarks": "absent.toml"}, "absent.toml"),
    ],
)
def test_what_cannot_be_drawn_is_said(
    more: dict[str, Any], text: str, folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    record = save_echo(folder)
    assert video(record, **more) == 2
    assert text in capsys.readouterr().err
    assert video(record, episodes=[0]) == 0


def test_a_file_is_replaced_when_that_is_wanted(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    record = save_echo(folder)
    assert video(record, episodes=[0]) == 0
    assert video(record, episodes=[0]) == 2
    assert "exists; --force replaces it" in capsys.readouterr().err
    assert video(record, episodes=[0], force=True) == 0


def test_a_full_disk_is_no_divergence(
    folder: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Nothing is left of a folder whose only video is not whole."""

    def fail(*_: object) -> None:
        raise OSError(28, "No space left on device", "v/00000.mp4")

    monkeypatch.setattr("reference_sim.exports.video_file.VideoFile.close", fail)
    assert video(save_echo(folder), episodes=[0]) == 2
    assert "v cannot be written (No space left on device)" in capsys.readouterr().err
    assert not (folder / "v").exists()


@pytest.mark.parametrize("kind", [RuntimeError, SystemExit])
def test_a_simulator_that_cannot_draw_is_no_divergence(
    folder: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    kind: type[BaseException],
) -> None:
    record = save_echo(folder)

    def fail(_: object) -> None:
        raise kind("no GL")

    monkeypatch.setattr(Calibration, "observe", fail)
    assert video(record, episodes=[0]) == 2
    assert f"cannot be drawn: {kind.__name__}: no GL" in capsys.readouterr().err


def test_a_folder_that_is_a_file_is_said(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (folder / "v").touch()
    assert video(save_echo(folder), episodes=[0]) == 2
    assert "v cannot be written (File exists)" in capsys.readouterr().err


SECRET = b"s" * 32


@pytest.fixture
def sealed_record(folder: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The first episode of it is open and the second sealed; no secret is found."""
    monkeypatch.chdir(folder)
    monkeypatch.setenv("XDG_STATE_HOME", str(folder / "state"))
    for name in ("PROCTOR_SEED_SECRET", "PROCTOR_DATABASE"):
        monkeypatch.delenv(name, raising=False)
    options = {"tasks": ["echo", "echo"], "sealed": True}
    found = benchmark_registry.resolve("calibration", options)
    drawn = seal(found.manifest, SECRET, found.seed_block, found.seed_max)
    shown = open_part(dict(drawn)) | {"seeds_sha256": drawn["seeds_sha256"]}
    record = folder / "run-1.proctor"
    plans = tuple(benchmark_registry.EpisodePlan(**e) for e in drawn["episodes"])
    sealed = replace(found, manifest=shown, episodes=plans)
    recordings = folder / "recordings"
    save_played_record(record, recordings, sealed, play_chunks, options=options)
    return record


@pytest.mark.parametrize(
    ("episodes", "replayed", "text"),
    [
        ("0", 1, None),
        ("0,1", 1, "episode 1 cannot be simulated: the seed is sealed; the machine"),
        ("1", 0, "episode 1 cannot be simulated: the seed is sealed; the machine"),
        ("0,7", 0, "the record has no episode 7; it has 0 to 1"),
    ],
)
def test_a_replay_of_chosen_episodes_leaves_sealed_ones_out_and_says_so(
    episodes: str,
    replayed: int,
    text: str | None,
    sealed_record: Path,
    capsys: pytest.CaptureFixture[str],
) -> None:
    options = ["--no-verdict", "--json", "--processes", "1", "--episodes", episodes]
    assert replay([str(sealed_record), *options]) == (0 if replayed else 2)
    out, err = capsys.readouterr()
    assert (json.loads(out)["exact"] if out else 0) == replayed
    said = [line for line in err.splitlines() if re.search("cannot be|has no", line)]
    assert [line.count(text or "") for line in said] == [1] * (text is not None), err


def test_a_sealed_seed_stays_a_secret(
    sealed_record: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert video(sealed_record, episodes=[1]) == 2
    said = capsys.readouterr().err
    assert "episode 1 cannot be simulated: the seed is sealed" in said
    assert "1 episode left out: sealed seeds" in said
    assert "--seeds" in said
    assert video(sealed_record, episodes=[0]) == 0
    assert json.loads(capsys.readouterr().out)["left_out"] == []
    assert video(sealed_record, force=True) == 0
    assert json.loads(capsys.readouterr().out)["left_out"] == [
        {"episode": 1, "outcome": "success", "reason": "seed_sealed"}
    ]


@pytest.mark.parametrize(
    ("place", "file", "is_used"),
    [
        ("var/proctor.sqlite.seeds", (0o600, SECRET.hex()), True),
        ("state/server/db.seeds", (0o600, SECRET.hex()), True),
        ("elsewhere/db.seeds", (0o600, SECRET.hex()), False),
        ("var/proctor.sqlite.seeds", (0o640, SECRET.hex()), False),
        ("var/proctor.sqlite.seeds", (0o600, (b"o" * 32).hex()), False),
        ("var/proctor.sqlite.seeds", (0o600, "no secret"), False),
        ("var/proctor.sqlite.seeds", (0o600, ""), False),
    ],
)
def test_the_host_sees_what_it_has_sealed(
    sealed_record: Path,
    place: str,
    file: tuple[int, str],
    is_used: bool,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """With the secret beside its database, or beside the token of its server."""
    folder = sealed_record.parent
    path = folder / place
    path.parent.mkdir(parents=True)
    mode, content = file
    path.write_text(content)
    path.chmod(mode)
    with socket.create_server(("127.0.0.1", 0)) as listener:
        local_servers.publish(listener, folder / "state" / "server" / "db.token")
    assert video(sealed_record, episodes=[1]) == (0 if is_used else 2)
    said = capsys.readouterr()
    assert ("sealed seeds: drawn with " in said.err) is is_used
    if is_used:
        (drawn,) = json.loads(said.out)["files"]
        assert drawn["replay"] == "exact"


@pytest.mark.slow("draws with MuJoCo")
@pytest.mark.parametrize(
    ("benchmark", "camera"),
    [("tabletop_state", "wrist"), ("mobile_bimanual_state", "front")],
)
def test_what_has_no_cameras_is_drawn_in_its_own_world(
    benchmark: str, camera: str, folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Every digest is the recorded one, with cameras, too."""
    found = benchmark_registry.resolve(benchmark)
    space = found.manifest["action_space"]
    zero = {name: [0.0] * one["size"] for name, one in space.items()}

    def play_zeros(episode: Episode, _simulator: Simulator) -> Iterator[Chunk]:
        while not episode.ended:
            yield [zero] * 50

    record = folder / "run-1.proctor"
    save_played_record(record, folder / "recordings", found, play_zeros, only={0})
    assert video(record, episodes=[0], cameras=[camera], size=[64, 48]) == 0
    (file,) = json.loads(capsys.readouterr().out)["files"]
    steps = found.manifest["max_steps"]
    assert (file["replay"], file["pictures"]) == ("exact", steps + 1)


@pytest.mark.slow("draws with MuJoCo")
def test_the_first_picture_is_the_simulator_s(folder: Path) -> None:
    """Within what H.264 loses, in both cameras; failures alone are drawn."""
    found = benchmark_registry.resolve("tabletop", images={
        "codec": "raw", "width": 224, "height": 224
    })  # fmt: skip
    space = found.manifest["action_space"]
    middle = {
        name: np.mean([one["minimum"], one["maximum"]], axis=0).tolist()
        for name, one in space.items()
    }

    def play_200_steps(_episode: Episode, _simulator: Simulator) -> Iterator[Chunk]:
        for _ in range(4):
            yield [middle] * 50

    record = folder / "run-1.proctor"
    save_played_record(record, folder / "recordings", found, play_200_steps, only={0})
    assert video(record, failures=True) == 0
    simulator = benchmark_registry.make(found.world)
    plan = found.episodes[0]
    simulator.reset(plan.task, plan.seed, plan.split)
    seen = {name: image.copy() for name, image in simulator.observe().images.items()}
    simulator.close()
    for camera in ("front", "wrist"):
        frames, rate = decoded(folder / "v" / f"00000-{camera}.mp4")
        assert (len(frames), rate) == (201, 20)
        keyframes = [number for number, frame in enumerate(frames) if frame.key_frame]
        assert keyframes == [*range(0, 201, 20)]
        shown = frames[0].to_ndarray(format="rgb24")
        difference = np.abs(shown.astype(int) - seen[camera])
        assert difference.mean() < 3
        assert np.quantile(difference, 0.99) < 40
