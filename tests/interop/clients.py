"""How the interop program and the example of each language are built and started.

Sources are copied to .cache/interop/ and built there, so that nothing a build leaves
can reach the repository; a client that is not committed is generated there first. A
language whose toolchain is missing is never built. It must not know what a scenario is.
"""

import fcntl
import filecmp
import os
import shutil
import subprocess
import sys
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from functools import cache
from pathlib import Path

from tests.interop.builds.build_steps import GENERATOR, ROOT, run_step, write_client
from tests.support.processes import run_program

CLIENTS = ROOT / "generated_clients"
CACHE = ROOT / ".cache" / "interop"
BUILD_OUTPUT = {"__pycache__", "build", "dist", "node_modules", "target"}
CPP_HEADERS = ("curl/curl.h", "nlohmann/json.hpp")


@dataclass(frozen=True)
class Language:
    """One client with its two programs. tools: executables that must be on PATH.
    headers: what g++ must find. install: what to install where one of them is missing.
    packages: what Debian has of it, for machines on which we may install. version:
    prints the toolchain's version. interop, example: the names of the programs that
    `start` starts in a folder. steps: commands that build, in the copied directory.
    evaluates: the package of clients/ on top of the generated client, else that client.
    on_request: the client is generated for the build; its programs are in clients/."""

    name: str
    tools: tuple[str, ...]
    install: str
    version: tuple[str, ...]
    start: Callable[[Path, str], list[str]]
    interop: str
    example: str
    steps: tuple[tuple[str, ...], ...] = ()
    environment: dict[str, str] = field(default_factory=dict)
    evaluates: bool = False
    on_request: bool = False
    headers: tuple[str, ...] = ()
    packages: tuple[str, ...] = ()

    @property
    def language(self) -> str:
        return self.name.removesuffix("-evaluate")

    @property
    def package(self) -> str:
        """The folder with the programs, seen from the repository's root."""
        ours = self.evaluates or self.on_request
        return f"{'clients' if ours else 'generated_clients'}/{self.language}"

    @property
    def directory(self) -> Path:
        return CACHE / self.name / "src" / self.package

    def interop_command(self) -> list[str]:
        return self.start(self.directory, self.interop)

    def example_command(self) -> list[str]:
        return self.start(self.directory, self.example)

    def missing(self) -> str:
        """Why this language cannot be built here; empty when it can."""
        absent = [tool for tool in self.tools if shutil.which(tool) is None]
        if not absent:
            absent = [name for name in self.headers if not has_header(name)]
        if absent:
            return f"{' and '.join(absent)} not found; install {self.install}"
        if self.on_request and not GENERATOR.exists():
            return "the generator is not installed; `make generate-check` installs it"
        return ""

    def provide(self) -> None:
        """Install the packages that are missing, as root on Debian or Ubuntu."""
        if self.packages and self.missing():
            why = f"for the client {self.name}"
            command = ("sh", "tools/debian_packages.sh", why, *self.packages)
            subprocess.run(command, cwd=ROOT, check=False)
            has_header.cache_clear()

    def toolchain(self) -> str:
        output = run_program(self.version, check=True)
        return (output.stdout or output.stderr).splitlines()[0].strip()

    def build(self) -> None:
        """Bring the programs up to date; BuildFailed holds what the compiler said."""
        (CACHE / self.name).mkdir(parents=True, exist_ok=True)
        with (CACHE / self.name / "lock").open("w") as lock:
            fcntl.flock(lock, fcntl.LOCK_EX)  # tests run in several processes
            self._build()

    def _build(self) -> None:
        stamp, recipe = CACHE / self.name / "built", f"{self.toolchain()}\n{self.steps}"
        built = stamp.read_text() if stamp.exists() else ""
        stamp.unlink(missing_ok=True)
        changed = self._copy_sources()
        # Built again, it would be replaced while another process runs it.
        if changed or built != recipe:
            for step in self.steps:
                run_step(step, self.directory, self.env())
        stamp.write_text(recipe)

    def _copy_sources(self) -> bool:
        """Bring the copy up to date; whether anything was changed."""
        if self.on_request:
            client = CACHE / self.name / "client"
            write_client(self.language, client)
            return mirror(client, self.directory)
        folders = sorted({f"generated_clients/{self.language}", self.package})
        copy = CACHE / self.name / "src"
        changes = [mirror(ROOT / folder, copy / folder) for folder in folders]
        return any(changes)

    def env(self) -> dict[str, str]:
        base = CACHE / self.name
        given = self.environment.items()
        return os.environ | {key: text.format(base=base) for key, text in given}


@cache
def has_header(name: str) -> bool:
    """Whether g++ finds this header."""
    command = ("g++", "-E", "-x", "c++", "-include", name, os.devnull)
    return subprocess.run(command, capture_output=True, check=False).returncode == 0


def mirror(source: Path, target: Path) -> bool:
    """Make `target` the same as `source`, but for what builds left in it. Returns
    whether anything was changed."""
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
    *(sys.executable, str(ROOT / "tests/interop/builds/maven_checksums.py")),
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

NODE = "Node.js 20.3 or newer with npm"
CPP_PACKAGES = (*("g++", "cmake", "make", "libcurl4-openssl-dev"), "nlohmann-json3-dev")
CPP = f"g++, CMake, make, libcurl and nlohmann-json (Debian: {' '.join(CPP_PACKAGES)})"
MAVEN = "a JDK of 11 or newer and Maven (Debian: default-jdk maven)"


def start_node(at: Path, program: str) -> list[str]:
    return ["node", str(at / "dist" / program)]


def make_steps(folder: str, programs: str) -> tuple[tuple[str, ...], ...]:
    configure = ("cmake", "-S", ".", "-B", folder, f"-D{programs}=ON")
    return (configure, ("make", "-C", folder, "-j2"))


TYPESCRIPT = Language(
    "typescript",
    tools=("node", "npm"),
    install=NODE,
    version=("node", "--version"),
    steps=(("npm", "ci", "--ignore-scripts"), ("npx", "tsc")),
    start=start_node,
    interop="interop/interop.js",
    example="example/worker.js",
    environment={"npm_config_cache": "{base}/npm"},
)
CPP_CLIENT = Language(
    "cpp",
    tools=("g++", "cmake", "make"),
    headers=CPP_HEADERS,
    install=CPP,
    packages=CPP_PACKAGES,
    version=("g++", "--version"),
    steps=make_steps("../build", "PROCTOR_PROGRAMS"),
    start=lambda at, program: [str(at.parent / "build" / program)],
    interop="interop",
    example="worker",
    environment={"CXXFLAGS": "-O0"},
)
LANGUAGES = (
    Language(
        "python",
        tools=(),
        install="",
        version=(sys.executable, "--version"),
        start=lambda at, program: [sys.executable, str(at / program)],
        interop="interop/interop.py",
        example="example/worker.py",
    ),
    TYPESCRIPT,
    Language(
        "go",
        tools=("go",),
        install="Go 1.24 or newer",
        version=("go", "version"),
        steps=(
            ("go", "vet", "./..."),
            ("go", "build", "-o", "build/", "./interop", "./example"),
        ),
        start=lambda at, program: [str(at / "build" / program)],
        interop="interop",
        example="example",
        environment={"GOMAXPROCS": "2", "GOFLAGS": "-buildvcs=false -mod=readonly"},
        on_request=True,
    ),
    Language(
        "rust",
        tools=("cargo",),
        install="Rust with cargo, and OpenSSL (Debian: libssl-dev pkg-config)",
        version=("cargo", "--version"),
        steps=(("cargo", "build", "--locked", "--examples", "--jobs", "2"),),
        start=lambda at, program: [str(at / "target" / "debug" / "examples" / program)],
        interop="interop",
        example="worker",
        on_request=True,
    ),
    Language(
        "java",
        tools=("java", "javac", "mvn"),
        install=MAVEN,
        version=("java", "-version"),
        steps=(
            *MAVEN_STEPS,
            (
                *("javac", "-cp", "target/classes:target/dependency/*"),
                *("-d", "build", "example/Worker.java", "example/Main.java"),
                "interop/Interop.java",
            ),
        ),
        start=lambda at, program: [
            *("java", "-cp"),
            f"{at}/build:{at}/target/classes:{at}/target/dependency/*",
            program,
        ],
        interop="Interop",
        example="Main",
        on_request=True,
    ),
    Language(
        "kotlin",
        tools=("java", "mvn"),
        install=MAVEN,
        version=("java", "-version"),
        steps=MAVEN_STEPS,
        start=lambda at, program: [
            *("java", "-cp"),
            f"{at}/target/classes:{at}/target/test-classes:{at}/target/dependency/*",
            program,
        ],
        interop="InteropKt",
        example="MainKt",
        on_request=True,
    ),
    CPP_CLIENT,
    replace(
        TYPESCRIPT,
        name="typescript-evaluate",
        interop="clients/typescript/interop/interop.js",
        example="clients/typescript/example/evaluate.js",
        evaluates=True,
    ),
    replace(
        CPP_CLIENT,
        name="cpp-evaluate",
        steps=make_steps("build", "PROCTOR_EVALUATE_PROGRAMS"),
        start=lambda at, program: [str(at / "build" / program)],
        example="evaluate",
        evaluates=True,
    ),
)
# The packages of clients/ by language.
PACKAGES = {language.language: language for language in LANGUAGES if language.evaluates}
