"""Levels of trust and quotas of records that are handed in."""

from __future__ import annotations

import dataclasses
from typing import Literal

import pytest

from reference_server.rules.imported_record import (
    FirstDivergence,
    ImportReplay,
    ImportUsage,
    RecordImport,
    next_to_replay,
    refuse_import,
    trust_of,
)

ONE = RecordImport(
    number=1,
    import_id="imp_1",
    account="alice",
    archive_sha256="a" * 64,
    size_bytes=100,
    statement_sha256="b" * 64,
    keyid="SHA256:c",
    run_id="run_1",
    benchmark_id="calibration",
    benchmark_version="1",
    manifest_sha256="d" * 64,
    policy_name="p",
    policy_version=None,
    score=0.5,
    episodes=4,
    imported_at_wall=0.0,
)
PARTED = "diverged when replayed by R"
KNOWN = {"SHA256:c": "a lab"}


def replay(
    result: Literal["exact", "outcome", "diverged"],
    where: FirstDivergence | None = None,
) -> ImportReplay:
    counts = {"exact": 0, "outcome": 0, "diverged": 0} | {result: 3}
    return ImportReplay(result, 3, **counts, first_divergence=where)


@pytest.mark.parametrize(
    ("found", "names", "level", "text"),
    [
        (None, {}, "reported", "reported"),
        (None, KNOWN, "signed", "signed by a lab"),
        (replay("exact"), {}, "replayed", "replayed by R (exact, 3 of 4 episodes)"),
        (
            replay("outcome"),
            KNOWN,
            "replayed",
            "signed by a lab, replayed by R (outcome, 3 of 4 episodes)",
        ),
        (replay("diverged"), {}, "diverged", "diverged when replayed by R"),
        (
            replay("diverged", FirstDivergence(2, 1, 7)),
            KNOWN,
            "diverged",
            f"signed by a lab, {PARTED} at episode 2, attempt 1, step 7",
        ),
    ],
)
def test_the_level_says_what_is_known(
    found: ImportReplay | None, names: dict[str, str], level: str, text: str
) -> None:
    trust = trust_of(dataclasses.replace(ONE, replay=found), names, "R")
    assert (trust.level, trust.text) == (level, text)
    assert trust.signer == names.get(ONE.keyid)


@pytest.mark.parametrize(
    ("has", "size", "text"),
    [
        (ImportUsage(1, 90), 10, None),
        (ImportUsage(2, 0), 10, "2 imports that are not finished"),
        (ImportUsage(0, 91), 10, "would take 101 bytes, and may take 100"),
    ],
)
def test_an_account_may_have_only_so_much(
    has: ImportUsage, size: int, text: str | None
) -> None:
    refused = refuse_import(has, ImportUsage(2, 100), size)
    if text is None:
        assert refused is None
    else:
        assert refused is not None
        assert text in refused.detail
        assert (refused.code, refused.requirement) == ("quota_exceeded", "REC-122")


def test_accounts_are_replayed_in_turn() -> None:
    """Of those whose turn was the longest ago, the oldest."""
    a, b, c = (dataclasses.replace(ONE, account=name) for name in "abc")
    assert next_to_replay([], {}) is None
    assert next_to_replay([a, b, c], {}) is a
    assert next_to_replay([a, b, c], {"a": 1}) is b
    assert next_to_replay([a, b], {"a": 3, "b": 2}) is b
