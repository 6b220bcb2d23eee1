"""Orientation: where a camera or a model stands, from points that are known."""

from course_lib.orientation.similarity import Similarity, similarity_transform

__all__ = ["Similarity", "similarity_transform"]
