"""Turns a page of the repository into a page of the site.

Links between pages stay; links to files without a page become the file's name, for
the site stands alone. Ids of rules in running text become links to their pages. Knows
nothing of what the pages say.
"""

import posixpath
import re
from collections.abc import Callable, Collection

ID = re.compile(r"(?<![\w\[/-])([A-Z]{2,6}-\d{3})(?![\w-])")
FENCE = re.compile(r"^(?P<mark>```|~~~).*?^(?P=mark)[^\n]*$", re.MULTILINE | re.DOTALL)
INDENTED = re.compile(r"(?:(?<=\n\n)|\A)(?: {4}[^\n]*\n|\n(?= {4}))+")
LINK = re.compile(
    r"(!?)\[((?:[^\[\]]|\[[^\]]*\])*)\]\(<?([^)>\s]+)>?(?: \"[^\"]*\")?\)"
)
CODE = re.compile(r"(`+)(?!`).*?(?<!`)\1(?!`)", re.DOTALL)
HEADING = re.compile(r"^#{1,6} [^\n]*$", re.MULTILINE)
MERMAID = re.compile(r"^```mermaid\n(.*?)^```$", re.MULTILINE | re.DOTALL)
COMMENT = re.compile(r"<!--.*?-->", re.DOTALL)


def convert(
    text: str, name: str, files: Collection[str], rules: Collection[str]
) -> str:
    """The text of the page `name`, a path, for a site that has these files and rules.

    `files` are paths of the site's source, as seen from its root.
    """
    text = MERMAID.sub(lambda found: picture(found[1]), COMMENT.sub("", text))
    kept: list[str] = []

    def keep(found: re.Match[str]) -> str:
        kept.append(found[0])
        return f"\0{len(kept) - 1}\0"

    def link(found: re.Match[str]) -> str:
        kept.append(_link(found, posixpath.dirname(name), files))
        return f"\0{len(kept) - 1}\0"

    for pattern in (FENCE, INDENTED):
        text = pattern.sub(keep, text)
    text = _outside_of_code(text, lambda part: LINK.sub(link, part), keep)
    text = HEADING.sub(keep, text)
    text = ID.sub(lambda found: link_to_rule(found[1], rules), text)
    while "\0" in text:
        text = re.sub("\0(\\d+)\0", lambda found: kept[int(found[1])], text)
    return text


def _outside_of_code(
    text: str, change: Callable[[str], str], keep: Callable[[re.Match[str]], str]
) -> str:
    """Change the text; code in it is kept, also inside of the text of links."""
    return change(CODE.sub(keep, text))


def link_to_rule(id_: str, rules: Collection[str]) -> str:
    """The id as a link, if it is a rule's."""
    return f"[{id_}](/rules/{id_}.md)" if id_ in rules else id_


def _link(found: re.Match[str], folder: str, files: Collection[str]) -> str:
    is_image, text, target = found[1], found[2], found[3]
    if re.match(r"[a-z]+:|#", target):
        return found[0]
    path, _, anchor = target.partition("#")
    path = posixpath.normpath(posixpath.join("/", folder, path)).lstrip("/")
    if path in files:
        if anchor and path.endswith(".md"):
            return f"{is_image}[{text}](/{path}#{anchor})"
        return f"{is_image}[{text}](/{path})"
    return text if "\0" in text or "`" in text or path in text else f"{text} (`{path}`)"


def picture(mermaid: str) -> str:
    """A picture that the browser draws; where it cannot, its text is shown."""
    escaped = mermaid.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")
    return f'```{{raw}} html\n<pre class="mermaid">\n{escaped}</pre>\n```'


def cell(text: str) -> str:
    """The text as a cell of a table."""
    return " ".join(text.split()).replace("|", "\\|")


def table(head: list[str], rows: list[list[str]]) -> str:
    """A table; cells are Markdown already."""
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join(f"| {' | '.join(line)} |" for line in lines) + "\n"
