"""Writes spec/vectors/record/: good records, and broken ones with what is wrong.

`python -m tools vectors` writes them, and the manifests, again; a test compares every
byte.
"""

import json
from pathlib import Path
from typing import Any

from tests.support.record.broken_records import (
    Broken,
    broken_records,
    good_archive_with_verdict,
)
from tests.support.record.sample_records import HOST_KEY, OTHER_KEY, make_archive
from tools import manifest_vectors

KEYS = {HOST_KEY.keyid: "example host", OTHER_KEY.keyid: "another lab"}
FOLDER = Path(__file__).resolve().parents[1] / "spec" / "vectors" / "record"


def files() -> dict[str, bytes]:
    """Name → content of every file of the folder."""
    broken = broken_records()
    listed = {
        "description": "Records; `file` and `rule` are what a verifier names, null in "
        "good ones. `keys`: keyid → whose key it is, as the caller of the verifier "
        "names them. `with_other_keys`: the same for callers who name other keys.",
        "keys": KEYS,
        "records": [
            {
                "record": "good.proctor",
                "file": None,
                "rule": None,
                "levels": ["signed by example host"],
                "description": "Nothing is wrong.",
            },
            {
                "record": "good_replayed.proctor",
                "file": None,
                "rule": None,
                "levels": [
                    "signed by example host",
                    "replayed by another lab (exact, 4 of 4 episodes)",
                ],
                "description": "Nothing is wrong, and another lab replayed it.",
            },
            *(
                {
                    "record": f"{name}.proctor",
                    "file": one.file,
                    "rule": one.rule,
                    "levels": [],
                    "description": one.description,
                }
                for name, one in broken.items()
            ),
        ],
        "with_other_keys": other_callers(broken["score_raised"]),
    }
    members = ((name, _lines(value)) for name, value in listed.items())
    text = ",\n".join(f'  "{name}": {lines}' for name, lines in members)
    return {
        "records.json": f"{{\n{text}\n}}\n".encode(),
        "good.proctor": make_archive(),
        "good_replayed.proctor": good_archive_with_verdict(),
        **{f"{name}.proctor": one.archive for name, one in broken.items()},
    }


def other_callers(raised: Broken) -> list[dict[str, Any]]:
    """The answers of a verifier to callers who name other keys than `KEYS`."""
    host, lab = ({keyid: name} for keyid, name in KEYS.items())
    signed = ["signed by example host"]
    none = {"file": None, "rule": None}
    wrong = {"file": "statement.dsse.json", "rule": "REC-031", "levels": []}
    score = {"file": raised.file, "rule": raised.rule, "levels": []}
    cases: tuple[tuple[str, dict[str, str], dict[str, Any], str], ...] = (
        ("good", {}, none | {"levels": ["reported"]}, "No key is named."),
        ("good", lab, wrong, "The key of another host is named."),
        ("good_replayed", host, none | {"levels": signed}, "The replayer is unknown."),
        ("good_replayed", lab, wrong, "The replayer is named and the host is not."),
        ("good_replayed", {}, none | {"levels": ["reported"]}, "No key is named."),
        ("score_raised", lab, score, "What is wrong in the file is named first."),
    )
    return [
        {"record": f"{name}.proctor", "keys": keys, **answer, "description": why}
        for name, keys, answer, why in cases
    ]


def _lines(value: object) -> str:
    """JSON of which each item of a list has a line, as in the other vectors."""
    if not isinstance(value, list):
        return json.dumps(value, ensure_ascii=False)
    items = (f"\n    {json.dumps(item, ensure_ascii=False)}" for item in value)
    return f"[{','.join(items)}\n  ]"


def main() -> int:
    FOLDER.mkdir(parents=True, exist_ok=True)
    wanted = files()
    for path in FOLDER.iterdir():
        if path.name not in wanted:
            path.unlink()
    for name, data in wanted.items():
        (FOLDER / name).write_bytes(data)
    return manifest_vectors.main()
