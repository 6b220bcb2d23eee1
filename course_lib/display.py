"""Show a block in whatever a reader sits at: a notebook or a terminal."""

from __future__ import annotations

import sys


def show_block(html: str, text: str) -> None:
    """Show a block as HTML in a notebook, as text in a terminal.

    Parameters
    ----------
    html, text : str
        The same content twice.
    """
    if "ipykernel" in sys.modules:
        from IPython.display import display

        display({"text/html": html, "text/plain": text}, raw=True)
    else:
        print(text)
