"""The secret seeds of sealed splits, as the host of a benchmark draws them.

A benchmark declares `sealed_splits`, with seeds that are public. A host plays other
ones in these splits: they follow from its secret, are the same in every run and after a
restart, and cannot be computed from anything that is shown. The hashed manifest
contains a commitment to them and not the seeds.
"""

from __future__ import annotations

import hashlib
import hmac
import json
from collections.abc import Mapping
from functools import cache
from typing import Any, TypeAlias

from reference_record.history.drawn_seeds import drawn_secret

Json: TypeAlias = Mapping[str, Any]
SECRET_BYTES = 32


def parse_secret(text: str) -> bytes:
    """The secret that a host keeps in a file. Raises ValueError."""
    secret = bytes.fromhex(text)
    if len(secret) < SECRET_BYTES:
        raise ValueError(f"a secret has {SECRET_BYTES} bytes in hexadecimal digits")
    return secret


def seal(manifest: Json, secret: bytes, block: int, seed_max: int) -> Json:
    """SEAL-003, SEAL-004: the manifest with secret seeds in its sealed splits.

    block: seeds stay together in blocks of so many, each at its place; 1 if they are
    independent. seed_max: the largest seed of the simulator. Equal seeds of a split
    stay equal, so that tasks stay paired.
    """
    sealed_splits = manifest.get("sealed_splits")
    if not sealed_splits:
        return manifest
    benchmark_id = manifest["benchmark_id"]
    blocks = (seed_max + 1) // block

    @cache  # tasks are paired: most blocks are of several episodes
    def draw_block(split: str, number: int) -> int:
        drawn = _derive(secret, "seed", benchmark_id, split, number)
        return int.from_bytes(drawn) % blocks * block

    def draw(split: str, seed: int) -> int:
        number, place = divmod(seed, block)
        return draw_block(split, number) + place

    episodes: list[Json] = []
    seeds: list[int] = []
    for episode in manifest["episodes"]:
        if episode["split"] in sealed_splits:
            seeds.append(draw(episode["split"], episode["seed"]))
            episodes.append({**episode, "seed": seeds[-1]})
        else:
            episodes.append(episode)
    salt = salt_of(secret, benchmark_id)
    commitment = hashlib.sha256(salt + json.dumps(seeds).encode()).hexdigest()
    return {**manifest, "episodes": episodes, "seeds_sha256": commitment}


def seal_for_run(
    manifest: Json, secret: bytes, block: int, seed_max: int, drawn: Json | None
) -> Json:
    """As `seal`; all splits of a run whose seeds were drawn for it are sealed.

    secret: of the host. drawn: `seeds_drawn` of the run; None if it has none.
    """
    return seal(
        as_drawn(manifest, drawn), secret_of_run(secret, drawn), block, seed_max
    )


def as_drawn(manifest: Json, drawn: Json | None) -> Json:
    """The manifest with the members that a draw of its seeds adds (HST-032)."""
    if drawn is None:
        return manifest
    return {**manifest, "sealed_splits": manifest["splits"], "seeds_drawn": drawn}


def secret_of_run(secret: bytes, drawn: Json | None) -> bytes:
    """The secret that the sealed seeds of a run follow from. secret: of the host."""
    if drawn is None:
        return secret
    return drawn_secret(draw_key(secret, drawn["draw_id"]), drawn["root_sha256"])


def draw_key(secret: bytes, draw_id: str) -> bytes:
    """The key of a draw, which the host seals before it and opens after it."""
    return _derive(secret, "draw", draw_id)


def salt_of(secret: bytes, benchmark_id: str) -> bytes:
    """The salt of the commitment to a benchmark's seeds; a host opens both together."""
    return _derive(secret, "salt", benchmark_id)


def _derive(secret: bytes, *purpose: str | int) -> bytes:
    """Bytes that only the secret gives for this purpose."""
    return hmac.digest(secret, json.dumps(purpose).encode(), "sha256")
