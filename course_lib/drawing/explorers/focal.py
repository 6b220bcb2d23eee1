"""The focal length explorer: what a lens and a sensor see, and from where."""

from __future__ import annotations

from functools import cache

import numpy as np
from numpy.typing import NDArray

from course_lib.camera import Camera, camera_at, first_guess_intrinsics, pixel_focal_length
from course_lib.drawing.explorers.frame import Frame, Label, Picture, Readout
from course_lib.drawing.explorers.street import angle_probe, frustum, renderer, upright_camera
from course_lib.drawing.sensors import SENSORS
from course_lib.optics import equivalent_focal_length, field_of_view

EYE = (0.5, -3.5, 1.65)
DEPTH = 14.0  # m: how far the frustum is drawn
VIEW_SIZE = (400, 320)


def focal_length_frame(f: float, sensor: str) -> Frame:
    """Return what a camera in the street sees, and the camera seen from outside.

    Parameters
    ----------
    f : float
        Focal length, mm.
    sensor : str
        A key of `course_lib.drawing.sensors.SENSORS`.

    Returns
    -------
    Frame
        The photograph, the view of the frustum, and the numbers.
    """
    size = SENSORS[sensor]
    camera = upright_camera(EYE, f, size)
    wide, high, diagonal = np.degrees(field_of_view(f, size))
    fx = pixel_focal_length(f, size, camera.image_size)[0]
    equivalent = equivalent_focal_length(f, size)
    w, h = camera.image_size
    photograph = Picture(
        "What the camera sees",
        f"Photograph of a street with {f:g} mm on {sensor}: {wide:.0f}° wide, {high:.0f}° high.",
        camera.image_size,
        renderer().picture(camera),
        probes=(angle_probe(camera),),
        pixels=True,
    )
    readouts = (
        Readout("Horizontal field", "θ", f"{wide:.1f}", "°"),
        Readout("Vertical field", "", f"{high:.1f}", "°"),
        Readout("Diagonal field", "", f"{diagonal:.1f}", "°"),
        Readout("Focal length in pixels", "fₓ", f"{fx:.0f}", "px"),
        Readout("35 mm equivalent", "", f"{equivalent:.0f}", "mm"),
        Readout("Sensor", "", f"{size[0]:g} × {size[1]:g}", "mm"),
        Readout("This picture", "", f"{w} × {h}", "px"),
    )
    return Frame((photograph, _outside(camera, f"{wide:.1f}°")), readouts)


def _outside(camera: Camera, angle: str) -> Picture:
    """Return the street from above, with the camera's field of view in it."""
    view, picture = _bird()
    foot = view.project(camera.centre)
    return Picture(
        "The camera from outside",
        f"The street from above; the camera's pyramid of sight opens {angle} to the sides.",
        VIEW_SIZE,
        picture,
        lines=frustum(camera, DEPTH, view),
        labels=(Label("camera", (float(foot[0]) + 4, float(foot[1]) + 16), "camera", "middle"),),
    )


@cache
def _bird() -> tuple[Camera, NDArray[np.uint8]]:
    """Return the camera above the street and its photograph, which stays the same."""
    K = first_guess_intrinsics(37, (36, 36 * VIEW_SIZE[1] / VIEW_SIZE[0]), VIEW_SIZE)
    view = camera_at((-16, -24, 15), (-0.6, 6, 1.6), K, VIEW_SIZE)
    return view, renderer().picture(view)
