"""The verdict as an in-toto statement, so that a machine can read and verify it.

Predicate `test-result/v0.1` of the in-toto Attestation Framework. Its subject is
report.json, and what the server was built as, where that is given. With a key the
statement is signed as a DSSE envelope; without one it stands alone and proves nothing.
"""

import base64
import hashlib
import json
import re
from pathlib import Path
from typing import Any

from cryptography.exceptions import UnsupportedAlgorithm
from cryptography.hazmat.primitives.asymmetric.ed25519 import Ed25519PrivateKey
from cryptography.hazmat.primitives.serialization import (
    Encoding,
    PublicFormat,
    load_pem_private_key,
)

from conformance.client.connections.transport.replaced_file import replace_file
from conformance.specification.document import load_spec, spec_sha256
from conformance.specification.ledger import load_ledger
from conformance.verdicts.result import Result
from conformance.verdicts.verdict import Outcome

STATEMENT_TYPE = "https://in-toto.io/Statement/v1"
PREDICATE_TYPE = "https://in-toto.io/attestation/test-result/v0.1"
PAYLOAD_TYPE = "application/vnd.in-toto+json"
_SUBJECT = re.compile(r"(?P<name>[^@\s]+)@sha256:(?P<digest>[0-9a-f]{64})")


class CannotAttest(Exception):
    """There is no verdict to state, or no key to sign it; the text gives the reason."""


def read_subject(text: str) -> dict[str, Any]:
    """Read NAME@sha256:HEX; raise ValueError if it is something else."""
    match = _SUBJECT.fullmatch(text)
    if match is None:
        raise ValueError(f"{text}: not NAME@sha256: and 64 hexadecimal digits")
    return {"name": match["name"], "digest": {"sha256": match["digest"]}}


def statement(result: Result, report: bytes, subject: str | None) -> dict[str, Any]:
    """Give the statement on a whole run; raise CannotAttest if it was none."""
    if result.is_partial:
        raise CannotAttest("only selected rules were judged")
    if result.exit_code not in (0, 1):
        raise CannotAttest(result.conclusion())
    settings = result.settings
    digest = {"sha256": hashlib.sha256(report).hexdigest()}
    report_subject = {"name": "report.json", "digest": digest}
    tests = _tests(result)
    return {
        "_type": STATEMENT_TYPE,
        "subject": [*([read_subject(subject)] if subject else []), report_subject],
        "predicateType": PREDICATE_TYPE,
        "predicate": {
            "result": _result_of(tests),
            "configuration": [
                {
                    "name": f"Proctor {load_spec().version}",
                    "digest": {"sha256": spec_sha256()},
                    "annotations": {
                        "server": settings.service.get("name"),
                        "server_version": settings.service.get("version"),
                        "profiles": settings.service.get("profiles"),
                        "levels": {v.name: v.text for v in result.levels()},
                        "seed": settings.seed,
                        "started_at": result.started_at,
                    },
                }
            ],
            **tests,
        },
    }


def _tests(result: Result) -> dict[str, list[str]]:
    """The ids of the rules by what their checks said; unjudged rules are left out."""
    ledger = load_ledger()
    kinds = ("passedTests", "warnedTests", "failedTests")
    tests: dict[str, list[str]] = {kind: [] for kind in kinds}
    for row in result.rows.values():
        if row.outcome == Outcome.PASSED:
            tests["passedTests"].append(row.requirement_id)
        elif row.outcome == Outcome.FAILED:
            is_must = ledger[row.requirement_id].level == "MUST"
            kind = "failedTests" if is_must else "warnedTests"
            tests[kind].append(row.requirement_id)
    return tests


def _result_of(tests: dict[str, list[str]]) -> str:
    if tests["failedTests"]:
        return "FAILED"
    return "WARNED" if tests["warnedTests"] else "PASSED"


def sign(payload: bytes, key: Ed25519PrivateKey) -> dict[str, Any]:
    """Give the DSSE envelope of a payload; a key's id is the hash of its raw bytes."""
    kind = PAYLOAD_TYPE.encode()
    signed = b"DSSEv1 %d %s %d %s" % (len(kind), kind, len(payload), payload)
    public = key.public_key().public_bytes(Encoding.Raw, PublicFormat.Raw)
    return {
        "payload": base64.b64encode(payload).decode(),
        "payloadType": PAYLOAD_TYPE,
        "signatures": [
            {
                "keyid": hashlib.sha256(public).hexdigest(),
                "sig": base64.b64encode(key.sign(signed)).decode(),
            }
        ],
    }


def load_key(path: Path) -> Ed25519PrivateKey:
    """Read a private key in PEM; raise CannotAttest if it is none of Ed25519."""
    try:
        key = load_pem_private_key(path.read_bytes(), password=None)
    except OSError as error:
        raise CannotAttest(f"{path}: {error.strerror}") from error
    except (ValueError, TypeError, UnsupportedAlgorithm) as error:
        raise CannotAttest(f"{path}: no private key in PEM without password") from error
    if not isinstance(key, Ed25519PrivateKey):
        raise CannotAttest(f"{path}: not an Ed25519 key")
    return key


def write_attestation(result: Result) -> None:
    """Write the statement to --attest, signed if there is a key."""
    settings = result.settings
    if settings.attest is None:
        return
    report = (Path(settings.report) / "report.json").read_bytes()
    stated = statement(result, report, settings.attest_subject)
    text = json.dumps(stated, indent=1, ensure_ascii=False)
    if settings.attest_key is not None:
        payload = json.dumps(stated, separators=(",", ":"), sort_keys=True).encode()
        text = json.dumps(sign(payload, load_key(Path(settings.attest_key))), indent=1)
    replace_file(Path(settings.attest), f"{text}\n")
