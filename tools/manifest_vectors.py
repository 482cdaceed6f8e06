"""Writes spec/vectors/manifests/: benchmarks, their canonical text and its digest.

`python -m tools vectors` writes them again; a test compares every byte.
"""

import json
from pathlib import Path
from typing import Any

from reference_record.contents.benchmark_manifest import manifest_of, manifest_sha256
from reference_record.formats.strict_json import canonical_json
from reference_sim import benchmark_registry

PATH = Path(__file__).resolve().parents[1] / "spec/vectors/manifests/manifests.json"
PLAIN = {
    "benchmark_id": "sample",
    "version": "1",
    "tasks": ["lift"],
    "splits": ["val", "test"],
    "max_steps": 300,
    "action_space": {"arm": {"size": 2, "unit": "rad", "out_of_range": "unbounded"}},
    "observation_space": {"state": {}, "images": {}, "tensors": {}},
    "episodes": [
        {"task": "lift", "split": "val", "seed": 7},
        {"task": "lift", "split": "test", "seed": 9007199254740991},
    ],
}
TEXTS = {
    "title": "Sample",
    "description": "Two episodes.",
    "unavailable_reason": None,
    "manifest_sha256": "0" * 64,
    "episodes_total": 2,
    "max_chunk": 64,
    "image_sizes": [{"width": 64, "height": 48}],
    "image_codecs": ["raw"],
    "sealed_splits": [],
    "action_space": {
        "arm": PLAIN["action_space"]["arm"] | {"description": "Two joints."}  # type: ignore[index]
    },
}
NAMED_LIKE_TEXTS = {
    name: {"size": 1, "out_of_range": "unbounded", "description": "A number."}
    | {"parts": {"description": {"size": 1, "description": "The number."}}}
    for name in ("description", "title")
}
NUMBERS = [
    *(1.0, -0.0, 10.0, 1e20, 1e21, 123456789012345680000.0, 0.1 + 0.2, 1 / 3, 4.5),
    *(1e-6, 1e-7, 0.000001234, 2e-3, 5e-324, 1.7976931348623157e308, -1.5e300),
    *(333333333.33333329, 9007199254740991.0, 1e23, 295147905179352830000.0),
]
NAMES = [
    *("\u20ac", "\r", "\ufb33", "1", "\U0001f602", "\x80", "\xf6"),
    *("Z", "a", "_", "aa", "\ue000"),
]
ESCAPES = (
    '\x00\b\t\n\x0b\f\r\x1f "/\\ \x7f\x80\u2028\u2029 <a&b> \u00e9 e\u0301 \U0001f602'
)


def _calibration(**options: Any) -> dict[str, Any]:
    return dict(benchmark_registry.resolve("calibration", options).manifest)


def _calibration_of_core() -> dict[str, Any]:
    """Calibration as a server without any profile of Service may offer it."""
    whole = _calibration()
    spaces = whole["observation_space"] | {"images": {}, "tensors": {}}
    tasks = ["score", "count", "delay"]
    return whole | {"tasks": tasks, "observation_space": spaces}


def cases() -> list[dict[str, Any]]:
    """All cases, each with the benchmark that a server describes."""
    described: dict[str, dict[str, Any]] = {
        "`calibration` without options.": _calibration(),
        "`calibration` with options.": _calibration(
            tasks=["score", "count", "echo", "delay", "fault"],
            max_steps=7,
            max_attempts=1,
            max_faults=2,
        ),
        "`calibration` of a Core server, without images and tensors.": (
            _calibration_of_core()
        ),
        "The smallest sample; its second seed is 2^53 - 1.": PLAIN,
        "The same with texts, choices of a server, no sealed split: the same digest.": (
            PLAIN | TEXTS
        ),
        "Actions and parts that are named like the texts that are left out.": (
            PLAIN | {"action_space": NAMED_LIKE_TEXTS}
        ),
        "A sealed split: its seed is the host's, and not in the manifest.": (
            PLAIN | {"sealed_splits": ["test"], "seeds_sha256": "a" * 64}
        ),
        "Numbers.": PLAIN | {"org_example_numbers": NUMBERS},
        "Names, sorted by UTF-16 code units: U+1F602 stands before U+E000.": (
            PLAIN | {"org_example_names": dict.fromkeys(NAMES, True)}
        ),
        "Characters that are escaped, and others; é as one character and as two.": (
            PLAIN | {"org_example_text": ESCAPES}
        ),
    }
    return [
        {
            "description": description,
            "benchmark": benchmark,
            "canonical": canonical_json(manifest_of(benchmark)).decode(),
            "manifest_sha256": manifest_sha256(benchmark),
        }
        for description, benchmark in described.items()
    ]


def text() -> str:
    """The file, a line for each case."""
    described = json.dumps(
        "`benchmark` is what a server describes, with its episodes; `canonical` the "
        "canonical text of its manifest (benchmarks.md), `manifest_sha256` the SHA-256 "
        "of that text in UTF-8."
    )
    lines = ",\n    ".join(json.dumps(case) for case in cases())
    return f'{{\n  "description": {described},\n  "cases": [\n    {lines}\n  ]\n}}\n'


def main() -> int:
    PATH.parent.mkdir(parents=True, exist_ok=True)
    PATH.write_text(text())
    return 0
