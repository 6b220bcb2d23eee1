"""Photographs and measurements of others: tests that need them skip where there are none."""

import os
from pathlib import Path

import pytest

from course_lib import data


def fetched(name: str) -> Path:
    """Return the path of a real file; in CI, where it must be there, say why it is not."""
    try:
        return data.fetch(name)
    except data.Unavailable as missing:
        if os.environ.get("CI"):
            raise
        pytest.skip(str(missing))
