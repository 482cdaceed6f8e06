"""Certifying in CI: the steps of action.yml and of the GitLab job, as on a runner.

The inputs are filled in as GitHub does, the texts are given to bash with the flags that
it uses, and the server is a real one.
"""

import fnmatch
import re
import shlex
import sys
from pathlib import Path
from typing import Any

import pytest
import yaml

from tests.support.paths import ROOT
from tests.support.processes import run_program
from tests.support.repository.installed import (
    TIMEOUT_S,
    Done,
    clean_environment,
    install_lock,
)
from tools.distributions.staging import DISTRIBUTIONS, VERSION
from tools.example_servers import NODE
from tools.locks.complete import complete_lock

CERTIFY = ROOT / "tools" / "certify"
GITLAB = CERTIFY / "gitlab.yml"
GITLAB_JOB = yaml.safe_load(GITLAB.read_text())[".proctor-conformance"]
ACTION = yaml.safe_load((ROOT / "action.yml").read_text())
PAGE = (ROOT / "docs/implement/continuous-integration.md").read_text()
SERVER_JS = shlex.join([str(NODE), str(ROOT / "examples/server_js/server.js")])
slow = pytest.mark.slow("installs the kit, starts servers and kits")


@pytest.mark.parametrize(
    ("schema", "file"),
    [
        (["vendor.github-actions"], ROOT / "action.yml"),
        (["vendor.gitlab-ci", "--data-transform", "gitlab-ci"], GITLAB),
        (["vendor.citation-file-format"], ROOT / "CITATION.cff"),
        (["vendor.github-issue-forms"], ROOT / ".github/ISSUE_TEMPLATE/rule.yml"),
    ],
    ids=["action", "gitlab", "citation", "issue form"],
)
def test_file_obeys_the_public_schema(schema: list[str], file: Path) -> None:
    check_schema(schema, file)


def test_examples_of_the_page_obey_the_public_schemas(tmp_path: Path) -> None:
    """A workflow, a step of one, and a job of GitLab. Expect each as it is pasted."""
    workflow, step, job = re.findall(r"(?ms)^```yaml\n(.+?)^```", PAGE)
    head = "on: push\njobs:\n  one:\n    runs-on: ubuntu-24.04\n    steps:\n"
    file = tmp_path / "example.yml"
    file.write_text(job)
    check_schema(["vendor.gitlab-ci", "--data-transform", "gitlab-ci"], file)
    for text in (workflow, head + step):
        file.write_text(text)
        check_schema(["vendor.github-workflows"], file)
        (one,) = yaml.safe_load(text)["jobs"].values()
        assert one["steps"][-1]["with"].keys() <= ACTION["inputs"].keys()
    given = yaml.safe_load(job)["conformance"]["variables"].keys()
    assert given <= GITLAB_JOB["variables"].keys()


def check_schema(schema: list[str], file: Path) -> None:
    program = Path(sys.executable).parent / "check-jsonschema"
    done = run_program([str(program), "--builtin-schema", *schema, str(file)])
    assert done.returncode == 0, done.stdout + done.stderr


def test_actions_of_others_are_pinned() -> None:
    used = [step["uses"] for step in ACTION["runs"]["steps"] if "uses" in step]
    assert used != []
    for one in used:
        assert re.fullmatch(r"[\w-]+/[\w-]+@[0-9a-f]{40}", one), one


def test_inputs_reach_the_shell_by_environment_only() -> None:
    """Text inside `run` would be read as commands."""
    for step in ACTION["runs"]["steps"]:
        assert "${{" not in step.get("run", "")


def test_job_image_and_citation_name_this_version() -> None:
    citation = yaml.safe_load((ROOT / "CITATION.cff").read_text())
    assert citation["version"] == VERSION
    kit = DISTRIBUTIONS[0]
    assert GITLAB_JOB["variables"]["PROCTOR_REVISION"] == f"v{VERSION}"
    recipe = (CERTIFY / "Containerfile").read_text()
    copied = re.findall(r"(?m)^COPY dist/(\S+) ", recipe)
    names = [f"{kit.file_stem}-requirements.txt", f"{kit.file_stem}-py3-none-any.whl"]
    assert len(copied) == len(names)
    for pattern, name in zip(copied, names, strict=True):
        assert fnmatch.fnmatch(name, pattern)


def test_the_page_runs_the_image_as_its_recipe_says() -> None:
    """The folder is made and mounted, and the caller may write to it."""
    run = re.compile(r"mkdir -p report && podman run[^\n]+\\\n[#\s]+[^\n]+")
    found = {
        " ".join(run.findall(text)[0].replace("#", "").split())
        for text in (PAGE, (CERTIFY / "Containerfile").read_text())
    }
    (command,) = found
    assert {"--rm", "keep-id", '"$PWD/report:/report"'} <= set(command.split())


def test_the_log_of_the_server_is_kept_only_if_asked_for() -> None:
    """It is printed by the server and not masked."""
    kept = ACTION["runs"]["steps"][2]["with"]["path"].split("\n")
    condition = "inputs.keep-server-log != 'true' && format('!{0}/server.log', "
    assert kept[0] == "${{ inputs.report }}"
    assert condition in kept[1]
    assert ACTION["inputs"]["keep-server-log"]["default"] == "false"
    assert GITLAB_JOB["artifacts"]["exclude"] == ["proctor-report/server.log"]


class Runner:
    """The environment of a step, as GitHub's runner gives it: inputs, folders, bash."""

    def __init__(self, directory: Path) -> None:
        self.temporary = directory / "temporary"
        self.workspace = directory / "workspace"
        self.summary, self.output = directory / "summary", directory / "output"
        self.temporary.mkdir()
        # A folder of the workspace that has the name of the kit's package.
        (self.workspace / "conformance").mkdir(parents=True)
        decoy = self.workspace / "conformance" / "__init__.py"
        decoy.write_text("raise SystemExit('not the kit')")

    def run(self, number: int, **inputs: str) -> Done:
        """Run a step of the action."""
        step: dict[str, Any] = ACTION["runs"]["steps"][number]
        known = {
            f"inputs.{name}": str(described.get("default", ""))
            for name, described in ACTION["inputs"].items()
        } | {"github.action_path": str(ROOT)}
        given = {f"inputs.{k.replace('_', '-')}": v for k, v in inputs.items()}
        assert given.keys() <= known.keys()
        known |= given
        values = {
            name: re.sub(r"\$\{\{ (\S+) \}\}", lambda found: known[found[1]], text)
            for name, text in step["env"].items()
        }
        self.summary.write_text("")
        self.output.write_text("")
        runner = {
            "GITHUB_STEP_SUMMARY": str(self.summary),
            "GITHUB_OUTPUT": str(self.output),
            "RUNNER_TEMP": str(self.temporary),
        }
        return self.bash(step["run"], runner | values)

    def bash(self, text: str, environment: dict[str, str]) -> Done:
        return run_program(
            ["bash", "--noprofile", "--norc", "-eo", "pipefail", "-c", text],
            cwd=self.workspace,
            env=clean_environment() | environment,
            timeout=TIMEOUT_S,
        )


@pytest.fixture(scope="module")
def runner(tmp_path_factory: pytest.TempPathFactory) -> Runner:
    """The kit, installed; its packages are there before, which saves half a minute. pip
    compares them with the lock, and would install what is missing."""
    made = Runner(tmp_path_factory.mktemp("runner"))
    lock = made.temporary / "kit.txt"
    lock.write_text(complete_lock("kit"))
    install_lock(lock, made.temporary / "proctor-kit")
    installed = made.run(0, python=sys.executable)
    assert installed.returncode == 0, installed.stdout + installed.stderr
    return made


@slow
def test_a_server_is_started_and_judged(runner: Runner) -> None:
    """Expect exit code 0, the verdict as summary, the reports."""
    arguments = "--only SVC-001,SVC-002 --seed 7"
    done = runner.run(1, start_cmd=SERVER_JS, profile="core", arguments=arguments)
    assert done.returncode == 0, done.stdout + done.stderr
    assert runner.output.read_text() == "exit-code=0\n"
    summary = runner.summary.read_text()
    assert summary.startswith("## Proctor: conformant (selected rules)\n")
    assert "2 MUST: 2 verified, 0 violated" in summary
    report = runner.workspace / ACTION["inputs"]["report"]["default"]
    assert {"report.html", "junit.xml"} <= {path.name for path in report.iterdir()}


@slow
def test_a_verdict_fails_the_step(runner: Runner) -> None:
    """A known failure that passes now. Expect exit code 1 in step and output."""
    (runner.workspace / "known").write_text("SVC-001  # it is wrong there\n")
    inputs = {"known_failures": "known", "arguments": "--only SVC-001"}
    done = runner.run(1, start_cmd=SERVER_JS, **inputs)
    assert done.returncode == 1, done.stdout + done.stderr
    assert runner.output.read_text() == "exit-code=1\n"
    assert "passes now" in runner.summary.read_text()


@slow
@pytest.mark.parametrize(
    ("inputs", "said"),
    [
        ({"url": "http://127.0.0.1:1"}, "start the server or correct"),
        ({}, "give "),
        ({"url": "http://h", "start_cmd": "x; touch evil"}, "exclude each other"),
    ],
    ids=["no server", "no input", "both"],
)
def test_nothing_decided_fails_the_step(
    runner: Runner, inputs: dict[str, str], said: str
) -> None:
    """Expect exit code 2, and a summary that says why."""
    done = runner.run(1, **inputs)
    assert done.returncode == 2, done.stdout + done.stderr
    assert runner.output.read_text() == "exit-code=2\n"
    assert said in runner.summary.read_text()
    assert not (runner.workspace / "evil").exists()


@slow
def test_an_old_python_is_refused(runner: Runner, tmp_path: Path) -> None:
    old = tmp_path / "python"
    old.write_text("#!/bin/sh\nexit 1\n")
    old.chmod(0o755)
    done = runner.run(0, python=str(old))
    assert done.returncode == 2
    assert done.stdout.startswith("::error::The kit needs Python 3.11 to 3.14")


@slow
@pytest.mark.release("the job of GitLab; the action of GitHub is")
def test_the_job_of_gitlab_judges(tmp_path: Path) -> None:
    """All its commands in a folder where no kit has run before, with the kit of the
    last commit of this repository."""
    runner = Runner(tmp_path)
    given = {
        "PROCTOR_REPOSITORY": str(ROOT),
        "PROCTOR_REVISION": "HEAD",
        "PROCTOR_START_CMD": SERVER_JS,
        "PROCTOR_ARGUMENTS": "--only SVC-001",
    }
    for command in GITLAB_JOB["script"]:
        done = runner.bash(command, GITLAB_JOB["variables"] | given)
        assert done.returncode == 0, done.stdout + done.stderr
    kept = runner.workspace / GITLAB_JOB["artifacts"]["paths"][0]
    assert "1 verified" in (kept / "summary.md").read_text()
    assert (runner.workspace / GITLAB_JOB["artifacts"]["reports"]["junit"]).is_file()
