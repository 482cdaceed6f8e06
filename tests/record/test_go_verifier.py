"""The verifier in Go, written from spec/profiles/record.md, names the same."""

import json
import subprocess
from itertools import groupby
from pathlib import Path

import pytest

from reference_client.command.main import main
from tests.support.paths import ROOT
from tests.support.processes import run_program
from tools.example_servers import GO, run_go

VECTORS = ROOT / "spec" / "vectors" / "record"
SOURCE = ROOT / "examples" / "verify_go"
GOOD = str(VECTORS / "good.proctor")
LISTED = json.loads((VECTORS / "records.json").read_text())
HOST, LAB = LISTED["keys"]
CASES = [LISTED | case for case in LISTED["records"] + LISTED["with_other_keys"]]

pytestmark = [
    pytest.mark.slow("builds a program"),
    pytest.mark.skipif(not GO, reason="set-up brings no Go"),
]


@pytest.fixture(scope="module")
def program(tmp_path_factory: pytest.TempPathFactory) -> Path:
    program = tmp_path_factory.mktemp("verify_go") / "verify-go"
    run_go("vet", "./...", folder=SOURCE)
    run_go("build", "-o", program, ".", folder=SOURCE)
    return program


def play(program: Path, *words: str) -> subprocess.CompletedProcess[str]:
    return run_program([program, *words])


def test_the_go_verifier_agrees_on_every_vector(program: Path) -> None:
    members = ("file", "rule", "levels")
    for _, group in groupby(CASES, key=lambda case: json.dumps(case["keys"])):
        cases = list(group)
        named = cases[0]["keys"].items()
        keys = [word for keyid, name in named for word in ("--key", f"{name}={keyid}")]
        paths = [str(VECTORS / case["record"]) for case in cases]
        done = play(program, *keys, *paths)
        answers = [json.loads(line) for line in done.stdout.splitlines()]
        assert [
            [Path(a["record"]).name, *(a[m] for m in members)] for a in answers
        ] == [[case["record"], *(case[m] for m in members)] for case in cases]
        assert done.returncode == any(case["rule"] for case in cases), done.stderr


@pytest.mark.parametrize(
    "words",
    [
        [GOOD],
        ["--key", HOST, GOOD],
        [GOOD, "--key", HOST],
        [GOOD, f"--key=a lab={HOST}"],
        [GOOD, "--key", LAB],
        [GOOD, "--key", "abc"],
        [GOOD, "--key", f"a=b={HOST}"],
        [GOOD, "--key", HOST.upper()],
        [GOOD, "--key", f"{HOST}0"],
        [GOOD, "--key"],
        [GOOD, "--keys", HOST],
        ["--key", HOST],
        [str(VECTORS / "absent.proctor")],
    ],
    ids=lambda words: " ".join(words).replace(str(VECTORS), ""),
)
def test_both_commands_end_alike(
    program: Path, words: list[str], capsys: pytest.CaptureFixture[str]
) -> None:
    done = play(program, *words)
    try:
        code: object = main(["verify", "--json", *words])
    except SystemExit as ended:
        code = ended.code
    assert done.returncode == code, done.stdout + done.stderr
    if code != 2:
        printed = json.loads(capsys.readouterr().out)
        assert json.loads(done.stdout)["levels"] == printed["levels"]
