"""A term of the course in nbgrader: its directory, its plug-ins, its secret."""

from course_lib.grading.configuration import configure

__all__ = ["configure"]
