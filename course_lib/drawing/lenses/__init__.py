"""The still figures of chapter 03, one function each."""

from __future__ import annotations

from course_lib.drawing.lenses.depth import (
    approximation,
    blur_against_distance,
    blur_cones,
    closeup,
    ranges,
)
from course_lib.drawing.lenses.imaging import (
    hole_and_lens,
    image_against_object,
    image_construction,
    pixel_on_object,
)
from course_lib.drawing.lenses.systems import principal_planes, ray_steps, zoom
from course_lib.drawing.lenses.views import aperture_series, wing
from course_lib.drawing.lenses.window import (
    airy_on_pixels,
    aperture_branches,
    lens_name,
    stops,
    sweet_spot,
)

__all__ = [
    "airy_on_pixels",
    "aperture_branches",
    "aperture_series",
    "approximation",
    "blur_against_distance",
    "blur_cones",
    "closeup",
    "hole_and_lens",
    "image_against_object",
    "image_construction",
    "lens_name",
    "pixel_on_object",
    "principal_planes",
    "ranges",
    "ray_steps",
    "stops",
    "sweet_spot",
    "wing",
    "zoom",
]
