"""How cameras see: the mathematics, exercises, figures and widgets of the course.

The mathematics (`camera`, `optics`, `transforms`, …) is plain functions on NumPy arrays and
imports nothing else. Conventions: camera frame x right, y down, z forward; poses map world to
camera; pixel ``(0, 0)`` is the centre of the top-left pixel; points are rows.
"""

from __future__ import annotations

from typing import Any


def __getattr__(name: str) -> Any:
    """Load what a notebook calls (`check`, `attempt`, `solution`) only when it is asked for."""
    if name in ("attempt", "attempt_each", "check", "solution"):
        from course_lib import notebook

        return getattr(notebook, name)
    raise AttributeError(f"module 'course_lib' has no attribute {name!r}")
