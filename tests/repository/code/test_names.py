"""Words and names: the field's terms, one name for one subject, folders that fit.

Every word of every hand-written text file is compared with BANNED: identifiers, file
names, comments, help, error texts, pages and rules alike. `python -m
tests.repository.code.test_names` prints all findings. Generated files follow
from the input of their generators, so they are left out.
"""

import ast
import fnmatch
import functools
import re
import sys
from collections import defaultdict
from collections.abc import Iterable, Iterator
from pathlib import PurePosixPath

import yaml

from tests.support.paths import ROOT
from tests.support.processes import run_program
from tests.support.repository.imports import PACKAGES, entries_of_git, nodes_of
from tools.generate import CONFIGS

GENERATED = (
    "generated_clients/*",
    "conformance/client/connections/transport/*",  # copied from the clients
    "reference_*/generated/*",
    "reference_record/pages/static/vendor/*",  # of third parties
    "requirements/*.txt",
)
# Written by hand although it lies in a folder of generated files.
HAND_WRITTEN = (
    "generated_clients/*/example/*",
    "generated_clients/*/interop/*",
    *(
        f"generated_clients/{config.stem}/{pattern}"
        for config in CONFIGS
        for pattern in yaml.safe_load(config.read_text())["by_hand"]
    ),
)
HERE = "tests/repository/code/test_names.py"

# Words of a private dialect -> what to write instead.
BANNED = {
    "blame blamed blames": "cause, origin of the error",
    "book books": "registry, table",
    "canvas canvases": "frame buffer",
    "crew crews": "workers",
    "desk desks": "client, validator",
    "door doors": "profile, endpoint",
    "farewell": "last message",
    "heart hearts": "heartbeat thread",
    "house houses": "server",
    "misfit misfits": "mismatch",
    "news": "change, update",
    "nobody somebody anybody everybody": "no client, another account, every caller",
    "nursery": "fork server",
    "patience patient patiently impatient": "timeout, retry policy",
    "puppet puppets": "skills",
    "scene scenes": "resources, given state; a MuJoCo scene is one",
    "seat seats seated": "worker slot",
    "shelf shelves": "store",
    "stage stages": "executor; a goal of a task has stages",
    "stranger strangers": "unknown caller, third-party package",
    "tale tales": "history",
    "tell tells telling teller": "send, report, say, return, distinguish",
    "told untold": "sent, reported, known",
    "whoever whomever": "the client that, every caller that",
}
# Where such a word is a term of the field, and why; an entry that is not needed fails.
MAY_SAY = {
    ("reference_sim/*", "scene scenes"): "MuJoCo calls a model of bodies a scene",
    ("examples/simulators/mujoco_world.cpp", "scene"): "the same",
    ("tests/sim/*", "scene scenes"): "the same",
    ("tests/support/sim/*", "scene scenes"): "the same",
    ("tests/support/libero/*", "scene scenes"): "the same",
    ("tests/server/push/test_chat_calls.py", "scene scenes"): "the same",
    ("docs/*/*task*.md", "scene scenes"): "the same",
    ("tools/experts.py", "scene"): "the same",
    ("reference_sim/*", "stage stages"): "a goal of a task has stages",
    ("tests/sim/*", "stage stages"): "the same",
    ("tests/support/sim/breakable_simulator.py", "stage stages"): "the same",
    ("spec/simulator.md", "stages"): "the same",
    ("reference_record/*", "stage stages"): "recordings name them, pages show them",
    ("tests/record/*", "stage stages"): "the same",
    ("docs/evaluate/pages.md", "stages"): "the same",
    ("docs/host/*", "stage stages"): "the same",
    ("spec/profiles/record.md", "stages"): "the same",
    ("spec/CHANGELOG.md", "stages"): "the same",
    ("docs/*/*task*.md", "stage stages"): "the same",
    ("tools/experts.py", "stage stages"): "the same",
    ("reference_sim/benchmarks/metaworld/*", "door shelf"): "names of its tasks",
    ("tests/sim/benchmarks/metaworld_checks.py", "door"): "an environment's name",
    ("reference_sim/benchmarks/mobile_bimanual/*", "shelf shelves"): "in its scene",
    ("conformance/*", "stage stages"): "a server is written in stages: --stage",
    ("docs/implement/*", "stage stages"): "the same",
    ("spec/CONFORMANCE.md", "stage"): "the same",
    ("tools/site/*", "stage stages"): "the same",
    ("tests/kit/*", "stage stages"): "the same",
    ("tests/support/kit/server_of_profiles.py", "stage stages"): "the same",
    (HERE, " ".join(BANNED)): "the list itself",
}
WORD = re.compile(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+")

# File names that several folders have -> why their subjects are one.
SAME_FILE_NAME = {
    "__init__.py __main__.py conftest.py": "Python's own names",
    "arguments.py main.py": "of each command",
    "benchmark.py experts.py layout.py plans.py": "the same part of each benchmark",
    "scene.py simulator.py skills.py tasks.py world.py": "the same part of each",
    "ebench.py events.py flageval.py hosting.py lifecycle.py": "an area of the "
    "rules: its checks, its decisions, the mutants that break it",
    "env.py": "the name that LeRobot's EnvHub and Alembic look for",
    "fork_server.py": "each starts processes by fork",
    "test_calibration.py test_events.py test_lifecycle.py test_scoring.py": "the kit's "
    "check of a subject and our own test of it",
}
# Class names that several modules define -> why. A package that may not import another
# has its own class for a noun of the protocol.
SAME_CLASS = {
    "Answer Episode Observation Operation PolicySession Result Session": "nouns "
    "of the protocol, on each side of the wire and in recordings",
    "Simulator": "of a simulator process, and in the file that programs copy",
    "Settings": "of the kit and of the server",
    "Task": "a task of the protocol: of a file, and of MuJoCo",
    # Different subjects; to be renamed.
    "Connection": "the client's, and a contender's",
    "Contender": "of two kinds of measurements",
    "Expert": "scripted policies of two tools and a benchmark",
    "Handler": "of two HTTP servers",
    "ServerProcess": "of the kit, and of the benchmarks",
}
SIBLINGS_MAX = 12
# Folders that have more, and why.
MORE_SIBLINGS = {
    ".": "each is described in README.md",
    "conformance": "a folder for each part, and for each kind of program it judges",
    "conformance/checks/profiles": "a file of checks for each profile",
    "docs/evaluate": "a page for each question of those who evaluate",
    "docs/host": "a page for each question of a host",
    "reference_sim": "what a simulator is, its process, and what is made of records",
    "reference_server": "a folder for each part, and what puts them together",
    "reference_server/http/pages": "a file for each kind of page, and what all share",
    "reference_server/settings": "a file for each subject, and the options of all",
    "reference_sim/benchmarks/mobile_bimanual": "the parts of one benchmark",
    "reference_record/pages/templates": "a template for each page",
    "requirements": "a file for each environment and each extra",
    "spec": "a document for each subject; spec/README.md names them",
    "spec/profiles": "a document for each profile",
    "spec/vectors/record": "a file for each way in which a record can be broken",
    "tests/cluster": "a file for each part of a cluster",
    "tests": "a folder for each package, and what judges the kit",
    "tests/kit": "a folder for each package of the kit, and runs of it as a whole",
    "tests/mutants/profiles": "a file of mutants for each profile",
    "tests/server": "a folder for each part of the server, and tests of the whole",
    "tests/support": "a folder for each package, and what starts servers",
    "tools": "a file for each command, and folders of commands of several files",
}


@functools.cache
def hand_written() -> list[str]:
    """Names of the files that git has and a person wrote."""
    command = ["git", "ls-files", "--cached", "--others", "--exclude-standard"]
    listed = run_program(command, cwd=ROOT, check=True).stdout.splitlines()
    return sorted(
        name
        for name in set(listed)
        if name.partition("/")[0] in entries_of_git()
        and (matches(name, HAND_WRITTEN) or not matches(name, GENERATED))
        and (ROOT / name).is_file()
    )


def matches(name: str, patterns: Iterable[str]) -> bool:
    return any(fnmatch.fnmatchcase(name, pattern) for pattern in patterns)


# --- words ---


def split_words(text: str) -> Iterator[str]:
    """`RunBook.house_of` -> run book house of."""
    return (word.lower() for word in WORD.findall(text))


@functools.cache
def findings() -> list[tuple[str, int, str]]:
    """File, line (0: its name) and word of each banned word."""
    banned = {word for words in BANNED for word in words.split()}
    found = []
    for name in hand_written():
        try:
            text = (ROOT / name).read_text("utf-8")
        except UnicodeDecodeError:  # a picture
            text = ""
        # Few files have such a word; only their lines are looked at one by one.
        if banned.isdisjoint(split_words(f"{name}\n{text}")):
            continue
        for number, line in enumerate([name, *text.splitlines()]):
            words = split_words(line)
            found += [(name, number, word) for word in words if word in banned]
    return found


def entry_for(name: str, word: str) -> tuple[str, str] | None:
    return next(
        (
            entry
            for entry in MAY_SAY
            if matches(name, entry[:1]) and word in entry[1].split()
        ),
        None,
    )


def replacement(word: str) -> str:
    return next(new for words, new in BANNED.items() if word in words.split())


def test_texts_use_the_terms_of_the_field() -> None:
    found = [
        f"{name}:{line}: {word} (say: {replacement(word)})"
        for name, line, word in findings()
        if entry_for(name, word) is None
    ]
    assert found == [], f"{len(found)} banned words\n" + "\n".join(found)


def test_each_exception_is_used() -> None:
    used = {entry_for(name, word) for name, _, word in findings()}
    assert set(MAY_SAY) - used == set()


# --- names of files and classes ---


def python_files(*folders: str) -> list[str]:
    """Our modules. A client of another language has its language's names."""
    return [
        name
        for name in hand_written()
        if name.endswith(".py")
        and not name.startswith("generated_clients/")
        and (not folders or name.split("/")[0] in folders)
    ]


def shared(places: Iterable[tuple[str, str]]) -> dict[str, set[str]]:
    """The names that have several places."""
    found = defaultdict(set)
    for name, place in places:
        found[name].add(place)
    return {name: where for name, where in found.items() if len(where) > 1}


def declared(table: dict[str, str]) -> set[str]:
    return {name for names in table for name in names.split()}


def test_a_file_name_has_one_subject() -> None:
    found = shared((PurePosixPath(name).name, name) for name in python_files())
    allowed = declared(SAME_FILE_NAME)
    assert {name: found[name] for name in found.keys() - allowed} == {}
    assert allowed - found.keys() <= {"conftest.py"}, "declared, and not shared"


def test_a_class_name_has_one_home() -> None:
    """Classes that cannot be imported are left out: private ones, those of tests."""
    found = shared(
        (node.name, name)
        for name in python_files(*PACKAGES, "benchmarks", "tools")
        for node in nodes_of(ROOT / name)
        if isinstance(node, ast.ClassDef) and not node.name.startswith("_")
    )
    allowed = declared(SAME_CLASS)
    assert {name: found[name] for name in found.keys() - allowed} == {}
    assert allowed - found.keys() == set(), "declared, and not shared"


def test_a_folder_is_taken_in_at_a_glance() -> None:
    siblings = defaultdict(set)
    for name in hand_written():
        parts = name.split("/")
        for depth, part in enumerate(parts):
            folder = "/".join(parts[:depth]) or "."
            is_mark = part.startswith((".", "__")) or part == "py.typed"
            if not is_mark and "_clients/" not in folder:
                siblings[folder].add(part)
    crowded = {
        folder for folder, within in siblings.items() if len(within) > SIBLINGS_MAX
    }
    assert crowded == set(MORE_SIBLINGS)


# --- imports ---


def imported_modules(name: str, modules: set[str]) -> set[str]:
    """Those of `modules` that a module imports, wherever the statement stands."""
    module = module_name(name)
    within = (
        module.split(".") if name.endswith("/__init__.py") else module.split(".")[:-1]
    )
    found = set()
    for node in nodes_of(ROOT / name):
        if isinstance(node, ast.Import):
            found |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            base = within[: len(within) - node.level + 1] if node.level else []
            origin = ".".join([*base, *filter(None, [node.module])])
            names = {f"{origin}.{alias.name}" for alias in node.names}
            # `from package import module` needs the module; other names the origin.
            found |= names & modules
            if names - modules:
                found.add(origin)
    return (found & modules) - {module}


def module_name(name: str) -> str:
    return name.removesuffix(".py").removesuffix("/__init__").replace("/", ".")


def cycles(imports: dict[str, set[str]]) -> set[str]:
    """The modules that import one another, directly or not."""
    left = dict(imports)
    while free := [name for name in left if not left[name] & left.keys()]:
        for name in free:
            del left[name]
    while free := [n for n in left if not any(n in left[m] for m in left if m != n)]:
        for name in free:
            del left[name]
    return set(left)


def test_cycles_are_found() -> None:
    assert cycles({"a": {"b"}, "b": {"c"}, "c": set()}) == set()
    assert cycles({"a": {"b"}, "b": {"c"}, "c": {"b", "d"}, "d": set()}) == {"b", "c"}


def test_no_modules_import_each_other_in_a_cycle() -> None:
    """In no package of ours, and not from one to another."""
    names = python_files(*PACKAGES)
    modules = {module_name(name) for name in names}
    imports = {module_name(name): imported_modules(name, modules) for name in names}
    assert cycles(imports) == set()


if __name__ == "__main__":
    for name, line, word in findings():
        if entry_for(name, word) is None:
            sys.stdout.write(f"{name}:{line}: {word} (say: {replacement(word)})\n")
