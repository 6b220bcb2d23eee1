"""Show a block in whatever a reader sits at: a notebook or a terminal."""

from __future__ import annotations

import sys
from base64 import b64encode
from html import escape


def show_block(html: str, text: str) -> None:
    """Show a block as HTML in a notebook, as text in a terminal.

    Parameters
    ----------
    html, text : str
        The same content twice.
    """
    if _in_a_kernel():
        from IPython.display import display

        display({"text/html": html, "text/plain": text}, raw=True)
    else:
        print(text)


def described_picture(png: bytes, description: str) -> str:
    """Return an ``img`` element: JupyterLab would show a bare PNG without the words that it needs.

    Parameters
    ----------
    png : bytes
        The picture.
    description : str
        Its text alternative.

    Returns
    -------
    str
        HTML.
    """
    data = b64encode(png).decode("ascii")
    return f'<img alt="{escape(description)}" src="data:image/png;base64,{data}">'


def _in_a_kernel() -> bool:
    """Return whether a notebook's kernel runs this; that ipykernel is loaded is not enough."""
    ipython = sys.modules.get("IPython")
    return ipython is not None and hasattr(ipython.get_ipython(), "kernel")
