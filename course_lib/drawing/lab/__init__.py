"""The figures of chapter 12, from arrays."""

from course_lib.drawing.lab.lengths import contributions, off_by, ruler_and_camera
from course_lib.drawing.lab.page import report_page
from course_lib.drawing.lab.plane import from_above, ray_and_plane
from course_lib.drawing.lab.sheets import (
    contact_sheet,
    covered,
    lens_bend,
    straightened,
    thumbnail,
)
from course_lib.drawing.lab.space import rays_from_above

__all__ = [
    "contact_sheet",
    "contributions",
    "covered",
    "from_above",
    "lens_bend",
    "off_by",
    "ray_and_plane",
    "rays_from_above",
    "report_page",
    "ruler_and_camera",
    "straightened",
    "thumbnail",
]
