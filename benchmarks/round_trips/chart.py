"""build/round_trips.svg: p50 and p99 of every contender, a panel for each scenario.

One logarithmic axis for all panels; a bar ends at p50, a thin line at p99. Written as
text: the shapes are rectangles, lines and words. Knows its section of the results only.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from html import escape

from benchmarks.results import Json
from benchmarks.round_trips import report
from tools.built_pages import BUILD

FILE = BUILD / "round_trips.svg"
LINK = f"![Round trips]({FILE.name})"
WIDTH, NAMES_WIDTH, MARGIN = 900, 330, 90
ROW, HEAD, AXIS = 24, 34, 30
OURS, PEER, LIMIT = "#1f6f50", "#8a93a0", "#c4a24a"
_STYLE = (
    "text{font:13px system-ui,sans-serif;fill:#20262e}.h{font-weight:600}"
    ".s{font-size:11px;fill:#5a6470}.ours{font-weight:600}"
)


def svg(section: Json) -> str:
    """A whole document."""
    scenarios: Mapping[str, Mapping[str, Json]] = section["scenarios"]
    every = [one for played in scenarios.values() for one in played.values()]
    scale = _Scale(
        min(one["p50_ms"] for one in every), max(one["p99_ms"] for one in every)
    )
    shapes, top = [], 10.0
    for scenario, title in report.TITLES.items():
        played = scenarios.get(scenario, {})
        if not played:
            continue
        shapes += list(_panel(title, played, scale, top))
        top += HEAD + ROW * len(played) + AXIS
    shapes.append(
        _text(NAMES_WIDTH, top + 8, "bar: p50 of a round trip; line: to p99", "s")
    )
    body = "\n".join(shapes)
    height = top + 20
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height:.0f}" '
        f'width="{WIDTH}" role="img" aria-label="Round trips by contender">\n'
        f"<style>{_STYLE}</style>\n"
        f'<rect width="{WIDTH}" height="{height:.0f}" fill="#ffffff"/>\n'
        f"{body}\n</svg>\n"
    )


class _Scale:
    """Milliseconds to pixels, by decades."""

    def __init__(self, least: float, most: float) -> None:
        self.first = math.floor(math.log10(least))
        self.last = math.ceil(math.log10(most))

    def x(self, value_ms: float) -> float:
        share = (math.log10(value_ms) - self.first) / (self.last - self.first)
        return NAMES_WIDTH + share * (WIDTH - NAMES_WIDTH - MARGIN)

    def decades(self) -> Iterator[float]:
        return (10.0**power for power in range(self.first, self.last + 1))


def _panel(
    title: str, played: Mapping[str, Json], scale: _Scale, top: float
) -> Iterator[str]:
    yield _text(10, top + 20, title, "h")
    bottom = top + HEAD + ROW * len(played)
    for value in scale.decades():
        x = scale.x(value)
        yield _line(x, top + HEAD, x, bottom, "#e3e6ea")
        yield _text(x, bottom + 15, f"{value:g} ms", "s", "middle")
    rows = sorted(played.items(), key=lambda item: item[1]["p50_ms"])
    for number, (name, one) in enumerate(rows):
        yield from _row(name, one, scale, top + HEAD + ROW * number)


def _row(name: str, one: Json, scale: _Scale, top: float) -> Iterator[str]:
    ours = name.startswith("ours")
    colour = OURS if ours else LIMIT if name == "tcp" else PEER
    start, p50, p99 = NAMES_WIDTH, scale.x(one["p50_ms"]), scale.x(one["p99_ms"])
    middle = top + ROW / 2
    shown = report.NAMES[name].replace("**", "").replace("`", "")
    yield _text(start - 8, middle + 4, shown, "ours" if ours else "", "end")
    yield (
        f'<rect x="{start}" y="{top + 4:.1f}" width="{p50 - start:.1f}" '
        f'height="{ROW - 8}" fill="{colour}"/>'
    )
    yield _line(p50, middle, p99, middle, colour)
    yield _line(p99, middle - 4, p99, middle + 4, colour)
    yield _text(p99 + 6, middle + 4, f"{report.ms(one['p50_ms'])} ms", "s")


def _text(x: float, y: float, words: str, kind: str, anchor: str = "start") -> str:
    return (
        f'<text x="{x:.1f}" y="{y:.1f}" class="{kind}" text-anchor="{anchor}">'
        f"{escape(words)}</text>"
    )


def _line(x1: float, y1: float, x2: float, y2: float, colour: str) -> str:
    return (
        f'<line x1="{x1:.1f}" y1="{y1:.1f}" x2="{x2:.1f}" y2="{y2:.1f}" '
        f'stroke="{colour}" stroke-width="1.5"/>'
    )
