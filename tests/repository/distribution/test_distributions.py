"""The wheels that are published: what is in them, and that each is used alone.

Built by `make dist`'s program, installed with their locks into empty environments where
nothing of this checkout can be imported.
"""

import hashlib
import json
import os
import re
import shlex
import subprocess
import tomllib
import zipfile
from collections import Counter
from pathlib import Path

import httpx
import pytest
from cyclonedx.schema import SchemaVersion
from cyclonedx.validation.json import JsonStrictValidator
from packaging.metadata import Metadata
from packaging.requirements import Requirement

from conformance.specification.document import spec_name
from tests.support.paths import ROOT
from tests.support.platform.hosted_server import HostedServer, send_form, sign_in
from tests.support.platform.sandboxes import open_folder
from tests.support.platform.uploaded_policies import SUPPORT
from tests.support.ports import free_port
from tests.support.processes import run_program
from tests.support.repository.installed import (
    Installed,
    build_wheels,
    clean_environment,
)
from tests.support.servers import TOKENS, ReferenceServer
from tools.distributions.locks import parse_lock
from tools.distributions.staging import DISTRIBUTIONS, VERSION, Distribution
from tools.example_servers import GO, build_server_go
from tools.locks.complete import complete_lock

slow = pytest.mark.slow("builds and installs wheels")
OF_CLIENT = ["reference_client", "reference_record", "reference_sim", "proctor_client"]
PACKAGES = ("conformance", *OF_CLIENT, "reference_server", "reference_platform")
MODULES = (*PACKAGES, "tests", "tools")
NAMES = [distribution.name for distribution in DISTRIBUTIONS]
# The files that the wheels are built from.
_IN_TREE = [name for name in PACKAGES if name != "proctor_client"]
SOURCES = ("requirements", "spec", "tools", "generated_clients/python", *_IN_TREE)
POLICY = """
class Best:
    def reset(self, instruction):
        pass

    def act(self, observation):
        names = ("score", "success", "end", "delay_s", "fault")
        action = {name: [float(name in ("score", "success", "end"))] for name in names}
        return action | {"vector": [0.0] * 8, "clipped": [0.0] * 2}
"""


@pytest.fixture(scope="module")
def dist(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("dist")
    build_wheels(folder)
    return folder


def wheel_of(dist: Path, distribution: Distribution) -> Path:
    return dist / f"{distribution.file_stem}-py3-none-any.whl"


def packed_files(dist: Path, distribution: Distribution) -> set[str]:
    with zipfile.ZipFile(wheel_of(dist, distribution)) as packed:
        return {name for name in packed.namelist() if ".dist-info/" not in name}


# --- what is in them ---


@slow
def test_every_file_is_in_one_wheel(dist: Path) -> None:
    """The files of the packages and the specification that git has. Expect it once."""
    packed = Counter(name for one in DISTRIBUTIONS for name in packed_files(dist, one))
    assert [name for name, count in packed.items() if count > 1] == []
    tracked = set()
    for folder in PACKAGES:
        at = ROOT / ("generated_clients/python" if folder == "proctor_client" else ".")
        done = run_program(["git", "ls-files", folder], cwd=at, check=True)  # fmt: skip
        tracked |= set(done.stdout.split())
    specification = {name for name in packed if "specification/files/" in name}
    assert set(packed) - specification == tracked
    assert "conformance/specification/files/openapi.yaml" in specification
    assert "conformance/specification/files/profiles/ebench.yaml" in specification


@slow
@pytest.mark.parametrize("distribution", DISTRIBUTIONS, ids=NAMES)
def test_metadata_is_valid(dist: Path, distribution: Distribution) -> None:
    """By the reader of the packaging library, which refuses what an index refuses."""
    with zipfile.ZipFile(wheel_of(dist, distribution)) as packed:
        (name,) = [n for n in packed.namelist() if n.endswith(".dist-info/METADATA")]
        metadata = Metadata.from_email(packed.read(name), validate=True)
        licenses = {n for n in packed.namelist() if ".dist-info/licenses/" in n}
    assert metadata.name == distribution.name
    assert str(metadata.version) == VERSION
    assert metadata.license_expression == "Apache-2.0"
    assert metadata.license_files is not None
    assert len(licenses) == len(metadata.license_files) >= 1
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    assert str(metadata.requires_python) == project["requires-python"]
    assert metadata.description is not None
    assert metadata.description.startswith(f"# {distribution.name}\n")


@slow
def test_extras_are_those_of_the_repository(dist: Path) -> None:
    """A message that names `proctor-eval[video]` is right in both."""
    wheel = wheel_of(dist, DISTRIBUTIONS[1])
    with zipfile.ZipFile(wheel) as packed:
        (file,) = [n for n in packed.namelist() if n.endswith(".dist-info/METADATA")]
        metadata = Metadata.from_email(packed.read(file))
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())
    ours = project["tool"]["setuptools"]["dynamic"]["optional-dependencies"]
    assert metadata.provides_extra is not None
    assert set(metadata.provides_extra) == set(ours)
    required = {str(r) for r in metadata.requires_dist or []}
    named = {"server": "server", "conformance": "kit", "host": "platform"}
    for name, extra in named.items():
        assert f'proctor-{name}=={VERSION}; extra == "{extra}"' in required


@slow
def test_the_same_commit_gives_the_same_bytes(dist: Path, tmp_path: Path) -> None:
    """Again in a clone elsewhere, with a strict umask. Expect the same SHA256SUMS."""
    clone = tmp_path / "clone"
    cloning = ["git", "clone", "--quiet", "--no-checkout", str(ROOT), str(clone)]
    subprocess.run(cloning, check=True)
    listed = "git ls-files -z --cached --others --exclude-standard --"
    files = shlex.join(["LICENSE", "pyproject.toml", "*/*.in", *SOURCES])
    copy = f"{listed} {files} | tar --null -T - -c | (umask 077; tar -x -C {clone})"
    subprocess.run(["bash", "-o", "pipefail", "-c", copy], cwd=ROOT, check=True)
    again = tmp_path / "again"
    again.mkdir()
    (again / "proctor_eval-0.0.9-py3-none-any.whl").touch()  # of an earlier build
    mine = {f"{DISTRIBUTIONS[0].file_stem}-notes.md", "mine.txt"}
    for name in mine:
        (again / name).touch()
    build_wheels(again, source=clone)
    sums = (dist / "SHA256SUMS").read_text()
    assert (again / "SHA256SUMS").read_text() == sums
    assert len(sums.splitlines()) == 3 * len(DISTRIBUTIONS)
    summed = {line.split("  ")[1] for line in sums.splitlines()}
    kept = {path.name for path in again.iterdir()} - summed
    assert kept == {"SHA256SUMS", *mine}
    for line in sums.splitlines():
        digest, name = line.split("  ")
        assert hashlib.sha256((dist / name).read_bytes()).hexdigest() == digest


# --- locks and bills of materials ---


@pytest.mark.parametrize("distribution", DISTRIBUTIONS, ids=NAMES)
def test_locks_hold_what_is_required(distribution: Distribution) -> None:
    lock = parse_lock(complete_lock(distribution.lock))
    locked = {package.name for package in lock}
    for name in distribution.requires:
        if name.endswith(".in"):
            lines = (ROOT / "requirements" / name).read_text().splitlines()
            texts = [line.partition("#")[0].strip() for line in lines]
            assert {Requirement(text).name for text in texts if text} <= locked


def test_a_lock_is_read_with_hashes_and_origins() -> None:
    digest = "0" * 64
    some, other = parse_lock(
        f"some-name==1.5 ; sys_platform != 'win32' \\\n    --hash=sha256:{digest}\n"
        f"    # via -r some.in\nother==2 \\\n    --hash=sha256:{digest}\n"
        "    # via -r some.in, some-name\n"
    )
    assert (some.name, some.version, some.hashes) == ("some-name", "1.5", [digest])
    assert some.marker == 'sys_platform != "win32"'
    assert some.required_by == ["-r some.in"]
    assert other.required_by == ["-r some.in", "some-name"]


def test_a_lock_with_a_line_of_another_kind_is_refused() -> None:
    with pytest.raises(ValueError, match="no-such-option"):
        parse_lock("some==1 \\\n    --no-such-option\n")
    with pytest.raises(ValueError, match="not pinned"):
        parse_lock("some>=1\n")


@slow
@pytest.mark.parametrize("distribution", DISTRIBUTIONS, ids=NAMES)
def test_bill_of_materials(dist: Path, distribution: Distribution) -> None:
    """By CycloneDX's own schema. Expect each package of the lock, with its hashes."""
    text = (dist / f"{distribution.file_stem}.cdx.json").read_text()
    assert JsonStrictValidator(SchemaVersion.V1_6).validate_str(text) is None
    bill = json.loads(text)
    wheel = wheel_of(dist, distribution).read_bytes()
    (digest,) = bill["metadata"]["component"]["hashes"]
    assert digest["content"] == hashlib.sha256(wheel).hexdigest()
    listed = {c["purl"]: c for c in bill["components"]}
    for package in parse_lock(complete_lock(distribution.lock)):
        component = listed[f"pkg:pypi/{package.name}@{package.version}"]
        (source,) = component["externalReferences"]
        hashes = {one["content"] for one in source["hashes"]}
        assert hashes == set(package.hashes) != set()
    # Nothing hangs in the air: every package is required by something.
    required = {name for d in bill["dependencies"] for name in d.get("dependsOn", [])}
    assert set(listed) <= required
    if distribution.name == "proctor-eval":
        assert {"pkg:npm/htmx.org@2.0.8", "pkg:npm/uplot@1.6.32"} <= set(listed)


# --- each is used alone ---


@slow
@pytest.mark.skipif(not GO, reason="set-up brings no Go")
def test_the_kit_judges_a_server_in_one_command(dist: Path, tmp_path: Path) -> None:
    """The server in Go, by the kit from its wheel. Expect rules verified, exit 0."""
    kit = Installed(tmp_path, dist, "proctor-conformance")
    assert kit.can_import(MODULES) == ["conformance"]
    server = build_server_go(tmp_path)
    done = kit.run(
        "proctor-conformance",
        *("--start-cmd", str(server), "--quick", "--only", "SVC,PRED"),
    )
    assert done.returncode == 0, done.stdout + done.stderr
    assert spec_name() in done.stdout
    (verified,) = re.findall(r"MUST: (\d+) verified, 0 violated", done.stdout)
    assert int(verified) > 20
    assert (tmp_path / "report" / "report.html").is_file()
    policy = kit.run("proctor-conformance-policy", "--help")
    assert policy.returncode == 0, policy.stderr


class WheelServer(ReferenceServer):
    """The reference server from its wheel."""

    def __init__(self, installed: Installed, *words: str, **settings: str) -> None:
        self.command = (str(installed.bin / "proctor-server"), *words)
        super().__init__(installed.directory, PYTHONSAFEPATH="1", **settings)


@slow
def test_a_client_plays_on_a_server_from_its_wheel(dist: Path, tmp_path: Path) -> None:
    """Each in an environment of its own. Expect the score of the policy, 1."""
    folders = tmp_path / "server", tmp_path / "client"
    for folder in folders:
        folder.mkdir()
    served = Installed(folders[0], dist, "proctor-eval", "proctor-server")
    assert set(served.can_import(MODULES)) == {*OF_CLIENT, "reference_server"}
    client = Installed(folders[1], dist, "proctor-eval")
    assert set(client.can_import(MODULES)) == set(OF_CLIENT)
    version = client.run("proctor", "--version")
    assert version.stdout.startswith(f"proctor {VERSION}, protocol version ")
    (folders[1] / "evaluate.py").write_text(POLICY)
    with WheelServer(served) as server:
        done = client.run(
            "proctor",
            *("run", "--url", server.url, "--policy", "evaluate.py:Best"),
            *("--benchmark", "calibration"),
            PROCTOR_TOKEN=TOKENS["alice"],
        )
    assert done.returncode == 0, done.stdout + done.stderr
    assert "success 1 of 1 scored" in " ".join(done.stdout.split())


@pytest.mark.release("the commands of a README from wheels")
def test_the_readme_of_the_server_leads_to_scores(dist: Path, tmp_path: Path) -> None:
    """Its files and its commands. Expect every episode of both worlds to succeed."""
    text = (ROOT / "tools/distributions/proctor-server/README.md").read_text()
    files = r"(?s)`(\w+\.py)`:\n\n```python\n(.*?)```"
    for name, body in re.findall(files, text):
        (tmp_path / name).write_text(body)
    served = Installed(tmp_path, dist, "proctor-eval", "proctor-server")
    path = {"PATH": f"{served.bin}:{os.environ['PATH']}"}
    (copy,) = re.findall(r"^    (cp .*)$", text, re.MULTILINE)
    environment = clean_environment() | path
    subprocess.run(["sh", "-c", copy], cwd=tmp_path, env=environment, check=True)
    commands = r"^    proctor-server (.*)\n(?:    |(?:.*\n)*?    )proctor run (.*)$"
    scored = 0
    for server_words, run_words in re.findall(commands, text, re.MULTILINE):
        # The server is started elsewhere, and no folder of a script is imported from.
        words = shlex.split(server_words.replace("my_", f"{tmp_path}/my_"))
        with WheelServer(served, *words, **path, PYTHONPATH=str(tmp_path)) as server:
            done = served.run(
                "proctor",
                *("run", "--url", server.url, *shlex.split(run_words)),
                PROCTOR_TOKEN=TOKENS["alice"],
            )
        assert done.returncode == 0, done.stdout + done.stderr
        assert "success 10 of 10 scored" in " ".join(done.stdout.split())
        scored += 1
    assert scored == 2


class WheelHost(HostedServer):
    """`proctor-host` from its wheel, as its README starts it, in its folder."""

    def __init__(self, installed: Installed, words: str) -> None:
        self._installed, self._command = installed, words
        super().__init__(installed.directory, "")

    def start(self, *_: str) -> None:
        program, *words = shlex.split(self._command)
        path = f"{self._installed.bin}:{os.environ['PATH']}"
        environment = clean_environment() | {"PATH": path, "PYTHONSAFEPATH": "1"}
        command = [str(self._installed.bin / program), *words]
        self._begin(command, environment, self.directory)


def confirmed_login(
    browser: httpx.Client, installed: Installed, words: list[str], home: Path
) -> None:
    """`proctor login`, with the code that it prints confirmed on the page."""
    with subprocess.Popen(
        [installed.bin / "proctor", *words], cwd=installed.directory,
        env=clean_environment() | {"HOME": str(home)}, stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT, text=True,
    ) as login:  # fmt: skip
        assert login.stdout is not None
        found = (re.search("code=(.*)", line) for line in login.stdout)
        code = next(match[1] for match in found if match)
        page = f"/hosting/device?code={code}"
        send_form(browser, page, "/hosting/device", code=code, decision="approve")
        assert "Signed in as ada" in login.stdout.read()


@pytest.mark.release("a host from wheels, to the first submission")
def test_the_readme_of_the_host_leads_to_a_submission(dist: Path) -> None:
    """Its commands, word for word but for places. Expect a completed submission."""
    with open_folder() as folder:
        text = (ROOT / "tools/distributions/proctor-host/README.md").read_text()
        text = text.replace("8460", str(free_port())).replace(" /b", f" {folder}/b")
        host = Installed(folder, dist, "proctor-eval", "proctor-server", "proctor-host")
        assert set(host.can_import(MODULES)) == set(PACKAGES) - {"conformance"}
        track = text.split("```toml\n")[1].split("```")[0]
        (folder / "letters.toml").write_text(track)
        (folder / "policy").mkdir()
        program = (SUPPORT / "policy_program.py").read_text()
        (folder / "policy" / "main.py").write_text(program)
        start, *commands = re.findall(r"^    (proctor.*)$", text, re.MULTILINE)
        with (
            WheelHost(host, start) as served,
            served.client(follow_redirects=True) as browser,
        ):
            person = {"full_name": "A", "organisation": "B", "email": "a@example.org"}
            account = {"account": "ada", "password": "correct horse"}
            register = "/hosting/register"
            send_form(browser, register, **person, **account, agrees="on")
            for command in commands:
                _, *words = shlex.split(command)
                if words[0] == "login":
                    sign_in(browser, **account)
                    page = "/hosting/tracks/letters"
                    send_form(browser, page, f"{page}/enter")
                    confirmed_login(browser, host, words, folder)
                    continue
                done = host.run("proctor", *words, HOME=str(folder))
                assert done.returncode == 0, done.stdout + done.stderr
                if words[0] == "submit":
                    assert "state       completed" in done.stdout
                    assert "policy   | predict 0" in done.stderr
