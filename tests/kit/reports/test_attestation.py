"""The statement of a verdict: what it names, and that its signature can be checked."""

import base64
import hashlib
import json
from pathlib import Path

import pytest
from cryptography.hazmat.primitives.asymmetric.ed25519 import Ed25519PrivateKey
from cryptography.hazmat.primitives.serialization import (
    Encoding,
    NoEncryption,
    PrivateFormat,
)
from securesystemslib.dsse import Envelope
from securesystemslib.signer._key import SSlibKey

from conformance.cli.arguments import parse_arguments, read_settings
from conformance.cli.kit_command import BadArguments
from conformance.reports.attestation import (
    PAYLOAD_TYPE,
    CannotAttest,
    load_key,
    sign,
    statement,
)
from conformance.run_settings import Settings
from conformance.specification.document import spec_sha256
from conformance.specification.ledger import PROFILES
from conformance.verdicts.result import Result
from conformance.verdicts.verdict import Outcome, Verdict
from tests.support.kit.concluded_results import concluded

DIGEST = "a" * 64


def result(*failed: str, only: str | None = None) -> Result:
    settings = Settings(profiles=list(PROFILES), only=[only] if only else [])
    settings.service = {"name": "a server", "version": "1", "profiles": []}
    made = concluded(settings, *[Verdict(id_, Outcome.FAILED) for id_ in failed])
    for row in made.rows.values():
        if row.outcome == Outcome.NOT_VERIFIED:
            row.allowed = True
    return made


def test_statement_names_report_server_and_rules() -> None:
    stated = statement(result(), b"{}", f"image@sha256:{DIGEST}")
    image, report = stated["subject"]
    assert image == {"name": "image", "digest": {"sha256": DIGEST}}
    assert report["digest"]["sha256"] == hashlib.sha256(b"{}").hexdigest()
    predicate = stated["predicate"]
    assert predicate["result"] == "PASSED"
    assert "PRED-003" in predicate["passedTests"]
    (configuration,) = predicate["configuration"]
    assert configuration["digest"] == {"sha256": spec_sha256()}
    assert configuration["annotations"]["server"] == "a server"


def test_a_violated_rule_fails_the_statement() -> None:
    predicate = statement(result("PRED-003"), b"", None)["predicate"]
    assert predicate["result"] == "FAILED"
    assert predicate["failedTests"] == ["PRED-003"]
    assert "PRED-003" not in predicate["passedTests"]


def test_selected_rules_are_no_verdict() -> None:
    with pytest.raises(CannotAttest):
        statement(result(only="PRED"), b"", None)


def test_another_library_verifies_the_signature(tmp_path: Path) -> None:
    key = Ed25519PrivateKey.generate()
    pem = key.private_bytes(Encoding.PEM, PrivateFormat.PKCS8, NoEncryption())
    (tmp_path / "key.pem").write_bytes(pem)
    payload = json.dumps(statement(result(), b"", None)).encode()
    signed = sign(payload, load_key(tmp_path / "key.pem"))
    assert base64.b64decode(signed["payload"]) == payload
    assert signed["payloadType"] == PAYLOAD_TYPE
    public = key.public_key().public_bytes_raw().hex()
    (one,) = signed["signatures"]
    reader = SSlibKey(one["keyid"], "ed25519", "ed25519", {"public": public})
    envelope = Envelope.from_dict(
        signed | {"signatures": [{"keyid": one["keyid"], "sig": one["sig"]}]}
    )
    assert set(envelope.verify([reader], 1)) == {one["keyid"]}


@pytest.mark.parametrize(
    "given",
    [
        ["--attest-key", "key.pem"],
        ["--attest", "out.json", "--only", "PRED"],
        ["--attest", "out.json", "--stage", "2"],
        ["--attest", "out.json", "--attest-subject", "image"],
        ["--attest", "out.json", "--attest-key", "/nowhere/key.pem"],
        ["--attest", "/nowhere/out.json"],
    ],
)
def test_what_could_only_fail_later_is_refused(given: list[str]) -> None:
    options = parse_arguments(["--url", "http://host", *given])
    with pytest.raises(BadArguments):
        read_settings(options)
    right = parse_arguments(["--url", "http://host", "--attest", "out.json"])
    assert read_settings(right).attest == "out.json"
