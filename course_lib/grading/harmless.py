"""Make a graded notebook safe to look at: nothing that a student wrote in words runs in a browser.

nbgrader's pages turn Markdown into HTML as it is, scripts included, in the browser of whoever may
give points. JupyterLab's sanitiser is not asked there. So what is more than words, pictures and
formulas is shown as it was typed; all other cells stay as they are.
"""

from __future__ import annotations

import base64
import re
import time
from collections.abc import Mapping
from functools import lru_cache
from typing import Any
from urllib.parse import urlsplit

from bleach.css_sanitizer import CSSSanitizer
from bleach.sanitizer import Cleaner
from bs4 import BeautifulSoup
from nbconvert.filters.markdown_mistune import (
    InvalidNotebook,
    IPythonRenderer,
    MarkdownWithMath,
)
from nbconvert.filters.strings import strip_files_prefix
from nbformat import NotebookNode
from nbformat.v4 import new_markdown_cell

from course_lib.grading.planning import MOST_CELLS
from course_lib.judging.limits import TimeLimitReached, time_limit

#: What Markdown is turned into, and what one may write into it by hand.
TAGS = {
    "a", "b", "blockquote", "br", "code", "dd", "del", "details", "div", "dl", "dt", "em", "h1",
    "h2", "h3", "h4", "h5", "h6", "hr", "i", "img", "input", "kbd", "li", "ol", "p", "pre", "s",
    "span", "strong", "sub", "summary", "sup", "table", "tbody", "td", "th", "thead", "tr", "u",
    "ul",
}  # fmt: skip
HEADINGS = {"h1", "h2", "h3", "h4", "h5", "h6"}
#: Attributes that Markdown is turned into, with the values that they then have.
VALUES = {
    "alt": r"[^<>]*",
    "checked": r"",
    "class": r"highlight|language-[\w+#-]*|anchor-link|task-list-item(-checkbox)?|\w{1,3}",
    "disabled": r"",
    "id": r"\S+",
    "open": r"",
    "start": r"\d+",
    "style": r"text-align: ?(left|right|center);?",
    "title": r"[^<>]*",
    "type": r"checkbox",
}
PICTURE = re.compile(r"data:image/(png|jpeg|gif);base64,[A-Za-z0-9+/=]*|[\w-][\w./-]*")
PICTURES = ("image/png", "image/jpeg", "image/gif")
SCHEMES = {"", "http", "https", "mailto"}
#: TeX that is more than a formula in MathJax: links, styles, names, other packages.
MORE_THAN_FORMULAS = re.compile(r"\\(href|style|class|cssId|require|mmlToken)(?![a-z])")
#: Letters of a cell that are still turned into HTML to look at; seconds for one cell, and for all.
MOST_LETTERS, PATIENCE, PATIENCE_IN_ALL = 20_000, 2.0, 20.0
AS_TYPED = (
    "*This is more than words, formulas and attached pictures (HTML, a command, a picture from "
    "elsewhere), or very long, so it is shown as it was typed:*"
)


def disarm(notebook: NotebookNode) -> None:
    """Leave only what is harmless in the cells that are the student's, and no labels of theirs.

    Parameters
    ----------
    notebook : nbformat.NotebookNode
        A graded submission; changed in place. Outputs are none of its business.
    """
    kernel = {k: v for k, v in notebook.metadata.items() if k == "kernelspec"}
    python = {"name": "python", "pygments_lexer": "ipython3"}
    notebook.metadata = NotebookNode(kernel | {"language_info": NotebookNode(python)})
    deadline = time.monotonic() + PATIENCE_IN_ALL
    for index, cell in enumerate(notebook.cells):
        label = cell.metadata.get("nbgrader")
        cell.metadata = NotebookNode({} if label is None else {"nbgrader": label})
        if cell.cell_type != "code" and not (label or {}).get("locked"):
            notebook.cells[index] = _harmless(cell, time.monotonic() < deadline)


def _harmless(cell: NotebookNode, in_time: bool) -> NotebookNode:
    """Return a cell of words as it is, or as it was typed if there is no time to look at it."""
    attached = cell.pop("attachments", {})
    pictures = {name: kept for name, data in attached.items() if (kept := _pictures(data))}
    if cell.cell_type == "raw" and not cell.source.strip():
        return cell
    if cell.cell_type == "markdown" and in_time and is_harmless(cell.source, pictures):
        if pictures:
            cell.attachments = NotebookNode(pictures)
        return cell
    return new_markdown_cell(as_typed(cell.source), id=cell.id, metadata=cell.metadata)


def _pictures(data: Any) -> dict[str, str]:
    """Return those parts of an attachment that are pictures made of dots."""
    parts = data.items() if isinstance(data, Mapping) else ()
    lines = {k: "".join(text.split()) for k, text in parts if isinstance(text, str)}
    return {kind: text for kind, text in lines.items() if kind in PICTURES and _is_base64(text)}


def _is_base64(text: str) -> bool:
    try:
        return bool(base64.b64decode(text, validate=True))
    except ValueError:
        return False


def as_typed(source: str) -> str:
    """Return Markdown that shows a source letter by letter.

    Parameters
    ----------
    source : str
        Anything.

    Returns
    -------
    str
        A sentence, and a block of code with a fence longer than any in the source.
    """
    runs = [len(run) for run in re.findall("`+", source)]
    fence = "`" * max([3, *(n + 1 for n in runs)])
    return f"{AS_TYPED}\n\n{fence}\n{source}\n{fence}"


def is_harmless(source: str, pictures: Mapping[str, Mapping[str, str]] | None = None) -> bool:
    """Whether Markdown becomes nothing but text, lists, tables, code, formulas, links, pictures.

    Parameters
    ----------
    source : str
        As a student wrote it.
    pictures : mapping of str to mapping, optional
        What is attached to the cell.

    Returns
    -------
    bool
        False also where it cannot be shown, as with a picture that is missing.
    """
    if len(source) > MOST_LETTERS:
        return False
    if pictures:
        return _looked_at(source, pictures)
    return _without_pictures(source)


@lru_cache(MOST_CELLS)
def _without_pictures(source: str) -> bool:
    return _looked_at(source, {})


def _looked_at(source: str, pictures: Mapping[str, Mapping[str, str]]) -> bool:
    """Turn Markdown into HTML as nbgrader's pages do, and see whether a sanitiser changes it."""
    try:
        with time_limit(PATIENCE):
            renderer = IPythonRenderer(escape=False, attachments=dict(pictures))
            page = MarkdownWithMath(renderer=renderer).render(source)
            return all(map(_is_clean, {page, strip_files_prefix(page)}))
    except (InvalidNotebook, ValueError, RecursionError, TimeLimitReached):
        return False


def _is_clean(page: str) -> bool:
    clean = _CLEANER.clean(page)
    if page.count("<") != clean.count("<"):  # ends without a beginning, too
        return False
    before, after = (BeautifulSoup(text, "html.parser") for text in (page, clean))
    same = "".join(str(before).split()) == "".join(str(after).split())
    return same and not MORE_THAN_FORMULAS.search(before.get_text())


def _is_allowed(tag: str, name: str, value: str) -> bool:
    """Whether an attribute is one that Markdown makes."""
    if (tag, name) == ("a", "href"):
        return urlsplit(value).scheme.lower() in SCHEMES
    if (tag, name) == ("img", "src"):
        return bool(PICTURE.fullmatch(value))
    if name == "id" and tag not in HEADINGS:
        return False
    return name in VALUES and bool(re.fullmatch(VALUES[name], value))


class _Vetted(CSSSanitizer):  # type: ignore[misc]
    """Leaves styles as they are: `_is_allowed` knows the few that may be."""

    def sanitize_css(self, style: str) -> str:
        """Return the same."""
        return style


_CLEANER = Cleaner(
    tags=TAGS,
    attributes=_is_allowed,
    protocols=["http", "https", "mailto", "data"],
    css_sanitizer=_Vetted(),
)
