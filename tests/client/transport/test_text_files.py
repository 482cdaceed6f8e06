"""Text files as editors save them, in every program that reads what people write."""

import codecs
from collections.abc import Callable
from pathlib import Path

import pytest

from conformance.cli.arguments import read_known_failures
from conformance.cli.kit_command import BadArguments
from reference_client.policies import PolicyMapping
from reference_record.command_line.text_file import NotText, decode_text
from reference_sim.benchmarks.question_file.question_lines import read_questions
from reference_sim.gymnasium.benchmark_file import read

MAPPING = "[observation]\nk = {from = 'step'}\n[action.values]\na = {}\n"
BENCHMARK = 'environment = "CartPole-v1" # caf\u00e9\n'
QUESTIONS = '{"question": "caf\u00e9?", "answer": 1}\n'
FAILURES = "PRED-004  # caf\u00e9\n"
READERS: list[tuple[Callable[[Path], object], str]] = [
    (PolicyMapping.read, MAPPING),
    (lambda path: list(read(str(path))), BENCHMARK),
    (read_questions, QUESTIONS),
    (lambda path: read_known_failures(str(path)), FAILURES),
]
NAMES = ["mapping", "benchmark", "questions", "known failures"]


@pytest.mark.parametrize(("reader", "text"), READERS, ids=NAMES)
@pytest.mark.parametrize("mark", [b"", codecs.BOM_UTF8])
@pytest.mark.parametrize("newline", ["\n", "\r\n"])
def test_a_mark_and_lines_of_windows_are_read(
    reader: Callable[[Path], object],
    text: str,
    mark: bytes,
    newline: str,
    tmp_path: Path,
) -> None:
    path = tmp_path / "file.toml"
    path.write_bytes(mark + text.replace("\n", newline).encode())
    assert reader(path)


@pytest.mark.parametrize(("reader", "text"), READERS, ids=NAMES)
@pytest.mark.parametrize("encoding", ["utf-16", "utf-16-le", "utf-32", "latin-1"])
def test_any_other_encoding_is_refused_in_a_sentence(
    reader: Callable[[Path], object], text: str, encoding: str, tmp_path: Path
) -> None:
    path = tmp_path / "file.toml"
    path.write_bytes(f"{text}# caf\u00e9".encode(encoding))
    with pytest.raises((ValueError, BadArguments)) as refusal:
        reader(path)
    refused = str(refusal.value)
    assert "file.toml" in refused
    assert refused.endswith(("save it as UTF-8", "save the file as UTF-8"))


@pytest.mark.parametrize(
    ("data", "fault"),
    [
        (codecs.BOM_UTF16_BE, "UTF-16"),
        (b"a\0", "UTF-16 or not a text file"),
        (b"a\nb\n\xe9", "line 3 is not UTF-8"),
    ],
)
def test_the_fault_is_named(data: bytes, fault: str) -> None:
    with pytest.raises(NotText, match=fault):
        decode_text(data)
