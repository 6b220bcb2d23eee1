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
    if _in_a_kernel():
        from IPython.display import display

        display({"text/html": html, "text/plain": text}, raw=True)
    else:
        print(text)


def _in_a_kernel() -> bool:
    """Return whether a notebook's kernel runs this; that ipykernel is loaded is not enough."""
    ipython = sys.modules.get("IPython")
    return ipython is not None and hasattr(ipython.get_ipython(), "kernel")
