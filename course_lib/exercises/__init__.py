"""The exercises of the course as data, one module a chapter."""

from course_lib.exercises.catalogue import CHAPTERS, all_exercises, find

__all__ = ["CHAPTERS", "all_exercises", "find"]
