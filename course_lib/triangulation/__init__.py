"""Triangulation."""

from course_lib.triangulation.two_views import triangulate

__all__ = ["triangulate"]
