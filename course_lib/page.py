"""A page that holds all it needs: one look for every report of the course, on screen and paper."""

from __future__ import annotations

from collections.abc import Iterable
from html import escape
from pathlib import Path

STYLE = Path(__file__).with_suffix(".css")
#: Okabe and Ito's colours, which colour-blind readers tell apart.
BLUE, SKY, ORANGE, AMBER, GREY, DARK = (
    "#0072b2", "#56b4e9", "#d55e00", "#e69f00", "#999", "#333"
)  # fmt: skip


def html_page(title: str, parts: Iterable[str], style: str = "") -> str:
    """Return a page of HTML that needs no other file, no network and no scripts.

    Parameters
    ----------
    title : str
        Plain text.
    parts : iterable of str
        HTML, from top to bottom.
    style : str, optional
        More CSS than all pages have.

    Returns
    -------
    str
        The page.
    """
    rules = STYLE.read_text("utf-8") + style
    head = (
        f"<meta charset='utf-8'><title>{escape(title)}</title>"
        f"<meta name='viewport' content='width=device-width'><style>{rules}</style>"
    )
    body = "\n".join(parts)
    page = f"<html lang='en'>\n<head>{head}</head>\n<body>\n{body}\n</body>\n</html>\n"
    return f"<!doctype html>\n{page}"


def svg(box: str, content: str, said: str) -> str:
    """Return a drawing with a text for those who do not see it.

    Parameters
    ----------
    box : str
        What is seen: left, top, width and height.
    content : str
        Elements of SVG.
    said : str
        The same in words.

    Returns
    -------
    str
        HTML.
    """
    words = escape(said, quote=True)
    return f"<svg viewBox='{box}' role='img' aria-label='{words}'>{content}</svg>"
