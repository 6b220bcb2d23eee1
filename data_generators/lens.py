"""A thin lens in front of the sensor: it gathers more light than a hole, and focuses it.

Every point of the lens sees the scene like a pinhole of its own; the lens bends their pictures
until they agree at one distance. Nearer and farther points are seen as disks.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from course_lib.camera import Camera, image_centre
from course_lib.checks import Array, check_length, check_size
from course_lib.optics import circle_of_confusion

MM = 1e-3  # m


@dataclass(frozen=True)
class Lens:
    """A thin lens, focused at a distance.

    Attributes
    ----------
    f : float
        Focal length, mm.
    N : float
        f-number: focal length by the diameter of the aperture.
    focus_distance : float
        From the lens to the plane that is seen sharply, mm; may be infinite.

    Raises
    ------
    TypeError, ValueError
        If a number is not positive, or the lens cannot focus at that distance.
    """

    f: float
    N: float
    focus_distance: float = np.inf

    def __post_init__(self) -> None:
        check_length(self.f, "f")
        check_length(self.N, "N")
        if self.focus_distance != np.inf:
            check_length(self.focus_distance, "focus_distance")
        if self.focus_distance <= self.f:
            raise ValueError(
                f"focus_distance must be larger than the focal length of {self.f:g} mm, "
                f"got {self.focus_distance:g} mm: no image is formed behind the lens"
            )

    @property
    def diameter(self) -> float:
        """Diameter of the aperture, mm."""
        return self.f / self.N

    @property
    def image_distance(self) -> float:
        """Distance from the lens to the sensor, mm, by the thin lens equation."""
        return 1 / (1 / self.f - 1 / self.focus_distance)

    @property
    def light(self) -> float:
        """Irradiance on the sensor's middle by radiance, sr.

        References
        ----------
        B. K. P. Horn, Robot Vision (1986), section 10.3, with the lens focused where it is.
        """
        return float(np.pi / 4 * (self.diameter / self.image_distance) ** 2)

    def intrinsics(self, pitch: ArrayLike, image_size: tuple[int, int]) -> Array:
        """Return the matrix K of a camera with this lens, focused where it is.

        Focusing nearer moves the lens away from the sensor and narrows the view a little.

        Parameters
        ----------
        pitch : float or array_like, shape (2,)
            Size of a pixel, across and down, mm.
        image_size : tuple of int
            Width and height, px.

        Returns
        -------
        ndarray, shape (3, 3)
            px.

        Raises
        ------
        TypeError, ValueError
            If a size is not positive.
        """
        fx, fy = self.image_distance / check_size(np.broadcast_to(pitch, 2), "pitch")
        cx, cy = image_centre(image_size)
        return np.array([[fx, 0, cx], [0, fy, cy], [0, 0, 1]])

    def pitch(self, camera: Camera) -> Array:
        """Return the size of a pixel of a camera that this lens belongs to, (2,), mm."""
        return np.asarray(self.image_distance / np.diag(camera.K)[:2])

    def disks(self, Z: ArrayLike, camera: Camera) -> Array:
        """Return the diameters of the disks that points are seen as, along a row.

        Parameters
        ----------
        Z : array_like
            Distances along the axis, m; may be infinite.
        camera : Camera
            Its matrix K must belong to the lens as it is focused: see `intrinsics`.

        Returns
        -------
        ndarray
            px.

        Raises
        ------
        TypeError, ValueError
            If a distance is not positive.
        """
        spots = circle_of_confusion(np.asarray(Z, float) / MM, self.focus_distance, self.f, self.N)
        return np.asarray(spots / self.pitch(camera)[0])
