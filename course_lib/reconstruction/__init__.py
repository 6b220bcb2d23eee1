"""Incremental reconstruction: from tie points to cameras and points, one picture after the other.

It uses what the chapters teach: relative pose, triangulation, resection, bundle adjustment.
"""

from course_lib.reconstruction.procedure import reconstruct
from course_lib.reconstruction.result import Reconstruction, Step

__all__ = ["Reconstruction", "Step", "reconstruct"]
