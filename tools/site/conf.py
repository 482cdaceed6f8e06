"""The settings of Sphinx for the site; what is built is in __main__.py."""

import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

_SPEC = Path(__file__).resolve().parents[2] / "spec" / "openapi.yaml"
_VERSION = re.search(r"^  version: (\S+)$", _SPEC.read_text(), re.MULTILINE)

project = "Proctor"
release = _VERSION[1] if _VERSION else ""
html_title = f"Proctor {release}"
copyright = "the authors of Proctor, Apache-2.0"  # noqa: A001 - Sphinx's name
extensions = ["myst_parser"]
html_theme = "furo"
html_css_files = ["site.css"]
html_js_files = ["pictures.js"]
html_copy_source = False
html_show_sphinx = False
html_last_updated_fmt = None
nitpicky = True
# Anchors as GitHub gives them, so that one link leads to both.
myst_heading_anchors = 4
myst_enable_extensions = ["attrs_inline"]
myst_all_links_external = False
# A cell of a table, a list in a list: what GitHub shows is not always well nested.
suppress_warnings = ["myst.header"]
pygments_style = "default"
pygments_dark_style = "github-dark"


_navigation: dict[str, Any] = {}


def _reuse_navigation(
    app: Any, page: str, _template: str, context: dict[str, Any], _tree: object
) -> None:
    """The pages of rules stand in no list, so their navigation is the same text.

    Writing it anew for each of them would be a third of the whole build.
    """
    if "orphan" not in app.env.metadata.get(page, {}) or not page.startswith("rules/"):
        return
    write: Callable[..., Any] = context["toctree"]

    def reuse(**settings: Any) -> Any:
        key = repr(sorted(settings.items()))
        if key not in _navigation:
            _navigation[key] = write(**settings)
        return _navigation[key]

    context["toctree"] = reuse


def setup(app: Any) -> None:
    app.connect("html-page-context", _reuse_navigation, priority=100)
