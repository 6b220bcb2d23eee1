"""What the pointer draws in another picture, in the browser alone: the image of its ray."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.camera import Camera
from course_lib.epipolar import relative_pose

Floats = NDArray[np.float64]
#: Nearer than this share of the farther end, an end of a ray has no image worth drawing.
VANISHING = 1e-3


@dataclass(frozen=True, eq=False)
class Trail:
    """The ray of the pixel under the pointer, as another picture of the frame shows it.

    A point at the depth Z on the ray of the pixel x has the image ``A x + e / Z`` (homogeneous).

    Attributes
    ----------
    picture : int
        Where it is drawn: the number of a picture of the frame.
    A : ndarray, shape (3, 3)
        What takes a pixel to the image of the point at infinity on its ray.
    e : ndarray, shape (3,)
        The image of the centre from which the rays start.
    near : float
        From which depth on the ray is drawn; up to infinity.
    depths : tuple of float
        Depths that get a spot and a label.
    unit : str
        Of the depths.
    role : str
        As of a line.
    """

    picture: int
    A: Floats
    e: Floats
    near: float
    depths: tuple[float, ...] = ()
    unit: str = ""
    role: str = field(default="second")

    @classmethod
    def between(
        cls, one: Camera, other: Camera, picture: int, near: float, depths: tuple[float, ...] = ()
    ) -> Trail:
        """Return the trail of the rays of one camera, as another camera shows them.

        Parameters
        ----------
        one, other : Camera
            Whose pixels are pointed at, and whose picture shows their rays.
        picture, near, depths
            As the attributes; depths are in m.

        Returns
        -------
        Trail
            ``A = K2 R K1⁻¹`` and ``e = K2 t``.
        """
        R, t = relative_pose(one.R, one.t, other.R, other.t)
        return cls(picture, other.K @ R @ np.linalg.inv(one.K), other.K @ t, near, depths, "m")

    def path(self, pixel: ArrayLike) -> Floats:
        """Return both ends of the ray's image, (2, 2), px; NaN where it has none.

        The browser computes the same for every movement of the pointer.
        """
        far = self.A @ np.append(np.asarray(pixel, dtype=float), 1.0)
        start, stop = _in_front(float(far[2]), float(self.e[2]), 1 / self.near)
        ends = far + np.array([[start], [stop]]) * self.e
        return np.asarray(ends[:, :2] / ends[:, 2:])

    def spots(self, pixel: ArrayLike) -> Floats:
        """Return the images of the points at the depths, (N, 2), px; NaN for one behind."""
        far = self.A @ np.append(np.asarray(pixel, dtype=float), 1.0)
        places = far + self.e / np.reshape(self.depths, (-1, 1))
        places[places[:, 2] <= 0] = np.nan
        return np.asarray(places[:, :2] / places[:, 2:])


def _in_front(w: float, slope: float, stop: float) -> tuple[float, float]:
    """Return between which of 0 and `stop` the depth ``w + s * slope`` is well above zero."""
    least = VANISHING * max(abs(w), abs(w + stop * slope))
    if max(w, w + stop * slope) < least or least == 0:
        return np.nan, np.nan
    start = (least - w) / slope if w < least else 0.0
    return start, (least - w) / slope if w + stop * slope < least else stop
