"""The still figures of chapter 01, one function each."""

from __future__ import annotations

from course_lib.drawing.pinhole.edges import meeting_lines, photograph
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
    lens_fan,
    pixel_grid,
    sensors_to_scale,
    view_angle,
)
from course_lib.drawing.pinhole.views import (
    dolly_strip,
    facade,
    hole_series,
    road_direction,
    street_lines,
    street_view,
)
from course_lib.drawing.sensors import SENSORS

__all__ = [
    "SENSORS",
    "bare_sensor_and_hole",
    "blur_against_hole",
    "blur_geometry",
    "dolly_strip",
    "eclipse",
    "facade",
    "foreshortening",
    "hole_series",
    "house",
    "house_picture",
    "image_planes",
    "lens_centred",
    "lens_fan",
    "meeting_lines",
    "one_line_runs_away",
    "photograph",
    "pixel_grid",
    "road_direction",
    "sensors_to_scale",
    "similar_triangles",
    "size_against_distance",
    "street_lines",
    "street_view",
    "view_angle",
]
