"""The explorers of chapter 03."""

from __future__ import annotations

from course_lib.drawing.explorers.aperture_window import STOPS, aperture_window_frame
from course_lib.drawing.explorers.depth_of_field import depth_of_field_frame
from course_lib.drawing.explorers.ray_tracer import SECOND, SPREADING, ray_tracer_frame
from course_lib.widgets.controls import Choice, Slider
from course_lib.widgets.explorer import Explorer

FOCUS = (1.2, 6.3, 7, 14)  # m: three signs, and the hyperfocal distance of the text
OBJECTS = (*range(20, 325, 5), 500, 1000, 10_000)  # mm


def depth_of_field_explorer() -> Explorer:
    """Return the depth-of-field explorer: a street through a real lens."""
    lenses = (24, 28, 35, 50, 85, 100)
    return Explorer(
        "Depth of field",
        [
            Slider("f", "Focal length", "f", "mm", 20, 100, 50, steps=50, landmarks=lenses),
            Slider("N", "f-number", "N", "", 1.4, 22, 2.8, steps=50, landmarks=STOPS[:-1]),
            Slider("focus", "Focus distance", "", "m", 1, 60, 3.5, steps=80, landmarks=FOCUS),
            Slider("pitch", "Pixel pitch", "c", "µm", 20, 75, 50, step=5),
        ],
        depth_of_field_frame,
    )


def ray_tracer_explorer() -> Explorer:
    """Return the ray tracer: an object and a thin lens."""
    return Explorer(
        "Rays through a thin lens",
        [
            _object_distance(150),
            Slider("f1", "Focal length", "f", "mm", 20, 150, 60, step=5),
        ],
        ray_tracer_frame,
    )


def _object_distance(default: float) -> Slider:
    """Return the slider of the object: on the table, or so far that its light is parallel."""
    return Slider("Z", "Object distance", "Z", "mm", 20, 1e6, default, steps=2, landmarks=OBJECTS)


def two_lens_explorer() -> Explorer:
    """Return the ray tracer with two lenses; it starts as a telephoto lens before a far object."""
    return Explorer(
        "Rays through two lenses",
        [
            _object_distance(1e6),
            Slider("f1", "Focal length 1", "f₁", "mm", 20, 150, 50, step=5),
            Choice("second", "Second lens", SECOND, SPREADING),
            Slider("f2", "Focal length 2", "|f₂|", "mm", 20, 150, 30, step=5),
            Slider("d", "Gap", "d", "mm", 5, 150, 30, step=1),
        ],
        ray_tracer_frame,
    )


def aperture_window_explorer() -> Explorer:
    """Return the aperture window: defocus and diffraction against the f-number."""
    return Explorer(
        "The aperture window",
        [
            Slider("N", "f-number", "N", "", 1.4, 32, 2.8, steps=60, landmarks=STOPS),
            Slider("f", "Focal length", "f", "mm", 16, 200, 85, step=1),
            Slider("near", "Nearest point", "", "m", 0.5, 10, 2, step=0.1, digits=1),
            Slider("depth", "Depth of range", "", "m", 0.05, 5, 0.5, step=0.05, digits=2),
            Slider("pitch", "Pixel pitch", "", "µm", 2, 14, 13.5, step=0.5, digits=1),
        ],
        aperture_window_frame,
    )
