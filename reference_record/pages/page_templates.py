"""The templates, and how numbers and texts of others are written in them.

Every value is escaped. A link to elsewhere is one only if it is http or https.
"""

from __future__ import annotations

import hashlib
import math
from collections.abc import Mapping
from functools import cache
from importlib.resources import files
from typing import Any, Protocol
from urllib.parse import urlsplit

from jinja2 import BaseLoader, ChoiceLoader, Environment, PackageLoader

from reference_record.command_line.printed_commands import server_check, server_command
from reference_record.comparison.difference_evidence import p_text
from reference_record.comparison.judge_agreement import ENOUGH, agreement_text
from reference_record.contents.declared_parts import declared_parts
from reference_record.texts.benchmark_part import part_text
from reference_record.texts.counted_text import counted
from reference_record.texts.figures import difference_figure, figure
from reference_record.texts.left_reason import left_reason
from reference_record.texts.score_headline import (
    SPLITS_MAX,
    means_to_quote,
    mix_of,
    notes_on,
    score_cell,
)

# Limits what a browser loads and runs; a server sends it with each of these pages.
CONTENT_SECURITY_POLICY = (
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data:; "
    "media-src 'self'; connect-src 'self'; form-action 'self'; base-uri 'none'; "
    "frame-ancestors 'none'"
)
ASSETS = {
    "icon.svg": "image/svg+xml",
    "pages.css": "text/css; charset=utf-8",
    "pages.js": "text/javascript; charset=utf-8",
    "vendor/NOTICE.txt": "text/plain; charset=utf-8",
    "vendor/htmx.min.js": "text/javascript; charset=utf-8",
    "vendor/htmx-sse.min.js": "text/javascript; charset=utf-8",
    "vendor/uPlot.iife.min.js": "text/javascript; charset=utf-8",
    "vendor/uPlot.min.css": "text/css; charset=utf-8",
}
EMPTY = "–"
_MINUS = "−"


class Links(Protocol):
    """Where pages lie. An empty text: there is no such page here.

    server_url: of the server that printed commands reach; empty if none is known.
    """

    @property
    def is_live(self) -> bool: ...
    @property
    def server_url(self) -> str: ...
    def index(self) -> str: ...
    def runs(self) -> str: ...
    def tracks(self) -> str: ...
    def asset(self, name: str) -> str: ...
    def benchmark(self, benchmark_id: str, manifest_sha256: str = "") -> str: ...
    def leaderboard(self, benchmark_id: str) -> str: ...
    def run(self, run_id: str) -> str: ...
    def record(self, run_id: str) -> str: ...
    def episode(self, run_id: str, episode: Mapping[str, Any]) -> str: ...
    def comparison(self, baseline: str, run_id: str) -> str: ...
    def pair(self, baseline: str, run_id: str, episode: Mapping[str, Any]) -> str: ...


def render_page(template: str, links: Links, *, csrf: str = "", **values: Any) -> str:
    """A whole page, or a part of one, as HTML.

    csrf: of the reader's session, for its forms; empty for a reader without one.
    """
    text = _environment().get_template(f"{template}.html.j2")
    return text.render(links=links, csrf=csrf, **values)


@cache
def compile_templates() -> None:
    """So that no page waits for it: a tenth of a second once, in any thread."""
    environment = _environment()
    for name in environment.list_templates(extensions=["j2"]):
        environment.get_template(name)


@cache
def read_asset(name: str) -> bytes:
    """A script or a style that the pages load; a name of ASSETS."""
    assert name in ASSETS
    return files(__package__).joinpath("static", name).read_bytes()


@cache
def asset_version(name: str) -> str:
    """Changes with the content, so that a browser may keep what it has for good."""
    return hashlib.sha256(read_asset(name)).hexdigest()[:12]


@cache
def _environment() -> Environment:
    return make_environment()


def make_environment(*more: BaseLoader) -> Environment:
    """The templates of these pages and, before them, those of another program.

    These extend the layout, and use the filters.
    """
    environment = Environment(
        loader=ChoiceLoader([*more, PackageLoader(__package__, "templates")]),
        autoescape=True,
        trim_blocks=True,
        lstrip_blocks=True,
        auto_reload=False,
    )
    environment.globals["kappa_enough"] = ENOUGH
    environment.globals["splits_max"] = SPLITS_MAX
    environment.globals["server_command"] = server_command
    environment.globals["server_check"] = server_check
    environment.filters |= {
        "counted": counted,
        "agreement": agreement_text,
        "p": p_text,
        "percent": percent,
        "score": score_text,
        "difference": difference_text,
        "run_score": score_cell,
        "notes": notes_on,
        "part": part_text,
        "mix": mix_of,
        "means": means_to_quote,
        "duration": duration,
        "milliseconds": milliseconds,
        "interval": interval,
        "web_link": web_link,
        "moment": moment,
        "numbers": numbers,
        "declared_parts": declared_parts,
        "left_reason": left_reason,
    }
    return environment


def percent(value: float | None) -> str:
    return EMPTY if value is None else f"{figure(100 * value, 1)} %"


def score_text(value: float | None) -> str:
    return EMPTY if value is None else figure(value, 3)


def difference_text(means: tuple[float | None, float | None]) -> str:
    """means: of the baseline and of the run."""
    baseline, mean = means
    if baseline is None or mean is None:
        return EMPTY
    return difference_figure(mean, baseline, 3).replace("-", _MINUS)


def interval(value: Mapping[str, float]) -> str:
    """The interval of a rate, in percent."""
    return f"{figure(100 * value['low'], 1)}–{figure(100 * value['high'], 1)} %"


def milliseconds(value: float | None) -> str:
    if value is None:
        return EMPTY
    return f"{figure(value, 2)} ms" if value < 10 else f"{value:.0f} ms"


def duration(seconds: float | None) -> str:
    """The two largest units; less than a second in milliseconds."""
    if seconds is None or not math.isfinite(seconds):
        return EMPTY
    if 0 < seconds < 1:
        return milliseconds(1000 * seconds)
    if seconds < 60:
        return f"{seconds:.2g} s"
    minutes = int(seconds) // 60
    if minutes < 60:
        return f"{minutes} min {int(seconds) % 60} s"
    if minutes < 24 * 60:
        return f"{minutes // 60} h {minutes % 60} min"
    return f"{minutes // 1440} d {minutes // 60 % 24} h"


def moment(text: str) -> str:
    """RFC 3339 in UTC as people read it: without milliseconds."""
    return f"{text[:10]} {text[11:19]} UTC"


def numbers(values: list[float] | None) -> str:
    """Some numbers, the first of many."""
    if not values:
        return EMPTY
    shown = ", ".join(f"{value:g}" for value in values[:8])
    return shown + (", …" if len(values) > 8 else "")


def web_link(text: str | None) -> str:
    """The address if a browser may follow it, else an empty text."""
    if not text or any(ord(letter) <= 32 for letter in text):
        return ""
    try:
        parts = urlsplit(text)
    except ValueError:
        return ""
    return text if parts.scheme in ("http", "https") and parts.hostname else ""
