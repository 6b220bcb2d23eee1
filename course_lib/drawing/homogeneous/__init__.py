"""The still figures of chapter 02, one function each, and the places that they show."""

from __future__ import annotations

from course_lib.drawing.homogeneous.moves import AXIS as HINGES
from course_lib.drawing.homogeneous.moves import (
    clockwise,
    gimbal_lock,
    opening_door,
    order_matters,
    split_by_axis,
)
from course_lib.drawing.homogeneous.projective import points_on_rays, what_survives
from course_lib.drawing.homogeneous.site import (
    CORNER,
    FROM_BLENDER,
    HOUSE,
    SIZE,
    K,
    cameras,
    corner_camera,
    first_camera,
    imports,
    street_map,
    taken_from,
)
from course_lib.drawing.homogeneous.sketches import (
    gimbal,
    looking_at,
    pixel_shapes,
    two_conventions,
    where_is_it,
)
from course_lib.drawing.homogeneous.views import columns_of, one_ray, sweep, wire

__all__ = [
    "CORNER",
    "FROM_BLENDER",
    "HINGES",
    "HOUSE",
    "SIZE",
    "K",
    "cameras",
    "clockwise",
    "columns_of",
    "corner_camera",
    "first_camera",
    "gimbal",
    "gimbal_lock",
    "imports",
    "looking_at",
    "one_ray",
    "opening_door",
    "order_matters",
    "pixel_shapes",
    "points_on_rays",
    "split_by_axis",
    "street_map",
    "sweep",
    "taken_from",
    "two_conventions",
    "what_survives",
    "where_is_it",
    "wire",
]
