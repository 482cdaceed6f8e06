"""Archives, envelopes, schemas and keys, beside other programs that read the same."""

import base64
import hashlib
import io
import json
import os
import random
import re
import zipfile
from pathlib import Path
from typing import Any

import jsonschema_rs
import msgspec
import pytest
from rfc8785 import CanonicalizationError
from securesystemslib.dsse import Envelope as OtherEnvelope
from securesystemslib.signer._key import SSlibKey

from reference_record.broken import BrokenRecord, UnusableRecord
from reference_record.contents.score import ScoredLine, compute_score, first_difference
from reference_record.formats.archive import Content, stream_archive
from reference_record.formats.bundle import open_bundle
from reference_record.formats.envelope import read_envelope, sign_envelope
from reference_record.formats.names import (
    EPISODES,
    EPISODES_MAX,
    FIXED,
    STATEMENT,
    check_count,
    recording_name,
)
from reference_record.formats.strict_json import canonical_json
from reference_record.keys import load_or_make
from reference_record.unsigned_record import add_verdict
from reference_record.verification import verify
from tests.support.paths import ROOT
from tests.support.record.sample_records import (
    HOST_KEY,
    OTHER_KEY,
    Sample,
    contents_of,
    make_archive,
    make_verdict,
)

SCHEMAS = json.loads((ROOT / "spec" / "schema" / "record.json").read_text())
SCORES = sorted((ROOT / "spec" / "vectors" / "scoring").glob("*.json"))


def schema(name: str) -> jsonschema_rs.Draft202012Validator:
    document = {"$ref": f"#/$defs/{name}", "$defs": SCHEMAS["$defs"]}
    return jsonschema_rs.Draft202012Validator(document)


def payload_of(envelope: bytes) -> Any:
    return json.loads(base64.b64decode(json.loads(envelope)["payload"]))


def test_other_programs_for_zip_read_an_archive() -> None:
    archive = make_archive()
    with zipfile.ZipFile(io.BytesIO(archive)) as opened:
        assert opened.testzip() is None
        found = {name: opened.read(name) for name in opened.namelist()}
    assert found == contents_of(archive)


@pytest.mark.parametrize("length", [0, 1, 1000])
def test_another_reader_of_dsse_agrees(length: int) -> None:
    payload = random.Random(length).randbytes(length) or b"{}"
    envelope = sign_envelope(payload, HOST_KEY)
    other = OtherEnvelope.from_dict(json.loads(envelope))
    key = {"public": HOST_KEY.public_key.hex()}
    signer = SSlibKey(HOST_KEY.keyid, "ed25519", "ed25519", key)
    assert other.verify([signer], 1).keys() == {HOST_KEY.keyid}
    assert other.payload == read_envelope(STATEMENT, envelope).payload == payload
    read_envelope(STATEMENT, envelope).check_signature(HOST_KEY.public_key)
    with pytest.raises(BrokenRecord, match="REC-006"):
        read_envelope(STATEMENT, envelope).check_signature(OTHER_KEY.public_key)


def test_the_files_fit_their_schemas() -> None:
    archive = make_archive()
    contents = contents_of(archive)
    verdict = make_verdict(archive)
    for envelope in (contents[STATEMENT], verdict):
        schema("envelope").validate(json.loads(envelope))
    schema("statement").validate(payload_of(contents[STATEMENT]))
    schema("verdict").validate(payload_of(verdict))
    schema("manifest").validate(json.loads(contents["manifest.json"]))
    for line in contents[EPISODES].splitlines():
        schema("episode").validate(json.loads(line))


@pytest.mark.parametrize("path", SCORES, ids=lambda path: path.stem)
def test_the_score_follows_the_golden_vectors(path: Path) -> None:
    vector = json.loads(path.read_text())
    rows = [list(one.values()) for one in vector["episodes"]]
    episodes = msgspec.convert(rows, list[ScoredLine])
    assert first_difference(vector["score"], compute_score(episodes)) is None


@pytest.mark.parametrize(
    ("expected", "found", "where"),
    [
        ({"a": 1.0}, {"a": 1.0 + 1e-10, "more": 2}, None),
        ({"a": 1.0}, {"a": 1.1}, "/a"),
        ({"a": None}, {"a": 0}, "/a"),
        ({"a": True}, {"a": 1}, "/a"),
        ({"a": 1}, {}, "/a"),
        ({"by": {}}, {"by": {"lift": {}}}, "/by/lift"),
        ({"by": {"lift": 1}}, {"by": 1}, "/by"),
        ({"a": 1.0}, {"a": "1"}, "/a"),
        ({"a": 1.0}, {"a": 10**400}, "/a"),
        ({"a": 1.0}, {"a": -(10**5000)}, "/a"),
    ],
)
def test_differences_of_scores(expected: Any, found: Any, where: str | None) -> None:
    difference = first_difference(expected, found)
    assert (difference or "").split(" ")[0] == (where or "")


def test_a_difference_of_scores_shows_the_begin_of_a_long_text() -> None:
    difference = first_difference({"a": 1.0}, {"a": "x" * 100_000})
    assert difference == f"/a is {'x' * 100}, not 1.0"


# --- directories ---


def unpack(directory: Path) -> None:
    """Write the files of the sample's record into a new directory."""
    with zipfile.ZipFile(io.BytesIO(make_archive())) as archive:
        archive.extractall(directory)


def test_a_directory_is_the_same_record(tmp_path: Path) -> None:
    folder, directory = tmp_path / "recordings", tmp_path / "run"
    folder.mkdir()
    record = Sample().record(folder)
    unpack(directory)
    assert record.size == len(make_archive())
    assert verify(open_bundle(directory)).statement_sha256 == record.statement_sha256


@pytest.mark.parametrize("name", ["episodes/00001.mcap", "manifest.json", "more.txt"])
def test_a_link_in_a_directory_is_refused(name: str, tmp_path: Path) -> None:
    directory = tmp_path / "run"
    unpack(directory)
    target = directory / name
    if target.exists():
        target.unlink()
    target.symlink_to("/etc/hostname")
    with pytest.raises(BrokenRecord, match=re.escape(name)) as broken:
        open_bundle(directory)
    assert broken.value.rule == "REC-003"


def test_a_pipe_is_no_record(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "run.proctor")
    with pytest.raises(BrokenRecord, match="REC-003"):
        open_bundle(tmp_path / "run.proctor")


# --- verdicts ---


@pytest.mark.parametrize("as_directory", [False, True])
def test_a_verdict_is_added_and_replaced(as_directory: bool, tmp_path: Path) -> None:
    archive, path = make_archive(), tmp_path / "run.proctor"
    if as_directory:
        unpack(path)
    else:
        path.write_bytes(archive)
    trusted = {HOST_KEY.keyid: "H", OTHER_KEY.keyid: "R"}
    for key, levels in (
        (HOST_KEY, ["signed by H", "replayed by H (exact, 4 of 4 episodes)"]),
        (OTHER_KEY, ["signed by H", "replayed by R (exact, 4 of 4 episodes)"]),
    ):
        add_verdict(open_bundle(path), path, "r", make_verdict(archive, key=key))
        assert verify(open_bundle(path), trusted).levels == levels
    assert verify(open_bundle(path)).levels == ["reported"]


# --- what cannot be written ---


def test_a_changed_recording_is_not_signed(tmp_path: Path) -> None:
    record = Sample().record(tmp_path)
    path = tmp_path / "00000.mcap"
    path.write_bytes(path.read_bytes()[:-1])
    with pytest.raises(UnusableRecord, match=re.escape(recording_name(0))):
        b"".join(record.stream())


def test_4_gib_are_no_archive() -> None:
    large = Content(2**32 - 1, 0, list)
    with pytest.raises(UnusableRecord, match="4 GiB"):
        next(stream_archive([(recording_name(0), large)]))


def test_more_recordings_than_allowed_are_refused() -> None:
    names = [*FIXED, *map(recording_name, range(EPISODES_MAX + 1))]
    with pytest.raises(BrokenRecord, match="REC-030"):
        check_count(names)


# --- keys ---


def test_a_key_is_made_once_for_its_owner(tmp_path: Path) -> None:
    path = tmp_path / "a" / "signing-key"
    key = load_or_make(path)
    assert path.stat().st_mode & 0o777 == 0o600
    assert list(path.parent.iterdir()) == [path]
    assert load_or_make(path).keyid == key.keyid
    assert key.keyid == "SHA256:" + hashlib.sha256(key.public_key).hexdigest()


def test_a_key_that_others_can_read_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "signing-key"
    load_or_make(path)
    path.chmod(0o644)
    with pytest.raises(UnusableRecord, match="chmod 600"):
        load_or_make(path)


def test_a_file_without_a_key_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "signing-key"
    path.touch(mode=0o600)
    with pytest.raises(UnusableRecord, match="no signing key"):
        load_or_make(path)


# --- canonical JSON ---


@pytest.mark.parametrize(
    ("value", "text"),
    [
        ({"b": 1, "a": [True, None, {}]}, '{"a":[true,null,{}],"b":1}'),
        ({"Z": "ü/\u2028", "a": '"\\\n'}, '{"Z":"ü/\u2028","a":"\\"\\\\\\n"}'),
        ([0.1, 1.0, 1e21, -0.0, 2**53 - 1], "[0.1,1,1e+21,0,9007199254740991]"),
        ({"\ue000": 1, "😂": 2}, '{"😂":2,"\ue000":1}'),
    ],
)
def test_a_value_has_one_text(value: Any, text: str) -> None:
    assert canonical_json(value) == text.encode()


@pytest.mark.parametrize("value", [2**53, float("nan"), {1: 2}, "\ud800"])
def test_a_value_without_a_text_is_a_value_error(value: Any) -> None:
    with pytest.raises(CanonicalizationError):
        canonical_json(value)
