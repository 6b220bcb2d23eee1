"""Lessons that run in the tests' own process leave it as it was."""

from collections.abc import Iterator

import numpy as np
import pytest


@pytest.fixture(autouse=True, scope="module")
def numbers_are_printed_as_before() -> Iterator[None]:
    """A lesson's first cell says how numbers are printed, for the whole process."""
    with np.printoptions():
        yield
