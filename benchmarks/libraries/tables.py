"""The report of the libraries: a table for each question, the chosen library first.

Everything is computed from its section of benchmarks.json; the questions are described
here. Imports none of the libraries.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from benchmarks import performance_page
from benchmarks.results import Json
from benchmarks.round_trips.report import ms

Figures = Mapping[str, Mapping[str, float]]


class Question(NamedTuple):
    """columns: as benchmarks.json names them → head of the table."""

    title: str
    text: str
    chosen: str
    columns: Mapping[str, str]


QUESTIONS = {
    "parsing": Question(
        "Parsing a response in the client",
        "Head and body of a turn without images, 804 bytes, no socket. httptools is "
        "measured as in `reference_client`, with its collection of the headers.",
        "httptools",
        {"answer_us": "one response, µs"},
    ),
    "messagepack": Question(
        "MessagePack",
        "Server, simulator and client: a turn without images, 670 bytes, and one with "
        "four raw images of 480 × 640. msgspec decodes into the client's structures, "
        "validates them and does not copy images; all others make dicts and copies.",
        "msgspec",
        {
            "encode_us": "encode, µs",
            "decode_us": "decode, µs",
            "decode_pictures_us": "decode, four images, µs",
        },
    ),
    "json": Question(
        "JSON",
        "Server and client, on request: the same turns. A library without Base64 is "
        "combined with one; a turn without images needs none. The server encodes "
        "images with pybase64; `reference_client` uses JSON only where a server has "
        "nothing else, and decodes images with msgspec.",
        "msgspec",
        {
            "encode_us": "encode, µs",
            "decode_us": "decode, µs",
            "encode_pictures_ms": "encode, four images, ms",
            "decode_pictures_ms": "decode, four images, ms",
        },
    ),
    "jpeg": Question(
        "JPEG",
        "Encoded by the simulator, decoded by the client: four images of 480 × 640, "
        "quality 90, 4:2:0, in one thread and in as many as there are cores. Decoded "
        "pixels are equal. Files are not: they are slightly larger than Pillow's.",
        "simplejpeg",
        {
            "encode_ms": "encode, ms",
            "encode_threads_ms": "in threads, ms",
            "decode_ms": "decode, ms",
            "decode_threads_ms": "in threads, ms",
            "files_kb": "the files, kB",
        },
    ),
    "servers": Question(
        "An HTTP server",
        "A minimal ASGI application answers a request of 538 bytes over one persistent "
        "connection: 670 bytes of body, or 3.7 MB with four images in nine messages, "
        "as sent by the reference server. CPU is that of all processes of the server. "
        "granian reads a view of memory byte by byte, so it receives copies.",
        "uvicorn: httptools, uvloop",
        {
            "p50_us": "p50, µs",
            "server_cpu_us": "server CPU, µs",
            "p50_pictures_ms": "four images, p50, ms",
            "server_cpu_pictures_ms": "server CPU, ms",
        },
    ),
    "clients": Question(
        "An HTTP client",
        "The first of these servers sends the 670 bytes. `reference_client` is its "
        "connection only, a socket and httptools.",
        "reference_client",
        {"p50_us": "p50, µs", "client_cpu_us": "client CPU, µs"},
    ),
}


def tables(section: Json) -> str:
    """A table for each question that was measured, and what was measured where."""
    parts = [
        f"### {question.title}\n\n{question.text}\n\n{table(question, figures)}"
        for name, question in QUESTIONS.items()
        if (figures := section["figures"].get(name))
    ]
    return "\n\n".join([*parts, _where(section)])


def ratios(question: Question, figures: Figures) -> dict[str, dict[str, float]]:
    """By contender and column: its figure as a multiple of that of the chosen one."""
    found: dict[str, dict[str, float]] = {}
    for column in question.columns:
        for name, figure in figures[column].items():
            ratio = figure / figures[column][question.chosen]
            found.setdefault(name, {})[column] = ratio
    return found


def table(question: Question, figures: Figures) -> str:
    by_name = ratios(question, figures)
    # The others by the first figure that they have.
    order = sorted(
        by_name,
        key=lambda name: (name != question.chosen, next(iter(by_name[name].values()))),
    )
    rows = [
        [
            f"**{name}**" if name == question.chosen else name,
            *(
                f"{ms(figures[column][name])} ({by_name[name][column]:.2f})"
                if column in by_name[name]
                else ""
                for column in question.columns
            ),
        ]
        for name in order
    ]
    return performance_page.table(["", *question.columns.values()], rows)


def _where(section: Json) -> str:
    on = section["measured_on"]
    versions = ", ".join(f"{name} {one}" for name, one in on["versions"].items())
    loads = " ".join(map(str, on["load_before"]))
    counts = section["rounds"]
    return (
        f"In brackets is the ratio to the first. Medians of {counts['in_process']} "
        f"rounds, of {counts['loopback']} on loopback, measured on {on['date']}: "
        f"{on['cores']} cores ({on['processor']}), Python {on['python']}, load before "
        f"{loads}. {versions}."
    )
