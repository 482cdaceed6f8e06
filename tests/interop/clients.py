"""How the interop program of each language is built and started.

Sources are copied to .cache/interop/ and built there, so that nothing a build leaves
can reach the repository. A language whose toolchain is missing is never built. It must
not know what a scenario is.
"""

from __future__ import annotations

import fcntl
import filecmp
import os
import shutil
import subprocess
import sys
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
CLIENTS = ROOT / "generated_clients"
CACHE = ROOT / ".cache" / "interop"
BUILD_OUTPUT = {"__pycache__", "build", "dist", "node_modules", "target"}
BUILD_S = 1800.0
CPP_HEADERS = ("curl/curl.h", "nlohmann/json.hpp")


class BuildFailed(Exception):
    """A program is not there to be run, for its build failed."""


@dataclass(frozen=True)
class Language:
    """One client and its interop program.

    tools: executables that must be on PATH. headers: what g++ must find.
    version: prints the toolchain's version.
    steps: commands that build, in the copied directory. command: starts the program.
    evaluates: the package of clients/ on top of the generated client, else that client.
    """

    name: str
    tools: tuple[str, ...]
    version: tuple[str, ...]
    command: Callable[[Path], list[str]]
    steps: tuple[tuple[str, ...], ...] = ()
    environment: dict[str, str] = field(default_factory=dict)
    evaluates: bool = False
    headers: tuple[str, ...] = ()

    @property
    def language(self) -> str:
        return self.name.removesuffix("-evaluate")

    @property
    def package(self) -> str:
        """The folder with the program, seen from the repository's root."""
        folder = "clients" if self.evaluates else "generated_clients"
        return f"{folder}/{self.language}"

    @property
    def directory(self) -> Path:
        return CACHE / self.name / "src" / self.package

    def missing(self) -> str:
        """Why this language cannot be built here; empty when it can."""
        absent = [tool for tool in self.tools if shutil.which(tool) is None]
        if not absent:
            absent = [name for name in self.headers if not has_header(name)]
        return f"{' and '.join(absent)} not found" if absent else ""

    def toolchain(self) -> str:
        output = subprocess.run(
            self.version, capture_output=True, text=True, check=True
        )
        return (output.stdout or output.stderr).splitlines()[0].strip()

    def build(self) -> None:
        """Bring the program up to date; BuildFailed holds what the compiler said."""
        (CACHE / self.name).mkdir(parents=True, exist_ok=True)
        with (CACHE / self.name / "lock").open("w") as lock:
            fcntl.flock(lock, fcntl.LOCK_EX)  # tests run in several processes
            self._build()

    def _build(self) -> None:
        sources = sorted({f"generated_clients/{self.language}", self.package})
        target = CACHE / self.name / "src"
        stamp, recipe = CACHE / self.name / "built", f"{self.toolchain()}\n{self.steps}"
        built = stamp.read_text() if stamp.exists() else ""
        stamp.unlink(missing_ok=True)
        changes = [mirror(ROOT / source, target / source) for source in sources]
        # Built again, it would be replaced while another process runs it.
        if any(changes) or built != recipe:
            self._run_steps()
        stamp.write_text(recipe)

    def _run_steps(self) -> None:
        for step in self.steps:
            done = subprocess.run(
                ("nice", *step),
                cwd=self.directory,
                env=self.env(),
                capture_output=True,
                text=True,
                timeout=BUILD_S,
                check=False,
            )
            if done.returncode != 0:
                output = (done.stdout + done.stderr).strip()[-3000:]
                raise BuildFailed(f"{' '.join(step)} failed:\n{output}")

    def env(self) -> dict[str, str]:
        base = CACHE / self.name
        return os.environ | {
            k: v.format(base=base) for k, v in self.environment.items()
        }


@cache
def has_header(name: str) -> bool:
    """Whether g++ finds this header."""
    command = ("g++", "-E", "-x", "c++", "-include", name, os.devnull)
    return subprocess.run(command, capture_output=True, check=False).returncode == 0


def mirror(source: Path, target: Path) -> bool:
    """Make `target` the same as `source`, but for what builds left in it.

    Returns whether anything was changed.
    """
    changed = False
    target.mkdir(parents=True, exist_ok=True)
    wanted = {path.relative_to(source) for path in source.rglob("*") if path.is_file()}
    wanted = {path for path in wanted if not BUILD_OUTPUT & set(path.parts)}
    for path in [path for path in target.rglob("*") if path.is_file()]:
        name = path.relative_to(target)
        if name not in wanted and not BUILD_OUTPUT & set(name.parts):
            path.unlink()
            changed = True
    for name in wanted:
        old, new = target / name, source / name
        if not old.exists() or not filecmp.cmp(old, new, shallow=False):
            old.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(new, old)
            changed = True
    return changed


REPOSITORY = "../../../m2"  # from the folder of a client
# A repository of its own for each build, held against checksums that are committed
# before anything in it is used, and after the build for what that downloaded.
CHECKSUMS = (
    *(sys.executable, str(ROOT / "tests" / "interop" / "maven_checksums.py")),
    *("check", REPOSITORY, ".mvn/checksums/checksums.sha256"),
)
MAVEN_STEPS = (
    CHECKSUMS,
    (
        *("mvn", "-q", "-B", f"-Dmaven.repo.local={REPOSITORY}"),
        *("package", "dependency:copy-dependencies"),
    ),
    CHECKSUMS,
)

LANGUAGES = (
    Language(
        "python",
        tools=(),
        version=(sys.executable, "--version"),
        command=lambda at: [sys.executable, str(at / "interop" / "interop.py")],
    ),
    Language(
        "typescript",
        tools=("node", "npm"),
        version=("node", "--version"),
        steps=(("npm", "ci", "--ignore-scripts"), ("npx", "tsc")),
        command=lambda at: ["node", str(at / "dist" / "interop" / "interop.js")],
        environment={"npm_config_cache": "{base}/npm"},
    ),
    Language(
        "go",
        tools=("go",),
        version=("go", "version"),
        steps=(
            ("go", "vet", "./..."),
            ("go", "build", "-o", "build/", "./interop", "./example"),
        ),
        command=lambda at: [str(at / "build" / "interop")],
        environment={"GOMAXPROCS": "2", "GOFLAGS": "-buildvcs=false -mod=readonly"},
    ),
    Language(
        "rust",
        tools=("cargo",),
        version=("cargo", "--version"),
        steps=(("cargo", "build", "--locked", "--examples", "--jobs", "2"),),
        command=lambda at: [str(at / "target" / "debug" / "examples" / "interop")],
    ),
    Language(
        "java",
        tools=("java", "javac", "mvn"),
        version=("java", "-version"),
        steps=(
            *MAVEN_STEPS,
            (
                *("javac", "-cp", "target/classes:target/dependency/*"),
                *("-d", "build", "example/Worker.java", "example/Main.java"),
                "interop/Interop.java",
            ),
        ),
        command=lambda at: [
            *(
                "java",
                "-cp",
                f"{at}/build:{at}/target/classes:{at}/target/dependency/*",
            ),
            "Interop",
        ],
    ),
    Language(
        "kotlin",
        tools=("java", "mvn"),
        version=("java", "-version"),
        steps=MAVEN_STEPS,
        command=lambda at: [
            *("java", "-cp"),
            f"{at}/target/classes:{at}/target/test-classes:{at}/target/dependency/*",
            "InteropKt",
        ],
    ),
    Language(
        "cpp",
        tools=("g++", "cmake", "make"),
        headers=CPP_HEADERS,
        version=("g++", "--version"),
        steps=(
            ("cmake", "-S", ".", "-B", "../build", "-DPROCTOR_PROGRAMS=ON"),
            ("make", "-C", "../build", "-j2"),
        ),
        command=lambda at: [str(at.parent / "build" / "interop")],
        environment={"CXXFLAGS": "-O0"},
    ),
    Language(
        "typescript-evaluate",
        tools=("node", "npm"),
        version=("node", "--version"),
        steps=(("npm", "ci", "--ignore-scripts"), ("npx", "tsc")),
        command=lambda at: [
            *("node", str(at / "dist/clients/typescript/interop/interop.js"))
        ],
        environment={"npm_config_cache": "{base}/npm"},
        evaluates=True,
    ),
    Language(
        "cpp-evaluate",
        tools=("g++", "cmake", "make"),
        headers=CPP_HEADERS,
        version=("g++", "--version"),
        steps=(
            ("cmake", "-S", ".", "-B", "build", "-DPROCTOR_EVALUATE_PROGRAMS=ON"),
            ("make", "-C", "build", "-j2"),
        ),
        command=lambda at: [str(at / "build" / "interop")],
        environment={"CXXFLAGS": "-O0"},
        evaluates=True,
    ),
)
# The packages of clients/ by language.
PACKAGES = {language.language: language for language in LANGUAGES if language.evaluates}
