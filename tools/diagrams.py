"""The pictures of docs/contribute/architecture.md, as Mermaid text that GitHub draws.

`make docs` writes them between their marks: the lifecycle from `x-lifecycle` of
spec/openapi.yaml, and which folder of the server imports which, from its source. A test
fails when the page is out of date. The other text is written by hand.
"""

from __future__ import annotations

import ast
from collections import defaultdict
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import yaml

ROOT = Path(__file__).resolve().parents[1]
PAGE = ROOT / "docs" / "contribute" / "architecture.md"
SPEC = ROOT / "spec" / "openapi.yaml"
SERVER = ROOT / "reference_server"
SIMULATORS = "reference_sim"
# Events that a request brings are drawn as such, the others happen by themselves.
EVENT_LABELS = {
    "stop_abort": "stop_run abort",
    "stop_drain": "stop_run drain",
    "last_lease_ends": "last session ends",
    "all_scored": "last episode scored",
}


def lifecycle_diagram(lifecycle: Mapping[str, Any]) -> str:
    """The states of a run and what moves it; refusals and self-loops are left out."""
    events: dict[tuple[str, str], list[str]] = defaultdict(list)
    for row in lifecycle["transitions"]:
        if row["to"] not in ("refused", row["from"]):
            label = EVENT_LABELS.get(row["event"], row["event"])
            when = f" ({row['when'].replace('_', ' ')})" if row.get("when") else ""
            events[row["from"], row["to"]].append(label + when)
    lines = ["stateDiagram-v2", f"    [*] --> {lifecycle['initial']}"]
    for (source, target), labels in events.items():
        lines.append(f"    {source} --> {target}: {', '.join(labels)}")
    sources = {row["from"] for row in lifecycle["transitions"] if _moves(row)}
    lines += [
        f"    {state} --> [*]" for state in lifecycle["states"] if state not in sources
    ]
    return "\n".join(lines)


def _moves(row: Mapping[str, Any]) -> bool:
    return row["to"] not in ("refused", row["from"])


def lifecycle_table(lifecycle: Mapping[str, Any]) -> str:
    """Every cell: where each event leads from each state; – where it is refused."""
    events = [*lifecycle["commands"], *lifecycle["events"]]
    cells: dict[tuple[str, str], list[str]] = defaultdict(list)
    for row in lifecycle["transitions"]:
        to = "–" if row["to"] == "refused" else f"`{row['to']}`"
        when = f" if {row['when'].replace('_', ' ')}" if row.get("when") else ""
        cells[row["from"], row["event"]].append(f"{to}{when}")
    lines = [
        "| state | " + " | ".join(f"`{event}`" for event in events) + " |",
        "|---" * (len(events) + 1) + "|",
    ]
    for state in lifecycle["states"]:
        row = ["<br>".join(cells[state, event]) for event in events]
        lines.append(f"| `{state}` | " + " | ".join(row) + " |")
    return "\n".join(lines)


def imports_of(source: str) -> set[str]:
    """The modules that a file imports when it runs; not those for types alone."""
    found: set[str] = set()
    for node in _statements(ast.parse(source)):
        if isinstance(node, ast.Import):
            found |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom) and node.module:
            found |= {f"{node.module}.{alias.name}" for alias in node.names}
    return found


def _statements(node: ast.AST) -> Iterator[ast.AST]:
    for child in ast.iter_child_nodes(node):
        if isinstance(child, ast.If) and "TYPE_CHECKING" in ast.unparse(child.test):
            continue
        yield child
        yield from _statements(child)


LEFT_OUT = ("assembly", "generated")


def part_of(module: str) -> str | None:
    """The folder of the server that a module is in; the simulators are one part.

    None for generated modules, which nearly everything imports, and for `assembly/`,
    which imports nearly everything.
    """
    names = module.split(".")
    if names[0] == SIMULATORS:
        return SIMULATORS
    if names[0] != SERVER.name or len(names) < 2 or names[1] in LEFT_OUT:
        return None
    return names[1] if (SERVER / names[1]).is_dir() else None


def imports_diagram() -> str:
    """Which folder of the reference server imports which."""
    arrows: set[tuple[str, str]] = set()
    for path in sorted(SERVER.rglob("*.py")):
        module = path.relative_to(ROOT).with_suffix("").as_posix().replace("/", ".")
        source = part_of(module)
        targets = {part_of(name) for name in imports_of(path.read_text())}
        if source is not None:
            arrows |= {(source, t) for t in targets if t is not None and t != source}
    lines = ["flowchart TD", *(f"    {a} --> {b}" for a, b in sorted(arrows))]
    return "\n".join(lines)


def page(text: str) -> str:
    """The page with its generated parts written anew."""
    lifecycle = yaml.safe_load(SPEC.read_text())["x-lifecycle"]
    parts = {
        "lifecycle": _fenced(lifecycle_diagram(lifecycle)),
        "lifecycle-table": lifecycle_table(lifecycle),
        "imports": _fenced(imports_diagram()),
    }
    for name, part in parts.items():
        opening, closing = f"<!-- {name} -->\n", f"<!-- /{name} -->"
        before, found, rest = text.partition(opening)
        if not found or closing not in rest:
            raise ValueError(f"{PAGE.name} has no marks for {name}")
        text = f"{before}{opening}\n{part}\n\n{closing}{rest.partition(closing)[2]}"
    return text


def _fenced(diagram: str) -> str:
    return f"```mermaid\n{diagram}\n```"


def main() -> int:
    """Write the page."""
    PAGE.write_text(page(PAGE.read_text()))
    return 0
