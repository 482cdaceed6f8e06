"""Stores what the kit said of each implementation, for the page of implementations.

`python -m tools.site.implementations 'NAME=report/report.json' …` reads whole reports
of the kit and writes implementations.json: who was judged, by which specification, and
every verdict.
"""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Any

from tools.site.rule_pages import VERDICTS


def read_report(path: Path) -> dict[str, Any]:
    """What is kept of a report; ValueError if it is not one of a whole run."""
    report = json.loads(path.read_text())
    is_excused = any(row["is_known_failure"] for row in report["rows"])
    if report["only"] or report["quick"] or report["stage"] or is_excused:
        raise ValueError(f"{path}: of selected rules only")
    return {
        "server": f"{report['server']['name']} {report['server']['version']}",
        "profiles": report["server"]["profiles"],
        "specification": report["spec"]["version"],
        "date": report["started_at"][:10],
        "conclusion": report["conclusion"],
        "headline": report["headline"],
        "rules": {row["requirement_id"]: row["outcome"] for row in report["rows"]},
    }


def main() -> None:
    named = dict(argument.split("=", 1) for argument in sys.argv[1:])
    found = {name: read_report(Path(path)) for name, path in named.items()}
    VERDICTS.write_text(json.dumps(found, indent=1, ensure_ascii=False) + "\n")


if __name__ == "__main__":
    main()
