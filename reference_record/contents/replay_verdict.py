"""Verdicts: what others found when they replayed a record, signed by them (SVR).

https://github.com/in-toto/attestation/blob/main/spec/predicates/svr.md; `replay` and
the key of the verifier are members of ours.
"""

from __future__ import annotations

import base64
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Final, Literal

import msgspec
from msgspec import Struct

from reference_record.broken import BrokenRecord
from reference_record.contents.statement import (
    Count,
    Sha256,
    Statement,
    Text,
    check_types,
    decode_key,
    public_key_in,
    write_statement,
)
from reference_record.formats.envelope import read_envelope, sign_envelope
from reference_record.formats.names import STATEMENT
from reference_record.formats.strict_json import read_json
from reference_record.keys import SigningKey

SVR_TYPE: Final = "https://in-toto.io/attestation/svr/v0.1"
Result = Literal["exact", "outcome", "diverged"]
PROPERTIES: Final[Mapping[Result, list[str]]] = {
    "exact": ["PROCTOR_REPLAYED_EXACT", "PROCTOR_REPLAYED_OUTCOME"],
    "outcome": ["PROCTOR_REPLAYED_OUTCOME"],
    "diverged": [],
}


class Verifier(Struct):
    """id: a URI of the key. name: chosen by the verifier itself."""

    id: Text
    name: Text
    keyid: Text
    public_key: Text


class Divergence(Struct):
    """The first step after which a replay was in another state; step from 1."""

    episode_index: Count
    attempt: Count
    step: Count


class ReplaySummary(Struct):
    """Episodes by how they replayed. engine: versions of what replayed them."""

    result: Result
    episodes: Count
    exact: Count
    outcome: Count
    diverged: Count
    first_divergence: Divergence | None
    engine: dict[str, Any]


class SvrPredicate(Struct):
    """REC-014: a Simple Verification Result."""

    verifier: Verifier
    timeCreated: Text  # noqa: N815 – in-toto's name
    properties: list[Text]
    replay: ReplaySummary


@dataclass(frozen=True, slots=True)
class ReplayVerdict:
    """A verdict whose signature fits the key that it names."""

    file: str
    keyid: str
    name: str
    created_at: str
    replay: ReplaySummary


def write_verdict(
    replay: ReplaySummary,
    *,
    statement_sha256: Sha256,
    name: str,
    at: str,
    key: SigningKey,
) -> bytes:
    """The signed bytes of a verdict about one record (REC-014)."""
    public_key = base64.b64encode(key.public_key).decode()
    predicate = SvrPredicate(
        Verifier(f"urn:proctor:key:{key.keyid}", name, key.keyid, public_key),
        at,
        PROPERTIES[replay.result],
        replay,
    )
    subject = [(STATEMENT, statement_sha256)]
    return sign_envelope(write_statement(subject, SVR_TYPE, predicate), key)


def read_verdict(
    file: str, data: bytes, statement_sha256: str, episodes: int
) -> ReplayVerdict:
    """REC-014: raise BrokenRecord unless it is whole and about this record.

    episodes: how many the record has.
    """
    envelope = read_envelope(file, data)
    envelope.check_signature(public_key_in(envelope))
    statement = read_json(file, envelope.payload, Statement[SvrPredicate])
    check_types(file, statement, SVR_TYPE)
    said = statement.predicate
    envelope.check_signature(decode_key(file, said.verifier.public_key))
    subject = [(entry.name, entry.digest.sha256) for entry in statement.subject]
    if subject != [(STATEMENT, statement_sha256)]:
        raise BrokenRecord(file, "REC-014", "it is about another record")
    replay = said.replay
    counted = replay.exact + replay.outcome + replay.diverged
    if not 0 < counted <= episodes:
        detail = f"it counts {counted} episodes of {episodes}"
        raise BrokenRecord(file, "REC-014", detail)
    if said.properties != PROPERTIES[replay.result] or counted != replay.episodes:
        raise BrokenRecord(file, "REC-014", "what it says contradicts itself")
    if replay.result != _result_of(replay):
        raise BrokenRecord(
            file, "REC-014", "its result does not follow from its counts"
        )
    return ReplayVerdict(
        file, envelope.keyid, said.verifier.name, said.timeCreated, replay
    )


def _result_of(replay: ReplaySummary) -> Result:
    if replay.diverged:
        return "diverged"
    return "outcome" if replay.outcome else "exact"


def replay_of(
    results: Mapping[int, tuple[Result, Divergence | None]], engine: dict[str, Any]
) -> ReplaySummary:
    """The sum over episodes. results: index → how it replayed, and where it parted."""
    verdicts = [result for result, _ in results.values()]
    first = next(
        (where for _, (how, where) in sorted(results.items()) if how == "diverged"),
        None,
    )
    replay = ReplaySummary(
        "exact",
        len(verdicts),
        verdicts.count("exact"),
        verdicts.count("outcome"),
        verdicts.count("diverged"),
        first,
        engine,
    )
    return msgspec.structs.replace(replay, result=_result_of(replay))
