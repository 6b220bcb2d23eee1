"""Tests of isolated grading skip where nothing can be isolated; in CI they must run, and fail."""

import os

import pytest

from course_lib.grading.isolation import why_not

walled = pytest.mark.skipif(bool(why_not()) and not os.environ.get("CI"), reason=why_not())
