"""Triangulation: where in space a point is, from where pictures show it.

A pixel tells a ray; a second picture tells where on it. Pixels are without distortion, cameras are
given by their camera matrices.
"""

from course_lib.triangulation.depth import depth_from_disparity, depth_uncertainty
from course_lib.triangulation.many_views import (
    point_covariance,
    refine_point,
    triangulate_linear,
)
from course_lib.triangulation.rays import (
    closest_points_on_rays,
    intersect_ray_plane,
    triangulate_midpoint,
)
from course_lib.triangulation.two_views import triangulate

__all__ = [
    "closest_points_on_rays",
    "depth_from_disparity",
    "depth_uncertainty",
    "intersect_ray_plane",
    "point_covariance",
    "refine_point",
    "triangulate",
    "triangulate_linear",
    "triangulate_midpoint",
]
