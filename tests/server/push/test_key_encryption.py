"""API keys of policy servers are encrypted in the database."""

import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import pytest

from reference_server.push.egress import EgressPolicy
from reference_server.push.key_encryption import DecryptionFailed, KeyEncryption
from reference_server.push.policy_server_validator import PolicyServerValidator
from reference_server.runs.service import body_digest
from tests.support.push_runs import push_submission
from tests.support.server.server_parts import expect_refusal, open_server_parts


def open_key_encryption(path: Path | None) -> KeyEncryption:
    key_encryption = KeyEncryption(path)
    key_encryption.open()
    return key_encryption


def test_a_key_is_decrypted_only_with_the_same_file(tmp_path: Path) -> None:
    path = tmp_path / "var" / "x.key"
    sealed = open_key_encryption(path).encrypt("sesame")
    assert "sesame" not in sealed
    assert open_key_encryption(path).decrypt(sealed) == "sesame"
    for other in (tmp_path / "y.key", None):
        with pytest.raises(DecryptionFailed):
            open_key_encryption(other).decrypt(sealed)


def test_without_a_file_the_encryption_key_is_in_memory() -> None:
    key_encryption = open_key_encryption(None)
    assert key_encryption.decrypt(key_encryption.encrypt("sesame")) == "sesame"


def test_the_key_file_has_mode_0600(tmp_path: Path) -> None:
    open_key_encryption(tmp_path / "x.key")
    (file,) = tmp_path.iterdir()
    assert file.stat().st_mode & 0o777 == 0o600


async def test_no_digest_of_an_api_key_is_stored(tmp_path: Path) -> None:
    """A reader of the database alone could try likely keys, one after another."""
    submission = push_submission("http://127.0.0.1:1", api_key="sesame")
    encryption = KeyEncryption()
    validator = PolicyServerValidator(EgressPolicy("all"), encryption, ("proctor",))
    async with open_server_parts(tmp_path / "proctor.sqlite") as parts:
        service = replace(
            parts.service,
            validate_submission=validator.validate_and_encrypt,
            comparable_submission=validator.digest_key,
        )
        first = await service.submit_run("alice", submission, "key")
        assert await service.submit_run("alice", submission, "key") is first
        with expect_refusal("idempotency_conflict"):
            other = push_submission("http://127.0.0.1:1", api_key="Sesame")
            await service.submit_run("alice", other, "key")
        use = await service.find_by_key("alice", "key")
        assert use is not None
        assert use.body_sha256 != body_digest(submission)
    assert KeyEncryption().digest("sesame") != encryption.digest("sesame")


@pytest.mark.slow("starts a server or a kit")
@pytest.mark.parametrize("content", [b"", b"no key", b"x" * 44])
def test_a_file_that_holds_no_key_ends_the_start_with_one_line(
    tmp_path: Path, content: bytes
) -> None:
    path = tmp_path / "x.key"
    path.write_bytes(content)
    with pytest.raises(ValueError, match=r"."):
        open_key_encryption(path)
    command = [sys.executable, "-m", "reference_server", "--sealing-key", str(path)]
    command += ["--database", str(tmp_path / "x.sqlite"), "--port", "0"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 2
    assert len(done.stderr.strip().splitlines()) == 1
    assert f"cannot use the key in {path}" in done.stderr
