"""The API keys of policy servers at rest."""

import subprocess
import sys
from pathlib import Path

import pytest

from reference_server.push.key_encryption import DecryptionFailed, KeyEncryption


def opened(path: Path | None) -> KeyEncryption:
    key_encryption = KeyEncryption(path)
    key_encryption.open()
    return key_encryption


def test_what_is_sealed_is_read_with_the_same_file_alone(tmp_path: Path) -> None:
    path = tmp_path / "var" / "x.key"
    sealed = opened(path).encrypt("sesame")
    assert "sesame" not in sealed
    assert opened(path).decrypt(sealed) == "sesame"
    for other in (tmp_path / "y.key", None):
        with pytest.raises(DecryptionFailed):
            opened(other).decrypt(sealed)


def test_without_a_file_it_is_read_until_the_process_ends() -> None:
    key_encryption = opened(None)
    assert key_encryption.decrypt(key_encryption.encrypt("sesame")) == "sesame"


def test_the_file_is_its_owners_alone_and_the_only_one(tmp_path: Path) -> None:
    opened(tmp_path / "x.key")
    (file,) = tmp_path.iterdir()
    assert file.stat().st_mode & 0o777 == 0o600


@pytest.mark.parametrize("content", [b"", b"no key", b"x" * 44])
def test_a_file_that_holds_no_key_ends_the_start_with_one_line(
    tmp_path: Path, content: bytes
) -> None:
    path = tmp_path / "x.key"
    path.write_bytes(content)
    with pytest.raises(ValueError, match=r"."):
        opened(path)
    command = [sys.executable, "-m", "reference_server", "--sealing-key", str(path)]
    database = ["--database", str(tmp_path / "x.sqlite")]
    done = subprocess.run(
        [*command, *database], capture_output=True, text=True, check=False
    )
    assert done.returncode == 2
    assert len(done.stderr.strip().splitlines()) == 1
    assert f"cannot use the key in {path}" in done.stderr
