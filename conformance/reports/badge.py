"""badge.svg and one for each level: the result in a few words, for a server's page.

Red when a MUST is violated, known or not; green only for a whole conformant run.
"""

from xml.sax.saxutils import escape

from conformance.specification.document import load_spec
from conformance.verdicts.levels import LevelVerdict
from conformance.verdicts.result import Result
from conformance.verdicts.verdict import Outcome

_GREEN, _RED, _GREY, _ORANGE = "#1f7a38", "#c62828", "#5b6472", "#96600a"
# Average width of Verdana at 11 pixels; textLength stretches the text to fit.
_CHARACTER = 6.4
_PADDING = 6


def badge(result: Result) -> str:
    return _drawn(f"proctor {_version()}", *_summarise(result))


def level_badge(verdict: LevelVerdict) -> str:
    """Draw the badge of a level: green only where the server has reached it."""
    name = f"proctor {verdict.name} {_version()}"
    if verdict.code == 0:
        judged = verdict.count(Outcome.PASSED)
        return _drawn(name, f"{judged}/{len(verdict.rows)} verified", _GREEN)
    colour = _RED if verdict.violated else _GREY
    return _drawn(name, verdict.text.partition(":")[0], colour)


def _version() -> str:
    return load_spec().version.rpartition(".")[0]


def _drawn(name: str, summary: str, colour: str) -> str:
    left, right = (_width(text) for text in (name, summary))
    whole = left + right
    label = escape(f"{name}: {summary}", {'"': "&quot;"})
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{whole}" height="20" '
        f'role="img" aria-label="{label}"><title>{label}</title>'
        f'<clipPath id="r"><rect width="{whole}" height="20" rx="3"/></clipPath>'
        f'<g clip-path="url(#r)"><rect width="{left}" height="20" fill="#333a45"/>'
        f'<rect x="{left}" width="{right}" height="20" fill="{colour}"/></g>'
        '<g fill="#fff" font-family="Verdana,DejaVu Sans,sans-serif" font-size="11" '
        f'text-anchor="middle">{_text_element(name, 0, left)}'
        f"{_text_element(summary, left, right)}</g></svg>\n"
    )


def _summarise(result: Result) -> tuple[str, str]:
    count = result.counts("MUST")
    about = count.total() - count[Outcome.NOT_APPLICABLE]
    verified = f"{count[Outcome.PASSED]}/{about} verified"
    if count[Outcome.FAILED]:
        return f"{verified}, {count[Outcome.FAILED]} violated", _RED
    if result.exit_code == 2:
        return "not decided", _ORANGE
    if result.exit_code == 1:
        return f"{verified}, outdated known failures", _RED
    if result.is_partial:
        return f"{verified} (selection)", _GREY
    return verified, _GREEN


def _width(text: str) -> int:
    return round(len(text) * _CHARACTER) + 2 * _PADDING


def _text_element(text: str, start: int, width: int) -> str:
    return (
        f'<text x="{start + width / 2:g}" y="14" textLength="{width - 2 * _PADDING}">'
        f"{escape(text)}</text>"
    )
