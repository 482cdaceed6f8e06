"""The file with the secret of sealed seeds."""

from pathlib import Path

import pytest

from reference_server.files.seed_secret import SeedSecret


def test_the_secret_outlives_the_process_and_is_the_owners(tmp_path: Path) -> None:
    path = tmp_path / "var" / "db.seeds"
    first, second = SeedSecret(path), SeedSecret(path)
    first.open()
    second.open()
    assert first.value == second.value
    assert len(first.value) == 32
    assert path.stat().st_mode & 0o777 == 0o600


def test_without_a_file_every_process_has_another_one() -> None:
    first, second = SeedSecret(), SeedSecret()
    first.open()
    assert first.value != second.value


@pytest.mark.parametrize("text", ["", "abcd", "no digits"])
def test_a_file_without_a_secret_is_refused(tmp_path: Path, text: str) -> None:
    path = tmp_path / "db.seeds"
    path.write_text(text)
    with pytest.raises(ValueError, match="hex"):
        SeedSecret(path).open()
