"""Homographies: what a camera makes of a plane, found from points and their images.

A homography is a 3 × 3 matrix whose scale means nothing: eight unknowns. Each point with its image
gives two equations, so four points determine it.
"""

from __future__ import annotations

from course_lib.homogeneous import apply_homography
from course_lib.homography.dlt import homography_dlt, normalise_points
from course_lib.homography.fit import fit_homographies, fit_homography, refine_homography

__all__ = [
    "apply_homography",
    "fit_homographies",
    "fit_homography",
    "homography_dlt",
    "normalise_points",
    "refine_homography",
]
