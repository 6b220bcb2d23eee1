"""What a measurement asks, a set-up that is to do it, and the verdict on a demand.

Use these classes through `course_lib.planning`.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from course_lib.camera import Camera, camera_at
from course_lib.checks import Array, check_length
from course_lib.optics import image_distance
from course_lib.planning.catalogue import CameraModel, LensModel
from course_lib.planning.view import Box


@dataclass(frozen=True, eq=False)
class Task:
    """What a measurement asks of its cameras.

    Attributes
    ----------
    box : Box
        What must be in the picture and sharp.
    normal : ndarray, shape (3,)
        Direction across the surface that is measured.
    motion : float
        How far the object moves to each side, m.
    speed : float
        Of its fastest point, m/s.
    resolution : float
        The most that one pixel may cover on the surface, m.
    frame_rate : float
        Pictures a second, 1/s.
    blur_px : float
        Largest spot, by defocus or by diffraction, and longest smear that count as sharp, px.
    sigma : float
        Largest standard deviation of a point in space, m; ``np.inf`` with one camera.
    exposure_at_f1 : float
        Exposure time that the light needs at f/1, s; 0 if there is always enough.
    """

    box: Box
    normal: Array
    resolution: float
    motion: float = 0.0
    speed: float = 0.0
    frame_rate: float = 1.0
    blur_px: float = 1.5
    sigma: float = np.inf
    exposure_at_f1: float = 0.0


@dataclass(frozen=True, eq=False)
class Setup:
    """A camera with a lens somewhere, and how both are set.

    Attributes
    ----------
    camera : CameraModel
    lens : LensModel
    eye, target : ndarray, shape (3,)
        Where the lens is, and where it looks, m.
    N : float
        f-number.
    exposure_time : float
        s.
    focus_distance : float
        From the lens along its axis, m.
    coefficients : tuple of float
        Distortion of the lens, in OpenCV's order; none unless given.
    up : tuple of float
        Direction in the world that is upwards in the picture.

    Raises
    ------
    TypeError, ValueError
        If the lens does not fit or a setting is not positive.
    """

    camera: CameraModel
    lens: LensModel
    eye: Array
    target: Array
    N: float
    exposure_time: float
    focus_distance: float
    coefficients: tuple[float, ...] = ()
    up: tuple[float, float, float] = (0, 0, 1)

    def __post_init__(self) -> None:
        for name in ("N", "exposure_time", "focus_distance"):
            object.__setattr__(self, name, check_length(getattr(self, name), name))
        if self.camera.mount != self.lens.mount:
            raise ValueError(
                f"{self.lens.name} has the mount {self.lens.mount}, {self.camera.name} has "
                f"{self.camera.mount}: choose a lens that fits"
            )

    @cached_property
    def view(self) -> Camera:
        """The pinhole camera of the set-up: its image distance is that of the focus."""
        distance = image_distance(self.lens.f_mm, 1000 * self.focus_distance)
        K = self.camera.intrinsics(self.lens)
        K[:2, :2] *= float(distance) / self.lens.f_mm
        return camera_at(self.eye, self.target, K, self.camera.image_size, self.up)


@dataclass(frozen=True)
class Verdict:
    """One demand: whether it is met, and why.

    Attributes
    ----------
    name : str
        Of the demand.
    met : bool
    value, limit : float
        What the set-up gives, and what is asked for, in `unit`.
    unit : str
    reason : str
        In a sentence.
    remedy : str
        What would make it work; empty if it does.
    """

    name: str
    met: bool
    value: float
    limit: float
    unit: str
    reason: str
    remedy: str = ""
