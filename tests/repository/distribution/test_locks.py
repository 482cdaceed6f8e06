"""The locks of requirements/, and their hashes, which stand once for all of them."""

import sys
from pathlib import Path

import pytest

from tests.support.paths import ROOT
from tests.support.processes import run_program
from tools.locks.complete import PIN, complete_lock, read_hashes
from tools.locks.resolve import LOCKS
from tools.locks.wheel_files import is_supported, read_pylock

DIGESTS = ["0" * 64, "1" * 64]


def test_every_pin_of_every_lock_has_hashes() -> None:
    """Expect no hashes of any other pin, which would be those of an old version."""
    pins = set()
    for name in LOCKS:
        lines = (ROOT / "requirements" / f"{name}.txt").read_text().splitlines()
        pins |= {pin[0] for line in lines if (pin := PIN.match(line))}
        complete_lock(name)
    hashes = read_hashes()
    assert pins == hashes.keys()
    assert all(hashes.values())


def test_a_lock_is_completed_by_the_standard_library_alone() -> None:
    """By a Python without packages, as on a machine where a kit is installed."""
    program = ROOT / "tools" / "locks" / "complete.py"
    done = run_program(
        [sys.executable, "-I", "-S", str(program), "kit"], cwd="/", check=True
    )
    assert done.stdout == complete_lock("kit")


def test_hashes_follow_their_pin_and_its_marker(tmp_path: Path) -> None:
    some = " ".join(["some==1", *(f"--hash=sha256:{d}" for d in DIGESTS)])
    (tmp_path / "hashes.txt").write_text(some + "\n")
    lock = tmp_path / "mine.txt"
    lock.write_text("some==1 ; sys_platform == 'win32'    # via -r mine.in, other\n")
    assert complete_lock("mine", tmp_path) == (
        "some==1 ; sys_platform == 'win32' \\\n"
        f"    --hash=sha256:{DIGESTS[0]} \\\n"
        f"    --hash=sha256:{DIGESTS[1]}\n"
        "    # via -r mine.in, other\n"
    )
    lock.write_text("some==1.1\n")
    with pytest.raises(ValueError, match=r"no hash of some==1\.1: run `make lock`"):
        complete_lock("mine", tmp_path)


@pytest.mark.parametrize(
    ("tags", "supported"),
    [
        ("py3-none-any", True),
        ("py2.py3-none-manylinux2014_x86_64.manylinux_2_17_x86_64", True),
        ("cp311-cp311-manylinux_2_28_aarch64", True),
        ("cp37-abi3-linux_x86_64", True),
        ("cp314-cp314-macosx_11_0_arm64", True),
        ("cp311-abi3.abi3t-win_amd64", True),
        ("cp314-cp314t-manylinux_2_28_x86_64", False),
        ("cp312-cp312-musllinux_1_2_x86_64", False),
        ("cp312-cp312-manylinux_2_28_riscv64", False),
        ("cp312-cp312-win32", False),
        ("pp311-pypy311_pp73-manylinux_2_28_x86_64", False),
        ("cp313-cp313-ios_13_0_arm64_iphoneos", False),
    ],
)
def test_wheels_of_supported_platforms_have_a_hash(tags: str, supported: bool) -> None:
    assert is_supported(f"some-1-{tags}.whl") is supported


def test_a_package_without_a_supported_wheel_cannot_be_locked(tmp_path: Path) -> None:
    pylock = tmp_path / "pylock.toml"
    wheel = '{{ url = "https://h/a/some-1-{}.whl", hashes = {{ sha256 = "{}" }} }}'
    head = '[[packages]]\nname = "some"\nversion = "1"\nwheels = '
    usual, foreign = (
        wheel.format(*one)
        for one in zip(("py3-none-any", "py3-none-win32"), DIGESTS, strict=True)
    )
    pylock.write_text(f"{head}[{usual}, {foreign}]\n")
    assert read_pylock(pylock) == {"some==1": [f"--hash=sha256:{DIGESTS[0]}"]}
    pylock.write_text(f"{head}[{foreign}]\n")
    with pytest.raises(ValueError, match="some==1 has no wheel"):
        read_pylock(pylock)
