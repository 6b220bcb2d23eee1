"""The still figures of chapter 01, one function each."""

from __future__ import annotations

from course_lib.drawing.pinhole.geometry import (
    image_planes,
    lens_centred,
    similar_triangles,
)
from course_lib.drawing.pinhole.light import (
    bare_sensor_and_hole,
    blur_against_hole,
    blur_geometry,
    eclipse,
)
from course_lib.drawing.pinhole.perspective import (
    foreshortening,
    house,
    house_picture,
    one_line_runs_away,
    size_against_distance,
)
from course_lib.drawing.pinhole.sensors import (
    SENSORS,
    lens_fan,
    pixel_grid,
    sensors_to_scale,
    view_angle,
)

__all__ = [
    "SENSORS",
    "bare_sensor_and_hole",
    "blur_against_hole",
    "blur_geometry",
    "eclipse",
    "foreshortening",
    "house",
    "house_picture",
    "image_planes",
    "lens_centred",
    "lens_fan",
    "one_line_runs_away",
    "pixel_grid",
    "sensors_to_scale",
    "similar_triangles",
    "size_against_distance",
    "view_angle",
]
