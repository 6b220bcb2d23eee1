"""Optics: what a camera sees, how sharp it is and how bright, with a hole or with lenses.

Lengths in mm unless a name says otherwise.
"""

from __future__ import annotations

from course_lib.optics.aperture import aperture_diameter, f_number, stops_between, working_f_number
from course_lib.optics.aperture_choice import (
    aperture_for_depth,
    apertures_for_limits,
    sharpest_f_number,
)
from course_lib.optics.diffraction import airy_diameter, is_diffraction_limited
from course_lib.optics.focus import (
    circle_of_confusion,
    closeup_depth_of_field,
    depth_of_field,
    depth_of_field_approximate,
    hyperfocal_distance,
)
from course_lib.optics.hole import (
    best_pinhole_diameter,
    equivalent_focal_length,
    field_of_view,
    pinhole_blur_diameter,
)
from course_lib.optics.lens_equation import (
    image_distance,
    magnification,
    object_distance,
    optical_power,
    pixel_on_object,
)
from course_lib.optics.lens_names import parse_lens_name
from course_lib.optics.lens_systems import cardinal_points, lens_system, two_lens_zoom
from course_lib.optics.ray_transfer import (
    free_space,
    image_of_point,
    system_matrix,
    thin_lens,
    trace_rays,
)

__all__ = [
    "airy_diameter",
    "aperture_diameter",
    "aperture_for_depth",
    "apertures_for_limits",
    "best_pinhole_diameter",
    "cardinal_points",
    "circle_of_confusion",
    "closeup_depth_of_field",
    "depth_of_field",
    "depth_of_field_approximate",
    "equivalent_focal_length",
    "f_number",
    "field_of_view",
    "free_space",
    "hyperfocal_distance",
    "image_distance",
    "image_of_point",
    "is_diffraction_limited",
    "lens_system",
    "magnification",
    "object_distance",
    "optical_power",
    "parse_lens_name",
    "pinhole_blur_diameter",
    "pixel_on_object",
    "sharpest_f_number",
    "stops_between",
    "system_matrix",
    "thin_lens",
    "trace_rays",
    "two_lens_zoom",
    "working_f_number",
]
