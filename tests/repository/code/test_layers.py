"""Architecture: which package may import which, what is defined once, sizes of parts.

Imports are read from the source text: nothing is imported to learn what it imports.
The lifecycle and the problems of the server are those of the specification.
"""

import ast
import re
import sys
import typing
from pathlib import Path

import pytest

from conformance.specification.ledger import load_ledger
from reference_record.generated import answers
from reference_server.generated import problem_codes
from reference_server.http.dispatch import PATH_PATTERNS
from reference_server.rules.runs import lifecycle, run
from reference_server.rules.runs.lifecycle import TRANSITIONS, Event, legal
from reference_server.rules.runs.run import State
from tests.support.paths import ROOT
from tests.support.repository.imports import (
    HAND_WRITTEN,
    PACKAGES,
    entries_of_git,
    files_of_package,
    importers_of,
    imports,
    module_of,
    name_of,
    nodes_of,
    tops,
)
from tests.support.repository.specification import DOCUMENT
from tests.support.server.runs import make_run

CODE_FORMAT_MODULES = {"cloudpickle", "dill", "joblib", "marshal", "pickle", "shelve"}
# Who may read one all the same, and why; an entry too many fails.
CODE_FORMAT_READERS = {
    "benchmarks/round_trips/contenders/ebench.py": "measured; both ends are ours",
    "conformance/profiles/pickles.py": "EBench; its reader lets nothing be named",
    "reference_sim/external/libero/libero_world.py": "its reader names arrays alone",
    "tests/sim/external/test_libero.py": "expects that reader's refusal",
    "tests/support/libero/fake_libero.py": "writes initial states as torch does",
    "tests/support/profiles/ebench_client.py": "sends EBench's pickles, and attacks",
}
VAGUE_NAMES = {"base", "common", "helper", "helpers", "manager", "utils"}
FUNCTION_LINES_MAX = 70


# --- layers ---

RULES = ROOT / "reference_server" / "rules"
PURE = sorted(RULES.rglob("*.py"))


# folder of reference_server → the other parts that it may import. A part is a folder or
# a module of reference_server, or the package reference_sim.
MAY_IMPORT: dict[str, set[str]] = {
    "cells": {"files", "generated", "process", "reference_record", "reference_sim"}
    | {"rules", "telemetry", "views"},
    "accounts": {"http", "outgoing", "reference_record", "rules", "settings"}
    | {"telemetry"},
    "assembly": {"accounts", "cells", "cluster", "files", "http", "monitoring"}
    | {"process"}
    | {"profiles", "push", "records", "reference_record", "reference_sim", "rules"}
    | {"runs", "settings", "storage"},
    "generated": set(),
    "rules": {"generated", "reference_record"},
    "settings": {"profiles", "reference_record", "reference_sim", "rules"},
    "storage": {"files", "process", "reference_record", "rules", "telemetry"},
    "records": {"files", "generated", "process", "reference_record", "reference_sim"}
    | {"failover", "rules", "storage", "telemetry"},
    "failover": {"reference_record", "reference_sim", "rules"},
    "files": {"reference_record"},
    "outgoing": {"process"},
    "process": {"reference_sim"},
    "telemetry": {"reference_record"},
    "views": {"generated", "reference_record", "reference_sim", "rules"},
    "runs": {"cells", "failover", "files", "generated", "process", "records"}
    | {"reference_record"}
    | {"reference_sim", "rules", "storage", "telemetry", "views"},
    "push": {"generated", "http", "outgoing", "process"}
    | {"reference_record", "rules"}
    | {"runs", "settings", "storage", "telemetry"},
    "cluster": {"http", "outgoing", "process", "reference_record", "rules", "runs"}
    | {"storage", "telemetry"},
    "http": {"files", "generated", "process", "records", "reference_record", "rules"}
    | {"runs", "settings", "storage", "telemetry", "views"},
    "monitoring": {"http", "process", "telemetry"},
    "profiles": {
        "cells",
        "generated",
        "http",
        "process",
        "push",
        "reference_record",
        "rules",
    }
    | {"reference_sim", "runs", "settings", "views"},
}
# Of these two, a folder above them may know only what is named here.
ONLY: dict[tuple[str, str], set[str]] = {
    ("cluster", "storage"): {"ListedNode", "Node", "NodeStore", "StoreFailed"}
    | {"Renewed", "StoredQueue"},
    ("http", "storage"): {"KeptFiles", "StoreFailed", "backup_command"}
    | {"database_area", "require_files"},
    ("http", "records"): {"RecordImports", "Recordings", "CannotDo", "AdminFiles"}
    | {"record_areas", "seeds_area"},
    ("push", "storage"): {"StoreFailed"},
    ("push", "http"): {"JSON", "PROBLEM_JSON"}
    | {"codec", "decode", "pointer", "validate", "words_of"}
    | {"bounded_parsing", "read_structure", "INLINE_BYTES_MAX", "WHOLE_BYTES_MAX"},
}


def test_every_folder_of_the_server_has_its_rule() -> None:
    server = ROOT / "reference_server"
    folders = {p.name for p in server.iterdir() if (p / "__init__.py").is_file()}
    assert folders == set(MAY_IMPORT)


def is_module(parts: list[str]) -> bool:
    path = ROOT.joinpath(*parts)
    return path.is_dir() or path.with_suffix(".py").is_file()


@pytest.mark.parametrize("folder", MAY_IMPORT)
def test_a_folder_imports_only_what_its_rule_allows(folder: str) -> None:
    found: set[str] = set()
    names: dict[tuple[str, str], set[str]] = {}
    for path in (ROOT / "reference_server" / folder).rglob("*.py"):
        for module in imports(path, module_of(path)):
            parts = module.split(".")
            if parts[0] == "reference_server" and len(parts) > 1:
                found.add(parts[1])
                if len(parts) > 3 and not is_module(parts):
                    names.setdefault((folder, parts[1]), set()).add(parts[-1])
            elif parts[0] in PACKAGES:
                found.add(parts[0])
    assert found - {folder} <= MAY_IMPORT[folder]
    for pair, allowed in ONLY.items():
        assert names.get(pair, set()) <= allowed


@pytest.mark.parametrize("path", PURE, ids=lambda path: path.stem)
def test_the_rules_import_only_each_other(path: Path) -> None:
    allowed = (
        "reference_server.rules",
        "reference_server.generated",
        "reference_record.generated",
        # A client decides by them before it asks, and so do pages; pure, too.
        "reference_record.comparison.difference_evidence",
        "reference_record.contents.contradicted_assumptions",
        "reference_record.formats.json_pointer",
    )
    others = {
        module
        for module in imports(path, module_of(path))
        if module.partition(".")[0] not in sys.stdlib_module_names
        and not module.startswith(allowed)
    }
    assert others == set()


@pytest.mark.parametrize("path", PURE, ids=lambda path: path.stem)
def test_the_rules_are_synchronous_and_use_no_clock(path: Path) -> None:
    waits = (ast.AsyncFunctionDef, ast.Await, ast.AsyncFor, ast.AsyncWith)
    assert [node for node in nodes_of(path) if isinstance(node, waits)] == []
    outside = {"asyncio", "datetime", "os", "random", "secrets", "socket", "time"}
    assert tops(path) & outside == set()


_SQL = """
board_store connection/database connection/postgresql connection/server_lock
connection/transactions database_commands folder_id import_store node_store record_store
runs/account_statements runs/run_statements runs/run_store tables/column_types
tables/database_clock
tables/database_tables tables/migrations/versions/r0001_baseline
tables/migrations/versions/r0002_nodes tables/migrations/versions/r0003_cluster_facts
tables/migrations/versions/r0004_failed_by
tables/migrations/versions/r0005_reasons
tables/migrations/versions/r0006_node_settings tables/schema_version
"""
SQL = _SQL.split()
EXPORTS = "reference_sim/exports"


@pytest.mark.parametrize(
    ("module", "owner", "files"),
    [
        ("sqlalchemy", "reference_server/storage", [f"{name}.py" for name in SQL]),
        ("mujoco", "reference_sim/mujoco", ["world.py"]),
        ("av", EXPORTS, ["video_file.py"]),
        ("pyarrow", EXPORTS, ["lerobot_format.py", "parquet_tables.py"]),
        ("ray", "reference_sim/process/ray", ["launcher.py", "simulator_actor.py"]),
    ],
)
def test_dependencies_have_one_owner(module: str, owner: str, files: list[str]) -> None:
    found = importers_of(module, among=files_of_package(*PACKAGES))
    assert found == [f"{owner}/{file}" for file in files]


@pytest.mark.parametrize(
    ("package", "forbidden_imports"),
    [
        ("reference_sim", ["reference_server", "reference_client", "conformance"]),
        ("reference_client", ["reference_sim.exports"]),
        ("reference_server", ["reference_sim.exports"]),
        ("reference_sim", ["proctor_client", "starlette", "uvicorn", "httpx"]),
        ("reference_record", ["reference_server", "reference_sim"]),
        ("reference_record", ["reference_client", "conformance"]),
        ("reference_record", ["proctor_client", "starlette", "httpx", "sqlalchemy"]),
        ("reference_client", ["reference_server", "reference_platform", "conformance"]),
        ("reference_server", ["reference_platform", "conformance"]),
        ("reference_server", ["reference_client", "proctor_client"]),
        ("conformance", ["reference_server", "reference_sim", "reference_platform"]),
        ("conformance", ["reference_client", "proctor_client"]),
    ],
)
def test_a_package_does_not_import(package: str, forbidden_imports: list[str]) -> None:
    assert importers_of(*forbidden_imports, among=files_of_package(package)) == []


def test_nothing_reads_a_format_that_carries_code() -> None:
    found = importers_of(*CODE_FORMAT_MODULES, among=iter(HAND_WRITTEN))
    assert found == sorted(CODE_FORMAT_READERS)


# --- the lifecycle ---

LIFECYCLE = DOCUMENT["x-lifecycle"]


def stated(state: str, event: str, retryable: bool | None) -> str | None:
    """Where the specification lets an event lead; None where it refuses."""
    # `legal` decides for runs with episodes left; EPI-009 is decided behind it.
    retry = "retryable" if retryable else "not_retryable"
    when = {None, "episodes_left", retry}
    rows = [
        row["to"]
        for row in LIFECYCLE["transitions"]
        if (row["from"], row["event"]) == (state, event) and row.get("when") in when
    ]
    assert len(rows) <= 1, f"{len(rows)} rows for {state}, {event}, {retryable}"
    return None if not rows or rows[0] == "refused" else rows[0]


@pytest.mark.parametrize("retryable", [True, False, None])
@pytest.mark.parametrize("event", [*LIFECYCLE["commands"], *LIFECYCLE["events"]])
@pytest.mark.parametrize("state", LIFECYCLE["states"])
def test_the_table_decides_as_stated(
    state: State, event: Event, retryable: bool | None
) -> None:
    expected = stated(state, event, retryable)
    assert legal(make_run(state=state, retryable=retryable), event) == bool(expected)
    if expected is not None:
        assert TRANSITIONS[(state, event)] == expected


def test_the_table_has_no_cell_of_its_own() -> None:
    rows = [row for row in LIFECYCLE["transitions"] if row["to"] != "refused"]
    assert set(TRANSITIONS) == {(row["from"], row["event"]) for row in rows}


def test_the_enums_match_the_specification() -> None:
    assert list(typing.get_args(State)) == LIFECYCLE["states"]
    assert set(typing.get_args(Event)) == {*LIFECYCLE["commands"], *LIFECYCLE["events"]}
    schemas = DOCUMENT["components"]["schemas"]
    assert schemas["RunState"]["enum"] == LIFECYCLE["states"]
    assert schemas["Outcome"]["enum"] == list(typing.get_args(answers.Outcome))
    ends = list(typing.get_args(run.SessionEnd))
    assert schemas["SessionEnd"]["x-extensible-enum"] == ends


def test_every_command_has_guards() -> None:
    assert set(lifecycle.GUARDS) == set(typing.get_args(lifecycle.Command))


# --- problems ---


def refusals_in(source: str) -> set[str]:
    """First arguments of Refused(...), Refuse(...): what this code can answer."""
    return {
        str(call.args[0].value)
        for call in ast.walk(ast.parse(source))
        if isinstance(call, ast.Call)
        and isinstance(call.func, ast.Name)
        and call.func.id in ("Refused", "Refuse")
        and call.args
        and isinstance(call.args[0], ast.Constant)
    }


def server_refusal_codes() -> set[str]:
    found = {code for _, code in PATH_PATTERNS.values()}
    for path in files_of_package("reference_server"):
        found |= refusals_in(path.read_text())
    return found


def test_the_problems_of_the_catalogue_are_those_in_use() -> None:
    assert server_refusal_codes() == set(DOCUMENT["x-problems"])


def test_the_generated_catalogue_is_the_specification() -> None:
    assert DOCUMENT["x-problems"] == problem_codes.PROBLEMS


def test_statuses_with_retry_after_are_retryable() -> None:
    for code, entry in DOCUMENT["x-problems"].items():
        if entry["status"] in (429, 503):
            assert entry["retryable"], code


def test_cited_requirements_exist() -> None:
    cited: set[str] = set()
    for path in files_of_package(
        "reference_platform", "reference_record", "reference_server", "reference_sim"
    ):
        cited |= set(re.findall(r"\b[A-Z]{2,6}-\d{3}\b", path.read_text()))
    assert len(cited) > 50
    assert cited - load_ledger().keys() == {"SHA-256"}


# --- names and sizes ---


def test_file_names_are_not_vague() -> None:
    names = {name_of(path): path.relative_to(ROOT).parts for path in HAND_WRITTEN}
    vague = [
        name
        for name, parts in names.items()
        if {part.removesuffix(".py").strip("_") for part in parts} & VAGUE_NAMES
    ]
    assert vague == []


def lines_of(path: Path) -> int:
    return len(path.read_text().splitlines())


def test_a_function_fits_the_screen() -> None:
    sizes = {
        f"{name_of(path)}:{node.name}": (node.end_lineno or 0) - node.lineno + 1
        for path in HAND_WRITTEN
        for node in nodes_of(path)
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef)
    }
    assert len(sizes) > 500
    assert {n: s for n, s in sizes.items() if s > FUNCTION_LINES_MAX} == {}


@pytest.mark.parametrize(("name", "most"), [("README.md", 150), ("Makefile", 110)])
def test_readme_and_makefile_are_short(name: str, most: int) -> None:
    assert 0 < lines_of(ROOT / name) <= most


def test_the_top_level_has_few_entries() -> None:
    # Platforms find these two at the root only.
    entries = entries_of_git() - {"action.yml", "CITATION.cff"}
    shown = sorted(entry for entry in entries if not entry.startswith("."))
    assert 0 < len(shown) <= 19, shown
