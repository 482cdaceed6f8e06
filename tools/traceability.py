"""Every rule of the specification, from its sentence to the code that decides it.

`make docs` writes build/traceability.md: one row for each rule, with the file that
states it in spec/, the functions of the server and the simulators that cite its id, the
check that judges it and the mutants that break it. `gaps()` lists what is missing in
either direction; a test fails while there is one.

`python -m tools traceability PRED-002` prints the places of one rule with their lines;
`--release-ids` adds the rules that are new to spec/ids.txt.

Python files are read as text and never imported, except the lifecycle table and the
mutants, which are data. The kit lists its checks itself, in a process of its own.
"""

import ast
import json
import re
import subprocess
import sys
from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache
from itertools import groupby
from pathlib import Path

from conformance.specification.document import load_spec
from conformance.specification.ledger import POLICY, SIMULATOR, Requirement, load_ledger
from conformance.specification.rule_documents import read_rules
from reference_server.rules.runs.lifecycle import TRANSITIONS
from tests.mutants import load as load_mutants
from tools.built_pages import write_page

ROOT = Path(__file__).resolve().parents[1]
IDS = ROOT / "spec" / "ids.txt"
TABLE = "reference_server/rules/runs/lifecycle.py"
DECIDING = tuple(
    f"reference_{name}" for name in ("platform", "record", "server", "sim")
)
CITING = (*DECIDING, "reference_client", "conformance", "tests", "tools", "docs")
GENERATED = "generated"
ID = re.compile(r"\b[A-Z]{2,6}-\d{3}\b")
RANGE = re.compile(rf"({ID.pattern})`?(?: to |–|-|\.\.| through |…)`?({ID.pattern})")
NOT_RULES = frozenset({"SHA-256"})
UNUSED_NUMBER = "-999"  # tests and texts may use it for a rule that does not exist
TEXT_LENGTH = 110

# Rules that no single line decides, and why. A rule that gets a line leaves this table:
# an entry that is cited is a gap as well.
NO_DECIDING_LINE: Mapping[str, str] = {
    "SVC-004": "decided by the HTTP library, which reads what a refusal left unread",
    "SVC-005": "decided by the HTTP library, which joins the chunks",
    "SVC-006": "decided by the HTTP library, which waits for all connections at once",
    "SVC-003": "holds of every answer; the schemas of all views together decide it",
    "ERR-012": "holds of every request; it says that no line may fail",
    "MODEL-001": "holds of all rules together",
    "MODEL-002": "holds of all rules together, at the same time",
    "MODEL-003": "holds of all rules of Core together",
    "RES-003": "follows from RES-001, RES-002 and seeds that fix an episode",
}
NO_DECIDING_LINE_BY_PROFILE: Mapping[str, str] = {
    POLICY: "obeyed by policy servers; the evaluation server does not decide it",
    SIMULATOR: "obeyed by simulators; the evaluation server does not decide it",
}
# Rules that the kit judges and that no mutant breaks, and why.
NO_MUTANT: Mapping[str, str] = {
    "LIFE-201": "without this cell nothing can be played, and every row fails",
    "LIFE-302": "without this cell no check can end a run, and every row fails",
}

LIST_CHECKS = """
import json
from conformance.runner.execution import list_checks
print(json.dumps(list_checks()))
"""


@dataclass(frozen=True, order=True)
class Place:
    """A function, class or constant of a file; `name` is empty in a file's header."""

    file: str
    name: str
    line: int = field(default=0, compare=False)

    def __str__(self) -> str:
        return f"{self.file}:{self.line} {self.name or '(header)'}"


@dataclass
class Trace:
    """One rule and the places that carry its id."""

    rule: Requirement
    spec_file: str
    spec_line: int
    deciding: list[Place] = field(default_factory=list)
    headers: list[Place] = field(default_factory=list)
    check: Place | None = None
    mutants: list[str] = field(default_factory=list)

    @property
    def no_mutant(self) -> str | None:
        """Why no mutant breaks it, if that is known."""
        if self.rule.profile in NO_DECIDING_LINE_BY_PROFILE:
            return "obeyed by other programs; mutants are of the evaluation server"
        return NO_MUTANT.get(self.rule.id)

    @property
    def no_line(self) -> str | None:
        """Why no line decides it, if none does and that is known."""
        if self.deciding:
            return None
        reason = NO_DECIDING_LINE.get(self.rule.id)
        return reason or NO_DECIDING_LINE_BY_PROFILE.get(self.rule.profile)


def python_files(*folders: str) -> Iterator[Path]:
    """Hand-written Python files of the folders, sorted."""
    for folder in folders:
        for path in sorted((ROOT / folder).rglob("*.py")):
            if GENERATED not in path.relative_to(ROOT).parts:
                yield path


def citations(source: str, file: str) -> dict[str, list[Place]]:
    """The ids that a Python file cites: id → the places that cite it."""
    names = _names_by_line(source)
    found: dict[str, list[Place]] = defaultdict(list)
    for number, line in enumerate(source.splitlines(), 1):
        for id_ in ID.findall(line):
            place = Place(file, names.get(number, ""), number)
            if id_ not in NOT_RULES and place not in found[id_]:
                found[id_].append(place)
    return dict(found)


def _names_by_line(source: str) -> dict[int, str]:
    """Line → the innermost definition that it belongs to.

    A comment belongs to the statement below it. Lines of the module's docstring and of
    its imports belong to nothing.
    """
    lines, names = source.splitlines(), {}

    def walk(body: Iterable[ast.stmt], prefix: str) -> None:
        for node in body:
            name = prefix + _name_of(node)
            if not _name_of(node):
                continue
            decorators = getattr(node, "decorator_list", [])
            first = min(one.lineno for one in [node, *decorators])
            while first > 1 and lines[first - 2].lstrip().startswith("#"):
                first -= 1
            for number in range(first, (node.end_lineno or node.lineno) + 1):
                names[number] = name
            if isinstance(node, ast.ClassDef):
                walk(node.body, f"{name}.")

    walk(ast.parse(source).body, "")
    return names


def _name_of(node: ast.stmt) -> str:
    """The name of the function, class or variable that a statement defines."""
    match node:
        case ast.FunctionDef() | ast.AsyncFunctionDef() | ast.ClassDef():
            return node.name
        case ast.Assign(targets=[ast.Name(id=name), *_]):
            return name
        case ast.AnnAssign(target=ast.Name(id=name)):
            return name
        case _:
            return ""


@cache
def stated() -> dict[str, tuple[str, int]]:
    """Id → the file of spec/ and the line that states the rule."""
    rules = read_rules(ROOT / "spec")
    return {rule.id: (f"spec/{rule.document}", rule.line) for rule in rules}


@cache
def listed_checks() -> dict[str, tuple[str, str]]:
    """Id → name and docstring of the check that judges it, as the kit lists them."""
    listed = subprocess.check_output([sys.executable, "-c", LIST_CHECKS], cwd=ROOT)
    return {id_: (name, text) for id_, name, text in json.loads(listed)}


@cache
def checks() -> dict[str, Place]:
    """Id → where the check that judges it stands."""
    places = {
        node.name: Place(path.relative_to(ROOT).as_posix(), node.name, node.lineno)
        for path in python_files("conformance/checks")
        for node in ast.parse(path.read_text()).body
        if isinstance(node, ast.FunctionDef)
    }
    names = {id_: name.partition("[")[0] for id_, (name, _) in listed_checks().items()}
    return {id_: places[name] for id_, name in names.items()}


@cache
def _table() -> Place:
    for number, line in enumerate((ROOT / TABLE).read_text().splitlines(), 1):
        if line.startswith("TRANSITIONS"):
            return Place(TABLE, "TRANSITIONS", number)
    raise LookupError(f"{TABLE} has no TRANSITIONS")


@cache
def traces() -> dict[str, Trace]:
    """Every rule with all its places, in the order of the ledger."""
    found = {
        id_: Trace(rule, *stated().get(id_, ("", 0)), check=checks().get(id_))
        for id_, rule in load_ledger().items()
    }
    for path in python_files(*DECIDING):
        file = path.relative_to(ROOT).as_posix()
        for id_, places in citations(path.read_text(), file).items():
            if id_ in found:
                found[id_].deciding += [place for place in places if place.name]
                found[id_].headers += [place for place in places if not place.name]
    for row in load_spec().lifecycle["transitions"]:
        # The cell of the table is the decision: its key, or that there is none.
        if ((row["from"], row["event"]) in TRANSITIONS) == (row["to"] != "refused") or (
            row.get("when")
        ):
            found[row["id"]].deciding.insert(0, _table())
    for mutant in load_mutants().values():
        for id_ in mutant.kills:
            found[id_].mutants.append(mutant.name)
    return found


def gaps() -> list[str]:
    """One line for each gap between the specification and the code."""
    return [
        *(gap for trace in traces().values() for gap in _gaps_of(trace)),
        *_unknown_ids(),
        *_ranges(),
    ]


def _gaps_of(trace: Trace) -> Iterator[str]:
    rule = trace.rule
    if not trace.spec_line:
        yield f"{rule.id}: no line of spec/ states it"
    if not trace.deciding and trace.no_line is None:
        hint = f", only {trace.headers[0]}" if trace.headers else ""
        yield f"{rule.id}: nothing in {' or '.join(DECIDING)} cites it{hint}"
    if trace.deciding and rule.id in NO_DECIDING_LINE:
        yield f"{rule.id}: cited by {trace.deciding[0]}, and excused as not decided"
    if trace.check is None and rule.is_observable:
        yield f"{rule.id}: no check judges it"
    excused = trace.no_mutant is not None or not rule.is_observable
    if not trace.mutants and not excused:
        yield f"{rule.id}: no mutant breaks it"
    if trace.mutants and rule.id in NO_MUTANT:
        yield f"{rule.id}: broken by {trace.mutants[0]}, and excused as not broken"


def _texts() -> Iterator[tuple[str, str]]:
    """Name and text of all that may cite rules."""
    paths = [ROOT / "README.md", *python_files(*CITING)]
    paths += sorted((ROOT / "docs").rglob("*.md"))
    for path in paths:
        yield path.relative_to(ROOT).as_posix(), path.read_text()


def _unknown_ids() -> Iterator[str]:
    areas = {id_.partition("-")[0] for id_ in load_ledger()}
    for name, text in _texts():
        for id_ in sorted(set(ID.findall(text)) - set(load_ledger()) - NOT_RULES):
            if id_.partition("-")[0] in areas and not id_.endswith(UNUSED_NUMBER):
                yield f"{id_}: cited by {name}, and no rule"


def _ranges() -> Iterator[str]:
    for name, text in _texts():
        for match in RANGE.finditer(text):
            yield f"{match[1]}: {name} cites a range of ids; name each, for git grep"


# --- the page ---

HEADER = """\
# Traceability

Written by `make docs`. A test fails when a row has a gap.

Each rule is *stated* in `spec/`, *decided* in `reference_server/` or `reference_sim/`,
*judged* by one check of the kit, and *broken on purpose* by mutants. `git grep ID`
shows these places, and `python -m tools traceability ID` prints their lines. A cell of
the lifecycle is decided by its key in `TRANSITIONS`, or by that key's absence.
*Italics* say why a place is missing.
"""


def page() -> str:
    """The table as Markdown, one section for each area of rules."""
    parts = [HEADER]
    by_area = groupby(traces().values(), lambda trace: trace.rule.area)
    sections: dict[str, list[Trace]] = defaultdict(list)
    for area, group in by_area:
        sections[area] += group
    for area, rows in sections.items():
        parts.append(f"## {area}\n")
        parts.append("| id | rule | stated | decided | judged | broken by |")
        parts.append("|---|---|---|---|---|---|")
        parts += [_row(trace) for trace in rows]
        parts.append("")
    return "\n".join(parts).rstrip() + "\n"


def _row(trace: Trace) -> str:
    rule = trace.rule
    name = trace.spec_file.removeprefix("spec/")
    link = f"[{name}](../{trace.spec_file})"
    decided = [_linked(place) for place in trace.deciding] or [_why(trace.no_line)]
    judged = _linked(trace.check) if trace.check else _why(rule.why)
    broken = [f"`{name}`" for name in sorted(trace.mutants)]
    broken = broken or [_why(trace.no_mutant) if rule.is_observable else "–"]
    text = _shorten(rule.text).replace("|", "\\|")
    return (
        f"| {rule.id} | {text} | {link} | {'<br>'.join(decided)} | {judged} "
        f"| {' '.join(broken)} |"
    )


def _why(reason: str | None) -> str:
    return f"*{reason}*" if reason else "**missing**"


def _linked(place: Place) -> str:
    short = place.file.removeprefix("reference_").removeprefix("conformance/checks/")
    return f"[{short}](../{place.file}) `{place.name}`"


def _shorten(text: str) -> str:
    """The beginning of a sentence, cut between two words and outside of a code span."""
    if len(text) <= TEXT_LENGTH:
        return text
    cut = text[:TEXT_LENGTH].rpartition(" ")[0]
    if cut.count("`") % 2:
        cut = cut.rpartition("`")[0].rstrip()
    return f"{cut} …"


def describe(trace: Trace) -> str:
    """The places of one rule, with their lines."""
    rule = trace.rule
    return "\n".join(
        [
            f"{rule.id} ({rule.level}, {rule.profile}): {rule.text}",
            f"stated   {trace.spec_file}:{trace.spec_line}",
            *(f"decided  {place}" for place in trace.deciding),
            *([f"decided  {trace.no_line}"] if trace.no_line else []),
            f"judged   {trace.check or rule.why}",
            *(f"broken   by {name}" for name in sorted(trace.mutants)),
        ]
    )


def release_ids() -> None:
    """Add each rule that spec/ids.txt does not list yet: a release fixes what it is."""
    header, *lines = IDS.read_text(encoding="utf-8").splitlines()
    listed = {line.split()[0] for line in lines}
    new = [
        f"{rule.id} {rule.level} {rule.profile}"
        for rule in load_ledger().values()
        if rule.id not in listed
    ]
    text = "\n".join([header, *sorted([*lines, *new])]) + "\n"
    IDS.write_text(text, encoding="utf-8")


def main(*, ids: Sequence[str], is_release: bool) -> int:
    """Write the page, or print the places of rules."""
    if unknown := set(ids) - set(traces()):
        print(f"no rule has the id {', '.join(sorted(unknown))}", file=sys.stderr)
        return 2
    if ids:
        print("\n\n".join(describe(traces()[id_]) for id_ in ids))
        return 0
    if is_release:
        release_ids()
        return 0
    write_page("traceability.md", page())
    return 0
