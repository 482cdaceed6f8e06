"""Writes a result to a folder: result.json and episodes.csv."""

from __future__ import annotations

import csv
import json
import tempfile
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from pydantic_core import to_jsonable_python

from reference_client.printable_text import printable
from reference_record.command_line.replaced_file import replace_file, replacing
from reference_record.command_line.written_output import writing
from reference_record.pages.spreadsheet_cells import as_cell

# Columns of episodes.csv: members of an episode, then those of its result.
EPISODE_COLUMNS = ("episode_id", "index", "task", "split", "status", "attempt")
RESULT_COLUMNS = (
    *("outcome", "score", "steps", "terminated", "truncated", "faults", "seed"),
    *("think_s", "finished_at", "clipped_actions", "total_reward"),
)
PLAYER_COLUMNS = ("name", "version", "client")  # members of the result's player


def check_folder(folder: str | Path) -> None:
    """Make the folder, before an evaluation. Raises WrongUsage if that fails."""
    with writing(Path(folder), "--save"):
        Path(folder).mkdir(parents=True, exist_ok=True)
        tempfile.TemporaryFile(dir=folder).close()  # as in a folder that is read-only


def save_result(result: Mapping[str, Any], folder: str | Path) -> str:
    """Write both files, and return the sentence about them. Raises WrongUsage.

    Existing ones are replaced; the sentence names another run whose they were.

    result: `run`, `score` and `episodes`, as in the schemas of the specification, and
    whatever else result.json shall have.
    """
    check_folder(folder)
    replaced = _run_in(Path(folder, "result.json"))
    value = to_jsonable_python(result)
    run_id = value["score"]["run_id"]
    text = json.dumps(value, indent=2)
    with writing(Path(folder), "--save"):
        replace_file(Path(folder, "result.json"), text + "\n")
        with replacing(Path(folder, "episodes.csv")) as draft:
            _write_episodes(run_id, value["episodes"], draft)
    if replaced in (None, run_id):
        return f"Saved: {folder}"
    return f"Saved: {folder}, in place of the result of {replaced}"


def _run_in(path: Path) -> str | None:
    """The run of a saved result; None where there is none, or another file."""
    try:
        run_id = json.loads(path.read_bytes())["run"]["run_id"]
    except (OSError, ValueError, LookupError, TypeError):
        return None
    return printable(run_id) if isinstance(run_id, str) else None


def _write_episodes(
    run_id: str, episodes: Sequence[Mapping[str, Any]], path: Path
) -> None:
    with path.open("w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file)
        players = [f"player_{name}" for name in PLAYER_COLUMNS]
        writer.writerow(["run_id", *EPISODE_COLUMNS, *RESULT_COLUMNS, *players])
        for members in episodes:
            result = members.get("result") or {}
            player = result.get("player") or {}
            values = [run_id]
            values += [members.get(name, "") for name in EPISODE_COLUMNS]
            values += [result.get(name, "") for name in RESULT_COLUMNS]
            values += [player.get(name, "") for name in PLAYER_COLUMNS]
            writer.writerow([as_cell(value) for value in values])
