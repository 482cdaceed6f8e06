"""The kit as users install it: alone, and with the specification that it judges."""

import ast
import re
import subprocess
import sys
import tomllib
import venv
import zipfile
from pathlib import Path

import pytest

from conformance.specification.document import spec_name, spec_sha256
from tests.support.paths import ROOT
from tests.support.processes import run_program

PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text())
SETUPTOOLS = PROJECT["tool"]["setuptools"]
SOURCES = (
    *("conformance", "reference_client", "reference_platform", "reference_record"),
    *("reference_server", "reference_sim"),
)
PACKED = "conformance/specification/files"
Done = subprocess.CompletedProcess[str]


def test_every_package_is_packed() -> None:
    here = {
        ".".join(path.parent.relative_to(root).parts)
        for root in (ROOT, ROOT / "generated_clients" / "python")
        for path in root.glob("*/**/__init__.py")
        if path.relative_to(root).parts[0] in (*SOURCES, "proctor_client")
    }
    assert set(SETUPTOOLS["packages"]) == here | {"conformance.specification.files"}


def imported_modules(*folders: Path) -> set[str]:
    """Top-level names of what modules below import, the standard library's left out."""
    imported = set()
    for path in [path for folder in folders for path in folder.rglob("*.py")]:
        for node in ast.walk(ast.parse(path.read_text())):
            if isinstance(node, ast.Import):
                imported |= {alias.name.split(".")[0] for alias in node.names}
            elif isinstance(node, ast.ImportFrom) and node.module and not node.level:
                imported.add(node.module.split(".")[0])
    return imported - set(sys.stdlib_module_names)


def required_packages(requirements: str) -> set[str]:
    lines = (ROOT / "requirements" / requirements).read_text().splitlines()
    return {found[0] for line in lines if (found := re.match(r"[a-z][a-z0-9-]*", line))}


def test_kit_imports_only_locked_packages() -> None:
    lock = (ROOT / "requirements" / "kit.txt").read_text()
    locked = {line.split("==")[0].lower() for line in lock.splitlines() if "==" in line}
    names = {"PIL": "pillow", "yaml": "pyyaml", "_pytest": "pytest"}
    names["jsonschema_rs"] = "jsonschema-rs"
    foreign = imported_modules(ROOT / "conformance") - {"conformance"}
    assert {names.get(name, name) for name in foreign} <= locked
    assert not {"mujoco", "starlette", "uvicorn", "sqlalchemy"} & locked


def test_client_imports_only_the_packages_of_its_extra() -> None:
    ours = {"reference_client", "reference_record", "proctor_client"}
    generated = ROOT / "generated_clients" / "python" / "proctor_client"
    names = {"PIL": "pillow", "pydantic_core": "pydantic"}
    parts = ROOT / "reference_client", ROOT / "reference_record", generated
    foreign = imported_modules(*parts) - ours
    apart = {"lerobot", "torch"}  # imported by a policy that needs them
    assert apart <= foreign
    foreign -= apart
    assert {names.get(name, name) for name in foreign} == required_packages("client.in")
    assert required_packages("client.in") < required_packages("server.in")


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The wheel, built from a copy, so that nothing is left in this directory."""
    directory = tmp_path_factory.mktemp("wheel")
    source = directory / "source"
    listed = ["LICENSE", "pyproject.toml", "requirements", "spec", "generated_clients"]
    source.mkdir()
    for name in (*listed, *SOURCES):
        subprocess.run(["cp", "-r", str(ROOT / name), str(source)], check=True)
    pip = [sys.executable, "-m", "pip", "wheel", "--quiet", "--no-deps"]
    flags = ["--no-build-isolation", "--disable-pip-version-check"]
    to = ["--wheel-dir", str(directory)]
    subprocess.run([*pip, *flags, *to, str(source)], check=True)
    (built,) = directory.glob("*.whl")
    return built


def test_wheel_carries_the_specification(wheel: Path) -> None:
    with zipfile.ZipFile(wheel) as packed:
        for name in ("openapi.yaml", "scoring.md", "calibration.md"):
            ours = (ROOT / "spec" / name).read_bytes()
            assert packed.read(f"{PACKED}/{name}") == ours
        names = set(packed.namelist())
    for name in ("report.schema.json", "report.html.j2", "report.css", "report.js"):
        assert f"conformance/reports/{name}" in names
    marked = {f"{package}/py.typed" for package in (*SOURCES, "proctor_client")}
    assert marked <= names  # without it mypy and pyright read no type


def run_installed(wheel: Path, directory: Path, program: str) -> Done:
    """A program where the wheel is installed and nothing else is."""
    venv.create(directory / "venv", with_pip=False, symlinks=True)
    (site,) = (directory / "venv" / "lib").glob("python*/site-packages")
    with zipfile.ZipFile(wheel) as packed:
        packed.extractall(site)
    return run_program(
        [str(directory / "venv" / "bin" / "python"), "-P", "-c", program], cwd=directory
    )


def test_installed_kit_judges_the_same(wheel: Path, tmp_path: Path) -> None:
    """Installed elsewhere, with this environment's packages but not this directory."""
    ours = next(path for path in sys.path if path.endswith("site-packages"))
    program = (
        f"import sys; sys.path.append({ours!r})\n"
        "from conformance.cli.main import main\n"
        "sys.exit(main(['--dry-run', '--only', 'SVC']))"
    )
    done = run_installed(wheel, tmp_path, program)
    assert done.returncode == 0, done.stderr
    assert spec_name() in done.stdout
    assert spec_sha256()[:12] in done.stdout


KIT = "proctor-conformance"


@pytest.mark.parametrize(
    ("name", "extra"), [("proctor", "client"), (KIT, "kit"), (f"{KIT}-policy", "kit")]
)
def test_a_command_says_what_to_install(
    name: str, extra: str, wheel: Path, tmp_path: Path
) -> None:
    """Where only the other was wanted. Expect exit code 2, one line, no traceback."""
    module, _, function = PROJECT["project"]["scripts"][name].partition(":")
    program = f"import sys; from {module} import {function}; sys.exit({function}())"
    done = run_installed(wheel, tmp_path, program)
    assert done.returncode == 2
    (line,) = done.stderr.splitlines()
    assert f"pip install 'proctor-eval[{extra}]'" in line
