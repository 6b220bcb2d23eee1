"""Receipts for submissions that were put into place by hand, so that feedback can be released."""

from __future__ import annotations

import secrets
from collections.abc import Sequence
from datetime import UTC, datetime
from pathlib import Path
from typing import Any


def write_receipts(notebooks: Sequence[str], **_: Any) -> None:
    """Write what ``nbgrader submit`` would have written beside a submission, where it is missing.

    Without it ``nbgrader release_feedback`` stops, for all students. nbgrader calls this before
    it makes a student's feedback page, and copies the files from here to the page's folder.

    Parameters
    ----------
    notebooks : sequence of str
        The paths of one student's graded notebooks.
    """
    first = Path(notebooks[0])
    graded = datetime.fromtimestamp(first.stat().st_mtime, UTC)
    receipt = {
        "timestamp.txt": f"{graded:%Y-%m-%d %H:%M:%S} UTC",
        "submission_secret.txt": secrets.token_hex(64),
    }
    for name, text in receipt.items():
        path = first.with_name(name)
        if not path.exists():
            path.write_text(text, encoding="utf-8")
